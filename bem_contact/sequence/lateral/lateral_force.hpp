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

/// Both ends of an interval over which the force passes the one that is wanted, in any order.
struct LateralBracket {
  LateralSample a, b;
};

/// Narrows a bracket by the method of Alefeld, Potra and Shi (1995), until `wanted` is met within `tolerance`
/// (N) or the interval is narrower than `width` (mm), or the force is not known. The sample nearest to
/// `wanted`.
LateralSample narrow_lateral(const LateralForce& force, double wanted, const LateralBracket& bracket,
                             double tolerance, double width);

/// Steps from `from` by `step`, 2 `step`, 4 `step` ... (mm) to both sides in turn, at most `farthest` from
/// `from` (mm), until the force passes `wanted` between two of them. `step`: its sign says which side is
/// first. A side ends where the force is not known. Nothing if the force does not pass.
std::optional<LateralBracket> bracket_lateral_beside(const LateralForce& force, double wanted,
                                                     const LateralSample& from, double step, double farthest);

/// A displacement with the force that is wanted.
struct LateralRoot {
  double lateral = 0; ///< mm
  double slope = 0;   ///< dFy/dy of the samples around it, N/mm
};

/// The displacement at which the force is `wanted` to within `tolerance` (N), near `start`:
/// bracket_lateral_beside(), then narrow_lateral(). Throws ConvergenceError where the force is not met, or
/// jumps over it.
double solve_lateral_force(const LateralForce& force, double wanted, const LateralRoot& start,
                           double tolerance);

/// How far about a displacement the force is alike.
struct LateralSpread {
  double low = 0,
         high = 0;  ///< on either side, mm: so far the force is alike, and no farther than lateral::reach
  double slope = 0; ///< dFy/dy on the side that is longer, N/mm
  double error = 0; ///< mm: so far away the force differs by its error
};
/// By the shape of the force about `found` (mm), at doubling distances: forces that differ by lateral::uneven
/// of the `resultant` (N), or by their own `error` (N; nan: not known) are told apart. The shape is that of
/// rough solutions, because the model's own forces are uneven from element to element.
LateralSpread lateral_spread(const LateralForce& shape, double found, double error, double resultant);

/// A bracket narrower than this, mm, holds a jump of the force: within lateral::unsure a flange takes up less
/// than the resultant, so a narrower one would be met within what the certificate allows.
double narrowest_bracket();

/// Throws ConvergenceError: the search for `wanted` ended at `last` (force nan: no solution there), which
/// misses it by more than `tolerance`, N.
[[noreturn]] void refuse_search(double wanted, const LateralSample& last, double tolerance);

/// Throws InputError: no displacement gives the force that is wanted, and what the samples reach.
[[noreturn]] void refuse_lateral_force(double wanted, const std::vector<LateralSample>& samples);

} // namespace bem_contact
