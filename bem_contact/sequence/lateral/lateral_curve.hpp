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
  /// One displacement of the curve.
  struct Point {
    double lateral = 0;          ///< mm
    std::optional<double> force; ///< N; nothing where wheel and rail do not meet
    bool exact = false;          ///< of the model itself
  };

  /// The curve from `around` - lateral_reach to `around` + lateral_reach. `resultant`: of Fy and Fz, N.
  /// `known` is used and added to.
  LateralCurve(LateralForce rough, double around, double resultant, KnownLateralForces& known);

  /// The curve at a displacement.
  std::optional<double> operator()(double lateral);
  /// The model's force at a displacement.
  void learn(const LateralSample& exact);
  /// Points, ascending, near enough to each other to show each place where the curve passes `wanted`.
  std::vector<Point> points(double wanted);
  /// Where, on the side of `direction` (-1 or 1), the force first differs from that at `from` by `error` (N);
  /// the last sample if it nowhere does. The curve has the shape of the rough samples, linear between them,
  /// because the model's own forces are uneven from element to element.
  LateralSample leaves(const LateralSample& from, double error, int direction) const;
  const std::map<double, KnownLateralForces::Exact>& exact() const { return known_.exact; } ///< of the model

private:
  std::optional<double> rough(double lateral);
  double missed(double lateral) const;
  std::vector<Point> samples() const;
  bool refine(double wanted);
  void add_extrema(double wanted);

  LateralForce rough_;
  double resultant_;
  KnownLateralForces& known_;
};

} // namespace bem_contact
