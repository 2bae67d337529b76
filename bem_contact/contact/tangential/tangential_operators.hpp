#pragma once

#include "bem_contact/contact/operator/plane_transforms.hpp"
#include "bem_contact/contact/tangential/contact_matrix.hpp"
#include "bem_contact/contact/tangential/newton_factors.hpp"
#include "bem_contact/contact/tangential/step_box.hpp"
#include "bem_contact/contact/work.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace bem_contact::contact {

/// What is prepared of the tangential influence numbers of one grid. Every call gives a problem with the same
/// numbers and grid. Each operator is made when it is first asked for; it is complete then and stays as it
/// is. Serves one thread at a time.
class TangentialOperators {
public:
  explicit TangentialOperators(std::shared_ptr<TransformPool> pool = std::make_shared<TransformPool>());

  /// Gives up factors and directions of GCR.
  void forget_solutions();
  /// A_tt on the whole grid.
  const StripOperator& whole(const ContactProblem& problem, WorkBudget& work);
  /// The weights of the step (SlipStep::present) that B below has; what belongs to others is given up.
  TangentialOperators& use(const std::array<double, 3>& present);

  const StepNumbers& step_numbers(const ContactProblem& problem);
  /// B on boxes around the contact and scratch for it. The former boxes are used again while they serve.
  struct BoxWithScratch {
    const StepBox& box;
    StepBoxScratch& scratch;
  };
  BoxWithScratch box_around(const std::vector<int>& contact, const ContactProblem& problem, WorkBudget& work);
  /// B of a few elements and what Newton's method keeps for them.
  struct FewElements {
    ContactMatrix matrix;
    std::optional<NewtonFactors> factors = {}; ///< of some former J
    Gcr gcr{{few_kept_solutions, few_kept_directions}};
  };
  FewElements& few_elements(const std::vector<int>& contact, const ContactProblem& problem);

private:
  std::shared_ptr<TransformPool> pool_;
  std::optional<StripOperator> whole_;
  std::array<double, 3> present_{};
  std::optional<StepNumbers> step_numbers_;
  std::optional<StepBox> box_;
  std::optional<StepBoxScratch> scratch_;
  std::optional<FewElements> few_;
};

} // namespace bem_contact::contact
