#pragma once

#include "bem_contact/contact/solver_options.hpp"

#include <string>

/// How much a case enlarges small changes of its input. tools/stability calls the test program for it.
namespace bem_contact::hard {

/// Prints lines `moved | case | input | size | total | amplification` and `shifted | case | fraction | total
/// | change`, if the environment variable BEM_CONTACT_MOVED_INPUT is set; does nothing otherwise.
///
/// Each input (load, friction, rigid slip, undeformed distance, influence numbers) is multiplied by 1 + size,
/// for sizes of 1e-9, 1e-6 and 1e-3; and noise of `size` times the approach is added to the undeformed
/// distance. The amplification is the change of a total over its scale, divided by the size. The grid is
/// shifted along x by fractions of an element; the change of the total over its scale is printed.
void print_moved(const std::string& name, const ContactProblem& problem, SolverOptions options);

} // namespace bem_contact::hard
