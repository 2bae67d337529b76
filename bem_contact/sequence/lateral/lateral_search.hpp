#pragma once

#include "bem_contact/sequence/lateral/lateral_curve.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The lateral displacement at which a model bears a lateral force.
///
/// Tread and flange can bear the same force, and so can the flange before and behind its steepest place. The
/// displacement nearest to `start` where the curve (LateralCurve) passes the force is tried with the model,
/// and what the model says there corrects the curve. That goes on until two displacements of the model
/// bracket the force; there the method of Alefeld, Potra and Shi (1995) ends it.
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

  bool passes(); ///< whether the curve passes the force, as far as the curve is known
  /// The displacement nearest to the start where the curve passes the force, mm; the start if it does not.
  double guess();

  /// The displacement, mm, whose force is the wanted one within lateral_tolerance. `force` is the model's.
  /// Throws InputError if no displacement has this force, with the forces that can be reached;
  /// ConvergenceError if the force jumps over it, or if the model has no solution on the way.
  double find(const LateralForce& force);

  /// What to say of the displacement that was found. `error`: of the lateral force, N; nan: not
  /// known.
  LateralPosition describe(double found, double error);

  /// The model's force at the start, N. Nothing where it is not known.
  std::optional<double> force_at_start() const;

private:
  using Point = LateralCurve::Point;
  /// Where the curve passes the force: between two neighbouring points.
  struct Crossing {
    Point low, high;
    double about = 0; ///< mm, by the line between them
  };

  std::vector<Crossing> crossings();
  std::optional<Crossing> nearest_crossing();
  double on_curve(const Crossing& crossing, double width);
  double next_after(const Crossing& crossing, double least);
  double closest_approach(const LateralForce& force);
  std::vector<LateralSample> reached(const LateralForce& force);
  std::vector<double> beside_start(const LateralForce& force);
  bool try_at(const LateralForce& force, double lateral);
  bool learn(const LateralForce& force, double lateral);
  std::optional<double> slope_beside(double found) const;

  Question question_;
  LateralCurve curve_;
};

} // namespace bem_contact
