#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of contact/coupled. For the words see contact/settings.hpp.
namespace bem_contact::contact {

// --- outer iterations ---

/// 1. Influence numbers below this share of the largest self number are rounding.
BEM_CONTACT_TUNED(double, coupling_rounding, 1e-13);
/// 1. Tolerance of the first outer iterations: shear is only known so well, and tighter would be wasted work.
/// With 1e-4 sequences take 3 % more instructions.
BEM_CONTACT_TUNED(double, loose_tolerance, 1e-3);
/// 1. The tolerance follows the change of the last outer iteration, times this. Of 0.01 to 0.2 it takes the
/// fewest instructions in sequences: with 0.01 those of finite elements take 4 % more.
BEM_CONTACT_TUNED(double, tolerance_of_change, 0.1);
/// 1. A tolerance below this times the one asked for becomes that one: this outer iteration may be the last,
/// and what is left takes Newton's method hardly a step.
BEM_CONTACT_TUNED(double, final_tolerance_ratio, 30);
/// 1. From one outer iteration to the next the pressure force changes at most by this factor. Chosen.
BEM_CONTACT_TUNED(double, largest_force_step, 4);
/// 1. The largest pressure force that is tried, over the prescribed force. If it does not carry the force
/// nothing does: friction pulls the bodies together as hard as they press each other apart. Chosen.
BEM_CONTACT_TUNED(double, largest_force_ratio, 30);
/// 1. The prescribed force over the pressure force that is tried first, at most. Chosen.
BEM_CONTACT_TUNED(double, largest_start_share, 4);
/// 1. Near a start a unit more of pressure force bears at least so much more of the load. Where shear bears
/// nearly as much against the load as pressure bears of it, part of the contact sticks, and shear does not
/// grow in proportion: on a flange at 19 times the load this is 0.43, where a proportion would say 0.05.
BEM_CONTACT_TUNED(double, least_start_slope, 0.4);
/// 1. Two pressure forces give a secant if they differ by more than this share of the noise of sums of
/// forces, which loosely solved problems have: loose_tolerance. Chosen.
BEM_CONTACT_TUNED(double, least_secant_step, 0.1);
/// Outer iterations. Over so many their rate of convergence is judged. Of accelerated ones single changes say
/// nothing. Chosen: with twice as many, half of all that are allowed by default pass before anything is said.
BEM_CONTACT_TUNED(int, iterations_of_a_rate, 12);
/// 1. Iterations end without a result if they need more than this times those that are left. Chosen.
BEM_CONTACT_TUNED(double, hopeless_factor, 2);
/// Former iterations that Anderson acceleration uses. Chosen.
BEM_CONTACT_TUNED(int, anderson_memory, 5);
/// 1. Anderson acceleration starts anew if the residual exceeds anderson_restart times the best one. Its
/// first step is then anderson_short_step times a step without acceleration. Chosen.
BEM_CONTACT_TUNED(double, anderson_restart, 5);
BEM_CONTACT_TUNED(double, anderson_short_step, 0.3);
/// 1. Shear tractions that follow the pressure grow at most by this factor. Chosen.
BEM_CONTACT_TUNED(double, largest_shear_growth, 10);
/// Elements of the grid, and across it. Problems with fewer elements are solved as quickly without a start as
/// from a solution on larger elements.
BEM_CONTACT_TUNED(int, least_elements_for_rough_start, 800);
BEM_CONTACT_TUNED(int, few_across, 16);
/// 1. Tolerance on the larger elements of a start: their own error is larger.
BEM_CONTACT_TUNED(double, start_tolerance, 1e-3);

} // namespace bem_contact::contact
