#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <span>
#include <vector>

namespace bem_contact {

/// What one row of motion.step_table prescribes; what it does not name stays as the scene says.
struct MotionStep {
  std::optional<double> load, xi, eta, phi, force_x, force_s;
  std::optional<double> x; ///< where the contact lies on a grid that lies still, mm
};

/// How the surfaces move over each other, and with what friction. All tables of the scene are read.
struct Motion {
  struct Friction {
    double s = 0, mu = 0; ///< arc length on the rail, mm
  };

  MotionKind kind = MotionKind::steady;
  bool tangential = true;               ///< false: frictionless
  double friction = 0.3;                ///< of adhesion
  std::vector<Friction> friction_table; ///< instead, by ascending s; empty: the same everywhere
  std::optional<double> kinetic;        ///< coefficient of what slips
  std::optional<double> force_x, force_s;
  Creepage creepage;
  std::vector<MotionStep> steps; ///< of transient rolling and of shifts

  /// What a step changes in it.
  Creepage creepage_of(const MotionStep& step) const;
};

/// Throws InputError for a table that cannot be used.
Motion read_motion(const SceneFile& scene);

/// Sets kind, friction and shear forces of a problem, whose rows are set. Throws InputError where kinetic
/// friction is above that of adhesion on these rows.
void apply_motion(const Motion& motion, double reference_delta, ContactProblem& problem);

} // namespace bem_contact
