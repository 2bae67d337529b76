#include "bem_contact/profile/measured/profile_noise.hpp"

#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/settings.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// 1. Neighbours on either side in the fit that tells noise from shape: a cubic through nine points half a
/// millimetre apart leaves less than 0.1 um of an arc of 13 mm radius.
constexpr std::size_t noise_neighbours = 4;
/// 1. The same where points are far apart.
constexpr std::size_t near_noise_neighbours = 2;
/// mm. Over longer windows a cubic does not follow the arcs of 8 to 13 mm radius of all standards.
constexpr double shapeless_window = 3.0;
/// 1. The share of the points at which scatter is then looked for: of 39 rails and 12 wheels with a point
/// every 1.9 mm so many lie on one arc with their neighbours.
constexpr double quiet_share = 0.35;
/// 1. Standard deviation of a normal distribution over that quantile of its absolute values.
constexpr double normal_deviation_over_quiet = 2.2037;
/// 1. Scatter on arcs that is less than this share of the other shows that the other is shape. Of white noise
/// both agree within a third. Chosen.
constexpr double shape_share = 0.5;
/// mm. Waves are looked for in the means of so long stretches: with nine of them, those of 2 to 10 mm.
constexpr double wave_stretch = 1.0;
/// mm. Waves of less are not told from shape: S1002 without noise leaves 0.0001. Chosen.
constexpr double least_waves = 5e-4;
/// 1. Of both deviations, each times the root of its distance. White noise on six standards has 1.0 to 1.9,
/// as shape adds to it; waves of 1 um beside a scatter of 0.3 um have 7 and more.
constexpr double waves_over_noise = 2.0;
/// MPa. E* of two steel bodies, for the pressure that noise makes.
constexpr double steel_contact_modulus = 115000;
/// MPa. Noise that makes less is not worth a word: 1 % of a usual largest pressure.
constexpr double least_noise_pressure = 15;
/// mm over mm^(3/2) to the exponent below. Smoothing advised for noise e at the distance h is this times
/// (e sqrt(h)) to that exponent: the wavelength at which the scatter of the smoothed curvature, which grows
/// as e sqrt(h) L^(-5/2), is the same for every file. Measured with tools/benchmarks/profile_noise.
constexpr double smoothing_for_noise = 120;
/// 1. The exponent of this law.
constexpr double smoothing_for_noise_exponent = 0.4;

/// How far the middle point is from the cubic that fits all points, over what noise of deviation 1 makes of
/// it.
double deviation(std::span<const Point2> p) {
  const std::size_t at_middle = p.size() / 2;
  const Point2 chord = p.back() - p.front(), middle = p[at_middle];
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
  heights(static_cast<Eigen::Index>(at_middle), 1) = 1;
  const Eigen::MatrixXd fit = powers.colPivHouseholderQr().solve(heights);
  const double kept = 1 - fit(0, 1);
  return kept > 0 ? std::abs(fit(0, 0)) / std::sqrt(kept) : 0;
}

/// Deviations of the points from cubics through so many neighbours on either side.
std::vector<double> deviations_of(std::span<const Point2> points, std::size_t neighbours) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 2 * neighbours < points.size(); ++i)
    out.push_back(deviation(points.subspan(i, 2 * neighbours + 1)));
  return out;
}

/// The same from points with the least deviations: where cubics are long, most lie across a jump of the
/// curvature, but some lie on one arc.
double scatter_on_arcs(std::span<const Point2> points, std::size_t neighbours) {
  std::vector<double> deviations = deviations_of(points, neighbours);
  const auto at =
      deviations.begin() + static_cast<std::ptrdiff_t>(quiet_share * static_cast<double>(deviations.size()));
  std::ranges::nth_element(deviations, at);
  return normal_deviation_over_quiet * *at;
}

/// Means of so many neighbours each.
std::vector<Point2> means_of(std::span<const Point2> points, std::size_t count) {
  std::vector<Point2> out;
  for (std::size_t i = 0; i + count <= points.size(); i += count) {
    Point2 sum{};
    for (const Point2 p : points.subspan(i, count))
      sum = sum + p;
    out.push_back((1.0 / static_cast<double>(count)) * sum);
  }
  return out;
}

/// Standard deviation of the waves that are too long for the scatter, mm, and the distance of the means that
/// tell it, mm; both 0 without waves.
struct Waves {
  double deviation = 0, spacing = 0;
};
Waves waves_in(std::span<const Point2> points, const ProfileNoise& noise) {
  const double stretch = wave_stretch / std::max(noise.spacing, crowded);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(stretch)));
  const std::vector<Point2> means = means_of(points, count);
  if (count < 2 || means.size() <= 2 * noise_neighbours)
    return {};
  const Waves found{scatter_on_arcs(means, noise_neighbours), noise.spacing * static_cast<double>(count)};
  const bool besides = found.deviation * std::sqrt(found.spacing) >
                       waves_over_noise * noise.scatter * std::sqrt(noise.spacing);
  return besides && found.deviation > least_waves ? found : Waves{};
}

double slope_of(double deviation, double spacing) {
  return std::numbers::pi * deviation / (std::sqrt(3.0) * spacing);
}
double bending_of(double deviation, double spacing) {
  return std::numbers::pi * std::numbers::pi * deviation / (std::sqrt(5.0) * spacing * spacing);
}

} // namespace

ProfileNoise measure_noise(std::span<const Point2> points) {
  ProfileNoise noise;
  const std::size_t of_fit = 2 * noise_neighbours + 1;
  if (points.size() < of_fit)
    return noise;
  noise.spacing = median_spacing(points);
  noise.scatter = normal_deviation_over_median * median(deviations_of(points, noise_neighbours));
  if (static_cast<double>(of_fit - 1) * noise.spacing > shapeless_window)
    if (const double on_arcs = scatter_on_arcs(points, near_noise_neighbours);
        on_arcs < shape_share * noise.scatter)
      noise.scatter = on_arcs; // the rest is shape
  noise.slope = slope_of(noise.scatter, noise.spacing);
  noise.bending = bending_of(noise.scatter, noise.spacing);
  noise.as_white = noise.scatter;
  if (const Waves waves = waves_in(points, noise); waves.deviation > 0) {
    noise.waves = waves.deviation;
    noise.as_white = waves.deviation * std::sqrt(waves.spacing / noise.spacing);
    noise.slope = std::hypot(noise.slope, slope_of(waves.deviation, waves.spacing));
    noise.bending = std::hypot(noise.bending, bending_of(waves.deviation, waves.spacing));
  }
  noise.pressure = steel_contact_modulus / 2 * noise.slope;
  noise.coarse = noise.spacing > coarsest_spacing;
  if (noise.pressure > least_noise_pressure && !noise.coarse)
    noise.smoothing = smoothing_for_noise *
                      std::pow(noise.as_white * std::sqrt(noise.spacing), smoothing_for_noise_exponent);
  return noise;
}

} // namespace bem_contact
