#pragma once

#include <functional>

namespace bem_contact {

/// Divides 0 .. count - 1 into `threads` runs of about equal length and calls body(first, end, part) for each, `part`
/// its number, side by side on as many threads (OpenMP). With one thread the body runs here. `body` must not
/// throw.
void in_parts(int threads, int count, const std::function<void(int first, int end, int part)>& body);

} // namespace bem_contact
