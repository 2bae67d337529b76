#include "bem_contact/profile/worn/nominal_place.hpp"

#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/worn/outline_table.hpp"
#include "bem_contact/profile/worn/settings.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

using Points = std::vector<Point2>;

/// mm. Where the steps of a fit end.
constexpr double placing_tolerance = 1e-6;
/// 1 (widths of Tukey's weights). Points outside a nominal profile count up to so many times as far off as
/// worn ones: wear takes steel away. Lips of the steel, some tenths high, still do not count. Chosen.
constexpr double outside_widths = 4.0;
/// 1. Of a fit to what lies as near as most does:
constexpr int settling_rounds = 3;
/// mm. but not within less: the rounding of a file.
constexpr double settling_least = 0.01;
/// 1. Starts that are followed: the nearest ones.
constexpr std::size_t searched_places = 5;
/// 1. Places of which the share is asked for,
constexpr std::size_t settled_places = 2;
/// 1. the second if it is off by less than so many times.
constexpr double nearly_as_near = 1.5;
/// 1. Points by which starts are compared. Chosen.
constexpr std::size_t rating_points = 25;
/// 1. Steps of the last fit, on the profile itself.
constexpr int polishing_steps = 6;
/// 1. Points with which a place is looked for. Chosen.
constexpr std::size_t placing_points = 40;
/// 1. Points with which it is found. Chosen.
constexpr std::size_t settling_points = 150;
/// mm. Nearer places are the same,
constexpr double apart_distance = 0.5;
/// rad. if their angles are as near.
constexpr double apart_angle = 5e-3;
/// mm. Chords with which points are placed. Their bulges counted, an arc of 13 mm radius is off by
/// nanometres, the curve at a jump of the curvature by 2 um.
constexpr double outline_chord = 0.5;
/// mm. Points this near to the top (of a wheel: to the tip) say where the middle of it is. Chosen.
constexpr double placing_top = 2.0;

/// The nominal profile as the search sees it.
struct Nominal {
  OutlineTable table;
  bool wheel = false;

  /// What a point at this normal tells, beside one on a flank.
  double told(Point2 normal) const {
    return wheel ? 1.0 : told_on_top + (1 - told_on_top) * normal.y * normal.y;
  }
};

/// Tukey's weight; `width` is where it ends for worn points.
double weight_of(double depth, double width) {
  const double share = depth / (depth < 0 ? outside_widths * width : width), root = 1 - share * share;
  return root > 0 ? root * root : 0.0;
}

Eigen::Vector3d change_of(Point2 at, Point2 normal) {
  return {normal.y, normal.z, cross(at, normal) / placing_arm};
}

/// Sums of a step of weighted least squares over the depths.
struct Fit {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double total = 0;

  void add(Point2 at, Point2 normal, double depth, double weight) {
    if (weight == 0)
      return;
    const Eigen::Vector3d change = change_of(at, normal);
    matrix += weight * change * change.transpose();
    right += weight * depth * change;
    total += weight;
  }
  /// Returns how far it moves, mm.
  double move(NominalPlace& place) {
    matrix.diagonal().array() += placing_damping * total + std::numeric_limits<double>::min();
    const Eigen::Vector3d by = matrix.ldlt().solve(right);
    place.shift = place.shift + turned({by[0], by[1]}, place.angle);
    place.angle += by[2] / placing_arm;
    return by.norm();
  }
};

/// Calls look(seen, point in the nominal frame) for each point that is not beyond an end.
template <class Look>
void look_at(const Nominal& nominal, const Points& points, const NominalPlace& place, Look look) {
  const Turn back(-place.angle);
  std::size_t near = 0;
  for (const Point2 p : points) {
    const Point2 q = back(p - place.shift);
    if (const OutlineTable::Seen seen = nominal.table.see(q, near); !seen.beyond)
      look(seen, q);
  }
}

/// False if it runs away.
bool refine(NominalPlace& place, const Nominal& nominal, const Points& points, double width, int steps,
            double tolerance) {
  for (int i = 0; i < steps; ++i) {
    Fit fit;
    double on = 0;
    look_at(nominal, points, place, [&](const OutlineTable::Seen& seen, Point2 q) {
      const double weight = weight_of(seen.depth, width);
      on += weight;
      fit.add(q, seen.normal, seen.depth, weight * nominal.told(seen.normal));
    });
    if (on < least_placing_weight * static_cast<double>(points.size()))
      return false;
    const double moved = fit.move(place);
    if (std::abs(place.angle) > largest_placing_angle)
      return false;
    if (moved < tolerance)
      break;
  }
  return true;
}

/// Within which a point counts as unworn, mm.
double unworn_within(double scatter) {
  return std::max(unworn_distance, placing_scatters * scatter);
}

/// From a place that is nearly right: by what may be unworn, then by what lies as near as most of that does,
/// because wear begins slowly. Returns the last width, mm; 0 if it runs away.
double fit_robustly(NominalPlace& place, const Nominal& nominal, const Points& points, double scatter) {
  const double within = unworn_within(scatter);
  double width = 2 * within;
  if (!refine(place, nominal, points, width, settling_steps, searching_tolerance))
    return 0;
  for (int round = 0; round < settling_rounds; ++round) {
    std::vector<double> distances;
    look_at(nominal, points, place, [&](const OutlineTable::Seen& seen, Point2) {
      if (std::abs(seen.depth) < within)
        distances.push_back(std::abs(seen.depth));
    });
    if (distances.empty())
      return 0;
    width = std::clamp(settling_medians * median(std::move(distances)), settling_least, 2 * within);
    if (!refine(place, nominal, points, width, settling_steps, searching_tolerance))
      return 0;
  }
  return width;
}

UnwornPlace judged(const NominalPlace& place, const Nominal& nominal, const Points& points, double scatter) {
  const double within = unworn_within(scatter);
  double on = 0, outside = 0;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  look_at(nominal, points, place, [&](const OutlineTable::Seen& seen, Point2 q) {
    if (seen.depth < -within)
      ++outside;
    else if (seen.depth < within) {
      ++on;
      const Eigen::Vector3d change = change_of(q, seen.normal);
      stiffness += change * change.transpose();
    }
  });
  const auto count = static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(stiffness / std::max(on, 1.0));
  return {place, on / count, outside / count, solver.eigenvalues()[0]};
}

/// Middle, along y, and height of what is near the top of a rail, or near the tip of a wheel's flange.
Point2 top_of(const Points& points, bool wheel) {
  const double top =
      wheel ? std::ranges::max(points, {}, &Point2::z).z : std::ranges::min(points, {}, &Point2::z).z;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point2 p : points)
    if (std::abs(p.z - top) < placing_top) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  return {(low + high) / 2, top};
}

/// Places from which the search begins: the file's own frame, and the tops laid on each other.
std::vector<NominalPlace> starts(const Nominal& nominal, const Points& points) {
  Points its;
  for (std::size_t i = 0; i < nominal.table.chords().size(); ++i)
    its.push_back(nominal.table.middle_of(i));
  std::vector<NominalPlace> out{{}};
  for (const double angle : placing_angles) {
    Points turned_points;
    const Turn back(-angle);
    for (const Point2 p : points)
      turned_points.push_back(back(p));
    const Point2 shift = top_of(turned_points, nominal.wheel) - top_of(its, nominal.wheel);
    for (const double side : placing_sides)
      out.push_back({turned(shift + Point2{side, 0}, angle), angle});
  }
  return out;
}

/// Mean distance, where more than `most` (mm) counts as that.
double roughly_off(const NominalPlace& place, const Nominal& nominal, const Points& points, double most) {
  double sum = most * static_cast<double>(points.size());
  look_at(nominal, points, place, [&](const OutlineTable::Seen& seen, Point2) {
    sum -= most - std::min(most, std::abs(seen.depth));
  });
  return sum / static_cast<double>(points.size());
}

Points few_of(std::span<const Point2> points, std::size_t count) {
  Points out;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / count);
  for (std::size_t i = 0; i < points.size(); i += stride)
    out.push_back(points[i]);
  return out;
}

bool same_place(const NominalPlace& a, const NominalPlace& b) {
  return norm(a.shift - b.shift) < apart_distance && std::abs(a.angle - b.angle) < apart_angle;
}

/// Which places are taken: at most `count`, off by at most `ratio` times what the best is; more than
/// `farthest` (mm) counts as that.
struct Choice {
  double farthest = 0;
  std::size_t count = 0;
  double ratio = std::numeric_limits<double>::infinity();
};

/// The places at which the points are least off, the best first, none twice.
std::vector<NominalPlace> best_of(const std::vector<NominalPlace>& places, const Nominal& nominal,
                                  const Points& points, const Choice& choice) {
  std::vector<std::pair<double, NominalPlace>> rated;
  for (const NominalPlace& place : places)
    rated.emplace_back(roughly_off(place, nominal, points, choice.farthest), place);
  std::ranges::stable_sort(rated, {}, &std::pair<double, NominalPlace>::first);
  std::vector<NominalPlace> out;
  for (const auto& one : rated)
    if (out.size() < choice.count && one.first <= choice.ratio * rated.front().first &&
        std::ranges::none_of(out, [&](const NominalPlace& other) { return same_place(other, one.second); }))
      out.push_back(one.second);
  return out;
}

/// The search ends at these, the best first.
std::vector<NominalPlace> searched(const Nominal& nominal, std::span<const Point2> points) {
  const Points few = few_of(points, placing_points);
  std::vector<NominalPlace> out;
  for (NominalPlace place : best_of(starts(nominal, few), nominal, few_of(points, rating_points),
                                    {placing_widths[0], searched_places})) {
    bool good = true;
    for (const double width : placing_widths)
      good = good && refine(place, nominal, few, width, searching_steps, searching_tolerance);
    if (good)
      out.push_back(place);
  }
  const double last_width = placing_widths[std::size(placing_widths) - 1];
  return best_of(out, nominal, few, {last_width, settled_places, nearly_as_near});
}

struct Settled {
  UnwornPlace at;
  double width = 0; ///< mm
};

std::vector<Settled> settled_places_of(const Nominal& nominal, std::span<const Point2> points,
                                       double scatter) {
  const Points many = few_of(points, settling_points);
  std::vector<Settled> out;
  for (NominalPlace place : searched(nominal, points)) {
    const double width = fit_robustly(place, nominal, many, scatter);
    if (width > 0 && std::ranges::none_of(out, [&](auto& o) { return same_place(o.at.place, place); }))
      out.push_back({judged(place, nominal, many, scatter), width});
  }
  std::ranges::stable_sort(out, std::greater{}, [](const Settled& s) { return s.at.share - s.at.outside; });
  return out;
}

Nominal nominal_of(const ProfileCurve& curve) {
  return {OutlineTable::of_joints(curve, outline_chord), is_wheel(curve)};
}

} // namespace

PointOnNominal seen_from(const ProfileCurve& nominal, Point2 measured, const NominalPlace& place) {
  const Point2 q = place.to_nominal(measured);
  const CurvePoint foot = nominal.nearest(q);
  const Point2 normal = normal_of(foot.delta);
  const double along = dot(q - foot.position, tangent_of(foot.delta)); // 0 but at the ends
  return {foot.s, normal, dot(q - foot.position, normal), std::abs(along) > beyond_end};
}

bool is_wheel(const ProfileCurve& curve) {
  return curve.at(curve.s_end()).position.y < curve.at(curve.s_begin()).position.y;
}

std::vector<UnwornPlace> unworn_places(const ProfileCurve& nominal, std::span<const Point2> points,
                                       double scatter) {
  std::vector<UnwornPlace> out;
  for (const Settled& settled : settled_places_of(nominal_of(nominal), points, scatter))
    out.push_back(settled.at);
  return out;
}

NominalPlace place_nominal(const ProfileCurve& curve, std::span<const Point2> points, double scatter) {
  const Nominal nominal = nominal_of(curve);
  const std::vector<Settled> places = settled_places_of(nominal, points, scatter);
  if (places.empty())
    return starts(nominal, few_of(points, placing_points))[1];
  auto [best, width] = places.front();
  const Points many = few_of(points, settling_points);
  for (int i = 0; i < polishing_steps; ++i) { // the table is off by its chords
    Fit fit;
    for (const Point2 p : many)
      if (const PointOnNominal seen = seen_from(curve, p, best.place); !seen.beyond)
        fit.add(best.place.to_nominal(p), seen.normal, seen.depth,
                weight_of(seen.depth, width) * nominal.told(seen.normal));
    if (fit.move(best.place) < placing_tolerance)
      break;
  }
  return best.place;
}

} // namespace bem_contact
