#include "bem_contact/geometry/undeformed_distance.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace bem_contact {

namespace {

/// mm. A wheel that overlaps the rail by more is the other side of the flange, not the contact.
constexpr double deepest_overlap = 2.0;
/// mm of the wheel's profile. How far the crossing with a section x = const may lie from that with the locus.
/// Half of a flange's width: rows and sections of one contact stay on the same side of the flange.
constexpr double section_margin = 6.0;
/// 1. The nearest node is looked for among every so many (1.2 mm), then downhill: no rail or wheel has two
/// minima of the distance so near to each other.
constexpr int node_stride = 12;
/// 1. Rows for which that is begun together. Larger groups have more nodes within their reach. Measured.
constexpr int rows_together = 16;
/// 1. Steps to the angle at which a wheel that is not round meets a plane x = const: each is some 100 times
/// nearer. A bound.
constexpr int uneven_steps = 20;
/// 1. Room for rounding in the square of that reach.
constexpr double rounding_of_reach = 1e-12;

/// The normal of a row, seen along x.
struct Ray {
  Point2 origin, tangent, normal;

  explicit Ray(const ContactRow& row)
      : origin(row.position), tangent(tangent_of(row.delta)), normal(normal_of(row.delta)) {}
  double along(Point2 p) const { return dot(p - origin, tangent); }
  double outward(Point2 p) const { return -dot(p - origin, normal); }
};

/// The wheel cut by a plane x = const, over a stretch of its profile. Nodes are made when they are asked for:
/// from one row to the next the crossing moves by a few.
class WheelSection {
public:
  struct Node {
    Point2 position;
    bool joined = true;
  };

  WheelSection(const WheelOnRail& pair, const WheelFrame& frame, double x, int first, int last)
      : wheel_(pair.wheel), frame_(frame), uneven_(pair.uneven ? &*pair.uneven : nullptr),
        radius_(pair.wheel_radius), x_(x), rail_(uneven_ ? uneven_->rail(x) : 0), first_(first),
        places_(last - first + 1) {}

  int last() const { return static_cast<int>(places_.size()) - 1; }
  /// Where the wheel does not reach the plane a node is at the origin, and joined to none.
  Point2 position(int k) const { return reaches(k) ? places_[k].position : Point2{}; }
  bool joined(int k) const { return k > 0 && reaches(k - 1) && reaches(k); }
  Node between(int k, double t) const {
    const auto table = wheel_.nodes();
    const double from = table[first_ + k].s, to = table[first_ + k + 1].s;
    const auto p = from_section(from + t * (to - from), wheel_.between(first_ + k, t).position);
    return {p ? *p : position(k)};
  }

private:
  struct Angle {
    double sine = 0, cosine = 1;
  };
  /// Nothing where the wheel does not reach the plane: on the circle of a point (y, z) the angle from `down`
  /// to `forward` is where its x is that of the plane.
  std::optional<Angle> angle_at(double y, double r) const {
    if (r <= 0)
      return std::nullopt;
    const double a = frame_.forward[0], b = frame_.down[0];
    const double c = (x_ - frame_.centre[0] - y * frame_.axle[0]) / r;
    const double size = a * a + b * b, under = size - c * c;
    if (under <= 0)
      return std::nullopt;
    const double root = std::sqrt(under);
    return Angle{(a * c - b * root) / size, (b * c + a * root) / size};
  }
  std::optional<Point2> from_section(double s, Point2 p) const {
    const Point2 round = p;
    double r = radius_ + p.z;
    std::optional<Angle> angle = angle_at(p.y, r);
    // The radius there depends a little on the angle, and the angle hardly on the radius.
    for (int i = 0; uneven_ && angle && i < uneven_steps; ++i) {
      const Point2 before = p;
      p = round + uneven_->wheel(std::atan2(angle->sine, angle->cosine), s);
      r = radius_ + p.z;
      angle = angle_at(p.y, r);
      if (std::abs(p.z - before.z) + std::abs(p.y - before.y) < crossing_distance)
        break;
    }
    if (!angle)
      return std::nullopt;
    const auto coordinate = [&](int i) {
      return frame_.centre[i] + p.y * frame_.axle[i] +
             r * (angle->cosine * frame_.down[i] + angle->sine * frame_.forward[i]);
    };
    return Point2{coordinate(1), coordinate(2) - rail_};
  }

  enum class State { unknown, reached, missed };
  struct Place {
    Point2 position{};
    State state = State::unknown;
  };
  bool reaches(int k) const {
    Place& place = places_[k];
    if (place.state == State::unknown) {
      const TabulatedProfile::Node& node = wheel_.nodes()[first_ + k];
      const auto p = from_section(node.s, node.position);
      place = p ? Place{*p, State::reached} : Place{{}, State::missed};
    }
    return place.state == State::reached;
  }

  const TabulatedProfile& wheel_;
  const WheelFrame& frame_;
  const UnevenSurfaces* uneven_; ///< null: even bodies
  double radius_, x_;
  double rail_; ///< how much lower than a straight rail this one is at x, mm
  int first_;
  mutable std::vector<Place> places_; ///< of the nodes, as far as they were asked for
};

/// The locus as a curve that is crossed.
struct LocusCurve {
  const ContactLocus& locus;

  int last() const { return static_cast<int>(locus.nodes().size()) - 1; }
  Point2 position(int k) const { return locus.nodes()[k].position; }
  bool joined(int k) const { return locus.nodes()[k].joined; }
  ContactLocus::Point between(int k, double t) const { return locus.between(k, t); }
};

struct Crossing {
  int k = 0; ///< between nodes k and k + 1
  double t = 0, distance = excluded_gap;
};

/// The last of the nodes k, k + 1 between which the ray crosses a curve that is walked against it, looked for
/// from `start` on; -1 where there is none.
template <class Curve> int interval_crossed(const Curve& curve, const Ray& ray, int start) {
  const int last = curve.last();
  const auto along = [&](int k) { return ray.along(curve.position(k)); };
  int k = std::clamp(start, 0, last);
  if (along(k) > 0) {
    do {
      if (++k > last || !curve.joined(k))
        return -1;
    } while (along(k) > 0);
    return k - 1;
  }
  do {
    if (k == 0 || !curve.joined(k))
      return -1;
    --k;
  } while (along(k) <= 0);
  return k;
}

/// Where the ray crosses a curve (the wheel's profile or locus), the nearest crossing to node `start`: regula
/// falsi of Anderson and Bjorck (1973), which halves the bracket now and then.
template <class Curve> std::optional<Crossing> crossing_of(const Curve& curve, const Ray& ray, int start) {
  const int k = interval_crossed(curve, ray, start);
  if (k < 0)
    return std::nullopt;
  Point2 p = curve.position(k + 1);
  double a = 0, b = 1, t = 1;
  double ga = ray.along(curve.position(k)), gb = ray.along(p); // ga > 0 >= gb
  for (int i = 0; i < crossing_steps && gb != 0 && std::abs(b - a) > crossing_width; ++i) {
    const bool halve = i % crossing_halving_period == crossing_halving_period - 1;
    t = halve ? 0.5 * (a + b) : b - gb * (b - a) / (gb - ga);
    p = curve.between(k, t).position;
    const double g = ray.along(p);
    if (std::abs(g) < crossing_distance)
      break;
    if ((g > 0) != (gb > 0)) {
      a = b, ga = gb;
    } else {
      const double m = 1 - g / gb;
      ga *= m > 0 ? m : 0.5;
    }
    b = t, gb = g;
  }
  const double distance = ray.outward(p);
  if (distance < -deepest_overlap || distance >= excluded_gap)
    return std::nullopt;
  return Crossing{k, t, distance};
}

/// Finds the nodes of a locus that are nearest to rows. Rows that follow each other are looked at in groups:
/// most groups lie far from the wheel, and to the others few nodes come near (triangle inequality).
class NearestNodes {
public:
  explicit NearestNodes(const ContactLocus& locus) : nodes_(locus.nodes()) {
    for (std::size_t k = 0; k < nodes_.size(); k += node_stride)
      some_.push_back(nodes_[k].position);
  }

  /// One number a row; -1 where the node lies beyond `farthest`.
  std::vector<int> of(std::span<const ContactRow> rows, double farthest = 1e9) {
    std::vector<int> out;
    for (std::size_t i = 0; i < rows.size(); i += rows_together) {
      const auto group = rows.subspan(i, std::min<std::size_t>(rows_together, rows.size() - i));
      const bool in_reach = choose_candidates(group, farthest);
      for (const ContactRow& row : group)
        out.push_back(in_reach ? nearest(row.position, farthest) : -1);
    }
    return out;
  }

private:
  bool choose_candidates(std::span<const ContactRow> group, double farthest);
  int nearest(Point2 p, double farthest) const;

  std::span<const ContactLocus::Node> nodes_;
  std::vector<Point2> some_;    ///< every so many, side by side in memory
  std::vector<double> squares_; ///< of their distances from the middle of the group
  std::vector<int> candidates_; ///< which of them may be the nearest to one of the group
};

double square(Point2 d) {
  return dot(d, d);
}

/// False where no node is near enough to any row of the group.
bool NearestNodes::choose_candidates(std::span<const ContactRow> group, double farthest) {
  const Point2 middle = group[group.size() / 2].position;
  double radius = 0;
  for (const ContactRow& row : group)
    radius = std::max(radius, square(row.position - middle));
  radius = std::sqrt(radius);
  squares_.resize(some_.size());
  std::ranges::transform(some_, squares_.begin(), [&](Point2 p) { return square(p - middle); });
  const double least = std::sqrt(std::ranges::min(squares_));
  if (least > farthest + node_stride * largest_table_step + radius)
    return false;
  const double reach = least + 2 * radius;
  candidates_.clear();
  for (std::size_t k = 0; k < squares_.size(); ++k)
    if (squares_[k] <= reach * reach * (1 + rounding_of_reach))
      candidates_.push_back(static_cast<int>(k));
  return true;
}

int NearestNodes::nearest(Point2 p, double farthest) const {
  const int last = static_cast<int>(nodes_.size()) - 1;
  const auto from = [&](int k) { return square(nodes_[k].position - p); };
  int best = last;
  double least = from(last);
  for (const int k : candidates_)
    if (const double here = square(some_[k] - p); here < least)
      best = k * node_stride, least = here;
  if (std::sqrt(least) > farthest + node_stride * largest_table_step)
    return -1;
  while (best > 0 && from(best - 1) < from(best))
    --best;
  while (best < last && from(best + 1) < from(best))
    ++best;
  return from(best) <= farthest * farthest ? best : -1;
}

} // namespace

std::vector<RowOnLocus> rows_on_locus(const ContactLocus& locus, std::span<const ContactRow> rows,
                                      double farthest) {
  const std::vector<int> nearest = NearestNodes(locus).of(rows, farthest);
  std::vector<RowOnLocus> out(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int near = nearest[i];
    if (near < 0)
      continue;
    const auto found = crossing_of(LocusCurve{locus}, Ray(rows[i]), near);
    if (!found)
      continue;
    const ContactLocus::Point p = locus.between(found->k, found->t);
    out[i] = {found->distance, p.x,    p.s, 0.5 * p.sharper * locus.curvature_along_x(found->k, found->t),
              p.rail_lower,    p.ahead};
  }
  return out;
}

std::vector<double> undeformed_distance(const WheelOnRail& pair, std::span<const RowOnLocus> on_locus,
                                        std::span<const ContactRow> rows, std::span<const double> x) {
  std::vector<double> gap(rows.size() * x.size(), excluded_gap);
  double from = pair.wheel.s_end(), to = pair.wheel.s_begin();
  for (const RowOnLocus& row : on_locus)
    if (row.hit())
      from = std::min(from, row.wheel_s), to = std::max(to, row.wheel_s);
  if (from > to)
    return gap;
  const int first = pair.wheel.interval(from - section_margin, 0);
  const int last = pair.wheel.interval(to + section_margin, first) + 1;
  const WheelFrame frame = pair.wheel_frame();

  std::vector<int> start(rows.size());
  for (std::size_t is = 0; is < rows.size(); ++is)
    start[is] = pair.wheel.interval(on_locus[is].wheel_s, first) - first;
  const auto measure = [&](const WheelSection& section, std::size_t is, std::size_t ix) {
    if (const auto found = crossing_of(section, Ray(rows[is]), start[is])) {
      start[is] = found->k;
      if (!pair.sections)
        gap[is * x.size() + ix] = found->distance;
      else if (const auto deeper = pair.sections->depth(x[ix], rows[is]))
        gap[is * x.size() + ix] = found->distance + *deeper;
    }
  };
  for (std::size_t ix = 0; ix < x.size(); ++ix) {
    const WheelSection section(pair, frame, x[ix], first, last);
    for (std::size_t is = 0; is < rows.size(); ++is) {
      if (!on_locus[is].hit())
        continue;
      if (!pair.roller) {
        measure(section, is, ix);
      } else { // rows of other radii have the same x in other half-planes
        const double phi = pair.roller->angle(x[ix], rows[is].position);
        measure(WheelSection(pair, pair.roller->seen(frame, phi), 0, first, last), is, ix);
      }
    }
  }
  return gap;
}

std::vector<double> wheel_stations(const ContactLocus& locus, std::span<const ContactRow> rows) {
  const std::vector<int> nearest = NearestNodes(locus).of(rows);
  std::vector<double> out;
  const auto& nodes = locus.nodes();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int near = nearest[i];
    // On the stretches beside the node.
    const auto on_locus = [&](double beside) {
      const int k = std::min(static_cast<int>(near + beside), static_cast<int>(nodes.size()) - 2);
      return locus.between(k, near + beside - k);
    };
    const auto from_row = [&](double beside) { return square(on_locus(beside).position - rows[i].position); };
    const bool left = near > 0 && nodes[near].joined;
    const bool right = near + 1 < static_cast<int>(nodes.size()) && nodes[near + 1].joined;
    constexpr int bits = std::numeric_limits<double>::digits / 2;
    const auto minimum =
        boost::math::tools::brent_find_minima(from_row, left ? -1.0 : 0.0, right ? 1.0 : 0.0, bits);
    out.push_back(on_locus(minimum.first).s);
  }
  return out;
}

} // namespace bem_contact
