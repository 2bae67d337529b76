#include "bem_contact/influence/influence_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/h5_image.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/influence/strict_h5.hpp"

#include <ostream>
#include <string_view>

namespace bem_contact {
namespace {

using strict_h5::read;
using strict_h5::read_columns;
using strict_h5::read_table;
using strict_h5::write;

constexpr std::string_view prismatic_name = "prismatic", revolution_name = "revolution";

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
  write(root, "format_major", influence_format_major);
  write(root, "format_minor", format_minor_of(f));
  for_each_scalar(f, [&](const char* name, const auto& value) { write(root, name, value); });
  write(root, "invariance",
        std::string(f.invariance == Invariance::revolution ? revolution_name : prismatic_name));
  const hsize_t ns = f.station_count(), nk = f.wavenumber_count(), n = 3 * ns;
  std::vector<double> table;
  for (const Station& station : f.stations)
    table.insert(table.end(), {station.s, station.position.y, station.position.z, station.delta});
  write(root, {"stations", {ns, 4}, table, "mm, mm, mm, rad"});
  if (f.is_table()) {
    write(root, "table_dx", f.table_dx);
    std::vector<double> lower;
    for (hsize_t m = 0; m < f.table_offsets(); ++m)
      append_lower(lower, std::span(f.table).subspan(m * n * n, n * n), n);
    write(root, {"table", {f.table_offsets(), lower_size(n)}, lower, "mm/MPa", true});
    return;
  }
  write(root, {"wavenumber", {nk}, f.wavenumber, "1/mm"});
  std::vector<double> kernel;
  kernel.reserve(f.kernel.size());
  for (hsize_t k = 0; k < nk; ++k)
    for (hsize_t entry = 0; entry < f.kernel_size(); ++entry)
      kernel.push_back(f.kernel[entry * nk + k]);
  write(root, {"kernel", {nk, lower_size(n)}, kernel, "mm/MPa", true});
  write(root, {"remote", {nk, 6, n}, f.remote, "mm/MPa, 1/MPa", true});
  write(root, {"remote_self", {nk, 6, 6}, f.remote_self, "mm/MPa and per mm of each rotation"});
}

InfluenceFunction read_contents(const std::filesystem::path& file) {
  const strict_h5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                               "opening '" + file.string() + "'");
  InfluenceFunction f;
  for_each_scalar(f, [&](const char* name, auto& value) { read(root, name, value); });
  std::string invariance;
  read(root, "invariance", invariance);
  if (invariance != prismatic_name && invariance != revolution_name)
    throw InputError("The influence file '" + file.string() + "' has the invariance '" + invariance + "'",
                     "there are 'prismatic' and 'revolution'", "Compute it again.");
  f.invariance = invariance == revolution_name ? Invariance::revolution : Invariance::prismatic;
  const std::vector<double> stations = read_table(root, "stations", {0, 4});
  for (std::size_t i = 0; i < stations.size(); i += 4)
    f.stations.push_back({stations[i], {stations[i + 1], stations[i + 2]}, stations[i + 3]});
  const hsize_t n = 3 * f.station_count();
  if (n > 0 && H5Lexists(root, "table", H5P_DEFAULT) > 0) {
    read(root, "table_dx", f.table_dx);
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
  f.kernel = read_columns(root, "kernel", {nk, lower_size(n)});
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
