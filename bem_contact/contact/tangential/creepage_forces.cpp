#include "bem_contact/contact/tangential/creepage_forces.hpp"

#include "bem_contact/contact/tangential/kinetic_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::contact {

namespace {

/// Directions in which the capacity of friction is compared with the force: 0.5 degrees apart. Chosen.
constexpr int capacity_directions = 720;

} // namespace

using Eigen::Vector2d;
using Eigen::VectorXd;

CreepageForces::CreepageForces(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                               TangentialTask& task, TangentialState& state)
    : system_(system), options_(options), work_(work), task_(task), state_(state), given_(task),
      share_(system.size()) {
  const ContactProblem& problem = *system.problem;
  for (int i = 0; i < system.size(); ++i)
    share_[i] = problem.lateral_share(i / problem.grid.mx);
  for (const int i : task.contact)
    capacity_ += most_borne(i) * problem.element_area();
}

double CreepageForces::most_borne(int i) const {
  const std::optional<YieldLimit>& yield = system_.problem->yield;
  return yield && yield->hardening < 0 ? std::min(given_.bound[i], yield->shear) : given_.bound[i];
}

Vector2d CreepageForces::at(const Vector2d& creepage) {
  const int n = system_.size();
  task_ = given_;
  add_creepage(system_, share_, creepage, task_);
  solve_with_kinetic_friction(system_, options_, work_, task_, state_);
  ++solves_;
  last_ = system_.problem->element_area() * Vector2d(state_.p.head(n).sum(), state_.p.tail(n).dot(share_));
  return last_;
}

std::optional<ForcedCreepage> CreepageForces::find(const std::vector<int>& components, const Vector2d& wanted,
                                                   double tolerance, const Vector2d& creepage) {
  if (system_.problem->kinetic != 1 || given_.contact.empty())
    return std::nullopt;
  const VectorXd start = state_.p;
  ++solves_;
  task_ = given_;
  const PrescribedForces forces{components, wanted, share_, tolerance, creepage};
  const auto found = newton_for_forces(system_, forces, options_, work_, task_, state_);
  if (!found)
    state_.p = start;
  return found;
}

Vector2d CreepageForces::of_no_mean_slip() const {
  const int n = system_.size();
  Vector2d slip = Vector2d::Zero(), under_one = Vector2d::Zero();
  for (const int i : given_.contact) {
    const Vector2d weight = given_.bound[i] * Vector2d(1, share_[i]);
    slip += weight.cwiseProduct(Vector2d(given_.rigid[i], given_.rigid[n + i]));
    under_one += system_.rule.length * weight.cwiseProduct(Vector2d(1, share_[i]));
  }
  return -slip.cwiseQuotient(under_one);
}

void CreepageForces::blend(const Solved& one, const Solved& other, double share) {
  state_.p = (1 - share) * one.p + share * other.p;
  state_.slip = (1 - share) * one.slip + share * other.slip;
  last_ = (1 - share) * one.force + share * other.force;
}

double CreepageForces::demand(const Vector2d& force) const {
  // The share is one of rows, and so are sums of bounds.
  const int mx = system_.columns();
  VectorXd bounds = VectorXd::Zero(system_.size() / mx);
  for (const int i : given_.contact)
    bounds[i / mx] += most_borne(i) * system_.problem->element_area();
  double largest = 0;
  for (int k = 0; k <= capacity_directions; ++k) {
    Vector2d d = force.normalized();
    if (k < capacity_directions)
      d = {std::cos(2 * std::numbers::pi * k / capacity_directions),
           std::sin(2 * std::numbers::pi * k / capacity_directions)};
    double carried = 0;
    for (Eigen::Index row = 0; row < bounds.size(); ++row)
      carried += bounds[row] * std::hypot(d[0], d[1] * share_[row * mx]);
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
