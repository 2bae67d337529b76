#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace bem_contact {

/// What a difference between two models is divided by: nothing, the other's own value, the resultant of Fy
/// and Fz, the bound of friction, or this bound times sqrt(area / pi).
enum class DifferenceScale { own, resultant, friction, friction_moment, plain };

/// One quantity that a comparison shows.
struct ComparedQuantity {
  const char *label, *unit; ///< for people
  std::string_view name;    ///< of the quantity
  DifferenceScale scale;
  bool friction = false; ///< without friction there is none

  std::optional<Measured> of(const SceneResult& result) const;  ///< its value and error
  double scale_of(double own, const SceneResult& result) const; ///< what a difference is divided by
  /// By how much the reference's number is larger than the model's, over its scale. Nothing where one of them
  /// is missing, where the scale is zero, and of approaches with different datums.
  std::optional<double> difference(const SceneResult& model, const SceneResult& reference) const;
};
/// Lists the quantities that a comparison shows, in the order of the outputs.
std::span<const ComparedQuantity> compared_quantities();

/// The differences under the names of their quantities; nan where there is none.
record::Record differences_of(const SceneResult& model, const SceneResult& reference);

} // namespace bem_contact
