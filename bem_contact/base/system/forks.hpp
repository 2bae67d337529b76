#pragma once

namespace bem_contact::system {

/// Calls them around each copy of this process: before it, and after it in this process and in the copy.
void watch_forks(void (*before)(), void (*here)(), void (*in_copy)());

} // namespace bem_contact::system
