#pragma once

#include "bem_contact/fatigue/damage.hpp"
#include "bem_contact/fatigue/shakedown.hpp"
#include "bem_contact/fatigue/stress_peaks.hpp"

#include <optional>
#include <vector>

namespace bem_contact {
struct SceneResult;
}

namespace bem_contact::fatigue {

/// What the steel bears.
struct FatigueProperties {
  double yield_shear = 300;   ///< k, MPa
  double poisson = 0.28;      ///< of the rail, for stresses below the surface
  DamageFunction damage = {}; ///< of one passage
  bool stresses = true;       ///< search the largest stresses below the surface: most of the work

  bool operator==(const FatigueProperties&) const = default;
};

/// One area in contact.
struct PatchFatigue {
  double s = 0, y = 0;      ///< centre of pressure: arc length on the rail, y of the rows' frame, mm
  double normal_force = 0;  ///< N: sum p_n dS
  double pmax = 0;          ///< MPa
  ShakedownPoint point;     ///< with the largest pressure of the patch as p0
  double surface_index = 0; ///< FI_surf of that point
  double largest_index = 0; ///< of its elements
  double t_gamma = 0;       ///< what friction dissipates by rolled distance, spin included, N
  double damage = 0;        ///< by passage, 1
};

/// What one contact does to the rail.
struct Fatigue {
  std::vector<double> element_index; ///< FI of each element; -0.5 outside the contact; field
  std::vector<PatchFatigue> patches; ///< largest normal force first
  std::optional<StressPeaks> peaks;  ///< where they are asked for and there is contact
};

/// Throws InputError for properties that make no sense and for a result that did not converge. Without
/// friction, or of a shift, T-gamma and damage are 0.
Fatigue fatigue_of(const SceneResult& result, const FatigueProperties& properties = {});

} // namespace bem_contact::fatigue
