#include "bem_contact/influence/harmonic_points.hpp"

#include "bem_contact/influence/settings.hpp"

#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Sum over `count` equally spaced points from -1 to 1 of each even Chebyshev polynomial T_0, T_2, ...; the
/// odd ones have none.
ArrayXd even_moments(Index count, Index polynomials) {
  const Index half = count / 2; // the other half is the same, for T_2j(t) = T_j(2 t^2 - 1)
  const ArrayXd t = ArrayXd::LinSpaced(count, -1, 1).head(half);
  const ArrayXd argument = 2 * t.square() - 1;
  const double middle = count % 2; // where the argument is -1
  ArrayXd moments(polynomials), before = ArrayXd::Ones(half), now = argument;
  for (Index j = 0; j < polynomials; ++j) {
    moments[j] = 2 * before.sum() + (j % 2 == 0 ? middle : -middle);
    before = 2 * argument * now - before;
    before.swap(now);
  }
  return moments;
}

std::vector<double> as_vector(const ArrayXd& a) {
  return {a.begin(), a.end()};
}

} // namespace

HarmonicPoints harmonic_points(long first, long last, double largest_angle) {
  const Index count = last - first + 1;
  const double waves = 0.5 * static_cast<double>(count - 1) * largest_angle;
  const auto points = static_cast<Index>(std::ceil(waves + point_reserve * std::cbrt(waves)) + least_points);
  if (points >= count)
    return {as_vector(ArrayXd::LinSpaced(count, static_cast<double>(first), static_cast<double>(last))),
            as_vector(ArrayXd::Ones(count))};
  const ArrayXd angle = (ArrayXd::LinSpaced(points, 0, static_cast<double>(points - 1)) + 0.5) *
                        (std::numbers::pi / static_cast<double>(points));
  const ArrayXd moments = even_moments(count, (points + 1) / 2);
  const ArrayXd node = angle.cos(), argument = 2 * node.square() - 1;
  ArrayXd weight = ArrayXd::Constant(points, moments[0]), before = ArrayXd::Ones(points), now = argument;
  for (Index j = 1; j < moments.size(); ++j) { // now: T_2j of the nodes
    weight += 2 * moments[j] * now;
    before = 2 * argument * now - before;
    before.swap(now);
  }
  const double half = 0.5 * static_cast<double>(last - first), middle = static_cast<double>(first) + half;
  return {as_vector(middle + half * node), as_vector(weight / static_cast<double>(points))};
}

} // namespace bem_contact
