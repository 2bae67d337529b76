#include "bem_contact/sequence/asked_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

double relative(double error, double value) {
  return value != 0 ? error / std::abs(value) : 0.0;
}

double error_of(AccuracyOf what, const ContactProblem& problem, const ContactResult& r) {
  const TotalErrors& e = r.discretisation->errors;
  switch (what) {
  case AccuracyOf::pmax:
    return relative(e.pmax, largest_pressure(r));
  case AccuracyOf::area:
    return relative(e.area, contact_area(r));
  case AccuracyOf::adhesion:
    return e.adhesion_share;
  case AccuracyOf::approach:
    return relative(e.approach, r.approach);
  case AccuracyOf::creepages:
    return std::max(relative(e.creepage_x, r.creepage_x), relative(e.creepage_s, r.creepage_s));
  case AccuracyOf::friction_power:
    return relative(e.T_gamma, T_gamma(r, problem.element_area()));
  case AccuracyOf::forces:
    break;
  }
  return r.certificate.discretisation;
}

} // namespace

double asked_error(const SceneFile::Grid& grid, const SceneResult& out) {
  return asked_error(grid, out.problem, out.result);
}

double asked_error(const SceneFile::Grid& grid, const ContactProblem& problem, const ContactResult& result) {
  const double forces = result.certificate.discretisation;
  const std::optional<Discretisation>& estimate = result.discretisation;
  if (!estimate || (estimate->rough && !estimate->converges))
    return forces;
  const auto error = [&](AccuracyOf what) {
    const double pmax = largest_pressure(result);
    return what == AccuracyOf::forces || estimate->converges
               ? error_of(what, problem, result)
               : std::max(forces, relative(pmax - estimate->coarse_pmax, pmax));
  };
  double largest = 0;
  for (const AccuracyOf what : grid.accuracy_of)
    largest = std::max(largest, error(what));
  return largest;
}

} // namespace bem_contact
