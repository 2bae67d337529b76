#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace bem_contact::contact {

/// F = p - Proj(p + r S), which is 0 where Coulomb's law holds, and the derivative M of the projection,
/// element by element. Vectors are [x, s] of the first element, of the second, ...
struct Linearisation {
  Eigen::VectorXd residual;
  std::vector<Eigen::Matrix2d> projection;
};

/// An element of the linearisation in single precision, of which Newton's linear systems are made.
struct NewtonElement {
  Eigen::Matrix2f projection; ///< M
  float stiffness;            ///< r
  float m;                    ///< trace of M: 2 where the element sticks, else at most 1

  bool sticks() const { return m > 1.5f; }
  /// The part of v on which J is not the identity: all of it where the element sticks, else along its bound.
  Eigen::Vector2f along(const Eigen::Vector2f& v) const {
    return sticks() ? v : m > 0 ? Eigen::Vector2f(projection * v / m) : Eigen::Vector2f::Zero();
  }
};
std::vector<NewtonElement> newton_elements(const Linearisation& at, const Eigen::VectorXd& stiffness);

/// result = J v = v - M (v - r B v), from v and B v.
void newton_image(std::span<const NewtonElement> elements, Eigen::Ref<const Eigen::VectorXf> v,
                  Eigen::Ref<const Eigen::VectorXf> bv, Eigen::VectorXf& result);

/// `stiffness` is r, `bound` the radius of the friction disc; one value an element.
Linearisation linearise(const Eigen::VectorXd& stiffness, const Eigen::VectorXd& bound,
                        const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

} // namespace bem_contact::contact
