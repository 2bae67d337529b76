#include "tools/benchmarks/cases/tables.hpp"

#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace cases {

using namespace bem_contact;

namespace {

struct Cost {
  double seconds = 1e30;
  SceneResult result;
};

/// The least CPU seconds of some solutions from nothing, on the grid given.
Cost cost_of(const SceneFile& scene) {
  Cost cost;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const std::clock_t start = std::clock();
    SceneResult r = Sequence().solve(scene);
    cost.seconds = std::min(cost.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
    cost.result = std::move(r);
  }
  return cost;
}

/// Rows s_from .. s_to of a result's grid that are in contact, and the vertical force on them.
struct Part {
  double s_from = 0, s_to = 0, force = 0;
};

/// Contact parted where at least `apart` mm are without.
std::vector<Part> parts_of(const SceneResult& r, double apart) {
  const ContactGrid& grid = r.problem.grid;
  std::vector<Part> parts;
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = r.problem.rows[is];
    double force = 0;
    bool touches = false;
    for (int i = is * grid.mx; i < (is + 1) * grid.mx; ++i) {
      touches = touches || r.result.pn[i] > 0;
      force +=
          (r.result.pn[i] * std::cos(row.delta) + r.result.ps[i] * std::sin(row.delta)) * grid.dx * grid.ds;
    }
    if (!touches)
      continue;
    if (parts.empty() || row.s - parts.back().s_to > apart)
      parts.push_back({row.s, row.s, 0});
    parts.back().s_to = row.s;
    parts.back().force += force;
  }
  return parts;
}

} // namespace

/// Each area alone: on the same elements, with the force that it bears and the same creepages.
void areas(const SweepFile& sweep) {
  constexpr double apart = 2; // mm
  fmt::print("{:>4} {:>10} {:>8} {:>12} {:>22} {:>8}\n", "case", "grid", "contact", "together ms", "alone ms",
             "ratio");
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    SequenceFiles files; // one area alone would choose a rolling radius of its own
    scene.motion.rolling_radius = prepare_case(scene, files).setup.motion.creepage.rolling_radius;
    const ContactGrid chosen = Sequence().solve(scene).problem.grid;
    scene.grid.accuracy.reset();
    scene.grid.elements.reset();
    scene.grid.dx = chosen.dx;
    scene.grid.ds = chosen.ds;
    const Cost both = cost_of(scene);
    const std::vector<Part> parts = parts_of(both.result, apart);
    double sum = 0;
    std::string alone;
    for (const Part& part : parts) {
      SceneFile one = scene;
      one.load.force = part.force;
      one.grid.rows = {part.s_from - 4 * chosen.ds, part.s_to + 4 * chosen.ds};
      const double seconds = cost_of(one).seconds;
      sum += seconds;
      alone += fmt::format("{:.1f} ", 1e3 * seconds);
    }
    const ContactGrid& grid = both.result.problem.grid;
    fmt::print("{:>4} {:>10} {:>8} {:>12.1f} {:>22} {:>8.2f}\n", i, fmt::format("{} x {}", grid.mx, grid.ms),
               std::ranges::count_if(both.result.result.pn, [](double p) { return p > 0; }),
               1e3 * both.seconds, alone, both.seconds / sum);
  }
}

} // namespace cases
