#include "bem_contact/geometry/sectioned_rail.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/profile/sections/section_curve.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Newton steps to a point of the surface: bounds. Four are usual.
constexpr int surface_steps = 20;
/// mm. Where they end: a digit above rounding.
constexpr double surface_tolerance = 1e-12;
/// mm. A step that is longer is cut: the surface turns over lengths like this.
constexpr double longest_surface_step = 5.0;

/// y and z of it.
Point2 plane_part(const Vector3& v) {
  return {v[1], v[2]};
}

} // namespace

SectionedRail::SectionedRail(std::shared_ptr<const RailSurfaces> surface, const Pose& pose, double along)
    : surface_(std::move(surface)), pose_(pose), along_(along) {
  if (along < surface_->from() || along > surface_->to())
    throw InputError(
        fmt::format("The wheel stands off the rail's sections (position.along is {:g} mm)", along),
        fmt::format("they are given from {:g} to {:g} mm", surface_->from(), surface_->to()),
        "Give a place between the first and the last section, or more sections.");
}

SectionedRail::Seen SectionedRail::seen(const Place& at, int side) const {
  const SectionedSurface::Point p = surface_->at(at.u, at.t, side);
  const Turn turn(pose_.angle);
  const Point2 position = pose_.origin + turn(p.position), by_u = turn(p.by_u), by_t = turn(p.by_t);
  return {frame_.seen_point({at.u - along_, position.y, position.z}), frame_.seen({1, by_u.y, by_u.z}),
          frame_.seen({0, by_t.y, by_t.z})};
}

/// u of the point of this t in the plane across x through the frame's origin.
std::optional<double> SectionedRail::u_across(double t) const {
  double u = along_ + frame_.origin[0];
  for (int i = 0; i < surface_steps; ++i) {
    const Seen p = seen({u, t});
    const double step = (frame_.origin[0] - p.position[0]) / p.by_u[0];
    if (!std::isfinite(step))
      return std::nullopt;
    u += step;
    if (std::abs(step) < surface_tolerance * (1 + std::abs(u)))
      break;
  }
  return surface_->has(u, t) ? std::optional(u) : std::nullopt;
}

ProfileCurve SectionedRail::look_from(const RailFrame& frame) {
  frame_ = frame;
  std::vector<SectionNode> nodes;
  const Turn back(-pose_.angle);
  const auto in_section = [&](const Seen& p) { // along the cut, by t
    const double turned = -p.by_t[0] / p.by_u[0];
    return back(plane_part(p.by_t) + turned * plane_part(p.by_u));
  };
  for (const double t : surface_->nodes()) {
    if (!surface_->has(along_ + frame.origin[0], t))
      continue;
    const auto u = u_across(t);
    if (!u)
      continue;
    const Seen before = seen({*u, t}, -1), after = seen({*u, t}, 1);
    nodes.push_back(
        {*u, t, back(plane_part(after.position) - pose_.origin), in_section(before), in_section(after)});
    if (nodes.size() < 2)
      continue;
    SectionNode &last = nodes[nodes.size() - 2], &here = nodes.back();
    if (surface_->body_of(last.t) != surface_->body_of(here.t)) // a straight line over the gap
      last.after = here.before = {};
  }
  ProfileCurve out = curve_through(fmt::format("rail at {:.6g} mm", along_ + frame.origin[0]), nodes);
  t_.clear();
  u_.clear();
  for (const SectionNode& node : nodes) {
    t_.push_back(node.t);
    u_.push_back(node.u);
  }
  s_ = out.joints();
  return out;
}

SectionedRail::Place SectionedRail::start(const ContactRow& row) const {
  const auto [k, share] = PlaceInTable(s_, row.s);
  return {u_[k] + share * (u_[k + 1] - u_[k]), t_[k] + share * (t_[k + 1] - t_[k])};
}

/// Newton's method in (u, t), for the point on the normal of the row.
std::optional<SectionedRail::Place> SectionedRail::found(double x, const ContactRow& row) const {
  const Point2 tangent = tangent_of(row.delta);
  Place at = start(row);
  at.u += x - frame_.origin[0];
  for (int i = 0; i < surface_steps; ++i) {
    const Seen p = seen(at);
    const double off_x = x - p.position[0], off_s = dot(row.position - plane_part(p.position), tangent);
    const double a = p.by_u[0], b = p.by_t[0], c = dot(plane_part(p.by_u), tangent),
                 d = dot(plane_part(p.by_t), tangent);
    const double determinant = a * d - b * c;
    double du = (off_x * d - b * off_s) / determinant, dt = (a * off_s - c * off_x) / determinant;
    if (!std::isfinite(du) || !std::isfinite(dt))
      return std::nullopt;
    const double longest = std::max(std::abs(dt), std::abs(off_x) > longest_surface_step ? 0 : std::abs(du));
    if (longest > longest_surface_step)
      du *= longest_surface_step / longest, dt *= longest_surface_step / longest;
    at.u += du;
    at.t += dt;
    if (std::abs(du) + std::abs(dt) < surface_tolerance * (1 + std::abs(at.u))) {
      return surface_->has(at.u, at.t) ? std::optional(at) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> SectionedRail::depth(double x, const ContactRow& row) const {
  const auto at = found(x, row);
  if (!at)
    return std::nullopt;
  const double deep = dot(plane_part(seen(*at).position) - row.position, normal_of(row.delta));
  return std::abs(deep) < farthest_row ? std::optional(deep) : std::nullopt;
}

double SectionedRail::slope(double x, const ContactRow& row, double length) const {
  const auto before = depth(x - 0.5 * length, row), after = depth(x + 0.5 * length, row);
  return before && after ? (*after - *before) / length : 0;
}

Vector3 SectionedRail::point(double x, const ContactRow& row) const {
  const Point2 p = row.position + depth(x, row).value_or(0) * normal_of(row.delta);
  return {x, p.y, p.z};
}

SectionedRail::OnBody SectionedRail::on_body(double x, const ContactRow& row) const {
  const auto at = found(x, row);
  const auto [u, t] = at ? *at : start(row);
  return {u, surface_->body_of(t), surface_->on_body(t)};
}

std::optional<SectionedRail::OnBody> SectionedRail::on_section(const ContactRow& row) const {
  const auto [u, t] = start(row);
  return surface_->has(u, t) ? std::optional(OnBody{u, surface_->body_of(t), surface_->on_body(t)})
                             : std::nullopt;
}

SectionedRail::Direction SectionedRail::direction(double x, const ContactRow& row) const {
  const auto at = found(x, row);
  const Seen p = seen(at ? *at : start(row));
  Vector3 normal = frame_.in_track(cross(p.by_u, p.by_t)); // into the rail: x times s
  const double length = norm(normal);
  if (!(length > 0))
    return {};
  for (double& component : normal)
    component /= length;
  // In the surface: the rolling direction, projected, and what is across it.
  const double level = std::sqrt(1 - normal[0] * normal[0]);
  const Vector3 ahead{level, -normal[0] * normal[1] / level, -normal[0] * normal[2] / level};
  const Vector3 across = cross(normal, ahead), line = frame_.in_track(p.by_u);
  const double turn =
      std::clamp(std::atan2(dot(across, line), dot(ahead, line)), -farthest_turn, farthest_turn);
  Direction out{{}, -normal[0] / normal[2]};
  for (int i = 0; i < 3; ++i)
    out.ahead[i] = std::cos(turn) * ahead[i] + std::sin(turn) * across[i];
  return out;
}

} // namespace bem_contact
