#include "bem_contact/influence/influence_function.hpp"

#include "bem_contact/base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <span>

namespace bem_contact {
namespace {

/// 1 (station widths). How unequally stations may be spaced: the rounding of s in a file.
constexpr double station_spacing_slack = 1e-6;
/// 1 (share of half a turn). How far the half period of a body of revolution may be off: rounding.
constexpr double half_turn_slack = 1e-9;

[[noreturn]] void refuse(const std::string& problem, const std::string& why) {
  throw InputError("The influence function is not valid: " + problem, why,
                   "Compute the influence file again.");
}

void require(bool holds, const std::string& problem, const std::string& why) {
  if (!holds)
    refuse(problem, why);
}

void require_length(std::span<const double> values, std::size_t expected, const std::string& name) {
  require(values.size() == expected, name + " has the wrong size",
          fmt::format("{} numbers where its tables ask for {}", values.size(), expected));
}

void require_finite(std::span<const double> values, const std::string& name) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad != values.end())
    refuse(name + " is not finite", fmt::format("its entry {} is NaN or infinite", bad - values.begin()));
}

void validate_metadata(const InfluenceDescription& f) {
  require(std::isfinite(f.material.shear_modulus) && f.material.shear_modulus > 0,
          "its shear modulus is not positive", fmt::format("{} MPa", f.material.shear_modulus));
  require(f.material.poisson >= 0 && f.material.poisson < 0.5, "its Poisson ratio is outside [0, 0.5)",
          fmt::to_string(f.material.poisson));
  require(std::isfinite(f.half_period) && f.half_period > 0, "its half period is not positive",
          fmt::format("{} mm", f.half_period));
  require(std::isfinite(f.betti_error) && std::isfinite(f.reaction_error) && std::isfinite(f.estimated_error),
          "one of its error estimates is not finite",
          "the Betti, reaction and estimated errors must be numbers");
  if (f.invariance == Invariance::revolution) {
    require(std::isfinite(f.reference_radius) && f.reference_radius != 0, "it has no reference radius",
            fmt::format("{} mm", f.reference_radius));
    const double half_turn = std::numbers::pi * std::abs(f.reference_radius);
    require(std::abs(f.half_period - half_turn) <= half_turn_slack * half_turn,
            "the half period of a body of revolution is not half a turn",
            fmt::format("{:.9g} mm, pi times its reference radius is {:.9g}", f.half_period, half_turn));
  }
}

void validate_stations(const InfluenceStrip& f) {
  require(!f.stations.empty(), "it has no stations", "the strip is empty");
  require(std::isfinite(f.station_width) && f.station_width > 0, "its station width is not positive",
          fmt::format("{} mm", f.station_width));
  for (std::size_t i = 0; i < f.stations.size(); ++i) {
    const Station& station = f.stations[i];
    const std::string name = fmt::format("station {}", i);
    const std::array<double, 4> values = {station.s, station.position.y, station.position.z, station.delta};
    require_finite(values, name);
    const double expected = f.stations.front().s + static_cast<double>(i) * f.station_width;
    require(std::abs(station.s - expected) <= station_spacing_slack * f.station_width,
            "its stations are not equally spaced",
            fmt::format("{} is at s = {:.9g} mm, not {:.9g}", name, station.s, expected));
  }
}

void validate_wavenumbers(const InfluenceStrip& f) {
  require(!f.wavenumber.empty(), "it has no wavenumbers", "the kernel is empty");
  require_finite(f.wavenumber, "its wavenumber table");
  require(f.wavenumber.front() == 0, "its first wavenumber is not 0",
          fmt::format("{} 1/mm", f.wavenumber.front()));
  for (std::size_t k = 1; k < f.wavenumber.size(); ++k)
    require(f.wavenumber[k] > f.wavenumber[k - 1], "its wavenumbers do not ascend",
            fmt::format("entry {}", k));
}

void validate_remote(const InfluenceStrip& f) {
  const std::size_t n = 3 * f.station_count(), nk = f.wavenumber_count();
  require_length(f.remote, nk * 6 * n, "its table of remote motions");
  require_length(f.remote_self, nk * 36, "its table of the remote section's own compliance");
  require_finite(f.remote, "its table of remote motions");
  require_finite(f.remote_self, "its table of the remote section's own compliance");
}

void validate_kernel(const InfluenceFunction& f) {
  require_length(f.kernel, f.wavenumber_count() * f.kernel_size(), "its kernel");
  require_finite(f.kernel, "its kernel");
  const std::size_t n = 3 * f.station_count();
  for (std::size_t k = 0; k < f.wavenumber_count(); ++k)
    for (std::size_t row = 0; row < n; ++row)
      if (!(f.kernel[f.kernel_index(k, row, row)] > 0))
        refuse("its kernel's diagonal is not positive",
               fmt::format("at wavenumber {} 1/mm, row {}", f.wavenumber[k], row));
}

void validate_table(const InfluenceFunction& f) {
  require(f.kernel.empty(), "it has both a kernel and a table", "one of them says all");
  require(f.table_offsets() > 0, "its table is empty", "no offsets");
  const std::size_t n = 3 * f.station_count();
  require_length(f.table, f.table_offsets() * n * n, "its table");
  require_finite(f.table, "its table");
  for (std::size_t row = 0; row < n; ++row)
    require(f.table[row * n + row] > 0, "its table's diagonal is not positive", fmt::format("row {}", row));
  for (std::size_t m = 0; m < f.table_offsets(); ++m)
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column <= row; ++column) {
        const double a = f.table[(m * n + row) * n + column], b = f.table[(m * n + column) * n + row];
        if (a != parity(static_cast<int>(row % 3), static_cast<int>(column % 3)) * b)
          refuse("its table is not reciprocal", fmt::format("offset {}, row {}, column {}", m, row, column));
      }
}

} // namespace

InfluenceStrip part_of(const InfluenceStrip& strip, StationRange range) {
  const auto first = static_cast<std::ptrdiff_t>(range.first),
             count = static_cast<std::ptrdiff_t>(range.count);
  InfluenceStrip part{strip};
  part.stations.assign(strip.stations.begin() + first, strip.stations.begin() + first + count);
  part.remote.clear();
  const auto columns = static_cast<std::ptrdiff_t>(3 * strip.station_count());
  for (auto row = strip.remote.begin(); row != strip.remote.end(); row += columns)
    part.remote.insert(part.remote.end(), row + 3 * first, row + 3 * (first + count));
  return part;
}

void validate(const InfluenceStrip& f) {
  validate_metadata(f);
  validate_stations(f);
  if (f.table_dx == 0) {
    validate_wavenumbers(f);
    return validate_remote(f);
  }
  require(std::isfinite(f.table_dx) && f.table_dx > 0, "the element length of its table is not positive",
          fmt::format("{} mm", f.table_dx));
  require(f.wavenumber.empty() && f.remote.empty() && f.remote_self.empty(),
          "it has both a kernel and a table", "one of them says all");
}

void validate(const InfluenceFunction& f) {
  require(f.table.empty() || f.table_dx != 0, "its table has no element length", "table_dx is 0");
  validate(static_cast<const InfluenceStrip&>(f));
  f.is_table() ? validate_table(f) : validate_kernel(f);
}

} // namespace bem_contact
