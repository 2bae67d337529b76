#include "bem_contact/contact/check/discretisation.hpp"

#include "bem_contact/contact/check/error_estimates.hpp"
#include "bem_contact/contact/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::contact {
namespace {

/// Totals of p_n or of p_t, and of p_t in the local frames.
struct Sums {
  double fx = 0, fy = 0, fz = 0, mz = 0; ///< frame of the rows
  double fs = 0, moment = 0;             ///< along s; about the point (x, s)
};

struct ForceSums {
  Sums normal, shear;
  double pressure = 0;        ///< sum p_n dS
  double friction = 0;        ///< sum mu p_n dS
  double friction_moment = 0; ///< sum mu p_n r dS, r from the point (x, s)
};

ForceSums sum_up(const ContactProblem& problem, const ContactResult& result, double x_at, double s_at) {
  ForceSums sums;
  const double area = problem.element_area();
  const int mx = problem.grid.mx;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const double cosine = std::cos(row.delta), sine = std::sin(row.delta);
    for (int i = is * mx; i < (is + 1) * mx; ++i) {
      if (!(result.pn[i] > 0))
        continue;
      const double x = problem.grid.x(i - is * mx);
      const double fn = result.pn[i] * area, fx = result.px[i] * area, fs = result.ps[i] * area;
      sums.normal.fy -= fn * sine;
      sums.normal.fz += fn * cosine;
      sums.normal.mz -= x * fn * sine;
      sums.shear.fx += fx;
      sums.shear.fy += fs * cosine;
      sums.shear.fz += fs * sine + fx * problem.rise;
      sums.shear.mz += x * fs * cosine - row.position.y * fx;
      sums.shear.fs += fs;
      sums.shear.moment += (x - x_at) * fs - (row.s - s_at) * fx;
      sums.pressure += fn;
      const double friction = problem.has_friction() ? shear_bound(problem, result, i) * area : 0.0;
      sums.friction += friction;
      sums.friction_moment += friction * std::hypot(x - x_at, row.s - s_at);
    }
  }
  return sums;
}

/// Of all patches, weighted by their forces.
struct Centre {
  double x = 0, s = 0;
};
Centre centre_of_pressure(const ContactResult& result) {
  Centre centre;
  double fn = 0;
  for (const PatchSummary& patch : result.patches) {
    centre.x += patch.fn * patch.x;
    centre.s += patch.fn * patch.s;
    fn += patch.fn;
  }
  return {centre.x / fn, centre.s / fn};
}

double largest_approach(const ContactResult& result) {
  double largest = 0;
  for (const PatchSummary& patch : result.patches)
    largest = std::max<double>(largest, patch.overlap);
  return largest;
}

} // namespace

std::string why_not_compared(const ContactProblem& coarse_problem, const ContactResult& coarse) {
  const bool line = coarse_problem.grid.is_line();
  const int least = line ? least_companion_line : least_companion;
  const int contact = count_elements(coarse).contact;
  if (contact < least)
    return fmt::format(
        "they are estimated from elements twice as large, of which {} are in contact, and {} are "
        "needed. Give smaller elements, so that about {} are in contact",
        contact, least, (line ? 2 : 4) * least);
  return coarse.trust.certificate.worst() <= companion_violation
             ? ""
             : "elements twice as large have no certified solution. Give smaller elements";
}

void compare(const ContactProblem& problem, const ContactProblem& coarse_problem, const ContactResult& coarse,
             ContactResult& result) {
  Trust& trust = result.trust;
  trust.why_no_errors = why_not_compared(coarse_problem, coarse);
  if (!trust.why_no_errors.empty())
    return;
  const Centre centre = centre_of_pressure(result);
  const ForceSums fine = sum_up(problem, result, centre.x, centre.s);
  const ForceSums rough = sum_up(coarse_problem, coarse, centre.x, centre.s);

  // what is added to a result of error C h^2 to remove it
  constexpr double second_order = 1.0 / 3.0;
  const auto normal = [&](double Sums::*q) { return second_order * (fine.normal.*q - rough.normal.*q); };
  const auto shear = [&](double Sums::*q) { return second_order * (fine.shear.*q - rough.shear.*q); };
  Discretisation& out = trust.discretisation.emplace();
  out.contact = count_elements(coarse).contact;
  out.coarse = coarse.totals;
  out.tractions = tractions_of(coarse);
  out.extrapolated = result.totals;
  out.extrapolated.Fx.value += shear(&Sums::fx);
  out.extrapolated.Fy.value += normal(&Sums::fy) + shear(&Sums::fy);
  out.extrapolated.Mz += normal(&Sums::mz) + shear(&Sums::mz);
  const double approach = second_order * (result.totals.approach - coarse.totals.approach);
  if (problem.load == LoadKind::force) {
    out.extrapolated.approach.value += approach;
    out.approach = std::abs(approach) / largest_approach(result);
  } else
    out.extrapolated.Fz.value += normal(&Sums::fz) + shear(&Sums::fz);
  out.normal = std::hypot(normal(&Sums::fy), normal(&Sums::fz)) / fine.pressure;
  out.extrapolated.creepage_x.value += second_order * (result.totals.creepage_x - coarse.totals.creepage_x);
  out.extrapolated.creepage_s.value += second_order * (result.totals.creepage_s - coarse.totals.creepage_s);
  if (problem.has_friction()) {
    out.tangential =
        std::hypot(fine.shear.fx - rough.shear.fx, fine.shear.fs - rough.shear.fs) / fine.friction;
    if (fine.friction_moment > 0)
      out.moment = std::abs(fine.shear.moment - rough.shear.moment) / fine.friction_moment;
  }
  estimate_errors(problem, coarse_problem, coarse, result);
  trust.certificate.discretisation = out.worst();
}

} // namespace bem_contact::contact
