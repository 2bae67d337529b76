#pragma once

#include "bem_contact/h5/handle.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// For the room influence: entries of an influence file. Each function throws InputError where HDF5 fails or
/// an entry is not what the format says.
namespace bem_contact::strict_h5 {

/// A handle that throws when the call that made it failed.
class Handle : public H5Handle {
public:
  Handle(H5Id id, int (*close)(H5Id), std::string_view what) : Handle(H5Handle(id, close), what) {}
  Handle(H5Handle&& made, std::string_view what);
};

/// Opens a file to read it.
Handle open_file(const std::filesystem::path& file);
/// Whether there is an entry of that name.
bool has(H5Id at, const char* name);

using Extent = std::uint64_t; ///< HDF5's hsize_t is another type of this size in each version of HDF5
using Shape = std::vector<Extent>;

void check(bool success, std::string_view what);

/// Attributes of one value. What is read must be of that kind.
void write(H5Id at, const char* name, double value);
void write(H5Id at, const char* name, int value);
void write(H5Id at, const char* name, std::uint64_t value);
void write(H5Id at, const char* name, const std::string& value);
void read(H5Id at, const char* name, double& value);
void read(H5Id at, const char* name, int& value);
void read(H5Id at, const char* name, std::uint64_t& value);
void read(H5Id at, const char* name, std::string& value);

/// How a table lies in its file. In chunks, each has one wavenumber and a checksum. `packed` also compresses
/// them, which pays for rounded numbers alone: six of the eight bytes of another cannot be compressed.
enum class Layout { whole, chunks, packed };
/// Writes a table of doubles and its attribute `unit`.
struct Table {
  const char* name;
  Shape shape;
  std::span<const double> values;
  const char* unit;
  Layout layout = Layout::whole;
};
void write(H5Id at, const Table& table);

/// The same of single precision, whole.
struct FloatTable {
  const char* name;
  Shape shape;
  std::span<const float> values;
  const char* unit;
};
void write(H5Id at, const FloatTable& table);

/// Reads a table of that shape; an extent of 0 stands for any.
std::vector<double> read_table(H5Id at, const char* name, Shape shape);
std::vector<float> read_floats(H5Id at, const char* name, Shape shape);
/// Columns first .. first + count - 1 of a table.
struct Columns {
  Extent first, count;
};
/// Reads runs of columns, which ascend, of a table of two extents: column by column. HDF5's own checksums are
/// not looked at: a sum of the whole file has to hold before (influence/file_seal.hpp).
std::vector<double> read_columns(H5Id at, const char* name, Shape shape, std::span<const Columns> runs);

} // namespace bem_contact::strict_h5
