#pragma once

#include "bem_contact/sequence/lateral/lateral_force.hpp"

#include <map>
#include <optional>
#include <vector>

namespace bem_contact {

/// Lateral forces, N, that are known of one scene under one load, by the displacement, mm.
struct KnownLateralForces {
  /// The model's force, and the rough one at the same displacement (nothing: there is no rough solution).
  struct Exact {
    double force = 0;
    std::optional<double> rough;
  };
  std::map<double, std::optional<double>> rough; ///< nothing where wheel and rail do not meet
  std::map<double, Exact> exact;
};

/// The lateral force over the lateral displacement: rough forces, corrected where the model's are known.
///
/// Rough forces show which branches there are. They differ from the model's by some per cent, which on a
/// tread can be more than the force changes over its whole width. So wherever the model was solved, the
/// difference is measured. It is added everywhere: linear between two such displacements, constant beyond
/// them.
class LateralCurve {
public:
  /// Bits of an extremum's displacement: some hundredths of a millimetre. The force changes by its square.
  static constexpr int extremum_bits = 10;

  /// One displacement of the curve that is known.
  struct Point {
    double lateral = 0;          ///< mm
    std::optional<double> force; ///< N; nothing where wheel and rail do not meet
    bool exact = false;          ///< of the model itself

    LateralSample sample() const { return {lateral, *force}; } ///< where there is a force
  };

  /// `resultant`: of Fy and Fz, N. `known` is used and added to.
  LateralCurve(LateralForce rough, double resultant, KnownLateralForces& known);

  /// The rough force at a displacement, which is kept.
  std::optional<double> rough(double lateral);
  /// The curve at a displacement.
  std::optional<double> operator()(double lateral);
  /// The model's force at a displacement.
  void learn(const LateralSample& exact);
  /// Returns the force of the model, where it is known.
  std::optional<double> exact(double lateral) const;
  /// The nearest displacement on the side of `direction` (-1 or 1), or this one, where the model is known.
  std::optional<LateralSample> exact_beside(double lateral, int direction) const;
  /// Where the model's known force is nearest to `wanted`, N.
  std::optional<LateralSample> nearest_exact(double wanted) const;
  /// dFy/dy from `here` to the nearest displacement within lateral::spacing where the model's known force
  /// differs by `telling`, N; N/mm.
  std::optional<double> slope_beside(const LateralSample& here, double telling) const;
  /// Whether the model is known nearer to a displacement than `distance`, mm.
  bool exact_within(double lateral, double distance) const;

  /// Rough solutions from `around` - lateral::reach to `around` + lateral::reach, and where contact ends.
  void survey(double around);
  /// All displacements that are known, ascending.
  std::vector<Point> points() const;
  /// Rough solutions at each extremum between points that falls short of `wanted` and may reach it.
  void survey_extrema(double wanted);

private:
  double missed_at(double lateral, const KnownLateralForces::Exact& known) const;
  double missed(double lateral) const;

  LateralForce rough_;
  double resultant_;
  KnownLateralForces& known_;
};

} // namespace bem_contact
