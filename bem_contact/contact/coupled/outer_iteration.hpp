#pragma once

#include "bem_contact/contact/coupled/solve_coupled.hpp"

#include <deque>
#include <optional>

namespace bem_contact::contact {

/// The tangential half of a coupled problem.
struct Shear {
  TangentialSystem system;
  Eigen::VectorXd rigid;  ///< w of the step, mm
  Eigen::VectorXd former; ///< what the tractions of former steps add to the slip, mm
  const StripOperator *normal_from_shear = nullptr, *shear_from_normal = nullptr; ///< null: no coupling
};

/// What the tractions of former steps add to the slip: sum_k former[k] u_k(x + k columns dx), u = -A p. mm.
Eigen::VectorXd former_slip(const ContactProblem& problem, const Shear& shear);

/// One turn: the normal problem under the displacements (A p_t)_n = v, then friction under its pressure. Sets
/// normal, shear, task and creepage of the solution, from which it starts. Without `shear` the first alone.
void turn_once(const ContactProblem& problem, const SolverOptions& options, const NormalSystem& system,
               const Shear* shear, const Eigen::VectorXd& gap, const Eigen::VectorXd& v,
               const NormalLoad& load, Solution& solution);

/// (A p_t)_n of the solution, mm; zero where the numbers do not couple.
Eigen::VectorXd normal_displacement(const Shear& shear, const Solution& solution);

/// Fixed-point iteration v = G(v) by Anderson's method, with a short memory.
class Anderson {
public:
  Eigen::VectorXd next(const Eigen::VectorXd& v, const Eigen::VectorXd& residual);

private:
  struct Turn {
    Eigen::VectorXd v, residual;
  };
  std::deque<Turn> history_;
  std::optional<double> best_;
};

} // namespace bem_contact::contact
