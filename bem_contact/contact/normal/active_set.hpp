#pragma once

#include "bem_contact/contact/normal/conjugate_gradients.hpp"
#include "bem_contact/contact/normal/normal_system.hpp"
#include "bem_contact/contact/solver_options.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// Primal-dual active set method (Hintermueller, Ito, Kunisch 2002) for the normal problem of
/// solve_normal.hpp. Each step solves A_CC p = q cos - gap on the active elements; then elements that
/// contradict the contact law change sides; those at the limit of the pressure keep p = H while the bodies
/// overlap there. The linear systems are solved by Cholesky, or by conjugate gradients only as precisely as
/// the sets are known.
class ActiveSet {
public:
  /// Starts from state.sides, state.p and state.approach if something is active. All arguments outlive this.
  ActiveSet(const NormalSystem& system, const Eigen::VectorXd& gap, const NormalLoad& load,
            const SolverOptions& options, WorkBudget& work, NormalState& state);

  /// True if the sets settled. If not, state.remark says why.
  bool run();
  const Eigen::VectorXd& displacement() const { return pressure_.u; } ///< A p of the last step

private:
  void take_limited(bool direct);
  bool solve_linear(const std::vector<int>& list);
  double balance_force(bool direct);
  int change_sides(const Boxes& where, double largest_u);
  bool progresses(int changes);

  const NormalSystem& system_;
  const Eigen::VectorXd& gap_;
  const NormalLoad& load_;
  const SolverOptions& options_;
  WorkBudget& work_;
  NormalState& state_;
  const bool by_force_;
  const double wanted_; ///< relative precision of the linear systems in the end
  double precision_;    ///< and now
  const Boxes whole_;
  bool limited_ = false;                   ///< some elements are at the limit of the pressure
  Eigen::VectorXd at_limit_, under_limit_; ///< their pressure, and the displacement that it causes
  Response pressure_, unit_; ///< of touching elements; unit: A_CC p = cos, what more approach adds
  int fewest_changes_, without_progress_ = 0;
};

/// The elements that overlap at the approach at which they, uniformly loaded, would carry the force. Sets
/// `approach` if the force is given.
std::vector<NormalSide> first_guess(const NormalSystem& system, const Eigen::VectorXd& gap,
                                    const NormalLoad& load, WorkBudget& work, double& approach);

} // namespace bem_contact::contact
