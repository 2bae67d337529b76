#include "bem_contact/scene/elastic_limit.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

double limit_of(const SceneFile& scene) {
  return largest_pressure_share * std::min(scene.rail.material.young(), scene.wheel.material.young());
}

[[noreturn]] void refuse(const SceneFile& scene, const std::string& pressure) {
  throw InputError(
      "The load is far beyond elastic contact",
      fmt::format("{}, and {:.4g} MPa are {:g} of the softer body's Young's modulus, where "
                  "linear elasticity ends",
                  pressure, limit_of(scene), largest_pressure_share),
      "Check load, lengths and moduli and their units (N, mm, MPa), and whether the grid holds the "
      "contact.");
}

} // namespace

void require_bearable(const SceneFile& scene, const ContactProblem& problem) {
  if (problem.load != LoadKind::force)
    return;
  const double area =
      problem.grid.size() * problem.grid.dx * problem.grid.ds; // no numbers yet; plane strain: dx = 1
  const double least = problem.force / area / (1 + (problem.tangential ? problem.largest_friction() : 0));
  if (least > limit_of(scene))
    refuse(scene, fmt::format("{:g} N on all of the grid's {:.4g} mm2 are {:.4g} MPa or more", problem.force,
                              area, least));
}

void require_elastic(const SceneFile& scene, double pressure) {
  if (pressure > limit_of(scene))
    refuse(scene, fmt::format("the largest pressure would be {:.4g} MPa", pressure));
}

} // namespace bem_contact
