#pragma once

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// In rolling, a layer that hardens brings plastic slip along from the elements ahead: a change of z = p + r
/// S there changes what it bears here. Empty where no layer hardens.
struct CarriedYield {
  struct Element {
    Eigen::Vector2f direction; ///< of z
    float rise, kept;          ///< LayerAnswer
    bool yields;
    std::array<int, 2> ahead; ///< places of the elements one and two columns ahead; -1: not in contact
  };
  std::vector<Element> elements;
  std::array<float, 2> share{}; ///< PlasticSlip::share() of these two

  /// result += factor times what z of the elements ahead changes in the projection of each.
  template <class Vector> void add(const Vector& z, typename Vector::Scalar factor, Vector& result) const {
    using Scalar = typename Vector::Scalar;
    std::vector<Scalar> borne(elements.size()); // change of what the layer bears after the step
    for (std::size_t a = elements.size(); a-- > 0;) {
      const Element& e = elements[a];
      Scalar before = 0;
      for (const std::size_t k : {0, 1})
        if (e.ahead[k] >= 0)
          before += Scalar(share[k]) * borne[e.ahead[k]];
      const auto direction = e.direction.template cast<Scalar>().eval();
      borne[a] = Scalar(e.kept) * before + Scalar(e.rise) * direction.dot(z.template segment<2>(2 * a));
      if (e.yields)
        result.template segment<2>(2 * a) += factor * Scalar(e.kept) * before * direction;
    }
  }
};

/// F = p - Proj(p + r S), which is 0 where Coulomb's law holds, and the derivative M of the projection,
/// element by element. Vectors are [x, s] of the first element, of the second, ...
struct Linearisation {
  Eigen::VectorXd residual;
  std::vector<Eigen::Matrix2d> projection;
  CarriedYield carried = {}; ///< the rest of the derivative
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

/// result = J v = v - M (v - r B v), from v and B v, with what elements carry along.
void newton_image(std::span<const NewtonElement> elements, const CarriedYield& carried,
                  Eigen::Ref<const Eigen::VectorXf> v, Eigen::Ref<const Eigen::VectorXf> bv,
                  Eigen::VectorXf& result);

/// `stiffness` is r, `bound` the radius of the friction disc; one value an element.
Linearisation linearise(const Eigen::VectorXd& stiffness, const Eigen::VectorXd& bound,
                        const Eigen::VectorXd& p, const Eigen::VectorXd& slip);

} // namespace bem_contact::contact
