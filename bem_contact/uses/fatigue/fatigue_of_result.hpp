#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/uses/fatigue/stress_peaks.hpp"
#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <vector>

/// What rolling contact fatigue reads off a contact.
namespace bem_contact {
struct SceneResult;
struct SweepFile;
} // namespace bem_contact

namespace bem_contact::fatigue {

/// Where a contact lies in the shakedown diagram (Johnson 1985, section 9.2).
struct ShakedownPoint {
  double load = 0;     ///< p0 / k, the largest pressure over the yield stress in shear
  double traction = 0; ///< mu used: the resultant of shear over the normal force
};

/// FI_surf = mu used - k / p0 (Ekberg, Kabo and Andersson, Fatigue Fract. Eng. Mater. Struct. 25 (2002) 899):
/// above 0 the surface flows cycle after cycle, and fatigues. Throws InputError unless p0/k > 0.
double surface_index(const ShakedownPoint& point);

/// FI of an element that bears no pressure. The map of Ekberg et al. is not read below it.
inline constexpr double least_element_index = -0.5;

/// FI of one element, from its own tractions: (|p_t| - k) / p_n, or least_element_index if that is more.
/// p_n > 0, MPa.
double element_index(double shear_traction, double pressure, double yield_shear);

/// Throws InputError unless the yield stress in shear is positive.
void require_yield_shear(double yield_shear);

/// Damage by fatigue of one passage over T-gamma, N: straight lines between nodes (Burstow, AEA Technology
/// AEATR-ES-2003-832 (2003), the whole life rail model). A crack begins where the damage of all passages
/// sums up to 1. Below the first node there is none. The defaults are public values for rails of grade 220:
/// nothing below 20 N, most at 65 N, none at 175 N. Other steels need other nodes.
struct DamageFunction {
  std::vector<double> t_gamma{20, 65, 175}; ///< N, rising
  std::vector<double> damage{0, 1e-5, 0};   ///< by passage, 1
  /// Above the last node: 0, or the last line goes on, below zero: there wear removes more than cracks grow.
  bool wear_is_negative = false;

  bool operator==(const DamageFunction&) const = default;
};

/// Returns the damage of one passage, 1.
double damage_of(const DamageFunction& function, double t_gamma);

/// Throws InputError unless there are two nodes or more, finite and rising, each with a damage.
void validate(const DamageFunction& function);

/// What the steel bears.
struct FatigueProperties {
  double yield_shear = 300;   ///< k, MPa
  DamageFunction damage = {}; ///< of one passage
  bool stresses = true;       ///< search the largest stresses below the surface: most of the work
  /// An influence file with stresses, or a body file: what lies below the surface is then that of this rail
  /// or wheel. Empty: of a half-space, with the shakedown limit of a long contact.
  std::filesystem::path body = {};

  bool operator==(const FatigueProperties&) const = default;
};

/// One area in contact.
struct PatchFatigue {
  double s = 0, y = 0;     ///< centre of pressure: arc length on the rail, y of the rows' frame, mm
  double normal_force = 0; ///< N: sum p_n dS
  double pmax = 0;         ///< MPa
  ShakedownPoint point;    ///< with the largest pressure of the patch as p0
  /// Of p0/k, where so much friction is used: limit_below() of shakedown.hpp. In a body, that up to which
  /// this patch shakes down for sure (uses/shakedown), where it is large enough to tell.
  double limit_below = 0;
  /// In a body: the load factor up to which it shakes down for sure; else nan.
  double shakedown = std::numeric_limits<double>::quiet_NaN();
  double shakedown_upper = shakedown; ///< that from which it does not
  double surface_index = 0;           ///< FI_surf of that point
  double largest_index = 0;           ///< of its elements
  double t_gamma = 0;                 ///< what friction dissipates by rolled distance, spin included, N
  double damage = 0;                  ///< by passage, 1

  /// Says whether the shakedown limit of the surface is exceeded.
  bool beyond_surface() const { return surface_index > 0; }
  /// Says whether the limit below the surface is exceeded. That may be so where beyond_surface() is true,
  /// too.
  bool beyond_below() const { return point.load > limit_below; }
};

/// What one contact does to the rail.
struct Fatigue {
  std::vector<double> element_index;          ///< FI of each element; -0.5 outside the contact; field
  std::vector<PatchFatigue> patches;          ///< largest normal force first
  std::optional<StressPeaks> peaks;           ///< where they are asked for and there is contact
  std::optional<StressPeaks> halfspace_peaks; ///< in a body: those of a half-space at the same points
  /// In a body: the patch with the least shakedown factor, without its maps.
  std::optional<shakedown::PatchShakedown> worst;
};

/// Throws InputError for properties that make no sense, and ConvergenceError for a result that is not
/// certified(). Without friction, or of a shift, T-gamma and damage are 0. In a body also what
/// shakedown_in_body() throws.
Fatigue fatigue_of(const SceneResult& result, const FatigueProperties& properties = {});

/// The numbers of a patch, in the order of the outputs. The program's tables and Python take names, units and
/// values from here.
std::span<const ColumnOf<PatchFatigue>> patch_columns(bool in_body = false);

/// One patch of one case of a load collective.
struct CollectivePatch : PatchFatigue {
  std::size_t index = 0;       ///< of the case in the sweep
  std::size_t patch = 0;       ///< of the case, from 1, the largest force first
  double weight = 1;           ///< how often the case occurs
  double along = 0;            ///< place of its wheelset along the track, mm
  StressPeaks peaks;           ///< of the case; 0 where they are not asked for
  StressPeaks halfspace_peaks; ///< of the case, in a body; else 0
};

/// What a load collective does to the rail.
struct CollectiveFatigue {
  std::vector<CollectivePatch> patches;                ///< case by case
  std::size_t cases = 0;                               ///< of the collective
  std::size_t beyond_surface = 0;                      ///< patches beyond the shakedown limit of the surface
  std::size_t beyond_below = 0;                        ///< others beyond that below the surface
  double damage = 0;                                   ///< of one passage, mean over the collective, 1
  std::optional<shakedown::PatchShakedown> worst = {}; ///< Fatigue::worst of all cases
};

/// Solves each case of a sweep. Throws InputError for properties that make no sense, ConvergenceError where a
/// case has no certified result, and Stopped soon after another thread sets `stop`. In a body `threads` work
/// side by side; the numbers do not depend on how many.
CollectiveFatigue fatigue_of(const SweepFile& sweep, const FatigueProperties& properties,
                             const std::atomic<bool>* stop = nullptr, int threads = 1);

/// The numbers of a patch with those of its case, in the order of the outputs.
std::span<const ColumnOf<CollectivePatch>> collective_columns(bool in_body = false);

/// What fatigue says at every door: of one result, whose field "FI" it looks into, and of a collective.
record::Record record_of(const Fatigue& fatigue, const ContactGrid& grid,
                         const FatigueProperties& properties);
/// A temporary is gone before its fields are looked at.
record::Record record_of(const Fatigue&& fatigue, const ContactGrid& grid,
                         const FatigueProperties& properties) = delete;
record::Record record_of(const CollectiveFatigue& fatigue, const FatigueProperties& properties);

} // namespace bem_contact::fatigue
