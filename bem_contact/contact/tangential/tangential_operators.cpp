#include "bem_contact/contact/tangential/tangential_operators.hpp"

#include <numeric>
#include <utility>

namespace bem_contact::contact {

TangentialOperators::TangentialOperators(std::shared_ptr<TransformPool> pool) : pool_(std::move(pool)) {}

void TangentialOperators::forget_solutions() {
  if (scratch_)
    scratch_->gcr.forget();
  if (few_) {
    few_->factors.reset();
    few_->gcr.forget();
  }
}

const StripOperator& TangentialOperators::whole(const ContactProblem& problem, WorkBudget& work) {
  if (!whole_) {
    const std::vector<int> tangential{component_x, component_s};
    work.spend(spectra_work(problem.numbers.translational, 4, problem.grid.ms, problem.grid.mx));
    whole_.emplace(problem.numbers, problem.grid.mx, tangential, tangential, pool_.get());
  }
  return *whole_;
}

TangentialOperators& TangentialOperators::use(const std::array<double, 3>& present) {
  if (present_ != present) {
    present_ = present;
    step_numbers_.reset();
    box_.reset();
    few_.reset();
  }
  return *this;
}

const StepNumbers& TangentialOperators::step_numbers(const ContactProblem& problem) {
  if (!step_numbers_) {
    std::vector<int> rows(problem.numbers.rows);
    std::iota(rows.begin(), rows.end(), 0);
    step_numbers_.emplace(problem.numbers, rows, problem.grid.mx, present_);
  }
  return *step_numbers_;
}

TangentialOperators::BoxWithScratch TangentialOperators::box_around(const std::vector<int>& contact,
                                                                    const ContactProblem& problem,
                                                                    WorkBudget& work) {
  const Boxes needed = boxes_around(contact, problem.grid, 0, !problem.numbers.translational);
  if (!box_ || !serve(box_->boxes(), needed, contact, problem.grid.mx)) {
    work.spend(spectra_work(problem.numbers.translational, 4, needed.rows(), needed.mx()));
    scratch_.reset();
    box_.emplace(problem.numbers, needed, present_, pool_.get());
    scratch_.emplace(*box_);
  }
  return {*box_, *scratch_};
}

TangentialOperators::FewElements& TangentialOperators::few_elements(const std::vector<int>& contact,
                                                                    const ContactProblem& problem) {
  if (!few_)
    few_.emplace(FewElements{ContactMatrix(problem, present_, contact)});
  else if (few_->matrix.elements != contact)
    few_->matrix = few_->matrix.with(problem, present_, contact);
  few_->gcr.use_elements(contact);
  return *few_;
}

} // namespace bem_contact::contact
