#include "bem_contact/h5/strict.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/attributes.hpp"
#include "bem_contact/h5/dataset.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace bem_contact::strict_h5 {

namespace {

using Extents = std::vector<hsize_t>; ///< a Shape as HDF5 takes it

constexpr unsigned deflate_level = 9;       ///< what is packed is written once, and sent often
constexpr hsize_t rows_of_a_cache_line = 8; ///< of doubles
/// Largest extent of a table that is read: a damaged file asks for no more memory than this.
constexpr hsize_t most_extent = 1000000;

struct OpenTable {
  Handle set;
  Shape shape;
};

/// `shape`: the extents wanted, 0 where any will do.
OpenTable open_table(hid_t at, const char* name, Shape shape) {
  Handle set(open_dataset(at, name), std::string("the table ") + name);
  const Handle space(H5Dget_space(set), H5Sclose, name);
  const Handle type(H5Dget_type(set), H5Tclose, name);
  Extents found(shape.size());
  const bool fits = H5Tget_class(type) == H5T_FLOAT &&
                    H5Sget_simple_extent_ndims(space) == static_cast<int>(shape.size()) &&
                    H5Sget_simple_extent_dims(space, found.data(), nullptr) >= 0;
  for (std::size_t i = 0; fits && i < shape.size(); ++i)
    if (shape[i] == 0 && found[i] > 0 && found[i] < most_extent)
      shape[i] = found[i];
  if (!fits || !std::ranges::equal(found, shape))
    throw InputError("The influence file's table '" + std::string(name) + "' has the wrong shape or type",
                     "it does not fit the file's stations and wavenumbers",
                     "Compute the influence file again.");
  return {std::move(set), std::move(shape)};
}

} // namespace

Handle::Handle(H5Handle&& made, std::string_view what) : H5Handle(std::move(made)) {
  if (*this < 0)
    throw InputError("HDF5 failed at " + std::string(what),
                     "what data/INFLUENCE_FORMAT.md asks for is missing or of another type",
                     "Compute the influence file again.");
}

void check(bool success, std::string_view what) {
  if (!success)
    throw InputError("HDF5 failed at " + std::string(what), "the disk may be full or the file damaged",
                     "Make room, or compute the influence file again.");
}

Handle open_file(const std::filesystem::path& file) {
  return {open_h5(file, H5Access::read), "opening '" + file.string() + "'"};
}

bool has(hid_t at, const char* name) {
  return H5Lexists(at, name, H5P_DEFAULT) > 0;
}

namespace {

/// The attribute, which must be one value of that class.
Handle open_scalar(hid_t at, const char* name, H5T_class_t wanted) {
  Handle attribute(H5Aopen(at, name, H5P_DEFAULT), H5Aclose, std::string("the attribute ") + name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Tget_class(type) != wanted)
    throw InputError(
        "The influence file's attribute '" + std::string(name) + "' is not one value of the right type",
        "data/INFLUENCE_FORMAT.md says which type it must have", "Compute the influence file again.");
  return attribute;
}

template <class Number> void read_number(hid_t at, const char* name, Number& value) {
  const Handle attribute = open_scalar(at, name, std::is_same_v<Number, double> ? H5T_FLOAT : H5T_INTEGER);
  check(H5Aread(attribute, memory_type<Number>(), &value) >= 0, name);
}

} // namespace

void write(hid_t at, const char* name, double value) {
  check(write_attribute(at, name, value), name);
}
void write(hid_t at, const char* name, int value) {
  check(write_attribute(at, name, value), name);
}
void write(hid_t at, const char* name, std::uint64_t value) {
  check(write_attribute(at, name, value), name);
}
void write(hid_t at, const char* name, const std::string& value) {
  check(write_attribute(at, name, value), name);
}

void read(hid_t at, const char* name, double& value) {
  read_number(at, name, value);
}
void read(hid_t at, const char* name, int& value) {
  read_number(at, name, value);
}
void read(hid_t at, const char* name, std::uint64_t& value) {
  read_number(at, name, value);
}
void read(hid_t at, const char* name, std::string& value) {
  const Handle attribute = open_scalar(at, name, H5T_STRING);
  const auto text = read_text(attribute);
  check(text.has_value(), name);
  value = *text;
}

namespace {

/// Types in the file and in memory.
struct NumberType {
  hid_t stored, native;
};
NumberType type_of(const double*) {
  return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
}
NumberType type_of(const float*) {
  return {H5T_IEEE_F32LE, H5T_NATIVE_FLOAT};
}

/// A double or a single table.
template <class Numbers> void write_numbers(hid_t at, const Numbers& table, Layout layout) {
  const char* name = table.name;
  const NumberType type = type_of(table.values.data());
  const Extents shape(table.shape.begin(), table.shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, name);
  const Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  check(H5Pset_obj_track_times(list, false) >= 0, name); // the same numbers give the same bytes
  if (layout != Layout::whole) {
    Extents chunk = shape;
    chunk.front() = 1;
    check(H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data()) >= 0, name);
    if (layout == Layout::packed)
      check(H5Pset_shuffle(list) >= 0 && H5Pset_deflate(list, deflate_level) >= 0, name);
    check(H5Pset_fletcher32(list) >= 0, name);
  }
  const Handle set(H5Dcreate2(at, name, type.stored, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose, name);
  check(H5Dwrite(set, type.native, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()) >= 0, name);
  write(set, "unit", std::string(table.unit));
}

template <class Number> std::vector<Number> read_numbers(hid_t at, const char* name, Shape wanted) {
  const auto [set, shape] = open_table(at, name, std::move(wanted));
  std::vector<Number> values(
      std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<hsize_t>()));
  check(H5Dread(set, type_of(values.data()).native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, name);
  return values;
}

} // namespace

void write(hid_t at, const FloatTable& table) {
  write_numbers(at, table, Layout::whole);
}

void write(hid_t at, const Table& table) {
  write_numbers(at, table, table.layout);
}

std::vector<double> read_table(hid_t at, const char* name, Shape wanted) {
  return read_numbers<double>(at, name, std::move(wanted));
}

std::vector<float> read_floats(hid_t at, const char* name, Shape wanted) {
  return read_numbers<float>(at, name, std::move(wanted));
}

std::vector<double> read_columns(hid_t at, const char* name, Shape wanted, std::span<const Columns> runs) {
  const auto [set, shape] = open_table(at, name, std::move(wanted));
  const Handle in_file(H5Dget_space(set), H5Sclose, name);
  const hsize_t rows = shape[0], together = std::min<hsize_t>(rows_of_a_cache_line, rows);
  const hsize_t begin = runs.front().first, width = runs.back().first + runs.back().count - begin;
  hsize_t columns = 0;
  for (const Columns& run : runs)
    columns += run.count;
  std::vector<double> values(rows * columns), part(together * width);
  const Handle unchecked(H5Pcreate(H5P_DATASET_XFER), H5Pclose, name);
  check(H5Pset_edc_check(unchecked, H5Z_DISABLE_EDC) >= 0, name);
  for (hsize_t first = 0; first < rows; first += together) {
    const hsize_t from[] = {first, begin}, count[] = {std::min(together, rows - first), width};
    const Handle in_memory(H5Screate_simple(2, count, nullptr), H5Sclose, name);
    check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, from, nullptr, count, nullptr) >= 0, name);
    check(H5Dread(set, H5T_NATIVE_DOUBLE, in_memory, in_file, unchecked, part.data()) >= 0, name);
    double* to = &values[first];
    for (const Columns& run : runs)
      for (hsize_t column = run.first - begin; column < run.first - begin + run.count; ++column, to += rows)
        for (hsize_t row = 0; row < count[0]; ++row)
          to[row] = part[row * width + column];
  }
  return values;
}

} // namespace bem_contact::strict_h5
