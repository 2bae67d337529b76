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
};

/// How the surfaces move over each other, and with what friction. It holds the contents of the CSV files that
/// the scene names, not their paths.
struct Motion {
  struct Friction {
    double s = 0, mu = 0;         ///< arc length on the rail, mm
    double falling = 0, half = 0; ///< as SceneFile has them, mm/s; 0: not in the table
  };

  MotionKind kind = MotionKind::steady;
  bool tangential = true;               ///< false: frictionless
  double friction = 0.3;                ///< coefficient of adhesion
  std::vector<Friction> friction_table; ///< instead, by ascending s; empty: the same everywhere
  std::optional<double> kinetic;        ///< coefficient of slip, not its ratio to `friction`; empty: the same
  std::optional<double> falling;        ///< mu at high slip velocity; empty: Polach's law, or no fall
  double half_slip_velocity = 0;        ///< mm/s, for `falling`
  std::optional<FallingFriction> polach;
  double speed = 0;                       ///< of rolling, mm/s; 0: not given
  std::optional<Heating> heating;         ///< its law of friction is set where the rows are known
  std::optional<double> hot;              ///< mu where it is hot, from hot_to on; empty: the same
  double hot_from = 0, hot_to = 1;        ///< degrees C, for `hot`
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
