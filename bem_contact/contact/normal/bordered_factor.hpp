#pragma once

#include "bem_contact/contact/normal/normal_lines.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// A_CC^-1 of the few elements C in contact, by Cholesky's factor L of a former set F. Between the two few
/// elements left (r) and few are new (a), so that
///     | A_FF  B | | p_F |   | b_F |
///     | B'    D | | y   | = | c   |,   B = [A_Fa  E_r],   D = [A_aa  0; 0  0]
/// has the pressures p_F, p_a = y_a that A_CC has: what left is held at p = 0. The small matrix
/// S = D - (L^-1 B)' (L^-1 B) is all that is factored anew (bordering: Golub, Van Loan 2013, 4.2).
class BorderedFactor {
public:
  /// C = F. `elements`: of the grid, in rising order.
  BorderedFactor(const NormalLines& lines, const std::vector<int>& elements);

  /// False if A_CC is not positive definite.
  bool positive() const { return positive_; }
  const std::vector<int>& elements() const { return present_; }  ///< C
  const std::vector<int>& factored() const { return factored_; } ///< F
  /// Another C, in rising order. False, and nothing changes, if so many elements differ from F that a factor
  /// of its own is faster.
  bool use_elements(const NormalLines& lines, const std::vector<int>& elements);
  /// A_CC^-1 right
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
  std::vector<int> factored_, present_; ///< F and C
  std::vector<int> place_;              ///< of each element of C: in F, or below 0: -1 - number among the new
  std::vector<int> left_;               ///< places in F
  Eigen::MatrixXd factor_;              ///< L
  Eigen::MatrixXd border_left_, border_new_;     ///< L^-1 E_r, L^-1 A_Fa
  Eigen::MatrixXd coupling_;                     ///< S_ra
  Eigen::LLT<Eigen::MatrixXd> of_left_, of_new_; ///< of -S_rr, and of S_aa + S_ar (-S_rr)^-1 S_ra
  bool positive_;
};

} // namespace bem_contact::contact
