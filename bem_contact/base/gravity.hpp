#pragma once

namespace bem_contact {

/// Acceleration of free fall, mm/s^2 (the standard value).
inline constexpr double standard_gravity = 9806.65;

} // namespace bem_contact
