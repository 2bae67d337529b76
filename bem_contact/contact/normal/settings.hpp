#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of contact/normal. For the words see contact/settings.hpp.
namespace bem_contact::contact {

/// Elements in contact. Up to here a Cholesky factorisation is faster than two runs of conjugate gradients.
BEM_CONTACT_TUNED(int, dense_normal_elements, 320);
/// 1. The factor of a former contact serves while the elements that left it and the new ones are no larger
/// share of it: to border it with more takes longer than to factor anew.
BEM_CONTACT_TUNED(double, most_bordered, 0.12);
/// 1. A box around the contact is wider by 1 + grid / this elements on each side, so that it serves longer.
/// Chosen.
BEM_CONTACT_TUNED(int, normal_margin_divisor, 60);
/// 1. Precision of the last linear systems: normal_precision times the tolerance asked for. It is no finer
/// than finest_normal_precision, which is all that double precision gives, and no coarser than
/// coarsest_normal_precision, which the certificate needs.
BEM_CONTACT_TUNED(double, normal_precision, 1e-2);
BEM_CONTACT_TUNED(double, finest_normal_precision, 1e-13);
BEM_CONTACT_TUNED(double, coarsest_normal_precision, 1e-6);
BEM_CONTACT_RELATION(finest_normal_precision <= coarsest_normal_precision);
/// 1. Precision of the first linear system from nothing, and from a guess. Chosen: the sets still change.
BEM_CONTACT_TUNED(double, cold_normal_precision, 1e-3);
BEM_CONTACT_TUNED(double, warm_normal_precision, 1e-4);
/// 1. Relative precision of the linear system after all elements have entered or left the contact. If only a
/// share of them has, this times that share. Chosen.
BEM_CONTACT_TUNED(double, precision_of_changes, 1e-2);
/// Bisections of the first approach: 2^-30 of the bracket is far below what the first guess needs.
BEM_CONTACT_TUNED(int, first_guess_bisections, 30);
/// 1. Rows with a smaller cos(delta) carry no vertical force: the search for a first approach leaves them
/// out. validate() refuses a prescribed force if all rows are like that.
BEM_CONTACT_TUNED(double, least_cosine, 1e-6);
/// 1. How far one run in single precision brings the residual down for certain.
BEM_CONTACT_TUNED(double, cg_single_run, 1e-4);
/// 1. Fixed step of MPRGP times the norm; it must be below 2 (Dostal, Schoeberl 2005, give 1.9 and more).
BEM_CONTACT_TUNED(double, mprgp_step, 1.9);
BEM_CONTACT_RELATION(mprgp_step < 2);
/// 1. Precision of MPRGP relative to the tolerance asked for, and its limit by rounding. Chosen.
BEM_CONTACT_TUNED(double, mprgp_precision, 1e-3);
BEM_CONTACT_TUNED(double, finest_mprgp_precision, 1e-12);
/// 1. Precision of the force relative to the tolerance asked for, where the approach is bracketed. Chosen.
BEM_CONTACT_TUNED(double, force_precision, 0.1);
/// 1. The first step of the bracket, as a share of the approach of one element under the whole force. Chosen.
BEM_CONTACT_TUNED(double, approach_bracket_start, 0.01);

} // namespace bem_contact::contact
