#pragma once

namespace bem_contact::report {

/// Profiles of a wear run that a page holds besides the new one: its animation moves smoothly, and both
/// profiles of all of them take about 1 MB.
inline constexpr int held_steps = 20;

} // namespace bem_contact::report
