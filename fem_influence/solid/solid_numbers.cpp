#include "fem_influence/solid/solid_numbers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/memory.hpp"
#include "fem_influence/shared/settings.hpp"
#include "fem_influence/shared/sparse_columns.hpp"
#include "fem_influence/solid/patch_functionals.hpp"
#include "fem_influence/solid/solid_body.hpp"
#include "fem_influence/solid/solid_solver.hpp"
#include "fem_influence/solid/solid_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <string>

namespace bem_contact::fem {

namespace {

/// mm. Samples lie within about this distance of the load. Farther away only the body's motion as a whole
/// counts, and elements may grow faster.
constexpr double accurate_distance = 20.0;

std::vector<SurfacePatch> sample_patches(const SolidNumbers& numbers) {
  std::vector<SurfacePatch> patches;
  for (int m = 0; m < numbers.offsets; ++m)
    for (const Station& station : numbers.stations)
      patches.push_back({station.s - numbers.ds / 2, station.s + numbers.ds / 2,
                         std::max(0.0, (m - 0.5) * numbers.dx), (m + 0.5) * numbers.dx});
  return patches;
}

/// Columns 3 P + j of the patches and components given.
std::vector<std::size_t> columns_of(std::span<const int> patches, std::span<const int> components) {
  std::vector<std::size_t> columns;
  for (const int p : patches)
    for (const int j : components)
      columns.push_back(static_cast<std::size_t>(3 * p + j));
  return columns;
}

/// Largest asymmetry at x = 0 between the loads of one mesh, which is that of the solver alone.
double betti_error(const SolidNumbers& a, std::size_t first, std::size_t last) {
  double worst = 0;
  for (std::size_t p = first; p < last; ++p)
    for (std::size_t q = first; q < p; ++q)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double here = a.at(p, j, 0, a.loads[q], i), there = a.at(q, i, 0, a.loads[p], j);
          const double scale = std::sqrt(a.at(p, j, 0, a.loads[p], j) * a.at(q, i, 0, a.loads[q], i));
          worst = std::max(worst, std::abs(here - parity(i, j) * there) / scale);
        }
  return worst;
}

/// Numbers of nothing yet: stations, elements and checked loads.
SolidNumbers empty_numbers(const BodyFile& body, const ProfileCurve& curve, std::vector<int> loads) {
  SolidNumbers numbers;
  numbers.stations = make_stations(body.strip, curve);
  numbers.ds = body.strip.station_width;
  numbers.dx = body.solid.dx > 0 ? body.solid.dx : numbers.ds;
  numbers.offsets = body.solid.offsets;
  const auto count = static_cast<int>(numbers.stations.size());
  std::sort(loads.begin(), loads.end());
  for (const int load : loads)
    if (load < 0 || load >= count)
      throw InputError(fmt::format("There is no station {} to load", load),
                       fmt::format("the strip has {}, counted from 0", count), "Choose another one.");
  numbers.loads = std::move(loads);
  numbers.values.assign(
      numbers.loads.size() * 9 * static_cast<std::size_t>(numbers.offsets) * numbers.stations.size(), 0.0);
  return numbers;
}

/// Puts the means of one load and component, `sampled`[3 patch + i], into their places.
void store(SolidNumbers& numbers, std::size_t load, int j, std::span<const SurfacePatch> patches,
           std::span<const double> sampled) {
  const auto count = static_cast<int>(numbers.stations.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (int i = 0; i < 3; ++i) {
      const int m = static_cast<int>(p) / count, row = static_cast<int>(p) % count;
      // The half element at x = 0 stands for a whole one, over which odd ones vanish.
      numbers.at(load, j, m, row, i) =
          m == 0 && parity(i, j) < 0 ? 0 : sampled[3 * p + static_cast<std::size_t>(i)] / patches[p].area();
    }
}

/// Loads first .. last - 1, all on one mesh that is fine around them.
void solve_on_one_mesh(SolidNumbers& numbers, std::size_t first, std::size_t last, const BodyFile& body,
                       const SolidMesh& mesh, const FieldWanted& field) {
  const std::span<const int> group = std::span(numbers.loads).subspan(first, last - first);
  std::vector<SurfacePoint> centres;
  for (const int load : group)
    centres.push_back({numbers.stations[static_cast<std::size_t>(load)].s, 0});
  const SolidBody solid(mesh, body.solid.degree,
                        {.loads = centres,
                         .load_radius = std::hypot(numbers.dx, numbers.ds) / 2,
                         .smallest = std::min(numbers.dx, numbers.ds) / body.solid.elements_per_load,
                         .grading = body.solid.grading,
                         .reach = accurate_distance});
  const std::vector<SurfacePatch> patches = sample_patches(numbers);
  const SparseColumns functionals = patch_functionals(solid, mesh.surface(), patches);
  const SolidSolver solver(solid, body.material);
  SolidReport& report = numbers.report;
  report.cells = std::max(report.cells, solid.cell_count());
  report.unknowns = std::max(report.unknowns, solver.unknowns(MirrorSymmetry::even));
  const auto solve = [&](MirrorSymmetry symmetry, std::span<const int> components) {
    solver.solve(symmetry, select_columns(functionals, columns_of(group, components)), functionals,
                 [&](std::size_t column, std::span<const double> sampled, std::span<const double> u) {
                   const std::size_t load = first + column / components.size();
                   const int j = components[column % components.size()];
                   store(numbers, load, j, patches, sampled);
                   if (!field.file.empty() && field.station == numbers.loads[load] && field.component == j)
                     solid.write_vtu(field.file, u);
                 });
  };
  solve(MirrorSymmetry::even, std::array<int, 2>{component_s, component_n});
  solve(MirrorSymmetry::odd, std::array<int, 1>{component_x});
  report.betti_error = std::max(report.betti_error, betti_error(numbers, first, last));
}

} // namespace

SolidNumbers solid_numbers(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                           SolidRequest request) {
  double seconds = 0;
  SolidNumbers numbers = empty_numbers(body, curve, std::move(request.loads));
  {
    const TimedScope timer(seconds);
    const SolidMesh solid_mesh(mesh, ContactSurface(curve, reference_radius_of(body)));
    const std::size_t loads = numbers.loads.size();
    if (request.progress)
      request.progress(0, loads);
    const auto at_once = static_cast<std::size_t>(body.solid.loads_at_once);
    for (std::size_t first = 0; first < loads; first += at_once) {
      const std::size_t last = std::min(first + at_once, loads);
      solve_on_one_mesh(numbers, first, last, body, solid_mesh, request.field);
      if (request.progress)
        request.progress(last, loads);
    }
  }
  numbers.report.peak_memory = peak_memory();
  numbers.report.seconds = seconds;
  return numbers;
}

} // namespace bem_contact::fem
