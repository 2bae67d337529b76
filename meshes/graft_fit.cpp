#include "meshes/graft_fit.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace bem_contact::meshes {
namespace {

constexpr double on_it = 0.1;        // mm: unworn
constexpr double least_share = 0.33; // of the profile
constexpr double rival = 0.9;        // of the best share: then nobody can choose
constexpr double apart_mm = 0.5, apart_rad = 5e-3;
constexpr double largest_angle = 0.1;     // rad
constexpr double arm = 30;                // mm, what turns are measured with
constexpr double least_stiffness = 0.004; // of 1: how much a unit move is felt at right angles to the surface
constexpr double largest_turn = 0.5;      // rad between the tangents of places that may belong together

struct Edge {
  Point2 from, along; ///< unit vector
  double length = 0;
};

/// The loop as chords about `step` long, mm.
std::vector<Edge> chords(const Loop& loop, double step) {
  std::vector<Edge> edges;
  for (const Piece& piece : loop) {
    constexpr int coarse = 64;
    double length = 0;
    const auto at = [&](int i, int count) {
      return piece.at(piece.from + (piece.to - piece.from) * i / count);
    };
    for (int i = 0; i < coarse; ++i)
      length += norm(at(i + 1, coarse) - at(i, coarse));
    const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int i = 0; i < count; ++i) {
      const Point2 a = at(i, count), b = at(i + 1, count);
      if (const double chord = norm(b - a); chord > 1e-9)
        edges.push_back({a, (1 / chord) * (b - a), chord});
    }
  }
  return edges;
}

struct Sample {
  Point2 position, tangent;
};

std::vector<Sample> samples_of(const ProfileCurve& curve, int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const CurvePoint p = curve.at(curve.s_begin() + (curve.s_end() - curve.s_begin()) * (i + 0.5) / count);
    samples.push_back({p.position, tangent_of(p.delta)});
  }
  return samples;
}

/// A sample in the body's frame: how far off the outline, and how that changes with (at.y, at.z, arm angle).
struct Residual {
  double distance = 0;
  Eigen::Vector3d change;
};

std::optional<Residual> residual(const Sample& sample, const std::vector<Edge>& edges,
                                 const GraftPlace& place) {
  const Point2 e_y = tangent_of(place.angle), e_z = normal_of(place.angle);
  const Point2 p = sample.position - place.at, q{dot(p, e_y), dot(p, e_z)};
  double least = std::numeric_limits<double>::infinity();
  const Edge* best = nullptr;
  for (const Edge& edge : edges) {
    const Point2 r = q - edge.from;
    const double t = std::clamp(dot(r, edge.along), 0.0, edge.length);
    const Point2 off = r - t * edge.along;
    if (const double square = dot(off, off); square < least) {
      least = square;
      best = &edge;
    }
  }
  const Point2 tangent{dot(sample.tangent, e_y), dot(sample.tangent, e_z)};
  if (dot(tangent, best->along) < std::cos(largest_turn))
    return std::nullopt;
  const Point2 normal{-best->along.z, best->along.y};
  return Residual{
      dot(q - best->from, normal),
      {-dot(normal, {e_y.y, e_z.y}), -dot(normal, {e_y.z, e_z.z}), (normal.y * q.z - normal.z * q.y) / arm}};
}

/// Gauss-Newton steps with Tukey's weights: what is farther off than `width` counts for nothing.
bool refine(GraftPlace& place, const std::vector<Sample>& samples, const std::vector<Edge>& edges,
            double width, int steps) {
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0;
    for (const Sample& sample : samples)
      if (const auto r = residual(sample, edges, place); r && std::abs(r->distance) < width) {
        const double root = 1 - std::pow(r->distance / width, 2), weight = root * root;
        matrix += weight * r->change * r->change.transpose();
        right -= weight * r->distance * r->change;
        total += weight;
      }
    if (total < 0.05 * static_cast<double>(samples.size()))
      return false;
    matrix.diagonal().array() += 1e-6 * total;
    const Eigen::Vector3d move = matrix.ldlt().solve(right);
    place.at = place.at + Point2{move[0], move[1]};
    place.angle += move[2] / arm;
    if (std::abs(place.angle) > largest_angle)
      return false;
    if (move.norm() < 1e-7)
      break;
  }
  return true;
}

/// Distances of what lies on the body, and how that part holds it: least eigenvalue of its mean stiffness.
struct Fit {
  std::vector<double> distances;
  double stiffness = 0;
};

Fit fit_of(const GraftPlace& place, const std::vector<Sample>& samples, const std::vector<Edge>& edges) {
  Fit fit;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (const Sample& sample : samples)
    if (const auto r = residual(sample, edges, place); r && std::abs(r->distance) < on_it) {
      matrix += r->change * r->change.transpose();
      fit.distances.push_back(std::abs(r->distance));
    }
  if (!fit.distances.empty())
    fit.stiffness =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix / static_cast<double>(fit.distances.size()))
            .eigenvalues()[0];
  return fit;
}

/// First by all that may be unworn, then by what lies as near as most of that does: wear begins slowly.
bool settle(GraftPlace& place, const std::vector<Sample>& samples, const std::vector<Edge>& edges) {
  if (!refine(place, samples, edges, 0.3, 6) || !refine(place, samples, edges, 2 * on_it, 20))
    return false;
  for (int round = 0; round < 3; ++round) {
    auto distances = fit_of(place, samples, edges).distances;
    if (distances.empty())
      return false;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    if (!refine(place, samples, edges, std::clamp(5 * *middle, 0.01, 2 * on_it), 20))
      return false;
  }
  place.share = static_cast<double>(fit_of(place, samples, edges).distances.size()) /
                static_cast<double>(samples.size());
  return true;
}

bool same(const GraftPlace& a, const GraftPlace& b) {
  return norm(a.at - b.at) < apart_mm && std::abs(a.angle - b.angle) < apart_rad;
}

/// Where the search begins: the file's own frame, and the profile's top laid on that of the body, with moves
/// to both sides; a wheel's top is its flange, that is its lowest place.
std::vector<GraftPlace> starts_of(const std::vector<Sample>& samples, const std::vector<Edge>& edges) {
  const auto middle_and_top = [](const auto& points, auto position, bool lowest) {
    double left = 1e300, right = -1e300, top = lowest ? -1e300 : 1e300;
    for (const auto& point : points) {
      const Point2 p = position(point);
      top = lowest ? std::max(top, p.z) : std::min(top, p.z);
    }
    for (const auto& point : points)
      if (const Point2 p = position(point); std::abs(p.z - top) < 15) {
        left = std::min(left, p.y);
        right = std::max(right, p.y);
      }
    return Point2{(left + right) / 2, top};
  };
  const bool wheel = samples[samples.size() / 2].tangent.y < 0;
  const Point2 mine = middle_and_top(
      samples, [](const Sample& s) { return s.position; }, wheel);
  const Point2 its = middle_and_top(
      edges, [](const Edge& e) { return e.from; }, wheel);
  std::vector<GraftPlace> starts;
  for (const double angle : {0.0, -0.025, 0.025, -0.05, 0.05}) {
    starts.push_back({{0, 0}, angle});
    for (const double side : {0.0, -5.0, 5.0, -12.0, 12.0, -25.0, 25.0})
      starts.push_back({mine + Point2{side, 0} - its, angle});
  }
  return starts;
}

std::string words(const GraftPlace& place) {
  return fmt::format("graft_at = [{:.3f}, {:.3f}], graft_angle = {:.5f}", place.at.y, place.at.z,
                     place.angle);
}

} // namespace

GraftPlace find_graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name) {
  const std::string problem =
      fmt::format("no place for the body of {} can be found on the profile {}", base_name, measured.name());
  constexpr const char* advice =
      "Give [body] graft_at and graft_angle, or take another body with graft_onto.";
  const auto few = samples_of(measured, 60), many = samples_of(measured, 300);
  const auto coarse = chords(base, 0.5);
  std::vector<GraftPlace> places;
  for (GraftPlace place : starts_of(few, coarse)) {
    bool good = true;
    for (const double width : {20.0, 8.0, 3.0, 1.0, 0.4})
      good = good && refine(place, few, coarse, width, 6);
    if (good &&
        std::none_of(places.begin(), places.end(), [&](const auto& other) { return same(place, other); }))
      places.push_back(place);
  }
  const auto fine = chords(base, 0.1);
  std::vector<GraftPlace> found;
  for (GraftPlace place : places)
    if (settle(place, many, fine) &&
        std::none_of(found.begin(), found.end(), [&](const auto& other) { return same(place, other); }))
      found.push_back(place);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  if (found.empty() || found.front().share < least_share)
    throw InputError(problem,
                     fmt::format("at most {:.0f} % of it lie within {} mm of that body's outline",
                                 found.empty() ? 0 : 100 * found.front().share, on_it),
                     advice);
  if (const double stiffness = fit_of(found.front(), many, fine).stiffness; stiffness < least_stiffness)
    throw InputError(problem,
                     fmt::format("its unworn part is an arc or a straight line, along which the body slides "
                                 "(stiffness {:.4f} where {} is needed)",
                                 stiffness, least_stiffness),
                     advice);
  if (found.size() > 1 && found[1].share > rival * found[0].share)
    throw InputError(problem, fmt::format("two are as good: {}; {}", words(found[0]), words(found[1])),
                     advice);
  return found.front();
}

} // namespace bem_contact::meshes
