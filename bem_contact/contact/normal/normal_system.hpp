#pragma once

#include "bem_contact/contact/normal/normal_operators.hpp"
#include "bem_contact/contact/problem.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace bem_contact::contact {

/// The linear part of one normal problem: what stays the same over its outer iterations. Fields are
/// [ms][mx]. `problem` and `operators` outlive it; the operators belong to the problem's influence numbers.
class NormalSystem {
public:
  NormalSystem(const ContactProblem& problem, NormalOperators& operators);

  /// (A p)_n, mm
  Eigen::VectorXd apply(const Eigen::VectorXd& p, WorkBudget& work) const;
  /// Does the same by direct sums, for a few hundred elements in contact.
  Eigen::VectorXd apply_directly(const Eigen::VectorXd& p, WorkBudget& work) const;
  /// right := A_CC^-1 right on the elements of the list; false where A_CC is not positive definite.
  bool solve_dense(const std::vector<int>& list, Eigen::MatrixXd& right) const;
  /// A_CC of the list, lower triangle.
  Eigen::MatrixXd block(const std::vector<int>& list) const;
  /// Boxes around these elements.
  const NormalBox& box_around(const std::vector<int>& elements, WorkBudget& work) const;
  NormalBoxVectors& vectors() const { return operators_->vectors(); } ///< of these boxes

  ContactGrid grid;
  const InfluenceNumbers* numbers;
  Eigen::VectorXd cosine;  ///< cos(delta) of each element
  double element_area = 0; ///< mm^2
  double self = 0;         ///< largest self influence number, mm/MPa
  double limit;            ///< of the pressure, MPa; infinite where there is none

private:
  NormalOperators* operators_;
};

struct NormalLoad {
  LoadKind kind = LoadKind::force;
  double approach = 0; ///< q, mm
  double force = 0;    ///< sum p_n cos(delta) dS, N
};

/// What an element may be: apart (p = 0), touching, or in contact at the limit of the pressure.
enum class NormalSide : char { apart, touching, at_limit };

struct NormalState {
  Eigen::VectorXd p; ///< MPa; zero outside the contact
  Eigen::VectorXd u; ///< (A p)_n, mm
  double approach = 0;
  Eigen::VectorXd unit; ///< MPa/mm: by how much p grows with the approach; a start of the next solution
  std::vector<NormalSide> sides;
  int iterations = 0;
  int products = 0; ///< of conjugate gradients
  bool converged = false;
  std::string solver, remark;

  /// Sets the sides that the pressure shows.
  void set_sides(double limit);
  bool in_contact() const; ///< some element is
};

} // namespace bem_contact::contact
