#pragma once

#include "bem_contact/contact/solve.hpp"

#include <functional>

namespace bem_contact {

/// The tractions of a result, as those of a former step.
Tractions tractions_of(const ContactResult& result);

/// `steps` steps of a shift or of transient rolling, one after the other: `prescribe(k, problem)` sets what
/// step k prescribes (load, rigid slip, forces, undeformed distance), then it is solved from the tractions of
/// the steps before, the first from `problem.previous` (nothing there: from rest). One result a step; where a
/// step did not converge its result says so, and the next go on from it. Creepages are searched from those of
/// the step before. Throws InputError for steady rolling and whatever solve() throws.
std::vector<ContactResult> solve_history(ContactProblem problem, int steps,
                                         const std::function<void(int, ContactProblem&)>& prescribe,
                                         const SolverOptions& options = {});

/// Displacement differences u = u_wheel - u_rail = -A p of every element, mm; fields.
struct Displacements {
  std::vector<double> ux, us, un;
};
Displacements displacements(const ContactProblem& problem, const ContactResult& result);

/// p_t S, what friction dissipates on each element per unit of rolled distance (shift: of the step), MPa
/// (shift: MPa mm); field.
std::vector<double> friction_power(const ContactResult& result);
/// sum p_t S dS, N (shift: N mm).
double friction_power(const ContactResult& result, double element_area);

/// Largest pressure of all patches, MPa, and their area, mm^2.
double largest_pressure(const ContactResult& result);
double contact_area(const ContactResult& result);

/// Elements of all patches; what is in contact either adheres or slips.
struct ElementCounts {
  int contact = 0, adhesion = 0, slip = 0;
};
ElementCounts count_elements(const ContactResult& result);

} // namespace bem_contact
