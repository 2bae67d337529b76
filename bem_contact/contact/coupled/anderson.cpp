#include "bem_contact/contact/coupled/anderson.hpp"

#include "bem_contact/contact/coupled/settings.hpp"

#include <Eigen/QR>

namespace bem_contact::contact {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd Anderson::next(const VectorXd& v, const VectorXd& residual) {
  if (!best_ || residual.norm() < *best_)
    best_ = residual.norm();
  else if (residual.norm() > anderson_restart * *best_) {
    history_.clear();
    return v + anderson_short_step * residual;
  }
  history_.push_back({v, residual});
  if (history_.size() > std::size_t(anderson_memory))
    history_.pop_front();
  const Eigen::Index columns = static_cast<Eigen::Index>(history_.size()) - 1;
  if (columns == 0)
    return v + residual;
  MatrixXd dv(v.size(), columns), dr(v.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    dv.col(k) = history_[k + 1].v - history_[k].v;
    dr.col(k) = history_[k + 1].residual - history_[k].residual;
  }
  const VectorXd weights = dr.colPivHouseholderQr().solve(residual);
  return v + residual - (dv + dr) * weights;
}

} // namespace bem_contact::contact
