#include "bem_contact/influence/influence_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/h5_handle.hpp"
#include "bem_contact/influence/h5_image.hpp"
#include "bem_contact/influence/lower_triangle.hpp"

#include <functional>
#include <numeric>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <utility>

namespace bem_contact {
namespace {

constexpr std::string_view prismatic_name = "prismatic", revolution_name = "revolution";

/// A handle that throws when the call that made it failed.
class Handle : public H5Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t), std::string_view what) : H5Handle(id, close) {
    if (id < 0)
      throw InputError("HDF5 failed at " + std::string(what),
                       "see data/INFLUENCE_FORMAT.md for what is expected",
                       "compute the influence file again");
  }
};

void check(herr_t status, std::string_view what) {
  if (status < 0)
    throw InputError("HDF5 failed at " + std::string(what), "the disk may be full or the file damaged",
                     "make room, or compute the influence file again");
}

// --- one pair of functions, write and read, for each kind of entry ---------------------------------

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

template <class Number> void write_attribute(hid_t at, const char* name, Number value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(at, name, file_type<Number>(), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         name);
  check(H5Awrite(attribute, memory_type<Number>(), &value), name);
}

/// Fixed length: text of variable length lies in HDF5's global heap, which has no checksum.
void write_attribute(hid_t at, const char* name, const std::string& value) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
  check(H5Tset_size(type, value.size() + 1), "a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "a text type");
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  check(H5Awrite(attribute, type, value.c_str()), name);
}

void require_scalar(hid_t attribute, H5T_class_t wanted, const char* name) {
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Tget_class(type) != wanted)
    throw InputError("the influence file's attribute '" + std::string(name) +
                         "' is not one value of the right type",
                     "see data/INFLUENCE_FORMAT.md", "compute the influence file again");
}

template <class Number> void read_attribute(hid_t at, const char* name, Number& value) {
  const Handle attribute(H5Aopen(at, name, H5P_DEFAULT), H5Aclose, std::string("the attribute ") + name);
  require_scalar(attribute, std::is_same_v<Number, double> ? H5T_FLOAT : H5T_INTEGER, name);
  check(H5Aread(attribute, memory_type<Number>(), &value), name);
}

void read_attribute(hid_t at, const char* name, std::string& value) {
  const Handle attribute(H5Aopen(at, name, H5P_DEFAULT), H5Aclose, std::string("the attribute ") + name);
  require_scalar(attribute, H5T_STRING, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Tis_variable_str(type) > 0) {
    const Handle memory(H5Tcopy(type), H5Tclose, name);
    char* text = nullptr;
    check(H5Aread(attribute, memory, &text), name);
    value = text ? text : "";
    H5free_memory(text);
    return;
  }
  value.assign(H5Tget_size(type), '\0');
  const Handle memory(H5Tcopy(type), H5Tclose, name);
  check(H5Aread(attribute, memory, value.data()), name);
  value.erase(std::min(value.find('\0'), value.size()));
}

using Shape = std::vector<hsize_t>;

/// `checked`: in chunks of one wavenumber, each with a checksum. Not compressed: of eight bytes of a kernel
/// six cannot be, and gzip took longer than all other writing.
void write_table(hid_t at, const char* name, const Shape& shape, std::span<const double> values,
                 const char* unit, bool checked = false) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, name);
  const Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  check(H5Pset_obj_track_times(list, false), name); // the same numbers give the same bytes
  if (checked) {
    Shape chunk = shape;
    chunk.front() = 1;
    check(H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data()), name);
    check(H5Pset_fletcher32(list), name);
  }
  const Handle set(H5Dcreate2(at, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose,
                   name);
  check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  write_attribute(set, "unit", std::string(unit));
}

struct Table {
  Handle set;
  Shape shape;
};

/// `shape`: the extents wanted, 0 where any will do.
Table open_table(hid_t at, const char* name, Shape shape) {
  Handle set(H5Dopen2(at, name, H5P_DEFAULT), H5Dclose, std::string("the table ") + name);
  const Handle space(H5Dget_space(set), H5Sclose, name);
  const Handle type(H5Dget_type(set), H5Tclose, name);
  Shape found(shape.size());
  const bool fits = H5Tget_class(type) == H5T_FLOAT &&
                    H5Sget_simple_extent_ndims(space) == static_cast<int>(shape.size()) &&
                    H5Sget_simple_extent_dims(space, found.data(), nullptr) >= 0;
  for (std::size_t i = 0; fits && i < shape.size(); ++i)
    if (shape[i] == 0 && found[i] > 0 && found[i] < 1000000)
      shape[i] = found[i];
  if (!fits || found != shape)
    throw InputError("the influence file's table '" + std::string(name) + "' has the wrong shape or type",
                     "it does not fit the file's stations and wavenumbers",
                     "compute the influence file again");
  return {std::move(set), std::move(shape)};
}

std::vector<double> read_table(hid_t at, const char* name, Shape wanted) {
  const auto [set, shape] = open_table(at, name, std::move(wanted));
  std::vector<double> values(
      std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<hsize_t>()));
  check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  return values;
}

// --- the contents -----------------------------------------------------------------------------------

/// Calls entry(name, member) for each scalar of the format, so that reading and writing cannot differ.
template <class Function, class Entry> void for_each_scalar(Function& f, Entry&& entry) {
  entry("body", f.body);
  entry("profile", f.profile);
  entry("profile_digest", f.profile_digest);
  entry("shear_modulus", f.material.shear_modulus);
  entry("poisson", f.material.poisson);
  entry("held", f.held);
  entry("method", f.method);
  entry("reference_radius", f.reference_radius);
  entry("half_period", f.half_period);
  entry("station_width", f.station_width);
  entry("betti_error", f.betti_error);
  entry("reaction_error", f.reaction_error);
  entry("estimated_error", f.estimated_error);
}

int format_minor_of(const InfluenceFunction& f) {
  return f.is_table() ? table_format_minor : influence_format_minor;
}

/// The upper triangles of a table by Maxwell-Betti.
void reflect(std::vector<double>& table, std::size_t n) {
  for (std::size_t m = 0; m < table.size() / (n * n); ++m)
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < row; ++column)
        table[(m * n + column) * n + row] = parity(static_cast<int>(row % 3), static_cast<int>(column % 3)) *
                                            table[(m * n + row) * n + column];
}

void write_contents(hid_t root, const InfluenceFunction& f) {
  write_attribute(root, "format_major", influence_format_major);
  write_attribute(root, "format_minor", format_minor_of(f));
  for_each_scalar(f, [&](const char* name, const auto& value) { write_attribute(root, name, value); });
  write_attribute(root, "invariance",
                  std::string(f.invariance == Invariance::revolution ? revolution_name : prismatic_name));
  const hsize_t ns = f.station_count(), nk = f.wavenumber_count(), n = 3 * ns;
  std::vector<double> table;
  for (const Station& station : f.stations)
    table.insert(table.end(), {station.s, station.position.y, station.position.z, station.delta});
  write_table(root, "stations", {ns, 4}, table, "mm, mm, mm, rad");
  if (f.is_table()) {
    write_attribute(root, "table_dx", f.table_dx);
    std::vector<double> lower;
    for (hsize_t m = 0; m < f.table_offsets(); ++m)
      append_lower(lower, std::span(f.table).subspan(m * n * n, n * n), n);
    write_table(root, "table", {f.table_offsets(), lower_size(n)}, lower, "mm/MPa", true);
    return;
  }
  write_table(root, "wavenumber", {nk}, f.wavenumber, "1/mm");
  write_table(root, "kernel", {nk, lower_size(n)}, f.kernel, "mm/MPa", true);
  write_table(root, "remote", {nk, 6, n}, f.remote, "mm/MPa, 1/MPa", true);
  write_table(root, "remote_self", {nk, 6, 6}, f.remote_self, "mm/MPa and per mm of each rotation");
}

InfluenceFunction read_contents(const std::filesystem::path& file) {
  const Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                    "opening '" + file.string() + "'");
  InfluenceFunction f;
  for_each_scalar(f, [&](const char* name, auto& value) { read_attribute(root, name, value); });
  std::string invariance;
  read_attribute(root, "invariance", invariance);
  if (invariance != prismatic_name && invariance != revolution_name)
    throw InputError("the influence file '" + file.string() + "' has the invariance '" + invariance + "'",
                     "there are 'prismatic' and 'revolution'", "compute it again");
  f.invariance = invariance == revolution_name ? Invariance::revolution : Invariance::prismatic;
  const std::vector<double> stations = read_table(root, "stations", {0, 4});
  for (std::size_t i = 0; i < stations.size(); i += 4)
    f.stations.push_back({stations[i], {stations[i + 1], stations[i + 2]}, stations[i + 3]});
  const hsize_t n = 3 * f.station_count();
  if (n > 0 && H5Lexists(root, "table", H5P_DEFAULT) > 0) {
    read_attribute(root, "table_dx", f.table_dx);
    const std::vector<double> lower = read_table(root, "table", {0, lower_size(n)});
    f.table.resize(lower.size() / lower_size(n) * n * n);
    for (hsize_t m = 0; m < f.table_offsets(); ++m)
      fill_symmetric(std::span(f.table).subspan(m * n * n, n * n),
                     std::span(lower).subspan(m * lower_size(n), lower_size(n)), n);
    reflect(f.table, n);
    return f;
  }
  f.wavenumber = read_table(root, "wavenumber", {0});
  const hsize_t nk = f.wavenumber_count();
  f.kernel = read_table(root, "kernel", {nk, lower_size(n)});
  f.remote = read_table(root, "remote", {nk, 6, n});
  f.remote_self = read_table(root, "remote_self", {nk, 6, 6});
  return f;
}

} // namespace

InfluenceFunction read_influence_file(const std::filesystem::path& file) {
  check_seal(file, influence_format_major);
  const QuietHdf5 quiet;
  InfluenceFunction function = read_contents(file);
  validate(function);
  return function;
}

void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function) {
  validate(function);
  const QuietHdf5 quiet;
  const H5Image image(seal_size, [&](hid_t root) { write_contents(root, function); });
  seal(std::as_writable_bytes(image.bytes()), influence_format_major, format_minor_of(function));
  write_whole(file, [&](std::ostream& out) { out << image; });
}

} // namespace bem_contact
