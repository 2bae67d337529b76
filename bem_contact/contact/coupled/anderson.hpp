#pragma once

#include <Eigen/Core>

#include <deque>
#include <optional>

namespace bem_contact::contact {

/// Anderson acceleration (1965) of a fixed-point iteration v = G(v), with a short memory. If the residual
/// grows far beyond the best one, the memory is dropped and a short plain step is taken.
class Anderson {
public:
  /// The next v to try. `residual` is G(v) - v.
  Eigen::VectorXd next(const Eigen::VectorXd& v, const Eigen::VectorXd& residual);

private:
  struct Trial {
    Eigen::VectorXd v, residual;
  };
  std::deque<Trial> history_;
  std::optional<double> best_;
};

} // namespace bem_contact::contact
