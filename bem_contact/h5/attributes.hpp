#pragma once

#include "bem_contact/h5/handle.hpp"
#include "bem_contact/h5/hdf5_functions.hpp"

#include <optional>
#include <string>
#include <type_traits>

/// Private to this room: attributes of one value. Each function says by its result whether HDF5 succeeded.
namespace bem_contact {

/// Type of a number in the file and in memory.
template <class Number> hid_t file_type() {
  return std::is_same_v<Number, double> ? H5T_IEEE_F64LE
                                        : (std::is_same_v<Number, std::uint64_t> ? H5T_STD_U64LE
                                           : std::is_same_v<Number, bool>        ? H5T_STD_U8LE
                                                                                 : H5T_STD_I32LE);
}
template <class Number> hid_t memory_type() {
  return std::is_same_v<Number, double> ? H5T_NATIVE_DOUBLE
                                        : (std::is_same_v<Number, std::uint64_t> ? H5T_NATIVE_UINT64
                                           : std::is_same_v<Number, bool>        ? H5T_NATIVE_UCHAR
                                                                                 : H5T_NATIVE_INT);
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
