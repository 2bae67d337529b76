#pragma once

namespace bem_contact::fem {

/// Most memory that this process has used so far, GiB.
double peak_memory();
/// Memory that processes may still take, GiB; infinite where the system does not say.
double available_memory();

} // namespace bem_contact::fem
