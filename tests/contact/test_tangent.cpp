// Tangents of solutions against central differences of whole solutions.
#include "bem_contact/contact/tangent.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/layer.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <string>

namespace bem_contact {
namespace {

/// What a problem is made of. Every member is an input.
struct Parts {
  double force = 5e3, approach = 0.02, xi = 4e-4, eta = -3e-4, phi = 1e-4, friction = 0.3, a = 1e-3,
         b = 1.2e-3, aside = 0.05, compliance = 1e-5, force_x = 0;
};
using Part = double Parts::*;

/// What a problem is.
struct Kind {
  bool by_approach = false, unlike = false, bent = false, turned = false, finds_xi = false, yields = false,
       frictionless = false;
  int elements = 20; ///< across
};

ContactProblem problem_of(const Parts& p, const Kind& kind) {
  const Material soft{30000.0, 0.4};
  const double size = 8.0 / kind.elements;
  ContactProblem problem = scenes::flat(kind.unlike ? soft : scenes::steel, scenes::steel, kind.elements + 3,
                                        kind.elements + 1, size, size, p.a, p.b);
  for (int is = 0; is < problem.grid.ms; ++is)
    for (int ix = 0; ix < problem.grid.mx; ++ix) {
      const double x = problem.grid.x(ix), s = problem.rows[is].s - p.aside;
      problem.gap[is * problem.grid.mx + ix] = p.a * x * x + p.b * s * s;
    }
  if (kind.bent)
    scenes::bend(problem, 12);
  if (kind.turned)
    scenes::rotate_numbers(problem);
  if (!kind.frictionless)
    scenes::set_creepage(problem, p.friction, p.xi, p.eta, p.phi);
  add_layer({{p.compliance}, 0}, problem.numbers);
  problem.load = kind.by_approach ? LoadKind::approach : LoadKind::force;
  problem.force = p.force;
  problem.approach = p.approach;
  if (kind.finds_xi)
    problem.force_x = p.force_x;
  if (kind.yields)
    problem.yield = YieldLimit{.shear = 120};
  return problem;
}

const SolverOptions precise{.tolerance = 1e-12, .estimate_discretisation = false};

std::map<std::string, double> numbers_of(const ContactResult& r) {
  const ContactTotals& t = r.totals;
  return {{"Fx", t.Fx},
          {"Fy", t.Fy},
          {"Fz", t.Fz},
          {"Mz", t.Mz},
          {"approach", t.approach},
          {"pmax", t.pmax},
          {"T_gamma", t.T_gamma},
          {"creepage_x", t.creepage_x},
          {"Fn", r.patches.front().fn},
          {"Mn", r.patches.front().moment_n}};
}

struct Input {
  const char* name;
  Part part;
  double step;
};
constexpr Input inputs[] = {{"force", &Parts::force, 0.5},
                            {"approach", &Parts::approach, 1e-6},
                            {"xi", &Parts::xi, 1e-8},
                            {"eta", &Parts::eta, 1e-8},
                            {"phi", &Parts::phi, 1e-8},
                            {"friction", &Parts::friction, 1e-5},
                            {"a", &Parts::a, 1e-8},
                            {"b", &Parts::b, 1e-8},
                            {"aside", &Parts::aside, 1e-5},
                            {"compliance", &Parts::compliance, 1e-9},
                            {"force_x", &Parts::force_x, 0.05}};

/// Both sides, with influence numbers of their own where they change.
TangentInput both_sides(const Parts& parts, const Kind& kind, const Input& input) {
  Parts lower = parts, upper = parts;
  lower.*input.part -= input.step;
  upper.*input.part += input.step;
  TangentInput out{problem_of(lower, kind), problem_of(upper, kind), input.step};
  if (input.part != &Parts::compliance)
    for (ContactProblem* side : {&out.lower, &out.upper})
      side->numbers.values.clear();
  return out;
}

/// Where no element changes its state within the steps of the differences, the two are the same.
int compare(Parts parts, const Kind& kind) {
  ContactProblem problem = problem_of(parts, kind);
  const ContactResult solved = solve(problem, precise);
  EXPECT_TRUE(solved.certified());
  WorkBudget work;
  const std::vector<Tangent> all = tangents(
      problem, solved, int(std::size(inputs)), [&](int k) { return both_sides(parts, kind, inputs[k]); },
      precise, work);
  int compared = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Input& input = inputs[k];
    const double range = std::min(all[k].below, all[k].above), step = std::min(20 * input.step, 0.4 * range);
    if (step < input.step) // it says that a state changes
      continue;
    const auto at = [&](double by) {
      Parts moved = parts;
      moved.*input.part += by;
      return solve(problem_of(moved, kind), precise);
    };
    const ContactResult lower = at(-step), upper = at(step), near_lower = at(-0.5 * step),
                        near_upper = at(0.5 * step);
    if (lower.state != solved.state || upper.state != solved.state)
      continue;
    ++compared;
    const auto from = numbers_of(all[k].lower), to = numbers_of(all[k].upper);
    const auto far_from = numbers_of(lower), far_to = numbers_of(upper), near_from = numbers_of(near_lower),
               near_to = numbers_of(near_upper), here = numbers_of(solved);
    for (const auto& [name, value] : here) {
      const double found = (to.at(name) - from.at(name)) / (2 * input.step),
                   difference = (4 * (near_to.at(name) - near_from.at(name)) / step -
                                 (far_to.at(name) - far_from.at(name)) / (2 * step)) /
                                3;
      const bool force = name[0] == 'F';
      const double largest = force ? here.at("Fn") : std::abs(value);
      // what a change of the input by its own size does, or of the number by a thousandth
      const double scale = std::max(
          {std::abs(difference), 1e-3 * largest / std::max(std::abs(parts.*input.part), 1e3 * input.step)});
      EXPECT_NEAR(found, difference, 1e-5 * scale)
          << input.name << " " << name << " step " << step << " range " << range;
    }
  }
  return compared;
}

TEST(Tangents, OfAContactWithFriction) {
  EXPECT_GE(compare({}, {}), 7);
}
TEST(Tangents, OfManyElements) {
  EXPECT_GE(compare({.force = 6e3}, {.elements = 44}), 5);
}
TEST(Tangents, WithoutFriction) {
  EXPECT_GE(compare({}, {.frictionless = true}), 4);
}
TEST(Tangents, UnderAPrescribedApproach) {
  NEEDS_NO_SANITIZER();
  EXPECT_GE(compare({}, {.by_approach = true}), 6);
}
TEST(Tangents, OfUnlikeMaterials) {
  EXPECT_GE(compare({}, {.unlike = true}), 6);
}
TEST(Tangents, OfACurvedStripWhoseShearBears) {
  EXPECT_GE(compare({.aside = 2}, {.bent = true}), 6);
  EXPECT_GE(compare({.aside = 2}, {.bent = true, .turned = true}), 6);
}
TEST(Tangents, OfALayerThatYields) {
  EXPECT_GE(compare({.compliance = 5e-5}, {.yields = true}), 6);
}
TEST(Tangents, OfACreepageThatIsFound) {
  EXPECT_GE(compare({.force_x = 600}, {.finds_xi = true}), 6);
}

} // namespace
} // namespace bem_contact
