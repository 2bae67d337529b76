#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

namespace bem_contact {

/// The independent check of a result: direct sums over the influence numbers, with nothing of the solvers'
/// operators. More than settings.hpp's many_terms terms (about 10,000 elements in contact) are summed by FFT,
/// and direct sums at 100 elements must confirm the FFT to 1e-9; if they do not, all sums are direct.
/// `displacements`: if not null, it gets the displacements of all elements from the same sums. Without it, x
/// and s are summed on rows in contact only.
/// Throws InputError if the fields of the result do not have the size of the grid.
Certificate certify(const ContactProblem& problem, const ContactResult& result,
                    Displacements* displacements = nullptr);

} // namespace bem_contact
