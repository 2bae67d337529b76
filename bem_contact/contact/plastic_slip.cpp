#include "bem_contact/contact/plastic_slip.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

PlasticSlip::PlasticSlip(const ContactProblem& problem)
    : problem_(problem), rule_(slip_step(problem)), stiffness_(element_stiffness(problem)),
      former_(problem.grid.size(), 0.0) {
  const int mx = problem.grid.mx;
  for (std::size_t k = 1; k <= std::min<std::size_t>(problem.previous.size(), 2); ++k) {
    const std::vector<double>& before = problem.previous[k - 1].plastic;
    const int columns = static_cast<int>(k) * rule_.columns;
    for (int i = 0; i < problem.grid.size() && !before.empty(); ++i)
      if (i % mx + columns < mx)
        former_[i] -= rule_.former[k] / rule_.present[0] * before[i + columns];
  }
  has_yielded_ = std::ranges::any_of(former_, [](double w) { return w != 0; });
}

LayerElement PlasticSlip::element(int i, double friction, double one_ahead, double two_ahead) const {
  return {.before = std::max(0.0, former_[i] + share(1) * one_ahead + share(2) * two_ahead),
          .friction = friction,
          .stiffness = stiffness_[i / problem_.grid.mx],
          .weight = rule_.present[0]};
}

std::vector<LayerAnswer> PlasticSlip::answers(const Given& given) const {
  const int mx = problem_.grid.mx;
  std::vector<LayerAnswer> out(problem_.grid.size());
  YieldLimit of_element{limit().shear, limit().hardening};
  for (int row = 0; row < problem_.grid.ms; ++row)
    for (int ix = mx - 1; ix >= 0; --ix) { // from the leading edge
      const int i = row * mx + ix;
      const auto ahead = [&](int k) { return ix + k < mx ? out[i + k].plastic : 0.0; };
      const LayerElement here = element(i, given.friction[i], ahead(1), ahead(2));
      const double reach = std::hypot(given.px[i] + here.stiffness * given.slip_x[i],
                                      given.ps[i] + here.stiffness * given.slip_s[i]);
      if (!given.limits.empty())
        of_element.shear = given.limits[i];
      out[i] = answer(of_element, here, reach);
    }
  return out;
}

double traction_scale(double bound, double friction) {
  constexpr double least_share = 1e-6; // 1. Chosen: as much as a certificate may leave of friction
  return std::max(bound, least_share * friction);
}

std::vector<double> plastic_of(const std::vector<LayerAnswer>& answers) {
  std::vector<double> out;
  out.reserve(answers.size());
  for (const LayerAnswer& at : answers)
    out.push_back(at.plastic);
  return out;
}

} // namespace bem_contact::contact
