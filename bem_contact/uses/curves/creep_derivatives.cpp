#include "bem_contact/uses/curves/creep_derivatives.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/models.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Of a derivative over the root of the number of elements in contact: larger elements may have the same
/// one by chance, and the border of the contact is known to a part of an element. Chosen on 45 slopes at zero
/// of ellipses with 20 to 40 elements across, beside Kalker's.
constexpr double border_share = 0.7;

/// 1, of each derivative.
double local_error(const DerivedContact& contact) {
  return border_share / std::sqrt(double(contact.elements));
}

constexpr double step_shares[] = {1, 0.5}; ///< of the steps of differences

/// The points of differences: for each creepage up and down by the step, and by half of it.
std::vector<Creepages> difference_points(const Creepages& at, const Creepages& steps) {
  std::vector<Creepages> points;
  for (const CreepKind kind : creep_kinds)
    for (const double share : step_shares)
      for (const double sign : {1, -1}) {
        points.push_back(at);
        points.back()[index(kind)] += sign * share * steps[index(kind)];
      }
  return points;
}

/// The points of difference_points() with whole steps, on elements twice as large. Their own grids:
/// joined elements of the others differ from point to point, where a contact moves by a row. None where the
/// scene counts its elements, or where there is no solution on larger ones.
std::vector<CreepPoint> on_larger_elements(const SceneFile& scene, HeldContact held,
                                           std::span<const Creepages> points, const CreepSolver& solve) {
  if (scene.kind != SceneKind::wheel_rail || scene.grid.mx || scene.grid.ms || is_closed_form(held.model))
    return {};
  held.dx *= 2;
  held.ds *= 2;
  std::vector<Creepages> whole;
  for (std::size_t i = 0; i < points.size(); i += 2 * std::size(step_shares))
    whole.insert(whole.end(), {points[i], points[i + 1]});
  try {
    return solve(held, whole);
  } catch (const ConvergenceError&) {
    return {};
  }
}

/// By differences of solutions.
CreepDerivatives by_differences(const DerivedContact& contact, const DerivativePlace& place,
                                const CreepSolver& solve) {
  const std::vector<Creepages> around = difference_points(place.at, place.steps);
  const std::vector<CreepPoint> points = solve(contact.held, around),
                                larger = on_larger_elements(contact.scene, contact.held, around, solve);
  CreepDerivatives out{.by_differences = true};
  const Creepages& steps = place.steps;
  const double local = local_error(contact), gain = std::pow(2, place.order) - 1;
  for (const CreepKind kind : creep_kinds) {
    const std::size_t k = index(kind);
    const auto slope = [&](std::size_t which, std::size_t i, const auto& of) {
      const CreepPoint* up = &points[2 * (std::size(step_shares) * k + which)];
      return ((up[0].*of)[i] - (up[1].*of)[i]) / (2 * step_shares[which] * steps[k]);
    };
    for (std::size_t i = 0; i < out.values.size(); ++i) {
      const double whole = slope(0, i, &CreepPoint::forces), half = slope(1, i, &CreepPoint::forces);
      const double coarse = larger.empty()
                                ? slope(0, i, &CreepPoint::coarse)
                                : (larger[2 * k].forces[i] - larger[2 * k + 1].forces[i]) / (2 * steps[k]);
      out.values[i][k] = half + (half - whole) / gain;
      out.errors[i][k] =
          std::abs(half - whole) + std::abs(whole - coarse) + local * std::abs(out.values[i][k]);
    }
  }
  return out;
}

/// The same bodies on elements twice as large. Nothing where the scene says something of each element, or
/// counts those of a wheel.
std::optional<std::pair<SceneFile, HeldContact>> twice_as_large(SceneFile scene, HeldContact held) {
  SceneFile::Grid& grid = scene.grid;
  const bool patch = scene.kind == SceneKind::patch;
  if (patch ? !scene.gap.table.empty() || !scene.motion.friction_table.empty() || grid.plane_strain
            : grid.mx || grid.ms)
    return std::nullopt;
  for (std::optional<int>* count : {&grid.mx, &grid.ms})
    if (*count)
      *count = (**count + 1) / 2;
  held.dx *= 2;
  held.ds *= 2;
  return std::pair{std::move(scene), held};
}

/// Of solutions that have them.
std::optional<CreepDerivatives> by_tangents(const DerivedContact& contact, const Creepages& at,
                                            const CreepSolvers& solvers) {
  const auto larger = twice_as_large(contact.scene, contact.held);
  if (!larger || is_closed_form(contact.held.model))
    return std::nullopt;
  const auto slopes = [&](SceneFile scene, const HeldContact& held) {
    for (const CreepKind kind : creep_kinds)
      scene.derivatives.emplace_back(name_of(kind));
    const CreepPoint point = solvers.with_slopes(scene, held, at);
    return point.certified ? point.slopes : std::vector<CreepForceValues>();
  };
  try {
    const std::vector<CreepForceValues> fine = slopes(contact.scene, contact.held),
                                        coarse = slopes(larger->first, larger->second);
    if (fine.empty() || coarse.empty())
      return std::nullopt;
    CreepDerivatives out;
    for (std::size_t k = 0; k < fine.size(); ++k)
      for (std::size_t i = 0; i < out.values.size(); ++i) {
        out.values[i][k] = fine[k][i];
        out.errors[i][k] = std::abs(fine[k][i] - coarse[k][i]) + local_error(contact) * std::abs(fine[k][i]);
      }
    return out;
  } catch (const InputError&) { // this scene has none
  } catch (const ConvergenceError&) {
  }
  return std::nullopt;
}

} // namespace

CreepDerivatives creep_derivatives(const DerivedContact& contact, const DerivativePlace& place,
                                   const CreepSolvers& solvers) {
  const std::optional<CreepDerivatives> found = by_tangents(contact, place.at, solvers);
  return found ? *found : by_differences(contact, place, solvers.points);
}

} // namespace bem_contact
