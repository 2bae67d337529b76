#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_function.hpp"

#include <cstdint>
#include <string>

/// Whether an influence function serves what it is wanted for. Each function throws InputError if it does
/// not.
namespace bem_contact {

/// A contact needs influence functions where their strip has ended.
class OffStripError : public InputError {
public:
  using InputError::InputError; ///< as Error
};

/// It was computed for this profile: the digest of ProfileCurve counts, the name is for the message.
void require_profile(const InfluenceDescription& function, const std::string& profile, std::uint64_t digest);
/// It was computed for this material.
void require_material(const InfluenceDescription& function, const Material& material);
/// Its material lies above its surface, as that of a wheel on a rail.
bool lies_above(const InfluenceStrip& strip);
/// The two files are not exchanged: the lower body (rail) has its material below, the upper one (wheel)
/// above.
void require_order(const InfluenceStrip& lower, const InfluenceStrip& upper);
/// [s_from, s_to], mm, lies on its contact strip. Throws OffStripError.
void require_strip(const InfluenceStrip& strip, double s_from, double s_to);

/// The shortest element along x that its wavenumbers serve, at the reference radius, mm. 0: a table, or
/// numbers of plane strain alone.
double shortest_dx(const InfluenceStrip& strip);

} // namespace bem_contact
