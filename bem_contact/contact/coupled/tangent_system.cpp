#include "bem_contact/contact/coupled/tangent_system.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/normal/conjugate_gradients.hpp"
#include "bem_contact/contact/normal/settings.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/tangential/linear_solution.hpp"
#include "bem_contact/influence/dense.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// 1. Residual of the linear systems, over their right sides. Derivatives are compared within 1e-5 of the
/// largest; sums over elements in which tractions cancel need more digits.
constexpr double tangent_precision = 1e-9;
/// 1. The same of the feedback between pressure and shear, which is no more precise than these systems; and
/// of right sides what is left of them beside former ones.
constexpr double feedback_precision = 1e-8;
/// 1. What former answers leave of a right side is solved to this precision of the whole of it. If it is more
/// than this share, its own answer is made as precise, and serves again. Chosen.
constexpr double least_kept_share = 0.1;
/// 1. Of the residual, after one of them. Single precision gives no more.
constexpr double correction_precision = 1e-4;
/// 1. Larger residuals, over the right side, are no rounding: the system is singular. Chosen.
constexpr double largest_tangent_residual = 1e-7;
/// Elements in contact below the limit of the pressure. Up to here Cholesky's factor takes less than
/// conjugate gradients for each of ten right sides do. Chosen.
constexpr int dense_tangent_elements = 500;
/// Directions of the feedback between pressure and shear. An outer iteration of the solution itself takes off
/// a digit or two, and GCR is faster. Chosen.
constexpr int most_directions = 60;

[[noreturn]] void refuse() {
  throw ConvergenceError("The derivatives were not found",
                         "a linearised system of the solution is singular, or nearly so: the solution is not "
                         "unique, as in full slip under a prescribed shear force",
                         "Leave out derivatives, or give creepages in place of shear forces.");
}

} // namespace

VectorXd KnownAnswers::take(VectorXd& right) const {
  VectorXd out = VectorXd::Zero(right.size());
  for (int round = 0; round < 2; ++round) // twice is enough (Kahan)
    for (const auto& [known, answer] : all_) {
      const double share = known.dot(right);
      right -= share * known;
      out += share * answer;
    }
  return out;
}

void KnownAnswers::keep(const VectorXd& right, const VectorXd& answer) {
  const double length = right.norm();
  all_.emplace_back(right / length, answer / length);
}

void TangentTractions::add(double factor, const TangentTractions& other) {
  pn += factor * other.pn;
  pt += factor * other.pt;
  approach += factor * other.approach;
  creepage += factor * other.creepage;
}

TangentSystem::TangentSystem(const ContactProblem& problem, const ContactResult& solved,
                             ContactOperators& operators, const SolverOptions& options, WorkBudget& work)
    : problem_(problem), work_(work), system_(problem, operators, settling_factor * options.tolerance, work) {
  const int n = problem.grid.size();
  const VectorXd pressure = vector_of(solved.pn);
  for (int i = 0; i < n; ++i)
    if (solved.pn[i] > 0 && solved.pn[i] < system_.normal.limit)
      touching_.push_back(i);
  if (static_cast<int>(touching_.size()) <= dense_tangent_elements) {
    normal_factor_ = system_.normal.block(touching_);
    if (!factor_cholesky(normal_factor_))
      refuse();
  }
  unit_ = inverse_normal(system_.normal.cosine);
  nothing_ = {VectorXd::Zero(n), VectorXd::Zero(2 * n), VectorXd::Zero(n)};
  if (system_.by_force)
    force_to_length_ = pressure.maxCoeff() * system_.normal.self / problem.force;
  if (system_.shear)
    prepare_shear(solved);
}

void TangentSystem::prepare_shear(const ContactResult& solved) {
  const int n = problem_.grid.size();
  const double length = system_.shear->system.rule.length;
  task_.bound = friction_ = VectorXd::Zero(n);
  for (int i = 0; i < n; ++i) {
    if (!(solved.pn[i] > 0))
      continue;
    const double mu = problem_.friction_of(i / problem_.grid.mx);
    task_.contact.push_back(i);
    task_.bound[i] = shear_bound(problem_, solved, i);
    friction_[i] = task_.bound[i] < mu * solved.pn[i] ? 0.0 : mu; // a layer may bear less
  }
  elements_.emplace(system_.shear->system, task_);
  matrix_.emplace(system_.shear->system, *elements_, work_, NewtonMatrix::Serves::many_right_sides);
  const VectorXd here = elements_->gather(joined(solved.px, solved.ps)),
                 moving = length * elements_->gather(joined(solved.slip_x, solved.slip_s));
  linearisation_ = linearise(elements_->stiffness, elements_->bound, here, moving);
  along_ = VectorXd::Zero(here.size());
  slips_.assign(n, 0);
  for (std::size_t a = 0; a < task_.contact.size(); ++a) {
    const Vector2d z = here.segment<2>(2 * a) + elements_->stiffness[a] * moving.segment<2>(2 * a);
    if (z.norm() > elements_->bound[a]) {
      slips_[task_.contact[a]] = 1;
      along_.segment<2>(2 * a) = z.normalized();
    }
  }
  if (problem_.force_x)
    found_.push_back(component_x);
  if (problem_.force_s)
    found_.push_back(component_s);
  slips_of_unit_ = answers_to_unit_ = MatrixXd::Zero(here.size(), static_cast<Eigen::Index>(found_.size()));
  for (Eigen::Index k = 0; k < slips_of_unit_.cols(); ++k) {
    for (std::size_t a = 0; a < task_.contact.size(); ++a)
      slips_of_unit_(2 * a + found_[k], k) =
          length *
          (found_[k] == component_x ? 1.0 : problem_.lateral_share(task_.contact[a] / problem_.grid.mx));
    answers_to_unit_.col(k) =
        inverse_shear(projected(linearisation_, slips_of_unit_.col(k), &elements_->stiffness));
  }
}

/// A^-1 right of the elements that touch by conjugate gradients.
VectorXd TangentSystem::iterated_normal(const VectorXd& right) {
  VectorXd left = VectorXd::Zero(right.size());
  double largest = 0;
  for (const int i : touching_)
    left[i] = right[i];
  const double length = left.norm();
  const VectorXd known = known_pressures_.take(left);
  const double share = left.norm() / length;
  if (!(share > feedback_precision))
    return known;
  for (const int i : touching_)
    largest = std::max(largest, std::abs(left[i]));
  const bool serves_again = share > least_kept_share;
  const double enough = (serves_again ? tangent_precision : tangent_precision / share) * largest;
  Response response{VectorXd::Zero(right.size()), VectorXd::Zero(right.size()), {}};
  if (!conjugate_gradients(system_.normal, touching_, left, enough, work_, response))
    refuse();
  if (serves_again)
    known_pressures_.keep(left, response.p);
  return known + response.p;
}

/// A^-1 right of the elements that touch; 0 elsewhere.
VectorXd TangentSystem::inverse_normal(const VectorXd& right) {
  if (!normal_factor_.size())
    return iterated_normal(right);
  VectorXd p(touching_.size()), out = VectorXd::Zero(right.size());
  for (std::size_t a = 0; a < touching_.size(); ++a)
    p[a] = right[touching_[a]];
  solve_lower(normal_factor_, p);
  solve_lower_transposed(normal_factor_, p);
  for (std::size_t a = 0; a < touching_.size(); ++a)
    out[touching_[a]] = p[a];
  return out;
}

/// J^-1 right.
VectorXd TangentSystem::inverse_shear(const VectorXd& right) {
  VectorXd left = right;
  const VectorXd known = known_shears_.take(left);
  const double share = left.norm() / right.norm();
  if (!(share > feedback_precision))
    return known;
  const bool serves_again = share > least_kept_share;
  auto out = linear_solution(*matrix_, linearisation_, elements_->stiffness, left,
                             {.wanted = serves_again ? tangent_precision : tangent_precision / share,
                              .accepted = largest_tangent_residual / share,
                              .correction = correction_precision},
                             work_);
  if (!out)
    refuse();
  if (serves_again)
    known_shears_.keep(left, *out);
  return known + *out;
}

/// Shear under the pressure of `out`, and the creepages of prescribed shear forces.
void TangentSystem::solve_shear(const TangentLoad& load, TangentTractions& out) {
  VectorXd right =
      projected(linearisation_, elements_->gather(load.drive - step_of_pressure(*system_.shear, out.pn)),
                &elements_->stiffness);
  for (std::size_t a = 0; a < task_.contact.size(); ++a) {
    const int i = task_.contact[a];
    right.segment<2>(2 * a) += (load.bound[i] + friction_[i] * out.pn[i]) * along_.segment<2>(2 * a);
  }
  VectorXd p = inverse_shear(right);
  if (!found_.empty()) {
    const MatrixXd sums = (problem_.element_area() / system_.shear->system.rule.length) * slips_of_unit_;
    VectorXd missing = -sums.transpose() * p;
    for (std::size_t k = 0; k < found_.size(); ++k)
      missing[k] += load.shear_forces[found_[k]];
    const Eigen::FullPivLU<MatrixXd> forces(sums.transpose() * answers_to_unit_);
    if (!forces.isInvertible())
      refuse();
    const VectorXd creepages = forces.solve(missing);
    p += answers_to_unit_ * creepages;
    for (std::size_t k = 0; k < found_.size(); ++k)
      out.creepage[found_[k]] = creepages[k];
  }
  elements_->write(p, out.pt);
}

/// `feedback`: what shear does to e, mm; and to the prescribed force, as a length.
TangentTractions TangentSystem::respond(const TangentLoad& load, const VectorXd& feedback) {
  const Eigen::Index n = problem_.grid.size();
  TangentTractions out{VectorXd::Zero(n), VectorXd::Zero(2 * n)};
  const VectorXd& cosine = system_.normal.cosine;
  out.pn = inverse_normal(-load.distance - feedback.head(n));
  if (problem_.load == LoadKind::approach) {
    out.approach = load.approach;
  } else {
    const double borne = force_to_length_ > 0 ? feedback[n] / force_to_length_ : 0.0;
    out.approach = ((load.force - borne) / problem_.element_area() - cosine.dot(out.pn)) / cosine.dot(unit_);
  }
  out.pn += out.approach * unit_;
  if (system_.shear)
    solve_shear(load, out);
  return out;
}

VectorXd TangentSystem::feedback_of(const TangentTractions& tangent) const {
  const Eigen::Index n = problem_.grid.size();
  VectorXd out = VectorXd::Zero(n + 1);
  if (system_.by_numbers) {
    const VectorXd all = normal_displacement(*system_.shear, tangent.pt);
    for (const int i : touching_)
      out[i] = all[i];
  }
  if (system_.by_force)
    out[n] = force_to_length_ * system_.shear_force(tangent.pt);
  return out;
}

TangentTractions TangentSystem::solve(const TangentLoad& load) {
  const VectorXd none = VectorXd::Zero(problem_.grid.size() + 1);
  TangentTractions out = respond(load, none);
  if (!system_.coupled())
    return out;
  VectorXd left = feedback_of(out);
  const double enough = feedback_precision * left.norm();
  const auto take = [&](const Direction& known) {
    const double share = known.image.dot(left);
    left -= share * known.image;
    out.add(share, known.answer);
  };
  for (const Direction& known : directions_)
    take(known);
  while (left.norm() > enough) {
    if (directions_.size() == most_directions)
      refuse();
    Direction next{left, {}, respond(nothing_, left)};
    next.image = next.feedback - feedback_of(next.answer);
    for (int round = 0; round < 2; ++round) // twice is enough (Kahan)
      for (const Direction& known : directions_) {
        const double share = known.image.dot(next.image);
        next.image -= share * known.image;
        next.feedback -= share * known.feedback;
        next.answer.add(-share, known.answer);
      }
    const double length = next.image.norm();
    if (!(length > 0))
      refuse();
    next.image /= length;
    next.feedback /= length;
    TangentTractions scaled{VectorXd::Zero(next.answer.pn.size()), VectorXd::Zero(next.answer.pt.size())};
    scaled.add(1 / length, next.answer);
    next.answer = std::move(scaled);
    directions_.push_back(std::move(next));
    take(directions_.back());
  }
  return out;
}

VectorXd TangentSystem::distance(const TangentTractions& tangent) const {
  VectorXd out = system_.normal.apply(tangent.pn, work_);
  if (system_.shear)
    out += normal_displacement(*system_.shear, tangent.pt);
  return out - tangent.approach * system_.normal.cosine;
}

VectorXd TangentSystem::slip(const TangentTractions& tangent) const {
  VectorXd out = VectorXd::Zero(2 * problem_.grid.size());
  if (!system_.shear)
    return out;
  VectorXd step;
  matrix_->step(elements_->gather(tangent.pt), step);
  VectorXd moving = -elements_->gather(step_of_pressure(*system_.shear, tangent.pn)) - step;
  for (std::size_t k = 0; k < found_.size(); ++k)
    moving += tangent.creepage[found_[k]] * slips_of_unit_.col(static_cast<Eigen::Index>(k));
  elements_->write(moving, out);
  return out;
}

} // namespace bem_contact::contact
