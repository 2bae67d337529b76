#pragma once

#include "bem_contact/contact/tangential/contact_elements.hpp"
#include "bem_contact/contact/tangential/linearisation.hpp"

namespace bem_contact::contact {

/// linearise() where the layer hardens or softens: the bounds follow from the tractions and slips of these
/// elements and of those ahead, on a grid of so many columns.
Linearisation linearise_hardening(const ContactElements& elements, int columns, const Eigen::VectorXd& p,
                                  const Eigen::VectorXd& slip);

} // namespace bem_contact::contact
