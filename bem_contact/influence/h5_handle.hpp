#pragma once

#include <cstdint>
#include <hdf5.h>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
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

// Attributes of one value. Each function says by its result whether HDF5 succeeded.

/// Type of a number in the file and in memory.
template <class Number> hid_t file_type() {
  return std::is_same_v<Number, double>
             ? H5T_IEEE_F64LE
             : (std::is_same_v<Number, std::uint64_t> ? H5T_STD_U64LE : H5T_STD_I32LE);
}
template <class Number> hid_t memory_type() {
  return std::is_same_v<Number, double>
             ? H5T_NATIVE_DOUBLE
             : (std::is_same_v<Number, std::uint64_t> ? H5T_NATIVE_UINT64 : H5T_NATIVE_INT);
}

template <class Number> bool write_attribute(hid_t object, const char* name, Number value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle attribute(H5Acreate2(object, name, file_type<Number>(), space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, memory_type<Number>(), &value) >= 0;
}

/// Of fixed length, because text of variable length lies in HDF5's global heap, which has no checksum.
bool write_attribute(hid_t object, const char* name, const std::string& text);

/// The text of an open attribute, of fixed or variable length.
std::optional<std::string> read_text(hid_t attribute);

} // namespace bem_contact
