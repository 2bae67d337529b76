#include "bem_contact/sequence/solution/layer_slope.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/layer.hpp"
#include "bem_contact/contact/shear_sensitivity.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/reference/creep_coefficients.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bem_contact {

namespace {

/// 1. The slope is met to this share.
constexpr double slope_precision = 1e-9;
/// 1. Slopes that are tried at most: three or four are the rule, because one over the slope is nearly linear
/// in the compliance.
constexpr int most_slopes = 40;

/// 1. Ratios of the semi-axes for which there are creep coefficients (reference/creep_coefficients.hpp).
constexpr double flattest_ellipse = 0.1, longest_ellipse = 10;

/// sum over rows of (2 a)^2 / 2 ds, mm^3: the slope times the compliance where the bodies are rigid. Every
/// row of a contact is taken as one length.
double rigid_slope(const ContactProblem& problem, const ContactResult& contact) {
  double sum = 0;
  for (int is = 0; is < problem.grid.ms; ++is) {
    double length = 0;
    for (int ix = 0; ix < problem.grid.mx; ++ix)
      length += contact.pn[is * problem.grid.mx + ix] > 0 ? problem.grid.dx : 0;
    sum += 0.5 * length * length * problem.grid.ds;
  }
  return sum;
}

} // namespace

double slope_without_slip(const ContactProblem& problem, const ContactResult& frictionless) {
  ContactResult at_rest = frictionless;
  for (auto* field : {&at_rest.px, &at_rest.ps, &at_rest.slip_x, &at_rest.slip_s})
    field->assign(frictionless.pn.size(), 0.0);
  const SlipChange unit{std::vector<double>(frictionless.pn.size(), 1.0),
                        std::vector<double>(frictionless.pn.size(), 0.0)};
  const ShearChange change = shear_sensitivity(problem, at_rest, unit);
  return std::reduce(change.px.begin(), change.px.end()) * problem.element_area();
}

double compliance_of_slope(const ContactProblem& problem, double share, const SolverOptions& given,
                           WorkBudget& work) {
  ContactProblem clean = problem;
  clean.kinetic = 1; // nothing slips
  clean.falling.clear();
  clean.heating.reset();
  clean.yield.reset();
  clean.memory.reset();
  clean.tangential = false;
  SolverOptions options = given;
  options.estimate_discretisation = options.displacements = false;
  options.early_end = nullptr;
  const ContactResult contact = solve(clean, options, work);
  clean.tangential = true;
  if (share == 1 || contact.patches.empty())
    return 0;
  const double without = slope_without_slip(clean, contact);
  // One over the slope, which grows with the compliance, less what it should be; without dimension.
  const auto excess = [&](double compliance) {
    ContactProblem layered = clean;
    add_layer({{compliance}, 0}, layered.numbers);
    return without / slope_without_slip(layered, contact) - 1 / share;
  };
  double lo = 0, at_lo = 1 - 1 / share;
  double hi = 1.5 * rigid_slope(clean, contact) / std::abs(without) * (1 / share - 1), at_hi = excess(hi);
  for (int i = 0; at_hi < 0 && i < most_slopes; ++i) {
    lo = hi, at_lo = at_hi;
    hi *= 2, at_hi = excess(hi);
  }
  if (!(at_hi >= 0))
    throw ConvergenceError("No compliance of the layer gives layer.slope",
                           "the slope of Fx over xi does not fall so far", "Give layer.compliance.");
  std::uintmax_t calls = most_slopes;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, lo, hi, at_lo, at_hi, [](double from, double to) { return to - from <= slope_precision * to; },
      calls);
  return 0.5 * (a + b);
}

double estimated_slope(const ContactSetup& setup, const SurfaceLayer& layer, const ContactProblem& problem,
                       const ContactResult& result) {
  if (result.patches.empty() || problem.plane_strain())
    return std::numeric_limits<double>::quiet_NaN();
  const PatchSummary& patch = result.patches.front();
  const Material &rail = setup.rail.material, &wheel = setup.wheel.material;
  const double compliance = layer.shear_of(static_cast<int>(std::lround(row_index(problem, patch.s)))),
               a = patch.semi_axis_a,
               ratio = std::clamp(a / patch.semi_axis_b, flattest_ellipse, longest_ellipse);
  const double c11 = reference::quick_creep_coefficients(ratio, 0.5 * (rail.poisson + wheel.poisson))[0];
  return 1 / (1 + 3 * c11 * shear_modulus_of_pair(rail, wheel) * compliance / (8 * a));
}

} // namespace bem_contact
