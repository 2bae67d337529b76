#include "bem_contact/contact/tangential/creepage_forces.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/tangential/kinetic_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::contact {

using Eigen::Vector2d;

CreepageForces::CreepageForces(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                               TangentialTask& task, TangentialState& state)
    : system_(system), options_(options), work_(work), task_(task), state_(state), given_(task),
      share_(system.size()) {
  const ContactProblem& problem = *system.problem;
  for (int i = 0; i < system.size(); ++i)
    share_[i] = problem.lateral_share(i / problem.grid.mx);
  for (const int i : task.contact)
    capacity_ += task.bound[i] * problem.element_area();
}

Vector2d CreepageForces::at(const Vector2d& creepage) {
  const int n = system_.size();
  task_ = given_;
  const double length = system_.rule.length;
  for (int i = 0; i < n; ++i) {
    task_.rigid[i] += creepage[0] * length;
    task_.rigid[n + i] += creepage[1] * length * share_[i];
    task_.drive[i] += creepage[0] * length;
    task_.drive[n + i] += creepage[1] * length * share_[i];
  }
  solve_with_kinetic_friction(system_, options_, work_, task_, state_);
  ++solves_;
  last_ = system_.problem->element_area() * Vector2d(state_.p.head(n).sum(), state_.p.tail(n).dot(share_));
  return last_;
}

void CreepageForces::blend(const Solved& one, const Solved& other, double share) {
  state_.p = (1 - share) * one.p + share * other.p;
  state_.slip = (1 - share) * one.slip + share * other.slip;
  last_ = (1 - share) * one.force + share * other.force;
}

double CreepageForces::demand(const Vector2d& force) const {
  const double area = system_.problem->element_area();
  double largest = 0;
  for (int k = 0; k <= capacity_directions; ++k) {
    Vector2d d = force.normalized();
    if (k < capacity_directions)
      d = {std::cos(2 * std::numbers::pi * k / capacity_directions),
           std::sin(2 * std::numbers::pi * k / capacity_directions)};
    double carried = 0;
    for (const int i : given_.contact)
      carried += given_.bound[i] * area * std::hypot(d[0], d[1] * share_[i]);
    largest = std::max(largest, force.dot(d) / carried);
  }
  return largest;
}

void CreepageForces::slip_along(const Vector2d& force) {
  const int n = system_.size();
  const Vector2d d = force.normalized();
  for (const int i : given_.contact) {
    state_.p[i] = given_.bound[i] * d[0];
    state_.p[n + i] = given_.bound[i] * d[1];
  }
}

double CreepageForces::unit() const {
  double slip = 0;
  for (const int i : given_.contact)
    slip = std::max(slip, given_.bound[i] / system_.stiffness[i]);
  return slip / system_.rule.length;
}

} // namespace bem_contact::contact
