#include "tools/benchmarks/cases/reference.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace cases {

using namespace bem_contact;

namespace {

/// On elements `finer` times as small as the grid's; longer ones where influence files have no numbers for
/// those.
Reference reference_of(SceneFile scene, const SceneFile::Grid& grid, int finer) {
  scene.grid = grid;
  scene.grid.accuracy.reset();
  scene.grid.elements.reset();
  std::string reason;
  for (int along_x = finer; along_x > 0; along_x /= 2)
    try {
      scene.grid.dx = grid.dx / along_x;
      scene.grid.ds = grid.ds / finer;
      const ContactResult r = Sequence().solve(scene).result;
      if (r.certified())
        return {along_x,           r.totals.Fx, r.totals.Fs,          r.totals.Fy,
                r.totals.approach, r.totals.Fz, scene.motion.friction};
      reason = r.trust.solver_note;
    } catch (const Error& error) {
      reason = error.what();
    }
  throw InputError("There is no reference", reason, "Its error is left out.");
}

} // namespace

std::vector<Reference> references(const SweepFile& sweep, const SweepFile& by, int finer, std::size_t every) {
  std::vector<Reference> exact(sweep.size());
  Progress progress("references", sweep.size());
  Sequence sequence;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    const SceneFile::Grid asked = scene.grid;
    scene.grid.accuracy = 0.02;
    scene.grid.accuracy_of = {ErrorQuantity::forces};
    if (i % every == 0)
      try {
        const ContactGrid chosen = sequence.solve(scene).problem.grid;
        scene = by.scene(i);
        scene.grid = asked;
        scene.grid.dx = chosen.dx;
        scene.grid.ds = chosen.ds;
        exact[i] = reference_of(scene, scene.grid, finer);
      } catch (const Error& error) {
        fmt::print(stderr, "case {} ({}): {}\n", i, sweep.describe(i), error.what());
      }
    progress.step();
  }
  progress.finish();
  for (int times = finer; times >= 0; times = times > 1 ? times / 2 : times - 1)
    if (const auto count = std::ranges::count(exact, times, &Reference::finer);
        count > 0 && (times > 0 || every == 1))
      fmt::print(stderr, "{} cases: {}\n", count,
                 times == 0
                     ? "no reference, no error"
                     : fmt::format("reference with elements 1/{} as long, 1/{} as wide", times, finer));
  return exact;
}

double error_of(const ContactResult& r, const Reference& exact) {
  return std::max({std::abs(r.totals.approach / exact.approach - 1),
                   std::hypot(r.totals.Fx - exact.Fx, r.totals.Fs - exact.Fs) / (exact.friction * exact.load),
                   std::abs(r.totals.Fy - exact.Fy) / exact.load});
}

} // namespace cases
