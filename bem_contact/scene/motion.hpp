#pragma once

#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include <optional>

namespace bem_contact {

/// What one row of motion.step_table prescribes; what it does not name stays as the scene says.
struct MotionStep {
  std::optional<double> load, xi, eta, phi, force_x, force_s;
  std::optional<double> x; ///< where the contact lies on a grid that lies still, mm
};

/// One for each step. Throws InputError for a table that cannot be used.
std::vector<MotionStep> read_steps(const SceneFile& scene);

/// Kind of motion, friction and shear forces, as the scene says; grid and rows are set. Throws InputError for
/// tables that do not fit.
void set_motion(ContactProblem& problem, const SceneFile& scene, double reference_delta);

/// Load, rigid slip and shear forces of one step. `placed`: null for a patch.
void prescribe_step(ContactProblem& problem, const SceneFile& scene, const WheelRailScene* placed,
                    const MotionStep& step);

} // namespace bem_contact
