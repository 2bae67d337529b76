#pragma once

#include "bem_contact/base/enum_names.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bem_contact {

/// What a warning is of, the most important first: the warnings of an answer stand in this order.
enum class WarningKind {
  // The numbers are not the answer.
  uncertified_step, ///< a step of a history is no solution
  contact_left_out, ///< the bodies may touch where nothing is computed
  edge_of_grid,     ///< the contact reaches the edge of a grid that cannot grow
  model_needed,     ///< finite elements would be needed, and cannot be taken
  second_solution,  ///< another state carries the same load
  // The question is probably not what was meant.
  flange_tip,        ///< the wheel stands on the tip of its flange
  no_play,           ///< the wheelset stands on both flanges
  end_of_profile,    ///< the contact reaches the end of a profile
  beyond_head,       ///< the contact lies deeper than the rail's head
  inclined_twice,    ///< file and scene incline the rail, or one leans outwards
  unlikely_value,    ///< a key whose value is usual in another unit
  large_creepage,    ///< above 10 %
  files_of_one_side, ///< of the two wheels of an axle only one has influence files
  // The numbers are known less well than asked for.
  no_convergence,  ///< the pressure does not converge with the size of the elements
  large_elements,  ///< too few elements lie across a patch
  missed_accuracy, ///< the stated errors are above grid.accuracy
  unsure_position, ///< load.force_y hardly determines the lateral displacement
  other_position,  ///< load.force_y is carried at position.lateral, too
  unseen_slide,    ///< the surfaces move past each other, and their distance does not follow
  rough_stresses,  ///< the stresses are those of a half-space below a curved surface
  yield,           ///< steel flows at this pressure
  friction_jump,   ///< friction that drops at once has no limit as elements shrink
  // The question was changed, or a part of it has no effect.
  changed_input, ///< a file is not what a stored result was made from
  grown_grid,    ///< the contact did not fit on the grid asked for
  without_effect ///< a key that changes nothing, or has another name today
};

template <> struct EnumNames<WarningKind> {
  static constexpr std::array<std::string_view, 25> names{
      "uncertified_step",  "contact_left_out", "edge_of_grid",
      "model_needed",      "second_solution",  "flange_tip",
      "no_play",           "end_of_profile",   "beyond_head",
      "inclined_twice",    "unlikely_value",   "large_creepage",
      "files_of_one_side", "no_convergence",   "large_elements",
      "missed_accuracy",   "unsure_position",  "other_position",
      "unseen_slide",      "rough_stresses",   "yield",
      "friction_jump",     "changed_input",    "grown_grid",
      "without_effect"};
};

/// What a person should know before the numbers are used.
struct Warning {
  WarningKind kind;
  std::string text;       ///< "<what> (<figure, unit>) <what to do>"
  std::string about = {}; ///< the key, where a kind has several; two of one kind about the same thing differ
                          ///< in figures alone

  bool operator==(const Warning&) const = default;
  bool differs_in_figures(const Warning& other) const { return kind == other.kind && about == other.about; }
};

/// Warnings in the order of their kinds.
class Warnings {
public:
  Warnings() = default;
  Warnings(std::initializer_list<Warning> all);

  /// Adds one behind those of its kind.
  void add(Warning one);
  void add(WarningKind kind, std::string text, std::string about = {}) {
    add({kind, std::move(text), std::move(about)});
  }
  /// Adds those that are not there yet.
  void add(const Warnings& others);

  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  const Warning& operator[](std::size_t i) const { return all_[i]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  std::vector<std::string> texts() const;
  std::vector<std::string> kinds() const; ///< their names

private:
  std::vector<Warning> all_;
};

/// A warning, and what it is of: "fem at equal forces".
struct PlacedWarning {
  std::string place;
  Warning warning;
};
/// Each warning once, with all places of it. Behind it stand the places where it has other figures.
Warnings once_each(const std::vector<PlacedWarning>& warnings);

/// Serves --strict: throws InputError with all warnings, if there are any.
void refuse_warnings(const Warnings& warnings);

} // namespace bem_contact
