// The same as dense.cpp where there is no OpenBLAS.
#include "bem_contact/influence/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace bem_contact {

bool factor_cholesky(Eigen::MatrixXd& a) {
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(a);
  return in_place.info() == Eigen::Success;
}

void solve_lower(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  factor.triangularView<Eigen::Lower>().solveInPlace(x);
}

void solve_lower_transposed(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  factor.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
}

/// The inverses of blocks stay empty: Eigen's solutions go by blocks themselves.
LuFactors::LuFactors(Eigen::MatrixXf a) : factors_(std::move(a)), pivots_(factors_.rows()) {
  if (factors_.rows() == 0)
    return;
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXf>> in_place(factors_);
  Eigen::VectorXi::Map(pivots_.data(), factors_.rows()) = in_place.permutationP().indices();
  regular_ = (factors_.diagonal().array() != 0).all();
}

void LuFactors::solve(Eigen::Ref<Eigen::VectorXf> x) const {
  if (factors_.rows() == 0)
    return;
  Eigen::VectorXf moved(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    moved[pivots_[static_cast<std::size_t>(i)]] = x[i];
  factors_.triangularView<Eigen::UnitLower>().solveInPlace(moved);
  factors_.triangularView<Eigen::Upper>().solveInPlace(moved);
  x = moved;
}

void dense_product(const Eigen::MatrixXf& a, Eigen::Ref<const Eigen::VectorXf> x,
                   Eigen::Ref<Eigen::VectorXf> out) {
  out.noalias() = a * x;
}

void dense_product(const Eigen::MatrixXd& a, Eigen::Ref<const Eigen::VectorXd> x,
                   Eigen::Ref<Eigen::VectorXd> out) {
  out.noalias() = a * x;
}

void dense_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out) {
  Eigen::MatrixXd::Map(out, a.rows(), b.cols()).noalias() = a * b;
}

void dense_product_of_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out) {
  Eigen::MatrixXd::Map(out, a.cols(), b.cols()).noalias() = a.transpose() * b;
}

} // namespace bem_contact
