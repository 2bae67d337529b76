#include "bem_contact/sequence/asked_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

/// Of a number that may be 0: nothing is relative to that.
double relative(const Measured& number) {
  return number.value != 0 ? number.error / std::abs(number) : 0.0;
}

double error_of(ErrorQuantity what, const ContactResult& r) {
  const ContactTotals& totals = r.totals;
  switch (what) {
  case ErrorQuantity::pmax:
    return relative(totals.pmax);
  case ErrorQuantity::area:
    return relative(totals.area);
  case ErrorQuantity::adhesion:
    return totals.adhesion_share.error;
  case ErrorQuantity::approach:
    return relative(totals.approach);
  case ErrorQuantity::creepages:
    return std::max(relative(totals.creepage_x), relative(totals.creepage_s));
  case ErrorQuantity::friction_power:
    return relative(totals.T_gamma);
  case ErrorQuantity::forces:
    break;
  }
  return r.trust.certificate.discretisation;
}

} // namespace

double asked_error(const SceneFile::Grid& grid, const ContactResult& result) {
  const double forces = result.trust.certificate.discretisation;
  const std::optional<Discretisation>& estimate = result.trust.discretisation;
  if (!estimate || (estimate->rough && !estimate->converges))
    return forces;
  const Measured change{result.totals.pmax, result.totals.pmax - estimate->coarse.pmax};
  double largest = 0;
  for (const ErrorQuantity what : grid.accuracy_of)
    largest = std::max(largest, what == ErrorQuantity::forces || estimate->converges
                                    ? error_of(what, result)
                                    : std::max(forces, relative(change)));
  return largest;
}

} // namespace bem_contact
