#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of contact/tangential. For the words see contact/settings.hpp.
namespace bem_contact::contact {

// --- Newton ---

/// Elements in contact. Up to here a dense matrix with LU factors as preconditioner is faster than transforms
/// (measured: with 220 sequences of cases take a sixth longer; time steps, which keep the factors, do not).
BEM_CONTACT_TUNED(int, dense_tangential_elements, 180);
/// Elements in contact. The same of many right sides with one matrix.
BEM_CONTACT_TUNED(int, dense_right_sides_elements, 500);
/// Products of GCR with the factors of a former matrix; then they are made anew, which takes as long as 20
/// products. Chosen.
BEM_CONTACT_TUNED(int, most_former_products, 10);
/// Products, 1, 1. GCR ends where so many products took off less than stalled_share of the residual, and it
/// is within stalled_near times the tolerance. Without that, 250 products left 1.28e-4 where 1e-4 was asked
/// for; the next Newton step makes good for it.
BEM_CONTACT_TUNED(int, stalled_products, 10);
BEM_CONTACT_TUNED(double, stalled_share, 0.01);
BEM_CONTACT_TUNED(double, stalled_near, 10);
/// Solutions and directions that are kept for the next system. Of 5 to 100 in all these take the least time
/// (measured): 30 of 100 products fewer in time steps, 16 in sequences, 40 where a force is prescribed.
BEM_CONTACT_TUNED(int, kept_solutions, 10);
BEM_CONTACT_TUNED(int, kept_directions, 5);
/// The same of few elements, where a product is cheap (measured: 10 and 5 take 3 % of a time step more).
BEM_CONTACT_TUNED(int, few_kept_solutions, 5);
BEM_CONTACT_TUNED(int, few_kept_directions, 2);
/// Elements in contact. Of more none are kept: to make them orthogonal takes what they save (measured).
BEM_CONTACT_TUNED(int, most_recycling_elements, 3000);
/// 1. The method ends when less than this share of a direction's image is new: single precision has no more
/// digits.
BEM_CONTACT_TUNED(float, least_new_share, 1e-6f);
/// 1. The same of one that was kept, which is left out: it would enlarge rounding by the inverse. Chosen.
BEM_CONTACT_TUNED(float, least_new_kept_share, 1e-3f);
/// 1. Newton's method projects p_t + stiffness S of an element onto the disc |p_t| <= mu p_n. The
/// derivative of this projection along the edge of the disc is 1 for an element that sticks and smaller for
/// one that slips. From this value on, a slipping element counts as sticking in that direction. Chosen.
BEM_CONTACT_TUNED(double, counts_as_sticking, 0.7);
/// 1. The preconditioner uses the mean of this derivative over all slipping elements, but at least this
/// value. Chosen: below it, slip is so fast that the matrix is the identity.
BEM_CONTACT_TUNED(double, least_mean_slope, 1e-3);
/// 1. Precision of the linear systems: the smaller of newton_forcing times the square of the last reduction
/// and known_forcing times the residual over the bounds of friction, within the two limits. Quadratic
/// convergence shows when the states are known, and so does a small residual at the start. The first is
/// chosen. With the second Newton's method takes an eighth fewer steps (measured).
BEM_CONTACT_TUNED(double, newton_forcing, 0.3);
BEM_CONTACT_TUNED(double, known_forcing, 10);
BEM_CONTACT_TUNED(double, finest_newton_forcing, 1e-4);
BEM_CONTACT_TUNED(double, coarsest_newton_forcing, 0.1);
BEM_CONTACT_RELATION(finest_newton_forcing <= coarsest_newton_forcing);
/// 1. A linear system need not reach more than this share of the tolerance asked for. Chosen.
BEM_CONTACT_TUNED(double, newton_end_forcing, 0.2);
/// Lengths that the line search tries, and by how much the residual has to decrease (Armijo's condition).
BEM_CONTACT_TUNED(int, newton_halvings, 6);
BEM_CONTACT_TUNED(double, newton_decrease, 1e-4);
/// Line searches without decrease; then Newton's method has failed. Chosen.
BEM_CONTACT_TUNED(int, most_failed_searches, 6);
/// 1. After a Newton step that leaves more of the residual, the worst rows are swept. Chosen.
BEM_CONTACT_TUNED(double, slow_newton_step, 0.3);

// --- sweeps and rolling on ---

/// 1. The rows to sweep hold this share of the sum of squares of the residual. Chosen.
BEM_CONTACT_TUNED(double, swept_share, 0.7);
/// 1, elements. These rows are swept only if they hold at most this share of all elements in contact, and at
/// most most_swept_elements: the cost of a sweep grows with the square of their number. Chosen.
BEM_CONTACT_TUNED(double, most_swept_share, 0.25);
BEM_CONTACT_TUNED(int, most_swept_elements, 1000);
/// Sweeps. At most so many over the rows; they end earlier if the share row_sweeps_enough of the residual is
/// left. Chosen.
BEM_CONTACT_TUNED(int, most_row_sweeps, 50);
BEM_CONTACT_TUNED(double, row_sweeps_enough, 0.01);
/// 1 / stiffness. Damping of the first sweep over rows. Undamped ones overshoot. Chosen.
BEM_CONTACT_TUNED(double, first_row_damping, 1);
/// Steps and relative precision of the iteration of More and Sorensen for one element: rounding.
BEM_CONTACT_TUNED(int, most_element_steps, 60);
BEM_CONTACT_TUNED(double, element_precision, 1e-13);

// --- kinetic friction and creepages ---

/// 1. An element slips if its traction is this close to the bound and its slip above this share of the
/// largest: well above the tolerance of the solvers, 1e-8.
BEM_CONTACT_TUNED(double, at_the_bound, 1e-7);
/// 1. A secant step outside the bracket is lengthened by this, to bracket the force, and a step grows at
/// most by the second. Chosen.
BEM_CONTACT_TUNED(double, creepage_overshoot, 1.2);
BEM_CONTACT_TUNED(double, creepage_growth, 10);
/// Steps that do not halve the bracket; then it is bisected. Chosen.
BEM_CONTACT_TUNED(int, most_slow_steps, 3);
/// 1. First step of the search, in units of the creepage that brings one element to its bound, and (second)
/// relative to the creepage of the outer iteration before, if there was one. Chosen.
BEM_CONTACT_TUNED(double, first_creepage_step, 10);
BEM_CONTACT_TUNED(double, near_creepage_step, 1e-3);

} // namespace bem_contact::contact
