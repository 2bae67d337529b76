#include "bem_contact/contact/tangential/friction.hpp"

#include "bem_contact/contact/prepared.hpp"
#include "bem_contact/contact/rolling_step.hpp"
#include "bem_contact/contact/tangential/linearise.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

using Eigen::VectorXd;

StepNumbers::StepNumbers(const InfluenceNumbers& numbers, int mx, const std::array<double, 3>& step)
    : mx_(mx), ms_(numbers.rows),
      values_(static_cast<std::size_t>(numbers.rows) * numbers.rows * 4 * (2 * mx - 1)) {
  std::size_t position = 0;
  for (int row_i = 0; row_i < ms_; ++row_i)
    for (int row_j = 0; row_j < ms_; ++row_j)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) {
          const auto a = [&](int m) {
            return (m < 0 ? parity(c, d) : 1) * numbers.at(std::abs(m), row_i, c, row_j, d);
          };
          for (int m = mx - 1; m > -mx; --m)
            values_[position++] = step[0] * a(m) + step[1] * a(m + 1) + step[2] * a(m + 2);
        }
}

TangentialSystem::TangentialSystem(const ContactProblem& the_problem, Prepared* kept)
    : problem(&the_problem), rule(slip_step(the_problem)), stiffness(the_problem.grid.size()),
      own_(kept ? nullptr : std::make_unique<Prepared>()), kept_(kept ? kept : own_.get()) {
  const auto& [mx, ms, dx, ds, x0] = problem->grid;
  const InfluenceNumbers& a = problem->numbers;
  for (int is = 0; is < ms; ++is) {
    double mean = 0;
    for (const int c : {component_x, component_s})
      for (int k = 0; k <= rolling_columns; ++k)
        mean += 0.5 * rule.present[k] * a.at(k, is, c, is, c);
    stiffness.segment(is * mx, mx).setConstant(1 / mean);
  }
}

StepBox::StepBox(const InfluenceNumbers& numbers, const Parts& the_box, const SlipStep& the_rule,
                 TransformPool* pool)
    : box(the_box), rule(the_rule),
      tt(numbers, box, {component_x, component_s}, {component_x, component_s}, pool), fast(tt, pool),
      sticks(box.size()), in(2 * box.size()), out(2 * box.size()), fast_in(2 * box.size()),
      fast_out(2 * box.size()) {
  using Inverse = BasicPlaneOperator<float>;
  for (const int c : {component_x, component_s}) {
    const Inverse a(numbers, box.mx(), box.ms(), {c}, {c}, Inverse::Form::periodic,
                    box.boxes.front().first_s + box.ms() / 2, pool);
    for (auto* list : {&behind, &ahead, &periodic, &damped})
      list->emplace_back(a);
    behind.back().invert_factor(Inverse::Factor::behind);
    ahead.back().invert_factor(Inverse::Factor::ahead);
  }
}

void StepBox::apply_each(const std::vector<BasicPlaneOperator<float>>& of, std::vector<float>& from,
                         std::vector<float>& to) {
  const std::size_t n = box.boxes.front().size();
  for (std::size_t field = 0; field < from.size() / n; ++field)
    of[field / box.boxes.size()].apply({&from[field * n], n}, {&to[field * n], n}, 0);
}

void StepBox::set_damping(double shift, double stiffness) {
  for (const std::size_t c : {0, 1})
    damped[c].invert_shifted(periodic[c], static_cast<float>(shift), static_cast<float>(stiffness),
                             rule.present);
}

void StepBox::invert_damped() {
  apply_each(damped, fast_in, fast_out);
}

void StepBox::step() {
  if (rule.present[1] != 0)
    return tt.apply_step(in, out);
  tt.apply(in, out);
  for (double& v : out)
    v *= rule.present[0];
}

void StepBox::fast_step() {
  if (rule.present[1] != 0)
    return fast.apply_step(fast_in, fast_out);
  fast.apply(fast_in, fast_out);
  for (float& v : fast_out)
    v *= static_cast<float>(rule.present[0]);
}

void StepBox::invert() {
  const int mx = box.mx();
  const std::size_t n = box.size();
  const auto d0 = static_cast<float>(rule.present[0]), d1 = static_cast<float>(rule.present[1]),
             d2 = static_cast<float>(rule.present[2]);
  apply_each(behind, fast_in, fast_out);
  for (const std::size_t c : {0, 1})
    for (int is = 0; is < box.rows(); ++is) {
      float* to = &fast_out[c * n];
      float u1 = 0, u2 = 0; // of the elements ahead, where they stick
      for (int i = (is + 1) * mx - 1; i >= is * mx; --i) {
        to[i] = sticks[i] ? (to[i] - d1 * u1 - d2 * u2) / d0 : 0.0f;
        u2 = u1;
        u1 = to[i];
      }
    }
  apply_each(ahead, fast_out, fast_out);
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (!sticks[i % n])
      fast_out[i] = 0;
}

TangentialSystem::TangentialSystem(TangentialSystem&&) noexcept = default;
TangentialSystem::~TangentialSystem() = default;

void TangentialSystem::spend(double elements) const {
  kept_->spend(elements);
}

StepBox& TangentialSystem::box_for(const std::vector<int>& contact) const {
  const Parts needed = parts_around(contact, problem->grid, 0, !problem->numbers.translational);
  std::optional<StepBox>& box = kept_->step_box;
  if (!box || !serve(box->box, needed, contact, problem->grid.mx) || box->rule.present != rule.present) {
    spend(spectra_work(problem->numbers.translational, 4, needed.rows(), needed.mx()));
    box.emplace(problem->numbers, needed, rule, kept_->pool.get());
  }
  return *box;
}

const Eigen::MatrixXd& TangentialSystem::matrix_for(const std::vector<int>& contact) const {
  StepMatrix& kept = kept_->step_matrix;
  if (kept.contact != contact || kept.step != rule.present)
    kept = {contact, rule.present, step_matrix(*this, contact)};
  return kept.matrix;
}

double TangentialSystem::product_work(int rows) const {
  return bem_contact::product_work(problem->numbers.translational, rows);
}

const StripOperator& TangentialSystem::whole() const {
  if (!kept_->tt) {
    spend(spectra_work(problem->numbers.translational, 4, problem->grid.ms, problem->grid.mx));
    kept_->tt.emplace(problem->numbers, problem->grid.mx, std::vector<int>{component_x, component_s},
                      std::vector<int>{component_x, component_s}, RowRange{}, kept_->pool.get());
  }
  return *kept_->tt;
}

VectorXd TangentialSystem::displacement(const VectorXd& p, int columns) const {
  spend(product_work(problem->grid.ms) * size());
  VectorXd u(p.size());
  whole().apply({p.data(), static_cast<std::size_t>(p.size())},
                {u.data(), static_cast<std::size_t>(u.size())}, columns);
  return u;
}

VectorXd TangentialSystem::step(const VectorXd& p) const {
  if (problem->motion != MotionKind::steady)
    return rule.present[0] * displacement(p);
  spend(product_work(problem->grid.ms) * size());
  VectorXd u(p.size());
  whole().apply_step({p.data(), static_cast<std::size_t>(p.size())},
                     {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

const StepNumbers& TangentialSystem::step_numbers() const {
  if (!kept_->step_numbers || kept_->step != rule.present) {
    kept_->step_numbers.emplace(problem->numbers, problem->grid.mx, rule.present);
    kept_->step = rule.present;
  }
  return *kept_->step_numbers;
}

double largest_slip(const VectorXd& rigid, const std::vector<int>& contact, const VectorXd& slip,
                    double floor) {
  const Eigen::Index n = rigid.size() / 2;
  double largest = floor;
  for (const int i : contact)
    largest = std::max({largest, std::hypot(rigid[i], rigid[n + i]),
                        std::hypot(slip[i] - rigid[i], slip[n + i] - rigid[n + i])});
  return largest;
}

double coulomb_violation(const TangentialSystem& system, const TangentialTask& task, const VectorXd& p,
                         const VectorXd& slip) {
  const int n = system.size();
  const double slip_scale = largest_slip(task.rigid, task.contact, slip, task.slip_floor);
  const double largest_bound = task.bound.maxCoeff();
  double worst = 0;
  for (const int i : task.contact) {
    const double s = std::hypot(slip[i], slip[n + i]);
    const double cone = std::hypot(p[i], p[n + i]) - task.bound[i];
    worst = std::max(worst, cone / largest_bound);
    if (s <= 0)
      continue;
    const double direction =
        std::hypot(p[i] - task.bound[i] * slip[i] / s, p[n + i] - task.bound[i] * slip[n + i] / s);
    worst = std::max(worst, std::min(s / slip_scale, direction / largest_bound));
  }
  return worst;
}

} // namespace bem_contact::contact
