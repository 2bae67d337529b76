#include "tools/benchmarks/cases/tables.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>

namespace cases {

using namespace bem_contact;

namespace {

constexpr int finer = 4; // elements of the reference: so many times as short, and as narrow

/// Of the contact, from the first to the last element, mm.
struct Extent {
  double x = 0, s = 0;
};

Extent extent_of(const SceneResult& r) {
  const ContactGrid& grid = r.problem.grid;
  int x0 = grid.mx, x1 = -1, s0 = grid.ms, s1 = -1;
  for (int i = 0; i < grid.size(); ++i)
    if (r.result.pn[i] > 0) {
      x0 = std::min(x0, i % grid.mx), x1 = std::max(x1, i % grid.mx);
      s0 = std::min(s0, i / grid.mx), s1 = std::max(s1, i / grid.mx);
    }
  return {(x1 - x0 + 1) * grid.dx, (s1 - s0 + 1) * grid.ds};
}

/// Makes a patch's grid a quarter larger than its contact, with the number of elements that it has. One row
/// or column keeps its width.
void fit_grid(SceneFile& scene) {
  for (int round = 0; round < 4 && scene.kind == SceneKind::patch; ++round) {
    const SceneResult r = Sequence().solve(scene);
    const Extent contact = extent_of(r);
    const double reserve = r.result.trust.touches_border ? 1.4 : 1.25;
    const auto fitted = [&](double length, int count, double element) {
      return std::max(0.3 * element, reserve * length / count);
    };
    if (*scene.grid.mx > 1)
      scene.grid.dx = fitted(contact.x, *scene.grid.mx, scene.grid.dx);
    if (*scene.grid.ms > 1)
      scene.grid.ds = fitted(contact.s, *scene.grid.ms, scene.grid.ds);
  }
}

/// One row or one column stays one.
SceneFile on_finer_grid(SceneFile scene, const ContactGrid& grid) {
  const int along = grid.mx == 1 ? 1 : finer, across = grid.ms == 1 ? 1 : finer;
  scene.grid.elements.reset();
  scene.grid.accuracy.reset();
  scene.grid.dx = grid.dx / along;
  scene.grid.ds = grid.ds / across;
  if (scene.grid.mx)
    *scene.grid.mx *= along;
  if (scene.grid.ms)
    *scene.grid.ms *= across;
  return scene;
}

void print_line(std::size_t index, const char* name, double value, double error, double exact,
                bool line = false, const ErrorParts& parts = {}) {
  fmt::print("{},{},{:.9g},{:.5g},{:.9g},{:d},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g}\n", index, name, value,
             error, exact, line, parts.change, parts.local, parts.peak, parts.adhesion, parts.fixed);
}

/// The parts of the error of a number; all 0 of one that has none.
ErrorParts parts_of(std::string_view name, const SceneResult& r) {
  struct Named {
    std::string_view name;
    ErrorParts PartsOfTotals::*parts;
  };
  constexpr auto all = std::to_array<Named>({{"Fx", &PartsOfTotals::Fx},
                                             {"Fs", &PartsOfTotals::Fs},
                                             {"Fy", &PartsOfTotals::Fy},
                                             {"Mz", &PartsOfTotals::moment},
                                             {"approach", &PartsOfTotals::approach},
                                             {"pmax", &PartsOfTotals::pmax},
                                             {"area", &PartsOfTotals::area},
                                             {"adhesion_share", &PartsOfTotals::adhesion_share},
                                             {"T_gamma", &PartsOfTotals::T_gamma},
                                             {"xi", &PartsOfTotals::creepage_x},
                                             {"eta", &PartsOfTotals::creepage_s},
                                             {"Tmax_rail", &PartsOfTotals::Tmax_rail},
                                             {"Tmax_wheel", &PartsOfTotals::Tmax_wheel}});
  const auto found = std::ranges::find(all, name, &Named::name);
  const std::optional<Discretisation>& estimate = r.result.trust.discretisation;
  if (found == all.end() || !estimate)
    return {};
  ErrorParts out = estimate->parts.*found->parts;
  if (name == "Mz") // there its change is one of 1 N mm
    out.change *= (r.moment.error - estimate->local_moment) / estimate->moment_change;
  return out;
}

/// The patch of `fine` that is nearest to this one.
std::size_t opposite(const PatchSummary& patch, const ContactResult& fine) {
  const auto nearest = std::ranges::min_element(
      fine.patches, {}, [&](const PatchSummary& p) { return std::hypot(p.x - patch.x, p.s - patch.s); });
  return static_cast<std::size_t>(nearest - fine.patches.begin());
}

void print_case(std::size_t index, const SceneResult& base, const SceneResult& fine) {
  const auto& estimate = base.result.trust.discretisation;
  print_line(index, estimate && !estimate->converges ? "unconverged" : "stated", estimate.has_value(), 0,
             std::abs(base.result.totals.pmax / fine.result.totals.pmax - 1));
  for (const Quantity& number : quantities())
    if (number.error)
      print_line(index, number.name, number.value(base), number.error(base), number.value(fine),
                 base.problem.grid.is_line(), parts_of(number.name, base));
  if (base.result.patches.size() != fine.result.patches.size())
    return;
  for (std::size_t i = 0; i < base.result.patches.size(); ++i) {
    const std::size_t exact = opposite(base.result.patches[i], fine.result);
    for (const PatchQuantity& number : patch_quantities())
      if (number.error)
        print_line(index, fmt::format("patch {}", number.name).c_str(), number.value(base, i),
                   number.error(base, i), number.value(fine, exact));
  }
}

} // namespace

void estimates(const SweepFile& sweep) {
  Sequence base_cases, fine_cases;
  fmt::print("case,quantity,value,error,exact,line,change,local,peak,adhesion,fixed\n");
  for (std::size_t i = 0; i < sweep.size(); ++i)
    try {
      SceneFile scene = sweep.scene(i);
      fit_grid(scene);
      const SceneResult base = base_cases.solve(scene);
      const SceneResult fine = fine_cases.solve(on_finer_grid(scene, base.problem.grid));
      if (base.result.certified() && fine.result.certified() && !base.result.trust.touches_border &&
          !fine.result.trust.touches_border)
        print_case(i, base, fine);
      std::fflush(stdout);
    } catch (const Error& error) {
      fmt::print(stderr, "case {} ({}): {}\n", i, sweep.describe(i), error.what());
    }
}

} // namespace cases
