#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/uses/curves/measured_forces.hpp"
#include "bem_contact/uses/fit/least_squares.hpp"
#include "bem_contact/uses/fit/measured_pressures.hpp"

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::fit {

/// Everything that was measured on one contact.
struct Measurements {
  std::vector<MeasuredForces> forces;       ///< tables of forces over a creepage
  std::vector<MeasuredPressures> pressures; ///< tables of pressures over places

  std::size_t points() const; ///< of all tables
};

/// Adds a table of forces (measured_forces()) or of pressures (measured_pressures()). Throws InputError.
void add_measured(Measurements& all, const std::string& source, const std::vector<std::string>& columns,
                  const std::vector<std::vector<double>>& rows);
/// The same of CSV files.
Measurements read_measured(const std::vector<std::string>& files);

/// What is looked for: the keys of a scene with which its forces and pressures come closest to measured ones.
struct Question {
  SceneText text;                   ///< its values are the first guess
  std::vector<SceneChange> changes; ///< of its keys
  std::string model;                ///< "": as the scene says
  Measurements measured;            ///< more points than keys
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
  std::vector<FittedKey> keys;       ///< in the order of the question
  std::vector<double> correlation;   ///< [key][key], of the estimates
  Measurements measured;             ///< with what is computed at the found values
  SceneResult solution;              ///< of the scene with the found values
  std::optional<CreepCurves> curves; ///< there, with one curve over the first forces; nothing without forces
  std::vector<std::pair<double, double>>
      band;                              ///< of that curve: where 95 % of what the points allow lies, N, N mm
  int tried = 0;                         ///< sets of values for which all points were solved
  bool converged = false;                ///< the search ended by itself
  std::vector<std::string> undetermined; ///< what the points do not say, in sentences
  SceneFile scene;                       ///< with the found values
};

/// Whether the search ended and all that is shown is certified.
bool certified(const CurveFit& fit);

/// Fits keys to measurements by least squares, points weighted by one over their scatter where it is given,
/// else by one over the largest value of their table. Pressures are those at the scene's own creepages. The
/// model, the size of the elements and where a wheel stands are those of the first guess
/// (HeldContact). Throws InputError for keys that no scene has, that are no numbers, have no value or that
/// nothing depends on, for too few points, and as creep_curves() does.
CurveFit fit_curve(const Question& question, const std::atomic<bool>* stop = nullptr);

} // namespace bem_contact::fit
