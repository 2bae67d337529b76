#include "bem_contact/profile/measured/profile_noise.hpp"
#include "bem_contact/profile/measured/profile_smoothing.hpp"
#include "sampled.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using Points = std::vector<Point2>;

/// A wave of height 1 um on a straight line of 200 mm.
Points wave(double length, double spacing) {
  Points points;
  for (double y = 0; y <= 200; y += spacing)
    points.push_back({y, 1e-3 * std::sin(2 * std::numbers::pi * y / length)});
  return points;
}

/// Amplitude of that wave over as many whole waves as there are in the middle half of the points.
double height(const Points& points, double length) {
  double s = 0, c = 0, n = 0;
  for (const Point2 p : points)
    if (p.y > 50 && p.y <= 50 + length * std::floor(100 / length)) {
      s += p.z * std::sin(2 * std::numbers::pi * p.y / length);
      c += p.z * std::cos(2 * std::numbers::pi * p.y / length);
      n += 1;
    }
  return 2e3 * std::hypot(s, c) / n;
}

TEST(Noise, IsMeasuredOnEveryStandard) {
  for (const char* name : {"S1002", "60E1", "46E3"})
    for (const double scatter : {0.0005, 0.002, 0.01})
      for (const double step : {0.1, 0.25, 0.5}) {
        const Points smooth = sampled_curve(standard_profile(name), step);
        const ProfileNoise noise = measure_noise(noisy(smooth, scatter, 3));
        // The median of some 150 deviations scatters by 10 % itself.
        EXPECT_NEAR(noise.scatter, scatter, 0.25 * scatter) << name << ' ' << scatter << ' ' << step;
        EXPECT_NEAR(noise.spacing, step, 0.02 * step + 2 * scatter);
      }
}

TEST(Noise, OfASmoothProfileIsNone) {
  for (const char* name : {"S1002", "60E1", "60E2", "54E1", "46E3"})
    for (const double step : {0.1, 0.25, 0.5})
      EXPECT_EQ(measure_noise(sampled_curve(standard_profile(name), step)).smoothing, 0)
          << name << ' ' << step;
}

/// Rounding to d scatters by d / sqrt(12).
TEST(Noise, RoundedCoordinatesScatter) {
  Points points = sampled_curve(standard_profile("60E1"), 0.25);
  for (Point2& p : points)
    p = {std::round(p.y * 100) / 100, std::round(p.z * 100) / 100};
  EXPECT_NEAR(measure_noise(points).scatter, 0.01 / std::sqrt(12.0), 1.5e-3);
}

/// The slope and the curvature of a spline through white noise have the scatter that the header states.
TEST(Noise, BendsTheCurveAsStated) {
  Points line;
  for (double y = 0; y <= 400; y += 0.25)
    line.push_back({y, 0});
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0, 0.002);
  for (Point2& p : line)
    p.z = normal(generator);
  const ProfileNoise noise = measure_noise(line);
  const ProfileCurve curve = ProfileCurve::through_points("line", line);
  double slope = 0, bend = 0;
  int count = 0;
  for (double s = 20; s < 380; s += 0.0313, ++count) {
    const CurvePoint p = curve.at(curve.s_begin() + s);
    slope += p.delta * p.delta;
    bend += p.curvature * p.curvature;
  }
  // A cubic spline keeps a little more or less than the sharp cut of the formula.
  EXPECT_NEAR(std::sqrt(slope / count), noise.slope, 0.25 * noise.slope);
  EXPECT_NEAR(std::sqrt(bend / count), noise.bending, 0.25 * noise.bending);
}

TEST(Smoothing, HasTheStatedResponse) {
  for (const double spacing : {0.1, 0.5})
    for (const double ratio : {0.5, 0.8, 1.0, 1.5, 2.0, 4.0}) {
      const double wavelength = 8, length = ratio * wavelength;
      const double kept = height(smoothed(wave(length, spacing), wavelength).points, length);
      EXPECT_NEAR(kept, 1 / (1 + std::pow(ratio, -6)), 0.02) << spacing << ' ' << ratio;
    }
}

TEST(Smoothing, DoesNotDependOnUnevenSpacing) {
  Points uneven = wave(8, 0.05);
  std::mt19937 generator(2);
  std::erase_if(uneven, [&](Point2) { return generator() % 3 != 0; });
  EXPECT_NEAR(height(smoothed(uneven, 8).points, 8), 0.5, 0.03);
}

/// Parabolas pass unchanged, ends included; so nearly do the arcs of rails.
TEST(Smoothing, KeepsParabolasAndArcsToTheirEnds) {
  Points parabola;
  for (double y = -20; y <= 20; y += 0.25)
    parabola.push_back({y, y * y / 600});
  // The length along its chords is not y, so that it is no exact parabola of that length.
  EXPECT_LT(smoothed(parabola, 10).largest, 1e-4);
  Points arc; // of radius 13 mm, over 80 degrees
  for (double angle = -0.7; angle <= 0.7; angle += 0.02)
    arc.push_back({13 * std::sin(angle), -13 * std::cos(angle)});
  for (const Point2 p : smoothed(arc, 8).points)
    EXPECT_NEAR(norm(p), 13, 4e-3); // (8 / 2 pi 13)^6 of it is 1e-5; the rest is at the ends
}

/// Where two arcs of a rail meet, the curvature jumps from 1/80 to 1/13. A square penalty of the third
/// derivative would spread the jump over the wavelength, 8 mm.
TEST(Smoothing, LetsTheCurvatureJump) {
  const auto piece = [](double radius, double t) {
    return Point2{radius * std::sin(t / radius), radius * (1 - std::cos(t / radius))};
  };
  Points arcs;
  for (double t = -20; t < 15; t += 0.25)
    arcs.push_back(piece(t < 0 ? 80 : 13, t));
  const SmoothedProfile smooth = smoothed(noisy(arcs, 0.002, 8), 8);
  EXPECT_THAT(smooth.kinks, IsEmpty());
  const ProfileCurve curve = ProfileCurve::through_points("arcs", smooth.points, smooth.kinks);
  const auto mean_curvature = [&](double from, double to) { // over 2 mm
    const CurvePoint a = curve.nearest(piece(from < 0 ? 80 : 13, from));
    const CurvePoint b = curve.nearest(piece(to <= 0 ? 80 : 13, to));
    return std::abs((b.delta - a.delta) / (b.s - a.s));
  };
  EXPECT_NEAR(mean_curvature(-2.5, -0.5), 1.0 / 80, 0.08 / 13);
  EXPECT_NEAR(mean_curvature(0.5, 2.5), 1.0 / 13, 0.08 / 13);
  for (const Point2 p : smooth.points)
    EXPECT_LT(std::abs(norm(p - Point2{0, p.y < 0 ? 80.0 : 13.0}) - (p.y < 0 ? 80 : 13)),
              0.009); // 15 um with a square;
}

TEST(Smoothing, KeepsATrueKinkWhereItIs) {
  Points roof;
  for (double y = -20; y <= 20; y += 0.25)
    roof.push_back({y, 0.3 * std::abs(y)});
  const SmoothedProfile smooth = smoothed(noisy(roof, 0.002, 1), 6);
  ASSERT_EQ(smooth.kinks.size(), 1u);
  EXPECT_LT(norm(smooth.points[smooth.kinks[0]]), 0.3);
  const ProfileCurve curve = ProfileCurve::through_points("roof", smooth.points, smooth.kinks);
  EXPECT_NEAR(curve.nearest({-1, 0.3}).delta, -std::atan(0.3), 0.01);
  EXPECT_NEAR(curve.nearest({1, 0.3}).delta, std::atan(0.3), 0.01);
}

TEST(Smoothing, FindsNoKinkInTheArcsOfRailsAndWheels) {
  for (const char* name : {"60E1", "S1002"})
    EXPECT_THAT(smoothed(noisy(sampled_curve(standard_profile(name), 0.25), 0.01, 1), 13).kinks, IsEmpty())
        << name;
}

TEST(Smoothing, WhatItRemovesIsTheNoise) {
  const Points smooth = sampled_curve(standard_profile("S1002"), 0.25);
  const SmoothedProfile done = smoothed(noisy(smooth, 0.002, 4), 7);
  // Scatter across the profile goes; scatter along it moves the points along the curve, and half of it stays.
  EXPECT_GT(done.rms, 0.002);
  EXPECT_LT(done.rms, 0.002 * std::sqrt(2.0));
  EXPECT_GT(done.largest, 2 * done.rms);
  // On the tread; at the flange the curvature jumps, and smoothing rounds the jumps.
  const ProfileCurve exact = standard_profile("S1002");
  const auto squares = [&](const Points& points) {
    double sum = 0;
    for (const Point2 p : points)
      sum += std::abs(p.y) < 20 ? std::pow(norm(p - exact.nearest(p).position), 2) : 0;
    return sum;
  };
  const double before = squares(noisy(smooth, 0.002, 4));
  const double after = squares(done.points);
  EXPECT_LT(after, 0.3 * before);
}

std::string said(const Points& points, const ProfileReading& reading = {}) {
  const SaidWarnings warnings;
  parse_profile(as_columns(points), "p.txt", ProfileKind::wheel, reading);
  return warnings.text();
}

TEST(NoisyFile, APointThatZigZagsIsDroppedWithAWarningThatSaysWhere) {
  Points points = sampled_curve(standard_profile("S1002"), 0.25);
  Point2& moved = points[points.size() / 2];
  moved.z += 1;
  EXPECT_THAT(said(points),
              HasSubstr(fmt::format("warning: p.txt: 1 point dropped where the profile zig-zags, at "
                                    "y = {:.4g}, z = {:.4g} mm of the file",
                                    moved.y, moved.z)));
}

TEST(NoisyFile, IsWarnedOfWithFiguresAndTheSmoothingToUse) {
  const Points points = noisy(sampled_curve(standard_profile("S1002"), 0.25), 0.002, 6);
  EXPECT_THAT(said(points), AllOf(HasSubstr("scatter by 2"), HasSubstr("um, 0.25 mm apart"), HasSubstr("MPa"),
                                  HasSubstr("(smoothing = 7.")));
  EXPECT_THAT(said(points, {.smoothing = 7}), Not(HasSubstr("warning")));
  EXPECT_THAT(said(points, {.smoothing = 7}), HasSubstr("root mean square"));
  EXPECT_THAT(said(points, {.smoothing = 3}), HasSubstr("smoothing = 3 leaves noise"));
  EXPECT_THAT(said(points, {.smoothing = 40}), HasSubstr("smoothing = 40 takes shape away"));
}

/// Waves of 2 to 10 mm along the normal, as strong at each length, beside a scatter of 0.3 um.
Points wavy(const ProfileCurve& curve, double deviation, double longest, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> per_mm(1 / longest, 0.5), phase(0, 2 * std::numbers::pi);
  constexpr int count = 60;
  std::vector<std::pair<double, double>> waves;
  for (int i = 0; i < count; ++i)
    waves.emplace_back(2 * std::numbers::pi * per_mm(generator), phase(generator));
  Points out;
  const double length = curve.s_end() - curve.s_begin();
  const int steps = static_cast<int>(length / 0.25);
  for (int i = 0; i <= steps; ++i) {
    const CurvePoint p = curve.at(curve.s_begin() + length * i / steps);
    double off = 0;
    for (const auto& [k, from] : waves)
      off += deviation * std::sqrt(2.0 / count) * std::sin(k * p.s + from);
    out.push_back(p.position + off * normal_of(p.delta));
  }
  return noisy(out, 0.0003, seed);
}

/// What is advised removes noise alone; what is shorter leaves noise, what is longer takes shape away.
TEST(NoisyFile, TheAdviceForWavesIsOne) {
  for (const char* name : {"S1002", "1/40"})
    for (const double deviation : {0.001, 0.006})
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const Points points = wavy(standard_profile(name), deviation, 10, seed);
        const auto of = [&](double smoothing) {
          const SaidWarnings quiet;
          return parse_measured_profile(as_columns(points), "w.whl", ProfileKind::wheel,
                                        {.smoothing = smoothing});
        };
        const MeasuredProfile raw = of(0);
        ASSERT_GT(raw.advice.smoothing, 0) << name << ' ' << deviation;
        EXPECT_THAT(raw.noise.waves,
                    testing::AllOf(testing::Gt(0.4 * deviation), testing::Lt(2.5 * deviation)));
        const std::string at_advice = said(points, {.smoothing = raw.advice.smoothing});
        EXPECT_THAT(at_advice, Not(HasSubstr("warning"))) << name << ' ' << deviation << ' ' << seed;
        const MeasuredProfile smooth = of(raw.advice.smoothing);
        EXPECT_LT(smooth.removed_rms, smooth.largest_noise_removed());
        EXPECT_THAT(said(points, {.smoothing = 0.5 * raw.advice.smoothing}), HasSubstr("leaves noise"));
      }
}

/// Whatever the noise is, no wavelength is said to be both too short and too long, and the advised one is
/// neither.
TEST(NoisyFile, NothingIsBothTooShortAndTooLong) {
  for (const double longest : {5.0, 10.0, 14.0})
    for (const double deviation : {0.0003, 0.002})
      for (const double smoothing : {3.0, 6.0, 9.0, 13.0}) {
        const Points points = wavy(standard_profile("S1002"), deviation, longest, 3);
        const std::string text = said(points, {.smoothing = smoothing});
        EXPECT_FALSE(text.find("leaves noise") != text.npos && text.find("takes shape away") != text.npos)
            << text;
      }
}

TEST(Noise, WavesOfASmoothProfileAreNone) {
  for (const char* name : {"S1002", "1/40", "60E1", "60E2", "54E1", "46E3"})
    for (const double step : {0.1, 0.25, 0.5})
      EXPECT_EQ(measure_noise(sampled_curve(standard_profile(name), step)).waves, 0) << name << ' ' << step;
}

/// Arcs and lines, a point every 1 to 1.9 mm, exact: cubics through nine of them do not follow.
TEST(Noise, CoarsePointsOfExactArcsHaveNone) {
  for (const char* name : {"60E1", "60E2", "54E1", "46E3", "S1002"})
    for (const double step : {1.0, 1.25, 1.5, 1.9}) {
      const Points points = sampled_curve(standard_profile(name), step);
      const ProfileNoise exact = measure_noise(points);
      EXPECT_LT(exact.pressure, 15) << name << ' ' << step;
      EXPECT_EQ(exact.smoothing, 0) << name << ' ' << step;
      double mean = 0; // a single draw of so few points tells scatter only roughly
      for (unsigned seed = 1; seed <= 20; ++seed)
        mean += measure_noise(noisy(points, 0.02, seed)).scatter / 20;
      EXPECT_GT(mean, 0.015) << name << ' ' << step;
    }
}

} // namespace
TEST(Messages, GoToStandardErrorBecauseStandardOutputIsTheHosts) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  read_profile(CONFORMAL_SOURCE_DIR "/data/bodies/worn_rail.txt", ProfileKind::rail);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), ::testing::HasSubstr("its points scatter by 2 um"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

} // namespace bem_contact
