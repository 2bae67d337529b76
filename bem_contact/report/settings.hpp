#pragma once

namespace bem_contact::report {

/// Profiles of a wear run that a page draws besides the new one: more lines cannot be told apart on paper.
inline constexpr int drawn_steps = 5;

} // namespace bem_contact::report
