#pragma once

#include <Eigen/Core>

namespace bem_contact::contact {

/// GMRES (Saad, Schultz 1986), preconditioned from the right, in single precision: what it solves for is a
/// correction, whose first digits are enough. Keeps its basis, so that a further solution of the same size
/// allocates nothing.
class Gmres {
public:
  using Vector = Eigen::VectorXf;

  /// apply(v, out) and precondition(v, out) write Vectors of rhs's size. True when the residual fell to
  /// tolerance * |rhs|; x is the best there is in any case. At most `most` products.
  template <class Apply, class Precondition>
  bool solve(const Apply& apply, const Precondition& precondition, const Eigen::VectorXd& rhs,
             double tolerance, int most, Eigen::VectorXd& x) {
    const double beta = rhs.norm();
    x.setZero(rhs.size());
    products_ = 0;
    if (beta == 0)
      return true;
    prepare(rhs.size(), most);
    basis_.col(0) = (rhs / beta).cast<float>();
    g_[0] = 1;
    int k = 0;
    while (k < most && std::abs(g_[k]) > tolerance) {
      if (k + 2 > basis_.cols())
        basis_.conservativeResize(Eigen::NoChange, std::min(2 * k + 2, most + 1));
      z_ = basis_.col(k);
      precondition(z_, w_);
      apply(w_, z_);
      ++products_;
      if (!orthogonalise(k))
        break;
      ++k;
      if (exhausted_)
        break;
    }
    if (k == 0)
      return false;
    combine(k);
    precondition(w_, z_);
    x = beta * z_.cast<double>();
    return std::abs(g_[k]) <= tolerance;
  }

  int products() const { return products_; } ///< of the last solution

private:
  void prepare(Eigen::Index unknowns, int most);
  /// z against the basis; the next column of the basis and of the triangle. False: nothing is left of it.
  bool orthogonalise(int k);
  /// w = basis times the solution of the triangle
  void combine(int k);

  Eigen::MatrixXf basis_;
  Eigen::MatrixXd h_;
  Eigen::VectorXd g_, cosine_, sine_;
  Vector z_, w_;
  int products_ = 0;
  bool exhausted_ = false;
};

} // namespace bem_contact::contact
