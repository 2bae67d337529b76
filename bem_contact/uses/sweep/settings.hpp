#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// 1. One process solves a chunk of cases one after the other and starts each case from the one before. More
/// chunks share the work better; longer chunks have fewer cold starts. Chosen, not measured.
BEM_CONTACT_TUNED(std::size_t, chunks_of_a_sweep, 8);
/// Cases. Smallest and largest chunk. Chosen, not measured.
BEM_CONTACT_TUNED(std::size_t, smallest_chunk, 4);
BEM_CONTACT_TUNED(std::size_t, largest_chunk, 32);

} // namespace bem_contact
