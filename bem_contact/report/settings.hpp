#pragma once

#include <cstdint>

namespace bem_contact::report {

/// Profiles of a wear run that a page holds besides the new one: its animation moves smoothly, and both
/// profiles of all of them take about 1 MB.
inline constexpr int held_steps = 20;

/// Bytes. Pages of smaller sweeps hold the patches of all cases, in three times as many bytes. Chosen, so
/// that a page can be sent by mail.
inline constexpr std::uintmax_t largest_with_fields = 4'000'000;

} // namespace bem_contact::report
