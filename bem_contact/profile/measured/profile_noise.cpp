#include "bem_contact/profile/measured/profile_noise.hpp"

#include "bem_contact/profile/measured/settings.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/settings.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// How far the middle point is from the cubic that fits all points, over what noise of deviation 1 makes of
/// it.
double deviation(std::span<const Point2> p) {
  const Point2 chord = p.back() - p.front(), middle = p[noise_neighbours];
  const double half = norm(chord) / 2;
  if (half == 0)
    return 0;
  const Point2 along = (0.5 / half) * chord, across{-along.z, along.y};
  // The middle lies at u = 0 and height 0. Two cubics are fitted: to the heights, and to a point at 1 in the
  // middle.
  const auto n = static_cast<Eigen::Index>(p.size());
  Eigen::MatrixXd powers(n, 4), heights = Eigen::MatrixXd::Zero(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point2 at = p[static_cast<std::size_t>(i)] - middle;
    const double u = dot(at, along) / half;
    powers.row(i) << 1, u, u * u, u * u * u;
    heights(i, 0) = dot(at, across);
  }
  heights(noise_neighbours, 1) = 1;
  const Eigen::MatrixXd fit = powers.colPivHouseholderQr().solve(heights);
  const double kept = 1 - fit(0, 1);
  return kept > 0 ? std::abs(fit(0, 0)) / std::sqrt(kept) : 0;
}

} // namespace

ProfileNoise measure_noise(std::span<const Point2> points) {
  ProfileNoise noise;
  const auto of_fit = static_cast<std::size_t>(2 * noise_neighbours + 1);
  if (points.size() < of_fit)
    return noise;
  std::vector<double> deviations;
  for (std::size_t i = 0; i + of_fit <= points.size(); ++i)
    deviations.push_back(deviation(points.subspan(i, of_fit)));
  noise.spacing = median_spacing(points);
  noise.scatter = normal_deviation_over_median * median(std::move(deviations));
  noise.slope = std::numbers::pi * noise.scatter / (std::sqrt(3.0) * noise.spacing);
  noise.bending =
      std::numbers::pi * std::numbers::pi * noise.scatter / (std::sqrt(5.0) * noise.spacing * noise.spacing);
  noise.pressure = steel_contact_modulus / 2 * noise.slope;
  noise.coarse = noise.spacing > coarsest_spacing;
  if (noise.pressure > least_noise_pressure && !noise.coarse)
    noise.smoothing = smoothing_for_noise *
                      std::pow(noise.scatter * std::sqrt(noise.spacing), smoothing_for_noise_exponent);
  return noise;
}

} // namespace bem_contact
