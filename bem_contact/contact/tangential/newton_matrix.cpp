#include "bem_contact/contact/tangential/newton_matrix.hpp"

#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/influence/dense.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::VectorXd;
using Eigen::VectorXf;

/// The Newton matrix of one linearisation and an approximate inverse of it, in single precision, for GCR.
/// The projection M of an element is the identity if it sticks, and m t t' if it slips, t along its bound. An
/// element that nearly sticks (m above counts_as_sticking) counts as sticking along t.
class FastJacobian {
  using Element = StepBoxScratch::Element;

public:
  FastJacobian(const StepBox& box, const std::vector<int>& local, const VectorXd& all_stiffness,
               const Linearisation& at, StepBoxScratch& scratch)
      : box_(box), local_(local), scratch_(scratch), n_(box.size()) {
    double slipping = 0, sum = 0, stiffness = 0;
    std::ranges::fill(scratch.fast_in, 0.0f); // stays so beside the elements in contact
    scratch.elements.clear();
    for (std::size_t a = 0; a < local.size(); ++a) {
      const double m = std::min(at.projection[a].trace(), 2.0);
      const auto r = static_cast<float>(all_stiffness[a]);
      scratch.sticks[local[a]] = m > counts_as_sticking;
      sticking_ = sticking_ || m > counts_as_sticking;
      scratch.elements.push_back({at.projection[a].cast<float>(), r, static_cast<float>(m), 0});
      stiffness += r;
      if (m <= counts_as_sticking) {
        slipping += 1;
        sum += m;
      }
    }
    if (!(sum > 0))
      return;
    // (1 - m)/m + r B, scaled from both sides to the mean of the first
    const double mean = std::max(sum / slipping, least_mean_slope), shift = (1 - mean) / mean;
    for (Element& e : scratch.elements)
      if (e.m <= counts_as_sticking)
        e.scale = static_cast<float>(std::sqrt(shift * e.m / (1 - e.m)));
    damped_ = true;
    scratch.damped.set(box, shift, stiffness / local.size());
  }

  /// B v
  void product(Eigen::Ref<const VectorXf> v, Eigen::Ref<VectorXf> result) const {
    for (std::size_t a = 0; a < local_.size(); ++a)
      put(a, v.segment<2>(2 * a));
    box_.step(scratch_.fast_in, scratch_.fast_out);
    for (std::size_t a = 0; a < local_.size(); ++a)
      result.segment<2>(2 * a) = get(a);
  }

  /// J v = v - M (v - r B v)
  void image(Eigen::Ref<const VectorXf> v, Eigen::Ref<const VectorXf> bv, VectorXf& result) const {
    for (std::size_t a = 0; a < local_.size(); ++a) {
      const Vector2f here = v.segment<2>(2 * a);
      const Element& e = scratch_.elements[a];
      result.segment<2>(2 * a) = here - e.projection * (here - e.stiffness * bv.segment<2>(2 * a));
    }
  }

  /// About J^-1 v: r B inverted where it sticks, the damped matrix where it slips; across the bound J is the
  /// identity.
  void precondition(const VectorXf& v, Eigen::Ref<VectorXf> result) const {
    result = v;
    for (std::size_t a = 0; a < local_.size(); ++a)
      if (const Element& e = scratch_.elements[a]; e.m >= 2)
        result.segment<2>(2 * a).setZero();
      else if (e.m > 0)
        result.segment<2>(2 * a) -= e.projection * v.segment<2>(2 * a) / e.m;
    if (sticking_) {
      for (std::size_t a = 0; a < local_.size(); ++a) {
        const Element& e = scratch_.elements[a];
        put(a, e.m >= 2 ? Vector2f(v.segment<2>(2 * a) / e.stiffness)
               : e.m > counts_as_sticking
                   ? Vector2f(e.projection * v.segment<2>(2 * a) / (e.m * e.m * e.stiffness))
                   : Vector2f(0, 0));
      }
      box_.invert(scratch_.sticks, scratch_.fast_in, scratch_.fast_out);
      for (std::size_t a = 0; a < local_.size(); ++a)
        if (const Element& e = scratch_.elements[a]; e.m >= 2)
          result.segment<2>(2 * a) = get(a);
        else if (e.m > counts_as_sticking)
          result.segment<2>(2 * a) += e.projection * get(a) / e.m;
    }
    if (!damped_)
      return;
    for (std::size_t a = 0; a < local_.size(); ++a) {
      const Element& e = scratch_.elements[a];
      put(a, e.scale > 0 ? Vector2f(e.scale / (e.m * e.m) * (e.projection * v.segment<2>(2 * a)))
                         : Vector2f(0, 0));
    }
    scratch_.damped.apply(box_, scratch_.fast_in, scratch_.fast_out);
    for (std::size_t a = 0; a < local_.size(); ++a)
      if (const Element& e = scratch_.elements[a]; e.scale > 0)
        result.segment<2>(2 * a) += e.scale / e.m * (e.projection * get(a));
  }

private:
  void put(std::size_t a, const Vector2f& v) const {
    scratch_.fast_in[local_[a]] = v[0];
    scratch_.fast_in[n_ + local_[a]] = v[1];
  }
  Vector2f get(std::size_t a) const {
    return {scratch_.fast_out[local_[a]], scratch_.fast_out[n_ + local_[a]]};
  }

  const StepBox& box_;
  const std::vector<int>& local_;
  StepBoxScratch& scratch_;
  std::size_t n_;
  bool sticking_ = false, damped_ = false;
};

} // namespace

NewtonMatrix::NewtonMatrix(const TangentialSystem& system, const ContactElements& elements, WorkBudget& work)
    : system_(system), elements_(elements) {
  if (static_cast<int>(elements.contact.size()) <= dense_tangential_elements) {
    matrix_ = &system.matrix_of(elements.contact);
    return;
  }
  const auto [box, scratch] = system.box_around(elements.contact, work);
  box_ = &box;
  scratch_ = &scratch;
  local_ = box.boxes().local(elements.contact, system.columns());
  std::fill(scratch.sticks.begin(), scratch.sticks.end(), 0);
  scratch.gcr.use_elements(elements.contact);
}

void NewtonMatrix::step(const VectorXd& v, VectorXd& result) const {
  if (matrix_) {
    result.noalias() = *matrix_ * v;
    return;
  }
  const int n = box_->size();
  std::fill(scratch_->in.begin(), scratch_->in.end(), 0.0);
  for (std::size_t a = 0; a < local_.size(); ++a) {
    scratch_->in[local_[a]] = v[2 * a];
    scratch_->in[n + local_[a]] = v[2 * a + 1];
  }
  box_->step(scratch_->in, scratch_->out);
  result.resize(elements_.unknowns());
  for (std::size_t a = 0; a < local_.size(); ++a) {
    result[2 * a] = scratch_->out[local_[a]];
    result[2 * a + 1] = scratch_->out[n + local_[a]];
  }
}

double NewtonMatrix::product_work() const {
  return matrix_ ? elements_.contact.size() : system_.product_work(box_->boxes().rows()) * box_->size();
}

VectorXd NewtonMatrix::solve_dense(const Linearisation& at) const {
  struct Unknown {
    Eigen::Index place; ///< of the element's x in a vector
    Vector2d direction; ///< of its step
    double m;
    Vector2d weight; ///< of the slip under a step: m stiffness direction
  };
  std::vector<Unknown> unknowns;
  VectorXd step = VectorXd::Zero(elements_.unknowns());
  for (int a = 0; a < elements_.unknowns() / 2; ++a) {
    const Matrix2d& projection = at.projection[a];
    const double m = projection.trace(); // 2 where the element sticks, else at most 1
    if (m > 1.5) {
      for (const Vector2d& axis : {Vector2d(1, 0), Vector2d(0, 1)})
        unknowns.push_back({2 * a, axis, 1, elements_.stiffness[a] * axis});
      continue;
    }
    step.segment<2>(2 * a) = -at.residual.segment<2>(2 * a);
    if (!(m > 0))
      continue;
    const Vector2d along = projection.col(projection(0, 0) > projection(1, 1) ? 0 : 1).normalized();
    step.segment<2>(2 * a) -= along * along.dot(step.segment<2>(2 * a));
    unknowns.push_back({2 * a, along, m, m * elements_.stiffness[a] * along});
  }
  const MatrixXd only_now =
      matrix_ ? MatrixXd() : step_matrix(*system_.problem, system_.rule.present, elements_.contact);
  const MatrixXd& b = matrix_ ? *matrix_ : only_now;
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  // In single precision, as GCR: the next step knows the residual in double. It may be smaller than any
  // float.
  const double size = std::max(at.residual.lpNorm<Eigen::Infinity>(), std::numeric_limits<double>::min());
  Eigen::MatrixXf jacobian(count, count);
  VectorXf right(count);
  const VectorXd known = b * step;
  VectorXd column(elements_.unknowns());
  for (Eigen::Index k = 0; k < count; ++k) {
    const Unknown& load = unknowns[k];
    column = load.direction[0] * b.col(load.place) + load.direction[1] * b.col(load.place + 1);
    for (Eigen::Index l = 0; l < count; ++l)
      jacobian(l, k) = static_cast<float>(unknowns[l].weight.dot(column.segment<2>(unknowns[l].place)));
    jacobian(k, k) += static_cast<float>(1 - load.m);
    right[k] = static_cast<float>((-load.direction.dot(at.residual.segment<2>(load.place)) -
                                   load.weight.dot(known.segment<2>(load.place))) /
                                  size);
  }
  if (!solve_lu(jacobian, right))
    right.setConstant(std::nanf(""));
  for (Eigen::Index k = 0; k < count; ++k)
    step.segment<2>(unknowns[k].place) += size * right[k] * unknowns[k].direction;
  return step;
}

/// True if GCR converged, or if there are so many elements that its result has to do.
bool NewtonMatrix::solve_by_gcr(const Linearisation& at, double tolerance, TangentialState& state,
                                VectorXd& step) const {
  const FastJacobian jacobian(*box_, local_, elements_.stiffness, at, *scratch_);
  const auto product = [&](const auto& v, auto&& result) { jacobian.product(v, result); };
  const auto image = [&](const auto& v, const auto& bv, VectorXf& result) { jacobian.image(v, bv, result); };
  const auto inverse = [&](const VectorXf& v, auto&& result) { jacobian.precondition(v, result); };
  const bool enough =
      scratch_->gcr.solve(product, image, inverse, -at.residual, {tolerance, most_gcr_products}, step);
  state.products += scratch_->gcr.products();
  return enough || elements_.unknowns() / 2 > most_dense_elements;
}

VectorXd NewtonMatrix::newton_step(const Linearisation& at, double tolerance, WorkBudget& work,
                                   TangentialState& state) const {
  const int before = state.products;
  VectorXd step;
  if (box_ && solve_by_gcr(at, tolerance, state, step))
    state.solver = "Newton, GCR";
  else {
    state.solver = "Newton, LU";
    step = solve_dense(at);
  }
  // An iteration of GCR is a product and the preconditioner, which is translational.
  const double gcr_work = box_ ? product_work() + 2.0 * box_->size() : 0;
  work.spend(2.0 * product_work() + (state.products - before) * gcr_work);
  return step;
}

} // namespace bem_contact::contact
