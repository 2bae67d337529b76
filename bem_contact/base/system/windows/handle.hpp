#pragma once

#include <utility>
#include <windows.h>

namespace bem_contact::system {

/// Closed when it goes.
class Handle {
public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  ~Handle() { close(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  void close() {
    if (HANDLE open = std::exchange(handle_, nullptr); open && open != INVALID_HANDLE_VALUE)
      CloseHandle(open);
  }
  void take(HANDLE handle) {
    close();
    handle_ = handle;
  }
  HANDLE get() const { return handle_; }
  HANDLE release() { return std::exchange(handle_, nullptr); }

private:
  HANDLE handle_;
};

} // namespace bem_contact::system
