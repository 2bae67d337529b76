#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace bem_contact {

/// Lateral force on the rail, N, of a wheelset at this lateral displacement, mm. Nothing where wheel and rail
/// do not meet, or no solution was found.
using LateralForce = std::function<std::optional<double>(double lateral)>;

/// What one displacement gives.
struct LateralSample {
  double lateral = 0; ///< mm
  double force = 0;   ///< N
};

/// The force from `around` - lateral_reach to `around` + lateral_reach, every lateral_step, as far as there
/// is one; ascending in the displacement.
std::vector<LateralSample> sample_lateral_force(const LateralForce& force, double around);

/// A displacement with the force that is wanted.
struct LateralRoot {
  double lateral = 0; ///< mm, to lateral_root_width
  double slope = 0;   ///< dFy/dy of the samples around it, N/mm
};

/// All of them between samples, ascending. Tread and flange can give the same force, and so can the flange
/// before and behind its steepest place. Where the samples have an extremum short of the force, a parabola
/// tells whether the function reaches it between them.
std::vector<LateralRoot> find_lateral_roots(const LateralForce& force, std::vector<LateralSample> samples,
                                            double wanted);

/// The displacement at which the force is `wanted` to within `tolerance` (N), near `start`. Secant steps
/// until two displacements bracket it, then the method of Alefeld, Potra and Shi (1995). Throws
/// ConvergenceError where the force is not met, or jumps over it.
double solve_lateral_force(const LateralForce& force, double wanted, const LateralRoot& start,
                           double tolerance);

/// Throws InputError: no displacement gives the force that is wanted, and what the samples reach.
[[noreturn]] void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples);

} // namespace bem_contact
