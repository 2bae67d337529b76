#include "bem_contact/contact/check/imbalance.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::contact {
namespace {

/// The largest of what the prescribed shear forces miss, over what friction can carry.
double shear_imbalance(const ContactProblem& problem, const ContactResult& result) {
  if (!problem.has_friction())
    return 0;
  double fx = 0, fs = 0;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double share = problem.lateral_share(is);
    for (int i = is * problem.grid.mx; i < (is + 1) * problem.grid.mx; ++i) {
      fx += result.px[i] * problem.element_area();
      fs += result.ps[i] * share * problem.element_area();
    }
  }
  const double missing = std::max(problem.force_x ? std::abs(fx - *problem.force_x) : 0.0,
                                  problem.force_s ? std::abs(fs - *problem.force_s) : 0.0);
  return missing > 0 ? missing / friction_bound(problem, result) : 0;
}

double vertical_imbalance(const ContactProblem& problem, const ContactResult& result) {
  if (problem.load != LoadKind::force)
    return 0;
  double force = 0;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double cosine = std::cos(problem.rows[is].delta), sine = std::sin(problem.rows[is].delta);
    for (int i = is * problem.grid.mx; i < (is + 1) * problem.grid.mx; ++i)
      force += (result.pn[i] * cosine + result.ps[i] * sine + result.px[i] * problem.rise) *
               problem.element_area();
  }
  const double missing = std::abs(force - problem.force);
  return problem.force > 0 ? missing / problem.force : missing;
}

} // namespace

double force_imbalance(const ContactProblem& problem, const ContactResult& result) {
  return std::max(vertical_imbalance(problem, result), shear_imbalance(problem, result));
}

std::string violated_condition(const Certificate& certificate, double tolerance) {
  const double worst = certificate.worst();
  if (!std::isfinite(worst))
    return "digits were lost: a number overflowed, lengths, forces or moduli lie too many decades apart";
  if (worst <= certificate.rounding)
    return "digits were lost: lengths, forces or moduli lie too many decades apart";
  return fmt::format(
      "the solvers reached their tolerance, {:.0e}, but the certificate finds {} violated by "
      "{:.1e}: unless a lower tolerance helps this is a fault of the program, please report it",
      tolerance, certificate.worst_name(), worst);
}

} // namespace bem_contact::contact
