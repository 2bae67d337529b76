#include "bem_contact/profile/worn/head_symmetry.hpp"

#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/worn/outline_table.hpp"
#include "bem_contact/profile/worn/settings.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// 1. Chords of the measured head: about a millimetre long. Chosen.
constexpr int symmetry_chords = 150;
/// mm. Last width at least: what sides differ by, as rolled.
constexpr double symmetry_least = 0.03;
/// 1 (last widths). What lies so near to its mirror image is symmetric.
constexpr double symmetric_widths = 1.5;
/// 1 (cosine to the horizontal). Steeper parts, beyond 64 degrees, are the sides of a head.
constexpr double steep_cosine = 0.44;
/// 1. Shares of the sides and of what is between that must be symmetric. A flank and a worn gauge face, with
/// an axis that is wrong by 25 to 50 mrad, cross the top so that 0.03 to 0.04 of it lies on its image; 1 mm
/// off the top and 0.6 mm off the gauge corner of 39 standards leave 0.15 and more.
constexpr double least_symmetric_sides = 0.5;
/// 1. Share of the top that must be symmetric, by the same heads.
constexpr double least_symmetric_top = 0.15;
/// 1. Share of a top that is not worn on one side. Chosen.
constexpr double whole_top = 0.9;

/// An axis of symmetry: turned by `angle` from +z (rad, from +y towards +z), `offset` beside the origin (mm,
/// along the turned +y).
struct Axis {
  double angle = 0, offset = 0;

  Point2 mirrored(Point2 p) const {
    const Point2 across = tangent_of(angle);
    return p + 2 * (offset - dot(p, across)) * across;
  }
};

/// A point's mirror image as seen from the curve.
struct Image {
  Point2 at;
  OutlineTable::Seen seen;
  double steep = 0; ///< 1 where the curve is parallel to the axis, 0 where it is square to it
};

template <class Look> void look_at_images(const OutlineTable& head, const Axis& axis, Look look) {
  std::size_t near = head.chords().size() - 1;
  const Point2 across = tangent_of(axis.angle);
  for (std::size_t i = 0; i < head.chords().size(); ++i) {
    const Point2 at = axis.mirrored(head.middle_of(i));
    if (const OutlineTable::Seen seen = head.see(at, near); !seen.beyond)
      look(Image{at, seen, std::pow(dot(seen.normal, across), 2)});
  }
}

double weight_of_image(const Image& image, double width) {
  const double share = image.seen.depth / width, root = 1 - share * share;
  return root > 0 ? root * root * (told_on_top + (1 - told_on_top) * image.steep) : 0;
}

/// False if it runs away.
bool refine_axis(Axis& axis, const OutlineTable& head, double width, int steps) {
  for (int i = 0; i < steps; ++i) {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double total = 0;
    const Point2 across = tangent_of(axis.angle);
    look_at_images(head, axis, [&](const Image& image) {
      const double weight = weight_of_image(image, width);
      if (weight == 0)
        return;
      // The image turns by twice the axis's turn.
      const Point2 arm = image.at - axis.offset * across, by_turn = 2 * Point2{-arm.z, arm.y};
      const Eigen::Vector2d change(dot(image.seen.normal, by_turn) / placing_arm,
                                   2 * dot(image.seen.normal, across));
      matrix += weight * change * change.transpose();
      right -= weight * image.seen.depth * change;
      total += weight;
    });
    if (total < least_placing_weight * told_on_top * static_cast<double>(head.chords().size()))
      return false;
    matrix.diagonal().array() += placing_damping * total;
    const Eigen::Vector2d by = matrix.ldlt().solve(right);
    axis.angle += by[0] / placing_arm;
    axis.offset += by[1];
    if (std::abs(axis.angle) > largest_placing_angle)
      return false;
    if (by.norm() < searching_tolerance)
      break;
  }
  return true;
}

/// How much of the head lies on its mirror image.
struct Symmetric {
  double steep = 0, flat = 0; ///< share of the steep parts, and of those between
};

Symmetric symmetric_parts(const OutlineTable& head, const Axis& axis, double within) {
  double steep = 0, flat = 0, all_steep = 0;
  const Point2 across = tangent_of(axis.angle);
  for (const OutlineTable::Chord& chord : head.chords())
    all_steep += std::abs(dot(chord.along, across)) < steep_cosine;
  look_at_images(head, axis, [&](const Image& image) {
    if (std::abs(image.seen.depth) < within)
      ++(image.steep > 1 - steep_cosine * steep_cosine ? steep : flat);
  });
  const auto count = static_cast<double>(head.chords().size());
  return {all_steep > 0 ? steep / all_steep : 0, all_steep < count ? flat / (count - all_steep) : 0};
}

/// The middle between both sides, if the head is turned by `angle`.
Axis axis_at(const OutlineTable& head, double angle) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < head.chords().size(); ++i) {
    const double y = dot(head.middle_of(i), tangent_of(angle));
    low = i == 0 ? y : std::min(low, y);
    high = i == 0 ? y : std::max(high, y);
  }
  return {angle, (low + high) / 2};
}

/// Last by what lies as near as most of what is symmetric: the scatter of the points.
std::optional<double> settle_axis(Axis& axis, const OutlineTable& head) {
  for (const double width : symmetry_widths)
    if (!refine_axis(axis, head, width, searching_steps))
      return std::nullopt;
  std::vector<double> distances;
  look_at_images(head, axis, [&](const Image& image) {
    if (std::abs(image.seen.depth) < unworn_distance && image.steep > told_on_top)
      distances.push_back(std::abs(image.seen.depth));
  });
  if (distances.empty())
    return std::nullopt;
  const double width =
      std::clamp(settling_medians * median(std::move(distances)), symmetry_least, unworn_distance);
  if (!refine_axis(axis, head, width, settling_steps))
    return std::nullopt;
  return width;
}

} // namespace

std::optional<HeadTurn> turn_by_symmetry(const ProfileCurve& rail) {
  const OutlineTable head = OutlineTable::of_equal(rail, symmetry_chords);
  for (const double start : symmetry_starts) {
    Axis axis = axis_at(head, start);
    const std::optional<double> width = settle_axis(axis, head);
    if (!width)
      continue;
    const Symmetric found = symmetric_parts(head, axis, symmetric_widths * *width);
    if (found.steep >= least_symmetric_sides && found.flat >= least_symmetric_top)
      return HeadTurn{axis.angle, found.flat >= whole_top};
  }
  return std::nullopt;
}

} // namespace bem_contact
