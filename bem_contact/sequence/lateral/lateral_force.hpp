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

/// Both ends of an interval over which the force passes the one that is wanted.
struct LateralBracket {
  LateralSample low, high; ///< ascending in the displacement
};

/// Narrows a bracket by the method of Alefeld, Potra and Shi (1995), until `wanted` is met within `tolerance`
/// (N) or the interval is narrower than `width` (mm), or the force is not known. The sample nearest to
/// `wanted`.
LateralSample narrow_lateral(const LateralForce& force, double wanted, const LateralBracket& bracket,
                             double tolerance, double width);

/// A displacement with the force that is wanted.
struct LateralRoot {
  double lateral = 0; ///< mm
  double slope = 0;   ///< dFy/dy of the samples around it, N/mm
};

/// The displacement at which the force is `wanted` to within `tolerance` (N), near `start`. Secant steps
/// until two displacements bracket it, then narrow_lateral(). Throws
/// ConvergenceError where the force is not met, or jumps over it.
double solve_lateral_force(const LateralForce& force, double wanted, const LateralRoot& start,
                           double tolerance);

/// Throws ConvergenceError: the search for `wanted` ended at `last` (force nan: no solution there), which
/// misses it by more than `tolerance`, N.
[[noreturn]] void refuse_search(double wanted, const LateralSample& last, double tolerance);

/// Throws InputError: no displacement gives the force that is wanted, and what the samples reach.
[[noreturn]] void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples);

} // namespace bem_contact
