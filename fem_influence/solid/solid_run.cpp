#include "fem_influence/solid/solid_run.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/shared/strip.hpp"
#include "fem_influence/solid/solid_solver.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bem_contact::fem {

namespace {

// Samples lie within about this distance, mm; farther away only the body's motion as a whole counts, and
// elements may grow faster.
constexpr double accurate_reach = 20;

std::vector<SurfacePatch> sample_patches(const SolidNumbers& numbers) {
  std::vector<SurfacePatch> patches;
  for (int m = 0; m < numbers.offsets; ++m)
    for (const Station& station : numbers.stations)
      patches.push_back({station.s - numbers.ds / 2, station.s + numbers.ds / 2,
                         std::max(0.0, (m - 0.5) * numbers.dx), (m + 0.5) * numbers.dx});
  return patches;
}

/// Columns 3 P + j of the patches given, for the components given.
SparseColumns pick(const SparseColumns& from, std::span<const int> patches, std::span<const int> components) {
  SparseColumns to;
  for (const int p : patches)
    for (const int j : components) {
      const auto c = static_cast<std::size_t>(3 * p + j);
      to.row.insert(to.row.end(), from.row.begin() + static_cast<std::ptrdiff_t>(from.column_begin[c]),
                    from.row.begin() + static_cast<std::ptrdiff_t>(from.column_begin[c + 1]));
      to.value.insert(to.value.end(), from.value.begin() + static_cast<std::ptrdiff_t>(from.column_begin[c]),
                      from.value.begin() + static_cast<std::ptrdiff_t>(from.column_begin[c + 1]));
      to.column_begin.push_back(to.row.size());
    }
  return to;
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

} // namespace

SolidNumbers solid_numbers(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                           std::vector<int> loads, SolidReport& report, const FieldWanted& field,
                           const SolidProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  SolidNumbers result;
  result.stations = make_stations(body.strip, curve);
  result.ds = body.strip.station_width;
  result.dx = body.solid.dx > 0 ? body.solid.dx : result.ds;
  result.offsets = body.solid.offsets;
  const auto count = static_cast<int>(result.stations.size());
  std::sort(loads.begin(), loads.end());
  for (const int load : loads)
    if (load < 0 || load >= count)
      throw InputError("There is no station " + std::to_string(load) + " to load",
                       "the strip has " + std::to_string(count) + ", counted from 0", "choose another one");
  result.loads = loads;
  const std::size_t of_load = 9 * static_cast<std::size_t>(result.offsets) * result.stations.size();
  result.values.assign(loads.size() * of_load, 0.0);

  const ContactSurface surface(curve, reference_radius_of(body));
  SolidBody solid(mesh, surface, body.solid.degree);
  const std::vector<SurfacePatch> patches = sample_patches(result);
  const double shortest = std::min(result.dx, result.ds);
  if (progress)
    progress(0, loads.size());
  const auto at_once = static_cast<std::size_t>(body.solid.loads_at_once);
  for (std::size_t first = 0; first < loads.size(); first += at_once) {
    const std::size_t last = std::min(first + at_once, loads.size());
    const std::span<const int> group = std::span(loads).subspan(first, last - first);
    std::vector<SurfacePoint> centres;
    for (const int load : group)
      centres.push_back({result.stations[static_cast<std::size_t>(load)].s, 0});
    solid.refine(centres, std::hypot(result.dx, result.ds) / 2, shortest / body.solid.elements_per_load,
                 body.solid.grading, accurate_reach);
    const SparseColumns functionals = patch_functionals(solid, surface, patches);
    const SolidSolver solver(solid, body.material);
    report.cells = std::max(report.cells, solid.cell_count());
    report.unknowns = std::max(report.unknowns, solver.unknowns(MirrorSymmetry::even));

    const auto run = [&](MirrorSymmetry symmetry, std::span<const int> components) {
      solver.solve(symmetry, pick(functionals, group, components), functionals,
                   [&](std::size_t column, std::span<const double> sampled, std::span<const double> u) {
                     const std::size_t load = first + column / components.size();
                     const int j = components[column % components.size()];
                     for (std::size_t p = 0; p < patches.size(); ++p)
                       for (int i = 0; i < 3; ++i) {
                         const int m = static_cast<int>(p) / count, row = static_cast<int>(p) % count;
                         // The half element at x = 0 stands for a whole one, over which odd ones vanish.
                         result.at(load, j, m, row, i) =
                             m == 0 && parity(i, j) < 0
                                 ? 0
                                 : sampled[3 * p + static_cast<std::size_t>(i)] / patches[p].area();
                       }
                     if (!field.file.empty() && field.station == loads[load] && field.component == j)
                       solid.write_vtu(field.file, u);
                   });
    };
    run(MirrorSymmetry::even, std::array{1, 2});
    run(MirrorSymmetry::odd, std::array{0});
    report.betti_error = std::max(report.betti_error, betti_error(result, first, last));
    if (progress)
      progress(last, loads.size());
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  report.peak_memory = static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace bem_contact::fem
