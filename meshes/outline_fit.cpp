#include "meshes/outline_fit.hpp"

#include "bem_contact/profile/median.hpp"
#include "meshes/settings.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace bem_contact::meshes {
namespace {

/// A sample in the body's frame: how far off the outline, and how that changes with (at.y, at.z, arm angle).
struct Residual {
  double distance = 0;
  Eigen::Vector3d change;
};

std::optional<Residual> residual(const ProfileSample& sample, std::span<const Chord> outline,
                                 const GraftPlace& place) {
  const Point2 e_y = tangent_of(place.angle), e_z = normal_of(place.angle);
  const Point2 p = sample.position - place.at, q{dot(p, e_y), dot(p, e_z)};
  double least = std::numeric_limits<double>::infinity();
  const Chord* best = nullptr;
  for (const Chord& chord : outline) {
    const Point2 r = q - chord.from;
    const double t = std::clamp(dot(r, chord.along), 0.0, chord.length);
    const Point2 off = r - t * chord.along;
    if (const double square = dot(off, off); square < least) {
      least = square;
      best = &chord;
    }
  }
  const Point2 tangent{dot(sample.tangent, e_y), dot(sample.tangent, e_z)};
  if (dot(tangent, best->along) < std::cos(largest_tangent_turn))
    return std::nullopt;
  const Point2 normal{-best->along.z, best->along.y};
  return Residual{dot(q - best->from, normal),
                  {-dot(normal, {e_y.y, e_z.y}), -dot(normal, {e_y.z, e_z.z}),
                   (normal.y * q.z - normal.z * q.y) / graft_arm}};
}

/// Distances of what lies on the body there, mm, and the mean stiffness of that part.
struct Unworn {
  std::vector<double> distances;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
};

Unworn unworn_at(const GraftPlace& place, std::span<const ProfileSample> samples,
                 std::span<const Chord> outline) {
  Unworn unworn;
  for (const ProfileSample& sample : samples)
    if (const auto r = residual(sample, outline, place); r && std::abs(r->distance) < unworn_distance) {
      unworn.stiffness += r->change * r->change.transpose();
      unworn.distances.push_back(std::abs(r->distance));
    }
  unworn.stiffness /= std::max(1.0, static_cast<double>(unworn.distances.size()));
  return unworn;
}

} // namespace

std::vector<Chord> chords(const Loop& loop, double step) {
  std::vector<Chord> outline;
  for (const Piece& piece : loop) {
    double length = 0;
    const auto at = [&](int i, int count) {
      return piece.at(piece.from + (piece.to - piece.from) * i / count);
    };
    for (int i = 0; i < chord_samples; ++i)
      length += norm(at(i + 1, chord_samples) - at(i, chord_samples));
    const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int i = 0; i < count; ++i) {
      const Point2 a = at(i, count), b = at(i + 1, count);
      if (const double chord = norm(b - a); chord > coinciding)
        outline.push_back({a, (1 / chord) * (b - a), chord});
    }
  }
  return outline;
}

std::vector<ProfileSample> samples_of(const ProfileCurve& curve, int count) {
  std::vector<ProfileSample> samples;
  for (int i = 0; i < count; ++i) {
    const CurvePoint p = curve.at(curve.s_begin() + (curve.s_end() - curve.s_begin()) * (i + 0.5) / count);
    samples.push_back({p.position, tangent_of(p.delta)});
  }
  return samples;
}

bool refine(GraftPlace& place, std::span<const ProfileSample> samples, std::span<const Chord> outline,
            double width, int steps) {
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0;
    for (const ProfileSample& sample : samples)
      if (const auto r = residual(sample, outline, place); r && std::abs(r->distance) < width) {
        const double root = 1 - std::pow(r->distance / width, 2), weight = root * root;
        matrix += weight * r->change * r->change.transpose();
        right -= weight * r->distance * r->change;
        total += weight;
      }
    if (total < least_weight * static_cast<double>(samples.size()))
      return false;
    matrix.diagonal().array() += fit_damping * total;
    const Eigen::Vector3d move = matrix.ldlt().solve(right);
    place.at = place.at + Point2{move[0], move[1]};
    place.angle += move[2] / graft_arm;
    if (std::abs(place.angle) > largest_graft_angle)
      return false;
    if (move.norm() < fit_tolerance)
      break;
  }
  return true;
}

bool settle(GraftPlace& place, std::span<const ProfileSample> samples, std::span<const Chord> outline) {
  if (!refine(place, samples, outline, settling_width, search_steps) ||
      !refine(place, samples, outline, 2 * unworn_distance, settling_steps))
    return false;
  for (int round = 0; round < settling_rounds; ++round) {
    const auto distances = unworn_at(place, samples, outline).distances;
    if (distances.empty())
      return false;
    if (!refine(place, samples, outline,
                std::clamp(settling_medians * median(distances), settling_least, 2 * unworn_distance),
                settling_steps))
      return false;
  }
  place.share = static_cast<double>(unworn_at(place, samples, outline).distances.size()) /
                static_cast<double>(samples.size());
  return true;
}

double stiffness_at(const GraftPlace& place, std::span<const ProfileSample> samples,
                    std::span<const Chord> outline) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(unworn_at(place, samples, outline).stiffness);
  return solver.eigenvalues()[0];
}

} // namespace bem_contact::meshes
