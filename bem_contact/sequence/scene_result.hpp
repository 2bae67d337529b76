#pragma once

#include "bem_contact/contact/history.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/sequence/stresses.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// Wall-clock seconds by phase.
struct PhaseSeconds {
  double geometry = 0; ///< files, profiles, contact search, undeformed distance
  double numbers = 0;  ///< influence numbers
  double solve = 0;
  double total = 0;

  PhaseSeconds& operator+=(const PhaseSeconds& other) {
    geometry += other.geometry;
    numbers += other.numbers;
    solve += other.solve;
    total += other.total;
    return *this;
  }
};

/// One scene solved with one model.
struct SceneResult {
  Model model = Model::halfspace;
  std::string reason;     ///< why this model, in a sentence
  ContactProblem problem; ///< grid, rows (wheel_rail: track frame), undeformed distance, rigid slip; without
                          ///< the values of the influence numbers
  ContactResult result;   ///< of the last step
  std::vector<ContactResult> history; ///< transient and shift: of every step
  ReferencePoint reference;
  bool left = false;           ///< left wheel: y and s are counted to the left (placement.hpp)
  double moment = 0;           ///< Mz about the vertical axis through the reference point, N mm
  std::vector<double> wheel_s; ///< station on the upper body of each row, mm; empty where it has none
  std::vector<Point2> rail_profile, wheel_profile; ///< near the contact at approach 0, frame of the rows, mm
  std::optional<StressesBelow> stresses;           ///< where the scene asks for them
  std::vector<std::string> warnings;
  PhaseSeconds seconds;
};

/// Both models at equal vertical force (a prescribed approach is turned into the force that fem finds for
/// it).
struct Comparison {
  SceneResult halfspace, fem;
};

} // namespace bem_contact
