#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

namespace bem_contact {

/// The independent check of a result: direct sums over the influence numbers, with nothing of the solvers'
/// operators. Where these are too many (settings.hpp: many_plane_terms; translational numbers only) an FFT of
/// its own sums, from the numbers again, on a longer grid; direct sums at an element of each row in contact
/// and at others must confirm it to 1e-9. If they do not, all sums are direct.
///
/// `displacements`: if not null, it gets the displacements of all elements from the same sums. Without it, x
/// and s are summed where slip is made of them: at the elements in contact now and ahead of them, those of
/// former tractions as well. `threads` share the sums of a steady motion.
///
/// Throws InputError if the fields of the result do not have the size of the grid.
Certificate certify(const ContactProblem& problem, const ContactResult& result,
                    Displacements* displacements = nullptr, int threads = 1);

} // namespace bem_contact
