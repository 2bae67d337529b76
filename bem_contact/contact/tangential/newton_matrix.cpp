#include "bem_contact/contact/tangential/newton_matrix.hpp"

#include "bem_contact/contact/tangential/box_jacobian.hpp"
#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/influence/dense.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact::contact {

namespace {

/// Elements in contact. Above this the dense matrix (432 MB here, in both precisions) is not even a
/// fall-back.
constexpr int most_dense_elements = 3000;
/// Products of GCR. Chosen: where it needs more, LU factors are as fast.
constexpr int most_gcr_products = 250;

} // namespace

using Eigen::VectorXd;
using Eigen::VectorXf;

NewtonMatrix::NewtonMatrix(const TangentialSystem& system, const ContactElements& elements, WorkBudget& work,
                           Serves serves)
    : system_(system), elements_(elements) {
  const int count = static_cast<int>(elements.contact.size());
  if (serves == Serves::many_right_sides) {
    own_gcr_.emplace(Gcr::Keeps{0, 0}).keep_all_directions();
    if (count <= dense_right_sides_elements) {
      own_few_.emplace(TangentialOperators::FewElements{
          ContactMatrix(*system.problem, system.rule.present, elements.contact)});
      few_ = &*own_few_;
      return;
    }
  } else if (count <= dense_tangential_elements) {
    few_ = &system.few_elements(elements.contact);
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
  result.resize(elements_.unknowns());
  if (few_) {
    dense_product(few_->matrix.b, v, result);
    return;
  }
  const int n = box_->size();
  std::fill(scratch_->in.begin(), scratch_->in.end(), 0.0);
  for (std::size_t a = 0; a < local_.size(); ++a) {
    scratch_->in[local_[a]] = v[2 * a];
    scratch_->in[n + local_[a]] = v[2 * a + 1];
  }
  box_->step(scratch_->in, scratch_->out);
  for (std::size_t a = 0; a < local_.size(); ++a) {
    result[2 * a] = scratch_->out[local_[a]];
    result[2 * a + 1] = scratch_->out[n + local_[a]];
  }
}

void NewtonMatrix::begin_anew() const {
  if (own_gcr_)
    own_gcr_->forget();
  if (own_few_)
    few_->factors.reset();
}

double NewtonMatrix::product_work() const {
  return few_ ? elements_.contact.size() : system_.product_work(box_->boxes().rows()) * box_->size();
}

BorderedSolution NewtonMatrix::solve_few(const Asked& asked, TangentialOperators::FewElements& few,
                                         TangentialState& state) const {
  const std::vector<NewtonElement> elements =
      newton_elements(asked.at, few.matrix.scale * elements_.stiffness);
  BorderedSolution step;
  const auto product = [&](const auto& v, auto&& result) { dense_product(few.matrix.fast, v, result); };
  const auto image = [&](const auto& v, const auto& bv, VectorXf& result) {
    newton_image(elements, asked.at.carried, v, bv, result);
  };
  const auto inverse = [&](const VectorXf& v, auto&& result) { few.factors->solve(elements, v, result); };
  const auto converges = [&](int most) {
    const bool done = few.gcr.solve(product, image, inverse, -asked.at.residual, asked.border,
                                    {asked.tolerance, most}, step);
    state.products += few.gcr.products();
    return done;
  };
  if (few.factors) {
    few.factors->use_elements(elements_.contact);
    if (converges(most_former_products))
      return step;
  }
  few.factors.emplace(elements_.contact, elements, few.matrix.fast);
  if (few.factors->regular())
    converges(most_gcr_products); // its result has to do
  else
    step.x.setConstant(elements_.unknowns(), std::numeric_limits<double>::quiet_NaN());
  return step;
}

bool NewtonMatrix::solve_on_box(const Asked& asked, TangentialState& state, BorderedSolution& step) const {
  const std::vector<NewtonElement> elements = newton_elements(asked.at, elements_.stiffness);
  const BoxJacobian jacobian(*box_, local_, elements, *scratch_);
  const auto product = [&](const auto& v, auto&& result) { jacobian.product(v, result); };
  const auto image = [&](const auto& v, const auto& bv, VectorXf& result) {
    newton_image(elements, asked.at.carried, v, bv, result);
  };
  const auto inverse = [&](const VectorXf& v, auto&& result) { jacobian.precondition(v, result); };
  Gcr& gcr = own_gcr_ ? *own_gcr_ : scratch_->gcr;
  const bool enough = gcr.solve(product, image, inverse, -asked.at.residual, asked.border,
                                {asked.tolerance, most_gcr_products}, step);
  state.products += gcr.products();
  return enough || elements_.unknowns() / 2 > most_dense_elements;
}

BorderedSolution NewtonMatrix::newton_step(const Linearisation& at, const Border& border, double tolerance,
                                           WorkBudget& work, TangentialState& state) const {
  const int before = state.products;
  const Asked asked{at, border, tolerance};
  BorderedSolution step;
  if (!few_ && solve_on_box(asked, state, step)) {
    state.solver = "Newton, GCR";
  } else {
    state.solver = "Newton, LU";
    if (few_) {
      step = solve_few(asked, *few_, state);
    } else {
      TangentialOperators::FewElements only_now{
          ContactMatrix(*system_.problem, system_.rule.present, elements_.contact)};
      step = solve_few(asked, only_now, state);
    }
  }
  // An iteration of GCR is a product and the preconditioner, which is translational or as dear as a product.
  const double gcr_work = product_work() + (box_ ? 2.0 * box_->size() : 0.0);
  work.spend(2.0 * product_work() + (state.products - before) * gcr_work);
  return step;
}

} // namespace bem_contact::contact
