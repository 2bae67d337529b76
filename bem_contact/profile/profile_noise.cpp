#include "bem_contact/profile/profile_noise.hpp"

#include "bem_contact/profile/settings.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bem_contact {

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How far the middle point is from the cubic that fits all points, over what noise of deviation 1 makes of
/// it.
double deviation(std::span<const Point2> p) {
  const Point2 chord = p.back() - p.front(), middle = p[noise_neighbours];
  const double half = norm(chord) / 2;
  if (half == 0)
    return 0;
  const Point2 along = (0.5 / half) * chord, across{-along.z, along.y};
  Eigen::Matrix<double, Eigen::Dynamic, 4> powers(p.size(), 4);
  Eigen::VectorXd height(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double u = dot(p[i] - middle, along) / half;
    powers.row(i) << 1, u, u * u, u * u * u;
    height[i] = dot(p[i] - middle, across);
  }
  // The middle lies at u = 0 and height 0: the fit there is the first coefficient, a weighted sum of the
  // heights.
  const Eigen::Matrix<double, 4, Eigen::Dynamic> inverse =
      powers.completeOrthogonalDecomposition().pseudoInverse();
  const double kept = 1 - inverse(0, noise_neighbours);
  return kept > 0 ? std::abs(inverse.row(0).dot(height)) / std::sqrt(kept) : 0;
}

} // namespace

ProfileNoise measure_noise(std::span<const Point2> points) {
  ProfileNoise noise;
  const auto of_fit = static_cast<std::size_t>(2 * noise_neighbours + 1);
  if (points.size() < of_fit)
    return noise;
  std::vector<double> lengths, deviations;
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(norm(points[i] - points[i - 1]));
  for (std::size_t i = 0; i + of_fit <= points.size(); ++i)
    deviations.push_back(deviation(points.subspan(i, of_fit)));
  noise.spacing = median(lengths);
  noise.scatter = normal_deviation_over_median * median(deviations);
  noise.slope = std::numbers::pi * noise.scatter / (std::sqrt(3.0) * noise.spacing);
  noise.bending =
      std::numbers::pi * std::numbers::pi * noise.scatter / (std::sqrt(5.0) * noise.spacing * noise.spacing);
  noise.pressure = steel_contact_modulus / 2 * noise.slope;
  if (noise.pressure > least_noise_pressure)
    noise.smoothing = smoothing_for_noise *
                      std::pow(noise.scatter * std::sqrt(noise.spacing), smoothing_for_noise_exponent);
  return noise;
}

} // namespace bem_contact
