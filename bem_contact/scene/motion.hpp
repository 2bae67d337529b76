#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// What one row of motion.step_table prescribes, in the units of ContactLoad and Creepage and in N for the
/// shear forces. What it does not name stays as the scene says.
struct MotionStep {
  std::optional<double> load, xi, eta, phi, force_x, force_s;
  std::optional<double> x; ///< where the contact lies on a grid that lies still, mm
  double slip = 1;         ///< how often the rigid slip of one rolling step
};

/// How the surfaces move over each other, and with what friction. It holds the contents of the CSV files that
/// the scene names, not their paths.
struct Motion {
  struct Friction {
    double at = 0, mu = 0;        ///< arc length on the rail, mm, or its inclination, rad
    double falling = 0, half = 0; ///< as SceneFile has them, mm/s; 0: not in the table
  };

  MotionKind kind = MotionKind::steady;
  bool tangential = true; ///< false: frictionless
  FrictionCoefficients coefficients;
  std::vector<Friction> friction_table; ///< instead of `friction`, ascending; empty: the same everywhere
  bool friction_by_inclination = false; ///< of the table: else by arc length
  double speed = 0;                     ///< of rolling, mm/s; 0: not given
  SceneFile::Temperature temperature;
  std::optional<double> force_x, force_s; ///< prescribed shear forces, N
  Creepage creepage;
  bool radial_displacement = true; ///< fem, steady: the wheel's surface is faster by u_r / R
  std::vector<MotionStep> steps;   ///< of transient rolling and of shifts

  /// The scene's creepage, with the values that the step prescribes in place of its own.
  Creepage creepage_of(const MotionStep& step) const;
};

/// Throws InputError for a table that cannot be used.
Motion read_motion(const SceneFile& scene);

/// Sets kind, friction, heat and shear forces of a problem, whose rows are set. Throws InputError where
/// friction in slip, at high slip velocity or when hot is above that of adhesion on these rows.
void apply_motion(const Motion& motion, double reference_delta, ContactProblem& problem);

} // namespace bem_contact
