#include "bem_contact/influence/influence_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/h5/image.hpp"
#include "bem_contact/h5/strict.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/influence/packed_file.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <string_view>
#include <system_error>
#include <utility>

namespace bem_contact {
namespace {

using strict_h5::read;
using strict_h5::read_columns;
using strict_h5::read_table;
using strict_h5::write;

/// 1. Of an influence file so many times the stations are read that a first contact needs: its patch may
/// grow, and the next case be beside it.
constexpr int first_stations_read = 2;
/// 1. And so many times those that were needed so far, when the contact has left them: each reading goes
/// through the file, 5 ms for 15 MB, so there should be few of them. Chosen, as the one before.
constexpr int more_stations_read = 3;

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

int format_minor_of(const InfluenceStrip& f, const StressKernel& stresses) {
  if (!stresses.empty())
    return stress_format_minor;
  return f.is_table() ? table_format_minor : influence_format_minor;
}

void write_contents(H5Id root, const InfluenceFunction& f, const StressKernel& stresses,
                    strict_h5::Layout chunks) {
  write(root, "format_major", influence_format_major);
  write(root, "format_minor", format_minor_of(f, stresses));
  for_each_scalar(f, [&](const char* name, const auto& value) { write(root, name, value); });
  write(root, "invariance",
        std::string(f.invariance == Invariance::revolution ? revolution_name : prismatic_name));
  const strict_h5::Extent ns = f.station_count(), nk = f.wavenumber_count(), n = 3 * ns;
  std::vector<double> table;
  for (const Station& station : f.stations)
    table.insert(table.end(), {station.s, station.position.y, station.position.z, station.delta});
  write(root, {"stations", {ns, 4}, table, "mm, mm, mm, rad"});
  if (f.is_table()) {
    write(root, "table_dx", f.table_dx);
    std::vector<double> lower;
    for (strict_h5::Extent m = 0; m < f.table_offsets(); ++m)
      append_lower(lower, std::span(f.table).subspan(m * n * n, n * n), n);
    write(root, {"table", {f.table_offsets(), lower_size(n)}, lower, "mm/MPa", chunks});
    return;
  }
  write(root, {"wavenumber", {nk}, f.wavenumber, "1/mm"});
  std::vector<double> kernel;
  kernel.reserve(f.kernel.size());
  for (strict_h5::Extent k = 0; k < nk; ++k)
    for (strict_h5::Extent entry = 0; entry < f.kernel_size(); ++entry)
      kernel.push_back(f.kernel[entry * nk + k]);
  write(root, {"kernel", {nk, lower_size(n)}, kernel, "mm/MPa", chunks});
  write(root, {"remote", {nk, 6, n}, f.remote, "mm/MPa, 1/MPa", chunks});
  write(root, {"remote_self", {nk, 6, 6}, f.remote_self, "mm/MPa and per mm of each rotation"});
  write_stress_kernel(root, stresses, ns);
}

InfluenceStrip read_strip(H5Id root, const std::filesystem::path& file) {
  InfluenceStrip f;
  int major = 0;
  read(root, "format_major", major);
  if (major != influence_format_major) // the seal's first line says it, too
    throw InputError(
        fmt::format("The influence file '{}' says of itself that its format is {}", file.string(), major),
        fmt::format("its first lines say {}", influence_format_major), "Compute it again.");
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
  if (strict_h5::has(root, "table")) {
    read(root, "table_dx", f.table_dx);
    return f;
  }
  f.wavenumber = read_table(root, "wavenumber", {0});
  f.remote = read_table(root, "remote", {f.wavenumber_count(), 6, 3 * f.station_count()});
  f.remote_self = read_table(root, "remote_self", {f.wavenumber_count(), 6, 6});
  return f;
}

/// A table of n x n numbers for each offset, from its lower triangle: the offsets of a number one after the
/// other. The rest by Maxwell-Betti.
std::vector<double> whole_table(std::span<const double> lower, std::size_t n) {
  const std::size_t offsets = lower.size() / lower_size(n);
  std::vector<double> table(offsets * n * n);
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column <= row; ++column) {
      const int sign = parity(static_cast<int>(row % 3), static_cast<int>(column % 3));
      const double* from = &lower[(lower_size(row) + column) * offsets];
      for (std::size_t m = 0; m < offsets; ++m) {
        table[(m * n + column) * n + row] = sign * from[m];
        table[(m * n + row) * n + column] = from[m];
      }
    }
  return table;
}

/// The function on some of the strip's stations.
InfluenceFunction read_part(H5Id root, const InfluenceStrip& strip, StationRange stations) {
  std::vector<strict_h5::Columns> numbers; // of the lower triangle
  const auto first = static_cast<strict_h5::Extent>(3 * stations.first),
             end = static_cast<strict_h5::Extent>(3 * stations.end());
  for (strict_h5::Extent row = first; row < end; ++row)
    numbers.push_back({lower_size(row) + first, row - first + 1});
  const strict_h5::Extent all = lower_size(3 * strip.station_count());
  InfluenceFunction f{part_of(strip, stations)};
  if (f.is_table())
    f.table = whole_table(read_columns(root, "table", {0, all}, numbers), end - first);
  else
    f.kernel = read_columns(root, "kernel", {f.wavenumber_count(), all}, numbers);
  return f;
}

/// The range in the middle of so many times its stations, as far as there are so many.
StationRange amid(StationRange range, int times, int stations) {
  const int count = std::min(times * range.count, stations);
  return {std::clamp(range.first - (count - range.count) / 2, 0, stations - count), count};
}

} // namespace

InfluenceFunction read_influence_file(const std::filesystem::path& file) {
  check_seal(file, influence_format_major);
  const QuietHdf5 quiet;
  const strict_h5::Handle root = strict_h5::open_file(file);
  const InfluenceStrip strip = read_strip(root, file);
  validate(strip);
  InfluenceFunction function = read_part(root, strip, strip.all_stations());
  validate(function);
  return function;
}

InfluenceFile::InfluenceFile(std::filesystem::path file)
    : path_(std::move(file)), state_(state()), checksum_(check_seal(path_, influence_format_major)) {
  const QuietHdf5 quiet;
  strip_ = read_strip(strict_h5::open_file(path_), path_);
  validate(strip_);
}

InfluenceFile::State InfluenceFile::state() const {
  std::error_code gone;
  const std::uintmax_t bytes = std::filesystem::file_size(path_, gone);
  return gone ? State{} : State{bytes, std::filesystem::last_write_time(path_, gone)};
}

const InfluenceFunction& InfluenceFile::around(StationRange stations) {
  if (held_.count > 0 && stations.first >= held_.first && stations.end() <= held_.end())
    return part_;
  require_unchanged();
  const int all = static_cast<int>(strip_.station_count());
  StationRange wanted = amid(stations, first_stations_read, all);
  if (held_.count > 0) {
    const int first = std::min(held_.first, stations.first);
    wanted = amid({first, std::max(held_.end(), stations.end()) - first}, more_stations_read, all);
  }
  const QuietHdf5 quiet;
  InfluenceFunction part = read_part(strict_h5::open_file(path_), strip_, wanted);
  validate(part);
  part_ = std::move(part);
  held_ = wanted;
  return part_;
}

void InfluenceFile::require_unchanged() {
  const State now = state();
  if (now == state_)
    return;
  if (check_seal(path_, influence_format_major) != checksum_)
    throw InputError("The influence file '" + path_.string() + "' is another one than before",
                     "some of its numbers have been used in this run, and others are needed now",
                     "Start again, and leave the file as it is meanwhile.");
  state_ = now;
}

double InfluenceFile::megabytes() const {
  return 1e-6 * sizeof(double) *
         static_cast<double>(strip_.remote.size() + part_.remote.size() + part_.kernel.size() +
                             part_.table.size());
}

namespace {

void write_sealed(const std::filesystem::path& file, const InfluenceFunction& function,
                  const StressKernel& stresses, strict_h5::Layout chunks) {
  validate(function);
  validate(stresses, function.station_count());
  const QuietHdf5 quiet;
  const H5Image image({.user_block = seal_size},
                      [&](H5Id root) { write_contents(root, function, stresses, chunks); });
  seal(std::as_writable_bytes(image.bytes()), influence_format_major, format_minor_of(function, stresses));
  write_whole(file, [&](std::ostream& out) { out << image; });
}

} // namespace

void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function) {
  write_influence_file(file, function, {});
}

void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function,
                          const StressKernel& stresses) {
  write_sealed(file, function, stresses, strict_h5::Layout::chunks);
}

void write_packed_influence_file(const std::filesystem::path& file, const InfluenceFunction& function) {
  write_packed_influence_file(file, function, {});
}

void write_packed_influence_file(const std::filesystem::path& file, const InfluenceFunction& function,
                                 const StressKernel& stresses) {
  write_sealed(file, rounded(function), stresses, strict_h5::Layout::packed);
}

StressKernel read_stress_kernel(const std::filesystem::path& file) {
  check_seal(file, influence_format_major);
  const QuietHdf5 quiet;
  const strict_h5::Handle root = strict_h5::open_file(file);
  return read_stress_kernel(root, read_strip(root, file).station_count());
}

} // namespace bem_contact
