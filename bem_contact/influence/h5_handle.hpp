#pragma once

#include <hdf5.h>

#include <mutex>
#include <utility>

/// Private to this room: what its .cpp files share of HDF5's C API.
namespace bem_contact {

/// An HDF5 identifier and the function that closes it; negative where the call that made it failed.
class H5Handle {
public:
  H5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  H5Handle(H5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  H5Handle& operator=(H5Handle&&) = delete;
  ~H5Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  operator hid_t() const { return id_; } // NOLINT: the C API takes ids everywhere

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Everything that calls HDF5 holds one of these. The library is not made for several threads, so that one
/// call waits for another here. It prints its error stack by default; while this lives, return values alone
/// tell of errors.
class QuietHdf5 {
public:
  QuietHdf5() : turn_(one_at_a_time()) {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
  /// Recursive, because writing a file makes an image of it first.
  static std::recursive_mutex& one_at_a_time() {
    static std::recursive_mutex mutex;
    return mutex;
  }
  std::lock_guard<std::recursive_mutex> turn_;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

} // namespace bem_contact
