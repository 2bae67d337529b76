#include "bem_contact/scene/elastic_limit.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/settings.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Share of the softer body's Young's modulus that no pressure may exceed: strains are tens of percent
/// there, and the theory is one of small strains. (Steel yields at a hundredth of that.)
constexpr double largest_pressure_share = 0.2;

double limit_of(const ContactSetup& setup) {
  return largest_pressure_share * std::min(setup.rail.material.young(), setup.wheel.material.young());
}

/// "rail.material.young = 210 MPa" and, if that looks like GPa, so much.
std::string softer_modulus(const ContactSetup& setup) {
  const bool rail = setup.rail.material.young() <= setup.wheel.material.young();
  const double young = (rail ? setup.rail : setup.wheel).material.young();
  return fmt::format("{}.material.young = {:g} MPa{}", rail ? "rail" : "wheel", young,
                     setup.wheel_rail() && young < softest_modulus ? ", which looks like GPa" : "");
}

[[noreturn]] void refuse(const ContactSetup& setup, const std::string& pressure) {
  throw InputError(
      "The load is far beyond elastic contact",
      fmt::format("{}, and {:.4g} MPa are {:g} of the softer body's Young's modulus ({}), where "
                  "linear elasticity ends",
                  pressure, limit_of(setup), largest_pressure_share, softer_modulus(setup)),
      "Check load, lengths and moduli and their units (N, mm, MPa), and whether the grid holds the "
      "contact.");
}

} // namespace

void require_bearable(const ContactSetup& patch) {
  if (patch.load.kind != LoadKind::force)
    return;
  const ContactProblem problem = patch.on(patch.patch()->plan()).problem;
  const double area = problem.grid.size() * problem.element_area(); // plane strain: per mm
  const double least = patch.load.force / area / (1 + (problem.tangential ? problem.largest_friction() : 0));
  if (least > limit_of(patch))
    refuse(patch, fmt::format("{:g} N on all of the grid's {:.4g} mm2 are {:.4g} MPa or more",
                              patch.load.force, area, least));
}

void require_small_approach(double approach) {
  if (approach > largest_approach)
    throw InputError("The load is far beyond elastic contact",
                     fmt::format("the bodies would approach by about {:.3g} mm", approach),
                     "Check load, moduli and their units (N, mm, MPa; steel has 210000 MPa).");
}

void require_elastic(const ContactSetup& setup, double pressure) {
  if (pressure > limit_of(setup))
    refuse(setup, fmt::format("the largest pressure would be {:.4g} MPa", pressure));
}

} // namespace bem_contact
