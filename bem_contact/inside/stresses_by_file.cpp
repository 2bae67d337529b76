#include "bem_contact/inside/stresses_by_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"
#include "bem_contact/inside/kernel_sums.hpp"
#include "bem_contact/inside/loaded_inside.hpp"
#include "bem_contact/inside/on_stations.hpp"
#include "bem_contact/inside/remainder.hpp"
#include "bem_contact/inside/waves.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace bem_contact::inside {

namespace {

using halfspace::Stress;

double mean_curvature(const StressKernel& kernel, const std::vector<BelowSurface>& points) {
  const auto [first, last] = std::ranges::minmax(points, {}, &BelowSurface::s);
  const double step = kernel.places[1].s - kernel.places[0].s, from = first.s - step, to = last.s + step;
  return (surface_at(kernel, to).delta - surface_at(kernel, from).delta) / (to - from);
}

void require_reached(const StressKernel& kernel, const std::vector<BelowSurface>& points) {
  for (const BelowSurface& p : points)
    if (p.s < kernel.places.front().s || p.s > kernel.places.back().s || p.depth > kernel.depths.back())
      throw InputError("The influence file has no stresses at one of these points",
                       fmt::format("they reach from s = {:g} to {:g} mm, to a depth of {:g} mm",
                                   kernel.places.front().s, kernel.places.back().s, kernel.depths.back()),
                       "Move it, or compute the file with other keys of [stress].");
}

/// Of a body of revolution the kernel has the half-space subtracted at one angle, and here it is added at one
/// length. So a stress is taken too far along x by the ratio of the radii of load and point, which moves it
/// by at most so much of the largest one there.
void add_error_of_radii(AreaStresses& area, const InfluenceStrip& strip, const StressKernel& kernel,
                        const SurfaceTractions& on) {
  if (strip.reference_radius == 0)
    return;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < on.pn.size(); ++i)
    if (on.at(i) != std::array<double, 3>{}) {
      const Station& station = strip.stations[i / static_cast<std::size_t>(on.columns)];
      const double own = relative_radius(strip.reference_radius, station.position.z);
      least = std::min(least, own);
      most = std::max(most, own);
    }
  for (std::size_t i = 0; i < area.points.size(); ++i) {
    const double own =
        relative_radius(strip.reference_radius, surface_at(kernel, area.points[i].s).position.z);
    double largest = 0;
    for (const Stress& t : area.flat[i])
      largest = std::max(largest, von_mises(t));
    area.error[i] += std::max({0.0, own - least, most - own}) * largest;
  }
}

} // namespace

void add_stresses_by_file(StressesInside& stresses, const SurfaceTractions& tractions,
                          const InfluenceStrip& strip, const StressKernel& kernel) {
  const SurfaceTractions on = on_stations(tractions, strip.stations, strip.station_width);
  const KernelSums sums(strip, kernel, on);
  const double first = kernel.places.front().s, last = kernel.places.back().s;
  for (AreaStresses& area : stresses.areas) {
    if (!area.section)
      require_reached(kernel, area.points);
    const AreaPlan plan(area.points, kernel.depths.front(),
                        [&](const BelowSurface& p) { return p.s >= first && p.s <= last; });
    area.curvature = mean_curvature(kernel, area.points);
    for (const BelowSurface& p : area.points) {
      const ContactRow above = surface_at(kernel, p.s);
      area.positions.push_back(above.position + p.depth * normal_of(above.delta));
    }
    add_remainder(area, plan, sums.at(plan.probes, area.x));
    add_error_of_radii(area, strip, kernel, on);
  }
  stresses.body = strip.profile;
  stresses.wavenumbers = kernel.remainder.wavenumber.size();
}

FileOfStresses::FileOfStresses(const std::filesystem::path& file)
    : strip(InfluenceFile(file).strip()), kernel(read_stress_kernel(file)) {
  if (kernel.empty())
    throw InputError(
        fmt::format("The influence file '{}' has no stresses of the inside", file.string()),
        "its body file did not ask for them",
        "Add [stress] depths = 20 to the body file, and call mesh_body BODY.toml -o BODY.msh and "
        "fem_influence BODY.toml BODY.msh -o FILE.h5 again.");
}

StressesInside stresses_by_file(const record::Record& result, const FileOfStresses& file,
                                std::span<const BelowSurface> own) {
  LoadedInside load = loaded_by(result, file.strip.profile_digest, file.strip.material.poisson, own);
  add_stresses_by_file(load.stresses, load.tractions, file.strip, file.kernel);
  return std::move(load.stresses);
}

} // namespace bem_contact::inside
