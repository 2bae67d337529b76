#include "bem_contact/profile/bodies/own_outline.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// mm. A shorter piece of an outline is a mistake. Chosen: a thousandth of the last digit of a drawing.
constexpr double shortest_outline_piece = 1e-6;
/// 1. An arc's chord may exceed its diameter by so much: a half circle with rounded ends.
constexpr double half_circle_rounding = 1e-9;
/// 1. Points of an arc among which the closest to the axle is looked for. Chosen.
constexpr int closest_point_samples = 64;

std::string text(Point2 p) {
  return fmt::format("({:.6g}, {:.6g})", p.y, p.z);
}

std::vector<OwnOutline::Piece> joined(const BodyFile::Body& body) {
  const auto& outline = body.outline;
  const auto is_arc = [](const auto& piece) { return piece.radius != 0; };
  if (outline.size() < 2 || (outline.size() == 2 && std::none_of(outline.begin(), outline.end(), is_arc)))
    throw InputError(
        fmt::format("The outline of {} has {}", body.name, counted(outline.size(), "piece", "pieces")),
        "a closed loop needs at least 3 lines, or 2 pieces one of which is an arc",
        "Give them in [body] outline = [{ to = [y, z] }, ...].");
  std::vector<OwnOutline::Piece> pieces;
  Point2 from = outline.back().to;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& piece = outline[i];
    const std::string name = fmt::format("Piece {} of the outline of {} from {} to {} mm", i + 1, body.name,
                                         text(from), text(piece.to));
    const double chord = norm(piece.to - from);
    if (chord < shortest_outline_piece)
      throw InputError(name + " has no length", "it ends where it begins",
                       "Remove it; the first piece begins where the last one ends, so the loop is closed.");
    if (is_arc(piece) && chord > 2 * std::abs(piece.radius) * (1 + half_circle_rounding))
      throw InputError(name + " is no arc",
                       fmt::format("its ends are {:.6g} mm apart, more than twice its radius of {} mm", chord,
                                   std::abs(piece.radius)),
                       "Give a larger radius or other ends.");
    pieces.push_back({{from, piece.to, piece.radius}, piece.group});
    from = piece.to;
  }
  return pieces;
}

/// The pieces turned so that the run of contact pieces comes first.
OwnOutline split(const std::vector<OwnOutline::Piece>& pieces, const std::string& name) {
  const std::size_t n = pieces.size();
  const auto contact = [&](std::size_t i) { return pieces[i % n].group == PieceGroup::contact; };
  std::size_t runs = 0, begin = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (contact(i) && !contact(i + n - 1)) {
      ++runs;
      begin = i;
    }
  if (runs == 0)
    throw InputError(fmt::format("The outline of {} has {} contact piece", name, contact(0) ? "only" : "no"),
                     "the contact surface is a run of neighbouring pieces with two ends",
                     "Give group = \"contact\" to some pieces, not to all.");
  if (runs > 1)
    throw InputError(fmt::format("The contact pieces of the outline of {} form {} separate runs", name, runs),
                     "the contact surface is one curve",
                     "Give group = \"contact\" to neighbouring pieces only.");
  OwnOutline outline;
  for (std::size_t i = 0; i < n; ++i)
    (contact(begin + i) ? outline.contact : outline.rest).push_back(pieces[(begin + i) % n]);
  return outline;
}

void require_smooth(const std::vector<OwnOutline::Piece>& contact, const std::string& name) {
  for (std::size_t i = 1; i < contact.size(); ++i) {
    const CurvePiece before = curve_of(contact[i - 1].shape), after = curve_of(contact[i].shape);
    const double turn = after.delta0 - point_on(before, before.length).delta;
    if (const double angle = std::abs(std::remainder(turn, 2 * std::numbers::pi)); angle > tangent_slack)
      throw InputError(
          fmt::format("The contact surface of {} has a corner at {} mm", name, text(contact[i].shape.from)),
          fmt::format("its pieces meet at {:.4g} rad, at most {} are taken as smooth", angle, tangent_slack),
          "Let the pieces be tangent there, or put a small arc between them.");
  }
}

/// Area within the loop, > 0 where the material is on the side of e_n.
double area_within(const std::vector<OwnOutline::Piece>& pieces) {
  double twice = 0;
  for (const auto& [shape, group] : pieces) {
    twice += cross(shape.from, shape.to);
    if (shape.radius != 0) { // and the segment between chord and arc
      const double turn = curve_of(shape).length / shape.radius;
      twice += shape.radius * shape.radius * (turn - std::sin(turn));
    }
  }
  return twice / 2;
}

/// Least distance of a piece from the axis at z = -reference_radius, < 0 beyond it: that of an end, or of the
/// point of an arc that comes closer than both.
double least_radius(const SectionPiece& shape, double reference_radius) {
  const auto radius = [&](Point2 p) {
    return std::copysign(1.0, reference_radius) * (reference_radius + p.z);
  };
  double least = std::min(radius(shape.from), radius(shape.to));
  const CurvePiece curve = curve_of(shape);
  for (int i = 1; i < closest_point_samples; ++i)
    least = std::min(least, radius(point_on(curve, curve.length * i / closest_point_samples).position));
  return least;
}

} // namespace

OwnOutline own_outline(const BodyFile::Body& body) {
  const auto pieces = joined(body);
  OwnOutline outline = split(pieces, body.name);
  require_smooth(outline.contact, body.name);
  const auto held = [](const auto& part) { return part.group == decltype(part.group)::held; };
  if (std::none_of(pieces.begin(), pieces.end(), held) &&
      std::none_of(body.holes.begin(), body.holes.end(), held))
    throw InputError(fmt::format("Nothing holds {}", body.name),
                     "a body that can move as a whole has no displacement",
                     "Give group = \"held\" to a piece or a hole away from the contact surface.");
  if (!(area_within(pieces) > 0))
    throw InputError(fmt::format("The outline of {} is walked the wrong way round", body.name),
                     "drawn with y to the right and z down the material must be on the right hand",
                     "Reverse the order of the pieces and the signs of their radii.");
  for (const auto& piece : pieces)
    if (const double r = least_radius(piece.shape, body.reference_radius);
        body.reference_radius != 0 && !(r > 0))
      throw InputError(
          fmt::format("{} reaches its axle", body.name),
          fmt::format("at a radius of {:.6g} mm: the axle is at z = {:g} mm", r, -body.reference_radius),
          body.reference_radius > 0
              ? "Raise [body] reference_radius or leave a bore around the axle."
              : "Lower [body] reference_radius (the axle lies below) or leave a bore around it.");
  return outline;
}

ProfileCurve outline_profile(const BodyFile::Body& body) {
  std::vector<CurvePiece> pieces;
  for (const auto& piece : own_outline(body).contact)
    pieces.push_back(curve_of(piece.shape));
  return ProfileCurve::from_pieces(body.name, std::move(pieces));
}

} // namespace bem_contact
