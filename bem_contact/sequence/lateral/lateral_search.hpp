#pragma once

#include "bem_contact/sequence/lateral/lateral_curve.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The lateral displacement at which a model bears a lateral force.
///
/// A start that bears the force is the answer, and nothing else is looked at. Else rough solutions survey the
/// displacements within lateral::reach: tread and flange can bear the same force, and so can the flange
/// before and behind its steepest place. The displacement nearest to the start where the curve (LateralCurve)
/// passes the force is tried with the model, and what the model says there corrects the curve. Two
/// displacements of the model that bracket the force end that: narrow_lateral() does the rest.
class LateralSearch {
public:
  /// What is looked for.
  struct Question {
    double wanted = 0;    ///< lateral force, N
    double start = 0;     ///< mm; the nearest displacement to it is taken
    double resultant = 0; ///< of lateral and vertical force, N
  };

  /// `known` is used and added to.
  LateralSearch(const Question& question, const LateralForce& rough, KnownLateralForces& known);

  /// Whether the start may bear the force, by a rough solution there.
  bool start_may_bear();
  bool met(double force) const; ///< N: whether this is the wanted one, as the certificate allows it

  bool passes(); ///< whether the curve passes the force, as far as the curve is known
  /// The displacement nearest to the start where the curve passes the force, mm; the start if it does not.
  double guess();
  void learn(const LateralSample& exact) { curve_.learn(exact); } ///< a force of the model

  /// The displacement, mm, whose force is met(). `force` is the model's.
  /// Throws InputError if no displacement has this force, with the forces that can be reached;
  /// ConvergenceError if the force jumps over it, or if the model has no solution on the way.
  double find(const LateralForce& force);

  /// What to say of the displacement that was found. `error`: of the lateral force, N; nan: not known. The
  /// others are looked for where the start was not the answer.
  LateralPosition describe(double found, double error);

  /// The model's force at the start, N. Nothing where it is not known.
  std::optional<double> force_at_start() const { return curve_.exact(question_.start); }

private:
  using Point = LateralCurve::Point;
  /// Where the curve passes the force: between two neighbouring points.
  struct Crossing {
    Point low, high;
    double about = 0; ///< mm, by the line between them
  };

  void survey();
  void survey_range();
  std::vector<Crossing> crossings() const;
  std::optional<Crossing> nearest_crossing() const;
  double on_curve(const Crossing& crossing);
  std::optional<LateralBracket> beside_start(const LateralForce& force);
  std::optional<LateralBracket> bracket(const LateralForce& force, const Crossing& crossing, double within);
  std::optional<double> try_extremum(const LateralForce& force, bool last);
  void refuse(const LateralForce& force);
  std::optional<double> try_at(const LateralForce& force, double lateral);

  Question question_;
  LateralCurve curve_;
  bool surveyed_ = false;
  std::vector<double>
      searched_; ///< displacements around which the model has been searched for an extremum, mm
};

} // namespace bem_contact
