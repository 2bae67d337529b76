#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/uses/curves/measured_forces.hpp"
#include "bem_contact/uses/fit/least_squares.hpp"

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::fit {

/// What is looked for: the keys of a scene with which its creep forces come closest to measured ones.
struct Question {
  SceneText text;                   ///< its values are the first guess
  std::vector<SceneChange> changes; ///< of its keys
  std::string model;                ///< "": as the scene says
  MeasuredForces measured;          ///< more points than keys
  std::vector<std::string> keys;    ///< whose values are numbers: "layer.compliance"
};

/// A key as the points have it.
struct FittedKey {
  std::string key;             ///< "layer.compliance"
  std::string unit;            ///< of its values
  double start = 0, value = 0; ///< first guess; what was found
  double low = 0, high = 0;    ///< ends of the interval of 95 %; nan: no point depends on it
  double standard_error = 0;   ///< the same
  Bound bound = Bound::none;   ///< of the key's range
  bool determined = false;     ///< some point depends on it
};

/// The answer.
struct CurveFit {
  std::vector<FittedKey> keys;     ///< in the order of the question
  std::vector<double> correlation; ///< [key][key], of the estimates
  MeasuredForces measured;         ///< with what is computed at the found values
  CreepCurves curves;              ///< there, with one curve over all points
  std::vector<std::pair<double, double>>
      band;                              ///< of that curve: where 95 % of what the points allow lies, N, N mm
  double misfit = 0;                     ///< root of the mean square of computed less measured, N, N mm
  int tried = 0;                         ///< sets of values for which all points were solved
  bool converged = false;                ///< the search ended by itself
  std::vector<std::string> undetermined; ///< what the points do not say, in sentences
  SceneFile scene;                       ///< with the found values
};

/// Whether the search ended and all that is shown is certified.
bool certified(const CurveFit& fit);

/// Fits keys to measured forces by least squares, points weighted by one over their scatter where it is
/// given. The model, the size of the elements and where a wheel stands are those of the first guess
/// (HeldContact). Throws InputError for keys that no scene has, that are no numbers, have no value or that
/// nothing depends on, for too few points, and as creep_curves() does.
CurveFit fit_curve(const Question& question, const std::atomic<bool>* stop = nullptr);

} // namespace bem_contact::fit
