#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of contact/tangential. For the words see contact/settings.hpp.
namespace bem_contact::contact {

// --- Newton ---

/// Elements in contact. Up to here a dense matrix with LU factors as preconditioner is faster than transforms
/// (measured: with 220 sequences of cases take a sixth longer; time steps, which keep the factors, do not).
BEM_CONTACT_TUNED(int, dense_tangential_elements, 180);
/// 1. With a larger share of new elements that matrix is made anew. Chosen.
BEM_CONTACT_TUNED(double, most_new_elements, 0.15);
/// Products of GCR with the factors of a former matrix; then they are made anew, which takes as long as 20
/// products. Chosen.
BEM_CONTACT_TUNED(int, most_former_products, 10);
/// Elements in contact. Above this the dense matrix (432 MB here, in both precisions) is not even a
/// fall-back.
BEM_CONTACT_TUNED(int, most_dense_elements, 3000);
/// Products of GCR. Chosen: where it needs more, LU factors are as fast.
BEM_CONTACT_TUNED(int, most_gcr_products, 250);
/// Products, 1, 1. GCR ends where so many products took off less than stalled_share of the residual, and it
/// is within stalled_near times the tolerance. Without that, 250 products left 1.28e-4 where 1e-4 was asked
/// for; the next Newton step makes good for it.
BEM_CONTACT_TUNED(int, stalled_products, 10);
BEM_CONTACT_TUNED(double, stalled_share, 0.01);
BEM_CONTACT_TUNED(double, stalled_near, 10);
/// Directions for which memory is taken at first; it grows where that is not enough. Chosen.
BEM_CONTACT_TUNED(int, first_directions, 32);
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

// Sensitivities.

/// 1. Precision of the linear system at a solution, and times it is solved for what is left of it: each takes
/// off four digits.
BEM_CONTACT_TUNED(double, sensitivity_precision, 1e-9);
BEM_CONTACT_TUNED(int, most_sensitivity_refinements, 12);
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
/// 1 / stiffness. Damping of the first sweep over all elements, and where it has become too slow to go on.
/// Undamped sweeps diverge; more is needed on finer grids. Chosen.
BEM_CONTACT_TUNED(double, first_element_damping, 3);
BEM_CONTACT_TUNED(double, largest_element_damping, 200);
/// Sweeps after which the damping is doubled unless this share or less of the violation is left. Chosen.
BEM_CONTACT_TUNED(int, sweeps_per_damping, 40);
BEM_CONTACT_TUNED(double, sweeps_enough, 0.3);
/// Steps and relative precision of the iteration of More and Sorensen for one element: rounding.
BEM_CONTACT_TUNED(int, most_element_steps, 60);
BEM_CONTACT_TUNED(double, element_precision, 1e-13);
/// Steps of the projected gradients for one rolling step or shift. Chosen.
BEM_CONTACT_TUNED(int, most_gradient_steps, 1000);
/// 1. Their precision relative to the largest bound, for a shift and for each of many rolling steps. Chosen.
BEM_CONTACT_TUNED(double, shift_precision, 1e-12);
BEM_CONTACT_TUNED(double, rolling_precision, 1e-10);
/// Lengths of the grid to roll on. Chosen: transients decay within a few lengths of the contact.
BEM_CONTACT_TUNED(int, rolling_on_lengths, 6);

// --- kinetic friction and creepages ---

/// 1. An element slips if its traction is this close to the bound and its slip above this share of the
/// largest: well above the tolerance of the solvers, 1e-8.
BEM_CONTACT_TUNED(double, at_the_bound, 1e-7);
/// Directions in which the capacity of friction is compared with the force: 0.5 degrees apart. Chosen.
BEM_CONTACT_TUNED(int, capacity_directions, 720);
/// 1. A force this close to the capacity is full slip: rounding.
BEM_CONTACT_TUNED(double, rounding_of_capacity, 1e-9);
/// Tangential problems that the search for one creepage may solve. Chosen.
BEM_CONTACT_TUNED(int, most_creepage_calls, 120);
/// 1 (shift: mm). Where everything slips no force depends on the creepage. Chosen: the search ends here.
BEM_CONTACT_TUNED(double, farthest_creepage, 1e12);
/// 1. A bracket narrower than this share of the creepage holds a jump of the force: far below what tells
/// adhesion from slip.
BEM_CONTACT_TUNED(double, creepage_jump, 1e-11);
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
/// 1. Precision of the tractions under a unit of creepage at a solution, from which its compliance follows: a
/// share of a stated error. Chosen.
BEM_CONTACT_TUNED(double, compliance_precision, 0.01);
/// Newton steps with creepages among the unknowns; then they are searched for. Chosen.
BEM_CONTACT_TUNED(int, most_forced_steps, 20);
/// Newton steps for two creepages, and how many of them may fail. Chosen.
BEM_CONTACT_TUNED(int, most_creepage_newton, 40);
BEM_CONTACT_TUNED(int, most_creepage_stops, 4);
/// 1. Difference of the finite differences, relative to the creepage. Chosen.
BEM_CONTACT_TUNED(double, creepage_difference, 1e-3);
/// 1. The longest of these steps, relative to the creepage. Chosen.
BEM_CONTACT_TUNED(double, longest_creepage_step, 2);
/// Lengths that the line search tries, and by how much the missing force has to decrease. Chosen.
BEM_CONTACT_TUNED(int, creepage_halvings, 10);
BEM_CONTACT_TUNED(double, creepage_decrease, 1e-3);

} // namespace bem_contact::contact
