#pragma once

#include "bem_contact/influence/h5_handle.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Private to this room: entries of an influence file. Each function throws InputError where HDF5 fails or an
/// entry is not what the format says.
namespace bem_contact::strict_h5 {

/// A handle that throws when the call that made it failed.
class Handle : public H5Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t), std::string_view what) : Handle(H5Handle(id, close), what) {}
  Handle(H5Handle&& made, std::string_view what);
};

using Shape = std::vector<hsize_t>;

void check(bool success, std::string_view what);

template <class Value> void write(hid_t at, const char* name, const Value& value) {
  check(write_attribute(at, name, value), name);
}

/// The attribute, which must be one value of that class.
Handle open_scalar(hid_t at, const char* name, H5T_class_t wanted);

template <class Number> void read(hid_t at, const char* name, Number& value) {
  const Handle attribute = open_scalar(at, name, std::is_same_v<Number, double> ? H5T_FLOAT : H5T_INTEGER);
  check(H5Aread(attribute, memory_type<Number>(), &value) >= 0, name);
}
void read(hid_t at, const char* name, std::string& value);

/// Writes a table of doubles and its attribute `unit`. `checked`: in chunks of one wavenumber, each with a
/// checksum. It is not compressed: six of the eight bytes of a number cannot be, and gzip took longer than
/// all other writing.
struct Table {
  const char* name;
  Shape shape;
  std::span<const double> values;
  const char* unit;
  bool checked = false;
};
void write(hid_t at, const Table& table);

/// Reads a table of that shape; an extent of 0 stands for any.
std::vector<double> read_table(hid_t at, const char* name, Shape shape);
/// Columns first .. first + count - 1 of a table.
struct Columns {
  hsize_t first, count;
};
/// Reads runs of columns, which ascend, of a table of two extents: column by column.
std::vector<double> read_columns(hid_t at, const char* name, Shape shape, std::span<const Columns> runs);

} // namespace bem_contact::strict_h5
