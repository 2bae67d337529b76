#pragma once

#include <optional>
#include <span>
#include <vector>

namespace bem_contact {

/// One value of the rolling radius difference.
struct RadiusDifference {
  double lateral = 0;    ///< mm
  double difference = 0; ///< right less left, mm
};

/// Returns the function with the zeros of the difference, which is linear between its values, as values of
/// their own. `function` rises in `lateral`.
std::vector<RadiusDifference> with_zeros(std::span<const RadiusDifference> function);

/// The free lateral motion of a wheelset with one amplitude (EN 15302).
struct EquivalentConicity {
  double amplitude = 0;    ///< half of the way from the leftmost to the rightmost point, mm
  double tan_gamma = 0;    ///< of the cone with the same wavelength
  double wavelength = 0;   ///< mm; infinite where nothing steers the wheelset
  double from = 0, to = 0; ///< leftmost and rightmost displacement, mm
};

/// What the motion of a wheelset depends on besides its rolling radius difference.
struct KlingelLengths {
  double contact_distance = 1500; ///< e: of the two contact circles, mm
  double wheel_radius = 460;      ///< r0, mm
};

/// The motion of this amplitude; nothing where there is none, because the table ends before, because nothing
/// holds the wheelset in the middle, or because no motion has this amplitude (a hump of the potential).
///
/// A wheelset that rolls without slip has y'' = -difference(y) / (e r0), a prime being d/dx. So
///     (y')^2 = 2 (S(amplitude) - S(y)) / (e r0),   S = integral of the difference over y,
/// and the wavelength is twice the integral of dy / y' from the leftmost to the rightmost point. The
/// difference is taken as linear between its values; S is then quadratic, and the integral has a closed form,
/// so that neither turning points nor jumps cost accuracy. The motion is about the lowest point of S.
///
/// `function` rises in `lateral`, which may repeat where the difference jumps; three values at least.
std::optional<EquivalentConicity> equivalent_conicity(std::span<const RadiusDifference> function,
                                                      double amplitude, const KlingelLengths& lengths);

} // namespace bem_contact
