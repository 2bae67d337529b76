#include "bem_contact/profile/standards/en13715_wheel.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

constexpr En13715Wheel usual_wheel;
/// mm. From the tape circle a straight line leads to the point of the tread that lay here.
constexpr double tread_joint = -0.5;
/// mm. The arc at the tip of the flange.
constexpr double tip_radius = 12;
/// mm. y of its centre, z is `tip_radius` above the tip.
constexpr double tip_centre = -55;

void require_range(const char* what, double value, double least, double most, const char* unit) {
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("EN 13715 has no wheel with {} of {:g} {}", what, value, unit),
                     fmt::format("it is {:g} to {:g} {}", least, most, unit),
                     "Name another one, as \"S1002 h28 e30.5 6.7%\".");
}

DrawnPiece moved(DrawnPiece piece, Point2 by) {
  piece.from = piece.from + by;
  piece.to = piece.to + by;
  if (!piece.polynomial.empty())
    piece.shift += by.y;
  return piece;
}

/// The face of the flange: the line goes on until the arc of `radius` that is tangent to it touches the tip's
/// circle about `tip` from outside that circle. Returns the joints: line and arc, arc and tip.
std::pair<Point2, Point2> face_joints(const DrawnPiece& line, double radius, Point2 tip) {
  const Point2 along = (1 / norm(line.to - line.from)) * (line.to - line.from);
  const Point2 inward{-along.z, along.y};
  // |line.from + u along + radius inward - tip| = radius - tip_radius
  const Point2 start = line.from + radius * inward - tip;
  const double half = dot(start, along), apart = radius - tip_radius;
  const double root = std::sqrt(half * half - dot(start, start) + apart * apart);
  const double u = -half - root;
  const Point2 centre = line.from + u * along + radius * inward;
  return {line.from + u * along, centre + (radius / apart) * (tip - centre)};
}

} // namespace

std::optional<En13715Wheel> parse_en13715_wheel(std::string_view words) {
  En13715Wheel wheel;
  while (true) {
    const auto begin = words.find_first_not_of(" _-/;");
    if (begin == std::string_view::npos)
      return wheel;
    words.remove_prefix(begin);
    const char letter = words.front();
    const bool slope = letter >= '0' && letter <= '9';
    if (!slope)
      words.remove_prefix(1);
    const auto end = std::min(words.find_first_not_of("0123456789.,"), words.size());
    std::string text(words.substr(0, end));
    std::ranges::replace(text, ',', '.');
    const std::optional<double> value = number_of_text(text);
    if (!value)
      return std::nullopt;
    words.remove_prefix(end);
    if (slope) {
      const auto percent = words.find_first_not_of(' ');
      if (percent == std::string_view::npos || words[percent] != '%')
        return std::nullopt;
      words.remove_prefix(percent + 1);
      wheel.slope = *value;
    } else if (letter == 'h' || letter == 'H') {
      wheel.height = *value;
    } else if (letter == 'e' || letter == 'E') {
      wheel.thickness = *value;
    } else {
      return std::nullopt;
    }
  }
}

std::string words_of(const En13715Wheel& wheel) {
  return fmt::format("h{:g} e{:g} {:g}%", wheel.height, wheel.thickness, wheel.slope);
}

std::vector<DrawnPiece> en13715_wheel(const std::vector<DrawnPiece>& usual, const En13715Wheel& wheel) {
  require_range("a flange height", wheel.height, 28, 32, "mm");
  require_range("a flange thickness", wheel.thickness, 28.5, 32.5, "mm");
  require_range("an outer slope", wheel.slope, 6.7, 15, "%");
  const double back = usual_wheel.thickness - wheel.thickness, higher = wheel.height - usual_wheel.height;
  const std::size_t face = usual.size() - 4; // its line; behind it the arcs of face, tip and back
  std::vector<DrawnPiece> pieces;
  for (std::size_t i = 0; i < face; ++i) {
    const DrawnPiece& piece = usual[i];
    if (back == 0 || piece.to.y > 0 || piece.from.y < 0) {
      pieces.push_back(piece.from.y < 0 ? moved(piece, {-back, 0}) : piece);
      continue;
    }
    DrawnPiece before = piece, behind = piece;
    before.to = {0, height_at(piece, 0)};
    behind.from = {tread_joint, height_at(piece, tread_joint)};
    behind = moved(behind, {-back, 0});
    pieces.insert(pieces.end(), {before, {before.to, behind.from}, behind});
  }
  if (wheel.slope != usual_wheel.slope)
    pieces.front().from.z =
        pieces.front().to.z - wheel.slope / 100 * (pieces.front().from.y - pieces.front().to.y);

  const Point2 up{0, higher}, tip{tip_centre - back, usual_wheel.height + higher - tip_radius};
  const DrawnPiece line = moved(usual[face], {-back, 0});
  const double radius = usual[face + 1].radius + 0.75 * higher;
  const auto [on_line, on_tip] = higher == 0 ? std::pair{line.to, usual[face + 1].to + Point2{-back, 0}}
                                             : face_joints(line, radius, tip);
  const Point2 tip_end = usual[face + 2].to + up;
  pieces.push_back({line.from, on_line});
  pieces.push_back({on_line, on_tip, radius});
  if (back == 0) {
    pieces.push_back({on_tip, tip_end, tip_radius});
  } else { // the ridge, where the tip's circle meets the one that stays
    const Point2 ridge{tip_centre - back / 2, tip.z + std::sqrt(tip_radius * tip_radius - back * back / 4)};
    pieces.push_back({on_tip, ridge, tip_radius});
    pieces.push_back({ridge, tip_end, tip_radius});
  }
  pieces.push_back(moved(usual[face + 3], up));
  return pieces;
}

} // namespace bem_contact
