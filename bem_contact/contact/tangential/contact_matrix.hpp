#pragma once

#include "bem_contact/contact/problem.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bem_contact::contact {

/// B (StepNumbers) of all pairs of a few elements, mm/MPa: [x, s] of the first element, of the second, ...
struct ContactMatrix {
  /// `present`: the weights of the step (SlipStep::present).
  ContactMatrix(const ContactProblem& problem, const std::array<double, 3>& present,
                const std::vector<int>& elements);

  std::vector<int> elements;
  Eigen::MatrixXd b;
  double scale;         ///< the largest entry on its diagonal, mm/MPa
  Eigen::MatrixXf fast; ///< b / scale in single precision, whose numbers end at 1e-38

  /// The same for other elements. Entries of pairs that both have are copied: from one iteration to the next
  /// few elements change.
  ContactMatrix with(const ContactProblem& problem, const std::array<double, 3>& present,
                     const std::vector<int>& others) const;

private:
  ContactMatrix(const std::vector<int>& elements, Eigen::MatrixXd b);
};

} // namespace bem_contact::contact
