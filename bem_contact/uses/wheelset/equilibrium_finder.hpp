#pragma once

#include "bem_contact/uses/wheelset/lateral_equilibrium.hpp"

#include <atomic>
#include <memory>
#include <optional>

namespace bem_contact {

/// The same question for half-spaces.
SceneFile with_half_spaces(const SceneFile& scene);

/// Approaches and rolling radius by rule of thumb.
EquilibriumStart first_guess(const SceneFile& scene);

/// Equilibria of a wheelset, at one lateral displacement after the other.
///
/// Tangent planes cost many times what half-spaces cost, and hardly move the equilibrium. So where the model
/// is tangent planes, or is chosen and no influence files are named, half-spaces choose the elements and find
/// the equilibrium. The model takes the last steps on the same elements, from where it stood at the
/// displacement before: beside the equilibrium by half-spaces.
class EquilibriumFinder {
public:
  EquilibriumFinder(const SceneFile& scene, const std::atomic<bool>* stop,
                    const std::shared_ptr<SequenceFiles>& files);

  /// The start for the equations at a displacement, from a solution near it. Elements and models are chosen
  /// there and kept, the elements `factor` times as large.
  EquilibriumStart begin(double lateral, double factor = 1);
  /// Elements and models are chosen at this pose and kept.
  void choose_elements(const WheelsetPose& pose);
  /// The same for an accuracy that elements chosen by half-spaces do not reach: the model itself chooses.
  void choose_elements_again(const WheelsetPose& pose);

  /// As find_equilibrium(), on the elements that were chosen.
  Equilibrium at(double lateral, const EquilibriumStart& start, double tolerance);

  /// As find_lateral_equilibrium(), on the elements that were chosen.
  std::optional<Equilibrium> under_lateral_force(const WheelsetState& near, double tolerance) {
    return find_lateral_equilibrium(wheels_, near, tolerance);
  }

  const SceneFile& scene() const { return wheels_.scene(); }        ///< as given
  int contact_problems() const;                                     ///< solved so far, of both wheels
  int model_problems() const { return wheels_.contact_problems(); } ///< those of them by the scene's model

private:
  std::optional<Equilibrium> by_half_spaces(double lateral, const EquilibriumStart& start, double tolerance);

  /// What the search for the equilibrium at one displacement begins with.
  struct First {
    Equilibrium quick;   ///< by half-spaces
    WheelsetState state; ///< by the model, at the same pose
  };

  WheelPair wheels_;
  std::unique_ptr<WheelPair> quick_; ///< with half-spaces; null: the model itself does all
  std::optional<First> first_;       ///< until it is used
  WheelsetPose beyond_;              ///< of the last equilibrium: its pose less that by half-spaces
};

} // namespace bem_contact
