#include "meshes/section.hpp"

#include "bem_contact/profile/bodies/own_outline.hpp"
#include "bem_contact/profile/bodies/rail_section.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "meshes/graft.hpp"
#include "meshes/graft_fit.hpp"
#include "meshes/wheel_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace bem_contact::meshes {
namespace {

using std::numbers::pi;

/// 1 (share of its radius). Hole of a disc, which must be held somewhere. Its effect is removed as structure.
constexpr double hole_of_disc = 0.05;
/// 1 (share of half the foot's width). What is steep and nearer to the middle is web, what is farther the
/// edge of the foot.
constexpr double widest_web = 0.5;

/// The profile in walking order, the strip marked; the strip comes first, what lies before it last.
struct Running {
  Piece strip;
  std::vector<Piece> after, before;
};

Running cut_at_strip(const ProfileCurve& curve, const BodyFile::Strip& strip) {
  require_strip_on_profile(strip, curve);
  const double from = std::max(strip.from, curve.s_begin()), to = std::min(strip.to, curve.s_end());
  Running running{along(curve, from, to, Group::contact), {}, {}};
  if (curve.s_end() - to > profile_slack)
    running.after.push_back(along(curve, to, curve.s_end()));
  if (from - curve.s_begin() > profile_slack)
    running.before.push_back(along(curve, curve.s_begin(), from));
  return running;
}

Loop close(const Running& running, const std::vector<Piece>& rest) {
  Loop loop{running.strip};
  loop.insert(loop.end(), running.after.begin(), running.after.end());
  loop.insert(loop.end(), rest.begin(), rest.end());
  loop.insert(loop.end(), running.before.begin(), running.before.end());
  return loop;
}

Piece piece_of(const SectionPiece& piece, bool mirrored, Group group) {
  const double side = mirrored ? -1 : 1;
  const Point2 a{side * piece.from.y, piece.from.z}, b{side * piece.to.y, piece.to.z};
  const CurvePiece curve = curve_of({mirrored ? b : a, mirrored ? a : b, piece.radius});
  return {[curve](double t) { return point_on(curve, t).position; }, 0, curve.length, group};
}

/// Steeper than 45 degrees, and not the edge of the foot.
bool is_web(const SectionPiece& piece, double foot_half_width) {
  const CurvePiece curve = curve_of(piece);
  const auto steep = [&](double along) {
    return std::abs(std::cos(point_on(curve, along).delta)) < std::sqrt(0.5);
  };
  return steep(0) && steep(curve.length) && piece.from.y < widest_web * foot_half_width;
}

/// A standard rail's whole outline from its top centre round; `held` is "foot" (its underside) or "web".
Loop rail_loop(const std::string& name, const std::string& held) {
  const auto right = rail_section(name);
  double foot = 0;
  for (const auto& piece : right)
    foot = std::max(foot, piece.to.y);
  const auto group = [&](std::size_t i) {
    const bool is_held = held == "web" ? is_web(right[i], foot) : i + 1 == right.size();
    return is_held ? Group::held : Group::free;
  };
  Loop loop;
  for (std::size_t i = 0; i < right.size(); ++i)
    loop.push_back(piece_of(right[i], false, group(i)));
  for (std::size_t i = right.size(); i-- > 0;)
    loop.push_back(piece_of(right[i], true, group(i)));
  return loop;
}

/// What closes the profile of a rail or wheel.
std::vector<Piece> below_profile(const BodyFile::Body& body, const ProfileCurve& profile,
                                 const std::string& held, std::string& note) {
  const bool rail = body.kind == BodyKind::rail;
  const Point2 begin = profile.at(profile.s_begin()).position, end = profile.at(profile.s_end()).position;
  if (!is_standard_profile(body.profile)) {
    const std::string base = graft_base(body);
    const ProfileCurve standard = standard_profile(base);
    Loop loop = rail ? rail_loop(base, held) : Loop{along(standard, standard.s_begin(), standard.s_end())};
    if (!rail)
      for (Piece& piece :
           wheel_body(standard.at(standard.s_end()).position, standard.at(standard.s_begin()).position, held))
        loop.push_back(std::move(piece));
    NominalPlace place{body.graft_at.value_or(Point2{}), body.graft_angle.value_or(0)};
    if (!body.graft_at && !body.graft_angle) {
      const GraftPlace found = find_graft(profile, base);
      place = found.place;
      note = fmt::format(
          "body of {} found at graft_at = [{:.3f}, {:.3f}], graft_angle = {:.5f}: {:.0f} % of the "
          "profile lie on it",
          base, place.shift.y, place.shift.z, place.angle, 100 * found.share);
      if (!found.doubt.empty())
        note += fmt::format("; warning: {} does not fit ({}) Take another body with graft_onto, or give "
                            "graft_at and graft_angle.",
                            base, found.doubt);
    }
    return graft(profile, placed(loop, place.shift, place.angle), base);
  }
  if (!rail)
    return wheel_body(end, begin, held);
  const Loop loop = rail_loop(body.profile, held);
  const auto head = static_cast<std::ptrdiff_t>(rail_head(body.profile).size());
  return {loop.begin() + head, loop.end() - head};
}

template <class Name> Group group_of(Name group) {
  return group == Name::held ? Group::held : Group::free;
}

std::vector<Loop> own_loops(const BodyFile::Body& body, const Running& running) {
  std::vector<Piece> rest;
  for (const auto& [shape, group] : own_outline(body).rest)
    rest.push_back(piece_of(shape, false, group_of(group)));
  std::vector<Loop> loops{close(running, rest)};
  for (const auto& hole : body.holes)
    loops.push_back({arc(hole.centre, hole.radius, 0, -2 * pi, group_of(hole.group))});
  return loops;
}

std::vector<Loop> loops_of(const BodyFile::Body& body, const ProfileCurve& profile, const Running& running,
                           std::string& note) {
  const double a = body.size, r = body.radius;
  const std::string held = held_part(body);
  const auto group = [&](const char* part) { return held == part ? Group::held : Group::free; };
  if (body.kind == BodyKind::outline)
    return own_loops(body, running);
  if (body.kind == BodyKind::rail || body.kind == BodyKind::wheel)
    return {close(running, below_profile(body, profile, held, note))};
  if (body.kind == BodyKind::block)
    return {close(running, {line({a, 0}, {a, a}, group("sides")), line({a, a}, {-a, a}, group("base")),
                            line({-a, a}, {-a, 0}, group("sides"))})};
  if (body.kind == BodyKind::disc)
    return {close(running, {arc({}, r, pi, 2 * pi)}), {arc({}, hole_of_disc * r, 0, -2 * pi, Group::held)}};
  // bore: walked clockwise from +y towards -z, as a hole is
  return {close(running, {arc({}, r, 0, -pi)}),
          {line({-a, -a}, {a, -a}, Group::held), line({a, -a}, {a, a}, Group::held),
           line({a, a}, {-a, a}, Group::held), line({-a, a}, {-a, -a}, Group::held)}};
}

} // namespace

Piece line(Point2 from, Point2 to, Group group) {
  return {[=](double t) { return (1 - t) * from + t * to; }, 0, 1, group};
}

Piece arc(Point2 centre, double radius, double angle_from, double angle_to, Group group) {
  return {[=](double t) {
            return centre + radius * Point2{std::cos(t), std::sin(t)};
          },
          angle_from, angle_to, group};
}

Piece bezier(Point2 p0, Point2 p1, Point2 p2, Point2 p3) {
  return {[=](double t) {
            const double u = 1 - t;
            return u * u * u * p0 + 3 * u * u * t * p1 + 3 * u * t * t * p2 + t * t * t * p3;
          },
          0, 1, Group::free};
}

Piece along(const ProfileCurve& curve, double from, double to, Group group) {
  const auto shared = std::make_shared<const ProfileCurve>(curve);
  return {[shared](double s) { return shared->at(s).position; }, from, to, group};
}

namespace {

/// An own outline was checked when it was read; a rail is as deep as its section.
void require_roller_below(const Section& section, double roller_radius) {
  double deepest = 0;
  for (const Piece& piece : section.loops.front())
    deepest = std::max(deepest, piece.end().z);
  if (roller_radius > 0 && !(deepest < roller_radius))
    throw InputError(
        fmt::format("The section of {} reaches the axis of its roller", section.name),
        fmt::format("it goes down to z = {:.6g} mm, body.roller_radius is {:g} mm", deepest, roller_radius),
        "Give a larger radius, or the roller's own section as an outline with a reference_radius "
        "below 0.");
}

} // namespace

Section make_section(const BodyFile& file) {
  const ProfileCurve profile = body_profile(file);
  Section section{body_name(file), {}, {}};
  section.loops = loops_of(file.body, profile, cut_at_strip(profile, file.strip), section.note);
  require_roller_below(section, file.body.roller_radius);
  return section;
}

double area(const Section& section, int samples) {
  double twice = 0;
  for (const auto& loop : section.loops)
    for (const auto& piece : loop) {
      Point2 a = piece.begin();
      for (int i = 1; i <= samples; ++i) {
        const Point2 b = piece.at(piece.from + (piece.to - piece.from) * i / samples);
        twice += cross(a, b);
        a = b;
      }
    }
  return twice / 2;
}

} // namespace bem_contact::meshes
