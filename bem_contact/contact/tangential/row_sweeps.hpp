#pragma once

#include "bem_contact/contact/tangential/contact_elements.hpp"
#include "bem_contact/contact/tangential/linearisation.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

/// Gauss-Seidel over the few rows that hold most of the residual, from the leading edge, everything else held
/// fixed. At a narrow end of the adhesion area slip eats its way through a row by one element a Newton step;
/// this costs less than Newton steps on all elements.
/// `slip` belongs to the tractions p before the call. Changes p on these rows. False, and p is unchanged, if
/// the residual is not concentrated in few rows or the sweeps do not reduce it.
bool sweep_rows(const TangentialSystem& system, const ContactElements& elements, const Eigen::VectorXd& slip,
                const Linearisation& at, WorkBudget& work, Eigen::VectorXd& p);

} // namespace bem_contact::contact
