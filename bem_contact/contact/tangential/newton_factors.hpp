#pragma once

#include "bem_contact/contact/tangential/linearisation.hpp"
#include "bem_contact/influence/dense.hpp"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// LU factors, in single precision, of Newton's matrix J = 1 - M (1 - r B) at one linearisation. J is the
/// identity across the bound of an element that slips, so such an element has one unknown, along its bound;
/// one that sticks has two.
///
/// From step to step, and from one case to the next, few elements change and few change their state: factors
/// of a former J precondition GCR for the present one.
class NewtonFactors {
public:
  /// `numbers`: of the elements on the grid; `b`: B of them (ContactMatrix), in the units of the elements'
  /// stiffness.
  NewtonFactors(const std::vector<int>& numbers, std::span<const NewtonElement> elements,
                const Eigen::MatrixXf& b);

  bool regular() const { return factors_->regular(); }
  /// The elements of the vectors that follow.
  void use_elements(const std::vector<int>& numbers);
  /// out = about J^-1 v at another linearisation. An element without factors has the identity.
  void solve(std::span<const NewtonElement> elements, const Eigen::VectorXf& v,
             Eigen::Ref<Eigen::VectorXf> out);

private:
  struct Unknown {
    int element; ///< place in numbers_
    Eigen::Vector2f direction;
  };
  std::vector<int> numbers_, present_;
  std::vector<int> place_; ///< in the vectors, of each of numbers_; -1: it is not there
  std::vector<Unknown> unknowns_;
  std::optional<LuFactors> factors_;
  Eigen::VectorXf before_, right_, change_; ///< scratch of solve()
};

} // namespace bem_contact::contact
