#include "meshes/graft.hpp"

#include "bem_contact/base/error.hpp"
#include "meshes/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::meshes {
namespace {

/// mm. An end may lie so far off the body.
constexpr double largest_joint_distance = 2.0;
/// rad. Between the tangents there: a flank that ends beside the under-head fillet.
constexpr double largest_joint_slope = 0.7;
/// mm. A blend replaces at least so much of the outline,
constexpr double shortest_blend = 4.0;
/// 1. and at least so many times the distance.
constexpr double blend_ratio = 5.0;
/// 1 (share of the section's area).
constexpr double largest_area_change = 0.3;
/// mm. Distance of the points of the outline among which the nearest one is looked for first.
constexpr double joint_step = 0.25;
/// 1. Of a piece, at least,
constexpr int least_joint_samples = 32;
/// 1. and at most.
constexpr int most_joint_samples = 4000;
/// 1. Times that the bracket around the nearest point is shortened by a third: to the last bit.
constexpr int nearest_place_steps = 100;

/// A place on a closed loop.
struct Place {
  std::size_t piece = 0;
  double t = 0;
  double along = 0; ///< length from the loop's beginning, mm
};

/// A closed loop with its length, sampled.
class WalkedLoop {
public:
  explicit WalkedLoop(const Loop& loop) : loop_(loop) {
    double along = 0;
    for (std::size_t p = 0; p < loop.size(); ++p) {
      const Piece& piece = loop[p];
      const double chord = norm(piece.at((piece.from + piece.to) / 2) - piece.begin());
      const int count =
          std::clamp(static_cast<int>(2 * chord / joint_step), least_joint_samples, most_joint_samples);
      for (int i = 0; i <= count; ++i) {
        const double t = piece.from + (piece.to - piece.from) * i / count;
        if (i > 0)
          along += norm(piece.at(t) - piece.at(samples_.back().t));
        samples_.push_back({p, t, along});
      }
    }
    length_ = along;
  }

  Point2 at(Place place) const { return loop_[place.piece].at(place.t); }

  Point2 tangent(Place place) const {
    const Piece& piece = loop_[place.piece];
    const double step = tangent_step * (piece.to - piece.from);
    const auto inside = [&](double t) {
      return std::clamp(t, std::min(piece.from, piece.to), std::max(piece.from, piece.to));
    };
    const Point2 d = piece.at(inside(place.t + step)) - piece.at(inside(place.t - step));
    return (1 / norm(d)) * d;
  }

  Place nearest(Point2 p) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (const double distance = norm(at(samples_[i]) - p); distance < least) {
        least = distance;
        best = i;
      }
    // Between the neighbouring samples the distance has one minimum.
    const auto of_piece = [&](std::size_t i) { return samples_[i].piece == samples_[best].piece; };
    double low = samples_[best > 0 && of_piece(best - 1) ? best - 1 : best].t;
    double high = samples_[best + 1 < samples_.size() && of_piece(best + 1) ? best + 1 : best].t;
    Place place = samples_[best];
    const auto distance = [&](double t) { return norm(loop_[place.piece].at(t) - p); };
    for (int i = 0; i < nearest_place_steps; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    place.t = (low + high) / 2;
    place.along +=
        norm(at(place) - at(samples_[best])) *
        ((place.t - samples_[best].t) * (loop_[place.piece].to - loop_[place.piece].from) < 0 ? -1 : 1);
    return place;
  }

  /// The place `by` mm further along (back where negative).
  Place moved(Place from, double by) const {
    const double along = std::fmod(from.along + by + length_, length_);
    const auto after =
        std::upper_bound(samples_.begin() + 1, samples_.end() - 1, along,
                         [](double value, const Place& sample) { return value < sample.along; });
    const Place &a = *(after - 1), &b = *after;
    if (a.piece != b.piece)
      return b;
    const double part = b.along > a.along ? (along - a.along) / (b.along - a.along) : 0;
    return {a.piece, a.t + part * (b.t - a.t), along};
  }

  /// The pieces from one place on to another.
  std::vector<Piece> between(Place from, Place to) const {
    std::vector<Piece> pieces;
    const auto add = [&](std::size_t p, double t_from, double t_to) {
      Piece piece = loop_[p];
      piece.from = t_from;
      piece.to = t_to;
      if (norm(piece.end() - piece.begin()) > coinciding)
        pieces.push_back(std::move(piece));
    };
    const bool around = to.piece == from.piece && to.along < from.along;
    if (to.piece == from.piece && !around) {
      add(from.piece, from.t, to.t);
      return pieces;
    }
    add(from.piece, from.t, loop_[from.piece].to);
    for (std::size_t p = (from.piece + 1) % loop_.size(); p != to.piece; p = (p + 1) % loop_.size())
      add(p, loop_[p].from, loop_[p].to);
    add(to.piece, loop_[to.piece].from, to.t);
    return pieces;
  }

private:
  const Loop& loop_;
  std::vector<Place> samples_;
  double length_ = 0;
};

/// Where an end of the profile meets the body.
struct Joint {
  Point2 end, tangent; ///< of the profile
  Place place;         ///< of the body's outline, nearest to the end
  double distance = 0; ///< mm
  double slope = 0;    ///< rad
};

Joint joint_at(const WalkedLoop& base, const CurvePoint& end) {
  Joint joint{end.position, tangent_of(end.delta), base.nearest(end.position)};
  const Point2 tangent = base.tangent(joint.place);
  joint.distance = norm(end.position - base.at(joint.place));
  joint.slope = std::abs(angle_from_to(tangent, joint.tangent));
  return joint;
}

Piece blend(Point2 from, Point2 from_tangent, Point2 to, Point2 to_tangent) {
  const double third = norm(to - from) / 3;
  return bezier(from, from + third * from_tangent, to - third * to_tangent, to);
}

} // namespace

std::vector<Piece> graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name) {
  const WalkedLoop loop(base);
  const Joint first = joint_at(loop, measured.at(measured.s_begin())),
              last = joint_at(loop, measured.at(measured.s_end()));
  const auto fits = [&](const Joint& joint) {
    return joint.distance <= largest_joint_distance && joint.slope <= largest_joint_slope;
  };
  const auto figures = [](const Joint& joint) {
    return fmt::format("its end at ({:.3f}, {:.3f}) mm lies {:.3f} mm off it, inclined by {:.3f} rad",
                       joint.end.y, joint.end.z, joint.distance, joint.slope);
  };
  if (!fits(first) || !fits(last))
    throw InputError(
        fmt::format("The profile {} does not fit the body of {}", measured.name(), base_name),
        fmt::format("{}; {}; up to {} mm and {} rad are blended", figures(first), figures(last),
                    largest_joint_distance, largest_joint_slope),
        "Move the body with [body] graft_at and graft_angle (a measured rail is often inclined), "
        "take another body with graft_onto, or cut the profile where it is not worn.");

  const auto reach = [&](const Joint& joint) {
    return std::max(shortest_blend, blend_ratio * joint.distance);
  };
  const Place from = loop.moved(last.place, reach(last)), to = loop.moved(first.place, -reach(first));
  std::vector<Piece> pieces{blend(last.end, last.tangent, loop.at(from), loop.tangent(from))};
  for (Piece& piece : loop.between(from, to))
    pieces.push_back(std::move(piece));
  pieces.push_back(blend(loop.at(to), loop.tangent(to), first.end, first.tangent));

  Loop whole{along(measured, measured.s_begin(), measured.s_end())};
  whole.insert(whole.end(), pieces.begin(), pieces.end());
  const double before = area(Section{"", std::vector<Loop>{base}}),
               after = area(Section{"", std::vector<Loop>{whole}});
  if (!(std::abs(after / before - 1) <= largest_area_change))
    throw InputError(fmt::format("The profile {} does not fit the body of {}", measured.name(), base_name),
                     fmt::format("the section would have {:.0f} mm^2 instead of {:.0f}", after, before),
                     "Check the profile's frame, unit and walking order.");
  return pieces;
}

Loop placed(const Loop& loop, Point2 by, double angle) {
  const Point2 e_y = tangent_of(angle), e_z = normal_of(angle);
  Loop moved = loop;
  for (std::size_t i = 0; i < loop.size(); ++i)
    moved[i].at = [at = loop[i].at, by, e_y, e_z](double t) {
      const Point2 p = at(t);
      return by + p.y * e_y + p.z * e_z;
    };
  return moved;
}

} // namespace bem_contact::meshes
