#pragma once

/// The numbers of the stated errors. They are fitted to random cases of tools/benchmarks/estimates, so that
/// about 96 in 100 true errors are below the stated ones and the median of stated over true is least. Those
/// of shear are fitted to 870 cases (seeds 1, 2, 6 and 7), the others to 415 (1 and 2); those of pmax and of
/// shear were set anew on 1200 (8 to 11), those of temperatures on 720 (1, 2, 6 to 9 and 12 to 17). `local`
/// of shear, shear_deviation, both of adhesion and those of creepages were set anew on 1357 by half-spaces
/// (8, 9, 41 and 51; 906 of them with free rolling), those of a prescribed Fs and of the normal force on 346
/// (111 to 141). tools/BENCHMARKS.md, section 9, judges them on other cases.
namespace bem_contact::contact {

/// The error of a number is the sum of four parts. Each entry is a share, 1.
struct ErrorShares {
  double change = 0; ///< of the change from elements twice as large
  /// Share of what whole elements leave open even where larger ones give the same number, because the border
  /// of the contact is known to a part of an element only.
  double local = 0;
  double peak = 0; ///< of how far the pressure (of temperatures: they) falls beside its peak
  /// Of the root of the sum of squares over the elements in adhesion, whose errors are taken as independent.
  double adhesion = 0;
};

/// Shares on a grid of rows and columns, and on one row or one column. There each end may be off by half an
/// element, but no other row adds its own.
struct GridShares {
  ErrorShares wide, line;

  const ErrorShares& of(bool is_line) const { return is_line ? line : wide; }
};

/// The table. Fx, Fs, Fy, Fz and moments are sums over elements.
namespace shares {
inline constexpr GridShares pmax{{.change = 0.02, .peak = 0.092}, {.change = 0.02, .peak = 0.22}};
inline constexpr GridShares area{{.local = 0.16}, {.local = 0.62}}; ///< local: the elements on the border
/// local: elements whose state is in doubt anyway; adhesion: the root of the border of adhesion.
inline constexpr GridShares adhesion_share{{.change = 0.25, .local = 1.2, .adhesion = 1.05},
                                           {.change = 0.25, .local = 0.504, .adhesion = 0.441}};
inline constexpr GridShares shear{{.change = 0.475, .local = 0.85, .adhesion = 0.5},
                                  {.change = 0.475, .local = 0.289, .adhesion = 0.17}};
/// The p_x that spin causes has opposite signs on both sides of the contact and cancels. In Fs spin leaves a
/// difference of tractions, whose error is as large as theirs.
inline constexpr GridShares shear_x{{.change = 0.475, .local = 0.85, .adhesion = 0.3},
                                    {.change = 0.475, .local = 0.289, .adhesion = 0.102}};
/// Normal force of a patch: shear changes it where normals turn within the contact.
inline constexpr GridShares normal{{.change = 0.475, .local = 0.85, .adhesion = 0.6},
                                   {.change = 0.475, .local = 0.289, .adhesion = 0.204}};
/// Moment about the normal of a patch.
inline constexpr GridShares patch_moment{{.change = 0.475, .local = 0.7395, .adhesion = 0.435},
                                         {.change = 0.475, .local = 0.25143, .adhesion = 0.1479}};
inline constexpr GridShares moment{{.change = 0.41325, .local = 0.7395, .adhesion = 0.435},
                                   {.change = 0.41325, .local = 0.25143, .adhesion = 0.1479}};
/// local: its rise, over the elements in contact.
inline constexpr ErrorShares temperature{.change = 0.17, .local = 0.17, .peak = 0.11};
/// Approach, and the overlap of a patch. local: over the elements in contact.
inline constexpr GridShares approach{{.change = 0.2, .local = 0.3, .peak = 0.018},
                                     {.change = 0.2, .peak = 0.034}};
inline constexpr GridShares overlap{{.change = 0.11, .local = 0.9, .peak = 0.034},
                                    {.change = 0.11, .peak = 0.062}};
/// Creepages that are found. local: the force that larger elements carry elsewhere, and adhesion: the force
/// of the elements in adhesion over the root of their number, both times the creepage per unit of force.
inline constexpr ErrorShares creepage_x{.change = 0.36, .local = 0.058, .adhesion = 0.2};
inline constexpr ErrorShares creepage_s{.change = 0.2952, .local = 0.04756, .adhesion = 0.164};
} // namespace shares

/// 1. The local part of sums of shear is bounded. Compare the shear of each element with the share of the sum
/// that its pressure would give it: the bound takes this many times the mean deviation in place of the mean
/// absolute value.
inline constexpr double shear_deviation = 6.0;
/// 1. The errors of these sums grow with this power of Region::elongation(). On elements longer than wide, as
/// scenes without [grid] have them, 88 to 94 % of 100 cases were within errors without it (seed 191).
inline constexpr double shear_elongation = 0.75;
/// 1. The same for the moment about the normal: with the power above 92 % of 100 cases were within.
inline constexpr double moment_elongation = 0.95;
/// 1. Of what the slip of elements does not show of the power of friction (contact/dissipation.hpp), in that
/// power and in the highest temperature: the place of this heat is known to some elements only.
inline constexpr double missing_power = 0.3;
inline constexpr double missing_heat = 0.9;
/// 1. Of the rise of temperature, times an element's size over the contact's, where slip does not show all of
/// the power: the border of slip lies between elements. Without it contacts of some 300 elements that nearly
/// all slip were up to 1.5 times outside.
inline constexpr double heat_between = 0.1;
/// 1. Share of the power from which on slip shows all of it.
inline constexpr double all_shown_power = 0.999;
/// 1. Share of the power that slip must show where the error of a temperature is stated: else slip is in a
/// zone narrower than an element, and a narrower one is hotter.
inline constexpr double least_shown_power = 0.5;
/// 1. Roughness of the undeformed distance, as a pressure, in pmax.
inline constexpr double pmax_rough = 0.06;
/// 1. The normal force of a patch changes where normals turn: by this share of what the sum of the pressure
/// exceeds its resultant by, divided by the number of elements in contact. Chosen on columns without
/// friction: "one column" of tools/benchmarks/estimates, seeds 291, 301 and 311.
inline constexpr double normal_bent = 0.15;
/// 1. Fy has an error from the direction of the pressure too: this share of the pressure beside its mean
/// direction, divided by the number of elements in contact.
inline constexpr double direction_local = 0.5;
/// 1. The creepage of a prescribed Fs has this share of the change of the rigid slip w_s from one element to
/// the next too. Under spin another place has another w_s.
inline constexpr double creepage_turn = 0.088;

} // namespace bem_contact::contact
