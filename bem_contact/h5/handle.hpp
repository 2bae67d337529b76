#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <utility>

/// What callers of this room see of HDF5's C API: no header of HDF5.
namespace bem_contact {

using H5Id = std::int64_t; ///< HDF5's hid_t

/// An HDF5 identifier and the function that closes it; negative where the call that made it failed.
class H5Handle {
public:
  H5Handle(H5Id id, int (*close)(H5Id)) : id_(id), close_(close) {}
  H5Handle(H5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  H5Handle& operator=(H5Handle&&) = delete;
  ~H5Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  operator H5Id() const { return id_; } // NOLINT: the C API takes ids everywhere
  H5Id release() { return std::exchange(id_, -1); }

private:
  H5Id id_;
  int (*close_)(H5Id);
};

enum class H5Access { read, change };

/// Opens a file without a lock, which some file systems of clusters do not have. Files of ours need none:
/// they are whole or not there (base/output_file.hpp), and one that is still being written has another name.
H5Handle open_h5(const std::filesystem::path& file, H5Access access);

/// Everything that calls HDF5 holds one of these. The library is not made for several threads, so that one
/// call waits for another here. It prints its error stack by default; while this lives, return values alone
/// tell of errors.
class QuietHdf5 {
public:
  QuietHdf5();
  ~QuietHdf5();
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
  std::lock_guard<std::recursive_mutex> turn_;
  int (*function_)(H5Id, void*) = nullptr; // HDF5's H5E_auto2_t
  void* data_ = nullptr;
};

} // namespace bem_contact
