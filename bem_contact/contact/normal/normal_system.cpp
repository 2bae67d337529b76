#include "bem_contact/contact/normal/normal_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {

using Eigen::VectorXd;

NormalSystem::NormalSystem(const ContactProblem& problem, NormalOperators& operators)
    : grid(problem.grid), numbers(&problem.numbers), cosine(problem.grid.size()),
      element_area(problem.element_area()),
      limit(problem.limit_pressure.value_or(std::numeric_limits<double>::infinity())),
      operators_(&operators) {
  for (int is = 0; is < grid.ms; ++is) {
    cosine.segment(is * grid.mx, grid.mx).setConstant(std::cos(problem.rows[is].delta));
    self = std::max(self, numbers->at(0, is, component_n, is, component_n));
  }
}

void NormalState::set_sides(double limit) {
  sides.resize(p.size());
  for (Eigen::Index i = 0; i < p.size(); ++i)
    sides[i] = p[i] >= limit ? NormalSide::at_limit : p[i] > 0 ? NormalSide::touching : NormalSide::apart;
}

bool NormalState::in_contact() const {
  return std::ranges::any_of(sides, [](NormalSide side) { return side != NormalSide::apart; });
}

VectorXd NormalSystem::apply(const VectorXd& p, WorkBudget& work) const {
  // one component costs about half of what one unit of work stands for
  work.spend(0.5 * product_work(numbers->translational, grid.ms) * grid.size());
  VectorXd u(p.size());
  operators_->whole(*numbers, grid.mx, work)
      .apply({p.data(), static_cast<std::size_t>(p.size())}, {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

VectorXd NormalSystem::apply_directly(const VectorXd& p, WorkBudget& work) const {
  work.spend(grid.size());
  return operators_->lines(*numbers, grid.mx).apply(p);
}

bool NormalSystem::solve_dense(const std::vector<int>& list, Eigen::MatrixXd& right) const {
  return operators_->solve_dense(list, *numbers, grid.mx, right);
}

Eigen::MatrixXd NormalSystem::block(const std::vector<int>& list) const {
  return operators_->lines(*numbers, grid.mx).block(list);
}

const NormalBox& NormalSystem::box_around(const std::vector<int>& elements, WorkBudget& work) const {
  return operators_->box_around(elements, *numbers, grid, work);
}

} // namespace bem_contact::contact
