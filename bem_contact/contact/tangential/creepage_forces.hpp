#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/newton.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace bem_contact::contact {

/// The shear forces as a function of the creepages: each evaluation solves a tangential problem. Pairs are
/// (x, s). All arguments of the constructor outlive this.
class CreepageForces {
public:
  CreepageForces(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                 TangentialTask& task, TangentialState& state);

  /// Forces at these creepages, N. Leaves task and state as solved there.
  Eigen::Vector2d at(const Eigen::Vector2d& creepage);
  const Eigen::Vector2d& last() const { return last_; } ///< of the last at() or blend()

  /// Finds the creepages `components` with which these forces are `wanted`, by newton_for_forces() from
  /// `creepage` and the state. Nothing where it finds none: the state is as before.
  std::optional<ForcedCreepage> find(const std::vector<int>& components, const Eigen::Vector2d& wanted,
                                     double tolerance, const Eigen::Vector2d& creepage);

  /// The solution of the last at().
  struct Solved {
    Eigen::VectorXd p, slip;
    Eigen::Vector2d force;
  };
  Solved solved() const { return {state_.p, state_.slip, last_}; }
  /// Interpolates between the solutions at two creepages that differ by rounding alone: (1 - share) of the
  /// one and `share` of the other. Where they differ nearly everything sticks, so that this is a solution.
  void blend(const Solved& one, const Solved& other, double share);
  bool may_blend() const { return system_.problem->kinetic == 1; }

  /// The largest of F d over the unit vectors d, where F is a prescribed force and friction carries at most
  /// sum mu p_n |(d_x, d_s share)| dS along d. Above 1 friction cannot carry F.
  double demand(const Eigen::Vector2d& force) const;
  /// Sets the tractions of full slip along the force.
  void slip_along(const Eigen::Vector2d& force);

  /// The creepages whose mean rigid slip, weighted with mu p_n, is 0: near those of small forces, wherever
  /// the given slip lies.
  Eigen::Vector2d of_no_mean_slip() const;

  double capacity() const { return capacity_; } ///< sum mu p_n dS, N
  int solves() const { return solves_; }
  /// The creepage whose slip over one step is what an element alone needs to reach its bound.
  double unit() const;

private:
  /// The largest bound that an element may have: of a layer that softens, that before it does, MPa.
  double most_borne(int i) const;

  const TangentialSystem& system_;
  const SolverOptions& options_;
  WorkBudget& work_;
  TangentialTask& task_;
  TangentialState& state_;
  TangentialTask given_;
  Eigen::VectorXd share_; ///< slip along s under a unit creepage along s; field
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
  double capacity_ = 0;
  int solves_ = 0;
};

} // namespace bem_contact::contact
