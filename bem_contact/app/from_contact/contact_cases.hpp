#pragma once

#include "bem_contact/app/from_contact/patch_grid.hpp"
#include "bem_contact/base/error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact::app::from_contact {

/// A table beside a scene: the key that names it, and its lines.
struct SceneTableFile {
  std::string key; ///< "gap.table"
  std::string text;
};

/// A case of CONTACT as a scene, or several that are steps of one.
struct ContactCase {
  int first = 1, last = 1; ///< cases of the file, from 1
  int module = 0, line = 0;
  std::map<std::string, std::string> keys; ///< of the scene, as TOML writes their values
  std::vector<SceneTableFile> tables;
  std::vector<std::string>
      left_out;                     ///< what has no counterpart and does not change the problem, in sentences
  std::vector<std::string> refused; ///< why there is no scene: it would be another problem

  /// It goes on from the tractions in which this case of the file ends; 0: it starts without any.
  int goes_on_from = 0;
  std::optional<PatchGrid> grid = {}; ///< of a patch
  /// Shifts of a patch: where a quadratic distance has its middle, x of CONTACT, mm.
  std::optional<double> gap_x = {};
  bool moves = false; ///< gap_x differs from step to step
  /// Of a wheel's shifts: where the wheelset is along the track, S of CONTACT, mm.
  std::optional<double> place = {};
  /// What differs from step to step, where there are several.
  struct Step {
    std::map<std::string, std::string> keys;
    double gap_x = 0;
  };
  std::vector<Step> steps;
  /// The tangential forces are these shares of the friction limit of a normal force that is to be found, x
  /// and s.
  std::optional<double> share_x = {}, share_s = {};
  double friction = 0; ///< in adhesion, of a patch

  void set(const std::string& key, const std::string& value) { keys[key] = value; }
  void set(const std::string& key, double value);
  void set_text(const std::string& key, const std::string& value) { keys[key] = '"' + value + '"'; }
  void leave(const std::string& sentence) { left_out.push_back(sentence); }
  void refuse(const std::string& sentence) { refused.push_back(sentence); }
  /// The value of a key that is a number; 0 where it is not given.
  double number(const std::string& key) const;
  bool is_shift() const { return keys.contains("motion.kind") && keys.at("motion.kind") == "\"shift\""; }
};

/// What from-contact makes of a file.
struct ContactCases {
  std::vector<ContactCase> cases;
  std::optional<InputError> broken; ///< why the file could not be read to its end; the cases before it stand
};

/// Reads an input file of CONTACT and translates every case. Throws InputError where the file cannot be
/// opened.
ContactCases read_contact_cases(const std::filesystem::path& file);

} // namespace bem_contact::app::from_contact
