#pragma once

#include "bem_contact/contact/coupled/contact_operators.hpp"
#include "bem_contact/contact/coupled/solution.hpp"
#include "bem_contact/contact/solver_options.hpp"

#include <Eigen/Core>

#include <optional>

namespace bem_contact::contact {

/// The tangential half of a coupled problem.
struct Shear {
  Shear(const ContactProblem& problem, ContactOperators& operators, WorkBudget& work);

  TangentialSystem system;
  Eigen::VectorXd rigid;    ///< w of the step, mm
  const Coupling* coupling; ///< null: the influence numbers do not couple
  Eigen::VectorXd former;   ///< what the tractions of former steps add to the slip, mm
};

/// One contact problem with its operators: what stays the same over the outer iterations. `problem` and
/// `operators` outlive it.
struct CoupledSystem {
  /// `negligible`: if displacements and forces change by less than this (relative), one outer iteration is
  /// enough.
  CoupledSystem(const ContactProblem& problem, ContactOperators& operators, double negligible,
                WorkBudget& work);

  /// Vertical force of the shear tractions, N.
  double shear_force(const Eigen::VectorXd& shear_tractions) const;

  const ContactProblem& problem;
  NormalSystem normal;
  Eigen::VectorXd gap;        ///< mm; field
  Eigen::VectorXd sine;       ///< of the inclination; field
  std::optional<Shear> shear; ///< nothing without friction
  // Whether shear acts on the normal problem, by bounds of what friction can carry.
  bool by_numbers = false; ///< by the normal displacements that it causes
  bool inclined = false;   ///< by its share of the prescribed vertical force
  bool by_force = false;   ///< by either, and a vertical force above 0 is prescribed
  bool coupled() const { return by_numbers || inclined; }
};

/// What the tractions of former steps add to the slip: sum_k former[k] u_k(x + k columns dx), u = -A p. mm.
Eigen::VectorXd former_slip(const ContactProblem& problem, const Shear& shear, WorkBudget& work);

/// One outer iteration: the normal problem under the displacements (A p_t)_n = v, then (with friction) the
/// tangential problem under its pressure. Starts from the normal and shear state of `solution` and sets them,
/// the task and the creepage.
void iterate_once(const CoupledSystem& system, const SolverOptions& options, const Eigen::VectorXd& v,
                  const NormalLoad& load, WorkBudget& work, Solution& solution);

/// The second half of an iteration: the tangential problem under the pressure of `solution`, with friction.
void solve_shear(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work,
                 Solution& solution);

/// (A p_t)_n, mm; zero where the numbers do not couple.
Eigen::VectorXd normal_displacement(const Shear& shear, const Eigen::VectorXd& pt);
/// What pressure does to the slip of a step of steady rolling, mm; zero where the numbers do not couple.
Eigen::VectorXd step_of_pressure(const Shear& shear, const Eigen::VectorXd& pn);

} // namespace bem_contact::contact
