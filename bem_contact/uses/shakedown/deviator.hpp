#pragma once

#include "bem_contact/halfspace/stress.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::shakedown {

/// The deviator of a stress as a vector of five components over the square root of 2, so that its length is
/// von Mises' stress over the square root of 3: what must not exceed k, the yield stress in shear. MPa. The
/// first two components hold the normal stresses, then xs, xn and sn.
using Deviator = Eigen::Matrix<double, 5, 1>;

/// Stresses at one point of a section while the load passes, and zero before and after.
using DeviatorPath = std::vector<Deviator>;

/// What a stress xx, ss or nn of 1 is as a Deviator.
inline Deviator unit_xx() {
  return Deviator(0.5, -0.28867513459481287, 0, 0, 0);
}
inline Deviator unit_ss() {
  return Deviator(0, 0.57735026918962573, 0, 0, 0);
}
inline Deviator unit_nn() {
  return -unit_xx() - unit_ss();
}

inline Deviator deviator(const halfspace::Stress& t) {
  Deviator out = t.xx * unit_xx() + t.ss * unit_ss() + t.nn * unit_nn();
  out[2] = t.xs;
  out[3] = t.xn;
  out[4] = t.sn;
  return out;
}

/// The deviator as a stress, whose normal components sum up to zero.
inline halfspace::Stress stress_of(const Deviator& d) {
  const double ss = d[1] / 0.86602540378443860, xx = d[0] - 0.5 * ss;
  return {xx, ss, -xx - ss, d[2], d[3], d[4]};
}

} // namespace bem_contact::shakedown
