#pragma once

#include "bem_contact/uses/wheelset/wheel_pair.hpp"

#include <Eigen/Core>

#include <optional>
#include <string_view>

namespace bem_contact {

/// The equations of equilibrium. Unknowns, all in mm: height; roll times half the distance of the contacts;
/// if it is looked for, the rolling radius as a creepage over creepage_scale; and, if a lateral force is
/// wanted, the lateral displacement.
class Balance {
public:
  /// `start`: u = 0. `lateral_force`: N, wanted; empty: start.lateral is given.
  Balance(WheelPair& wheels, const WheelsetPose& start, std::optional<double> lateral_force = {})
      : wheels_(wheels), given_(wheels.scene().wheelset), start_(start), lateral_force_(lateral_force) {}

  /// Nothing where the wheels cannot be solved, or one of them hangs. `derivatives`: WheelPair::at() has
  /// them.
  std::optional<WheelsetState> at(const Eigen::VectorXd& u, bool derivatives = false);

  Eigen::VectorXd none() const; ///< u = 0
  Eigen::VectorXd residual(const WheelsetState& s) const;
  /// Of the equations over u, by the model of the stiffness: each patch keeps the direction of its force. Not
  /// for the lateral displacement.
  Eigen::MatrixXd model(const WheelsetState& s) const;
  /// The same of a state that has derivatives: patches keep their places.
  Eigen::MatrixXd derivatives(const WheelsetState& s) const;

  /// How much of a step can be taken: within the bounds of this room. Throws LiftError for a wheel that
  /// lifts.
  double share_of(const WheelsetState& s, const Eigen::VectorXd& step) const;
  void set_arm(const WheelsetState& s);

  int evaluations = 0;

private:
  double force() const { return *given_.force; }
  double resultant() const;
  /// What forces on the rails contribute to each equation.
  Eigen::VectorXd equations(const WheelsetState& s, const Wrench& w) const;

  WheelPair& wheels_;
  const SceneFile::Wheelset& given_;
  WheelsetPose start_;
  std::optional<double> lateral_force_;
  double arm_ = 1; ///< half the distance of the contacts, mm
};

/// Newton's method with Broyden's updates.
struct BalanceSearch {
  Balance& balance;
  Eigen::VectorXd u{}, f{};
  Eigen::MatrixXd slope{};
  bool exact = false; ///< slope is by differences, here

  /// One step, halved until it lessens the residual. False if none does.
  bool step(WheelsetState& here);
};

} // namespace bem_contact
