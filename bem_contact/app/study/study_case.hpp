#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/scene/scene_text.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::app {

/// [uncertainty]: how much the inputs of a study scatter. Standard deviations of normal distributions; 0:
/// known.
struct Uncertainty {
  double friction = 0;      ///< of motion.friction, 1
  double load = 0;          ///< of load.force or wheelset.force, N
  double lateral = 0;       ///< of position.lateral, mm
  double profile_noise = 0; ///< of points of both profiles, mm
  int draws = 20, seed = 1;
  std::vector<std::string> states; ///< values of layer.state to answer the study for, too
  std::vector<std::string> parts;  ///< of the study that are drawn or have states; none: all

  bool asked() const { return friction > 0 || load > 0 || lateral > 0 || profile_noise > 0; }
};

/// [influence]: body files of which rail.influence and wheel.influence are computed where they are missing.
struct InfluenceBodies {
  std::string program = "tools/influence"; ///< called with a body file and the file to write
  std::string rail, wheel;                 ///< body files; "": none
};

/// A scene file with all that is asked of it.
struct StudyCase {
  SceneText text;
  std::vector<std::string> tables; ///< that it has, and keys at its top
  Uncertainty uncertainty = {};
  InfluenceBodies influence = {};

  bool has(std::string_view table) const;
  /// The model that a table of a command gives ("halfspace" of table.model); "": none.
  std::string model_of(std::string_view table) const;
};

/// Throws InputError for what is no TOML, and for wrong keys of [uncertainty] and [influence].
StudyCase study_case(SceneText text);

/// The text of a scene with other values, and with paths that hold from any folder. Tables of `dropped` are
/// left out.
std::string changed_text(const SceneText& scene, std::span<const SceneChange> changes,
                         std::span<const std::string_view> dropped);

/// The wheel of a wheelset that other parts of a study go on with, and how it was solved.
struct WheelOfStudy {
  WheelSide side{};
  std::string model;
  double dx = 0, ds = 0; ///< size of its elements, mm
};
/// `found`: the result of the wheelset.
WheelOfStudy wheel_of(const record::Record& found);

/// The wheel to which its displacement moves a wheelset, as a scene of one wheel: where the equilibrium has
/// put it, under the force that its rail bears, with the model and the elements by which it was solved. All
/// tables of commands stay. `found`: the result of the wheelset.
std::string wheel_text(const SceneText& scene, const record::Record& found);

/// Something that a study has taken: a key of the scene, its value, and whether the file gives it.
struct TakenValue {
  std::string key, value, unit;
  bool given = false;
};
/// What matters to every answer: model, profiles, track, friction, accuracy.
std::vector<TakenValue> taken_values(const SceneText& scene);

} // namespace bem_contact::app
