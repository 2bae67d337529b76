#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <array>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// The plastic slip w of a layer that yields (ContactProblem::yield), mm. Material carries it along, so that
/// a step adds to it by the rule of slip itself (slip_step.hpp):
///     |S_plastic| = sum_k present[k] w_now(x + k dx) + sum_k former[k] w_k(x + k columns dx).
/// What rolls into the grid is new. Without friction, or beside the contact, w stays.
class PlasticSlip {
public:
  explicit PlasticSlip(const ContactProblem& problem); ///< which outlives this and has a yield limit

  /// Fields of the tractions on all elements, MPa; of slip, mm; and what friction bears, mu p_n, MPa.
  /// `limits`: tau_0 at the temperatures of the elements, MPa; empty: that of the problem.
  struct Given {
    std::span<const double> px, ps, slip_x, slip_s, friction, limits = {};
  };
  /// The answers of all elements, each after those ahead of it; field.
  std::vector<LayerAnswer> answers(const Given& given) const;

  /// The layer of the element with this plastic slip one and two columns ahead of it, on the grid.
  LayerElement element(int i, double friction, double one_ahead, double two_ahead) const;
  /// Says whether an element may yield where friction bears at most so much, MPa.
  bool may_yield(double friction) const { return friction > limit().least() || has_yielded_; }
  double share(int ahead) const { return -rule_.present[ahead] / rule_.present[0]; } ///< of it, in `before`
  const YieldLimit& limit() const { return *problem_.yield; }

private:
  const ContactProblem& problem_;
  SlipStep rule_;
  std::vector<double> stiffness_; ///< one value a row
  std::vector<double> former_;    ///< what former steps leave, mm; field
  bool has_yielded_ = false;      ///< in former steps
};

/// What tractions are compared with, MPa: the largest bound. `friction`: of friction alone, which counts
/// where a layer is softened to nothing.
double traction_scale(double bound, double friction);

/// The plastic slip of these answers; field.
std::vector<double> plastic_of(const std::vector<LayerAnswer>& answers);

} // namespace bem_contact::contact
