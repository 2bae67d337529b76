#include "bem_contact/profile/sections/correspondence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/median.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

/// mm. Points that are laid beside each other are so far apart: a fillet of 3 mm has some.
constexpr double spacing = 1.0;
/// mm. The same where only the distance of two profiles is asked for: it takes a fifth of the time.
constexpr double wide_spacing = 3.0;
/// mm/rad. What a difference of directions counts: a corner of this radius is told from its neighbours.
constexpr double direction_length = 10.0;
/// mm. Pairs that are kept as marks are so far apart: between them arc lengths grow evenly.
constexpr double mark_spacing = 10.0;
/// mm. A mark this far beyond what a neighbour has is its end: rounding.
constexpr double kept_end = 1e-9;
/// mm. A point at the end of one profile that has no counterpart on the other counts as one that is so far
/// off: more than neighbours differ, less than from a nose to a wing.
constexpr double without_counterpart = 5.0;
/// mm. Where a part of a section shrinks to nothing its lines keep this distance.
constexpr double least_mark_distance = 2.0;
/// mm. Where a section reaches so far beyond all lines, others begin: a nose that was not there before.
constexpr double reach_of_new_lines = 20.0;
/// 1. How often the second profile is moved to where the first one is: once is enough for a rail that rises,
/// twice for one that widens too.
constexpr int shift_steps = 2;
/// mm. Profiles that differ by less where they lie are not looked for elsewhere.
constexpr double near_by = 1.0;
/// 1. A profile has moved to the side where it fits so many times better there. Chosen.
constexpr double moved_fits = 2;

/// How far two points are apart where the second profile is moved by `shift`.
double difference(const CurvePoint& a, const CurvePoint& b, Point2 shift) {
  return norm(a.position - b.position - shift) + direction_length * std::abs(a.delta - b.delta);
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

using Pairs = std::vector<std::pair<int, int>>;

/// Pairs of points of two profiles in walking order, from end to end, of the least sum of differences.
Pairs aligned(const std::vector<CurvePoint>& a, const std::vector<CurvePoint>& b, Point2 shift) {
  const int rows = static_cast<int>(a.size()), columns = static_cast<int>(b.size());
  std::vector<double> cost(static_cast<std::size_t>(rows) * columns);
  std::vector<char> from(cost.size());
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i) * columns + j; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double here = difference(a[i], b[j], shift), at_end = std::min(here, without_counterpart);
      double least = i == 0 && j == 0 ? here : std::numeric_limits<double>::infinity();
      char step = 0;
      const auto offer = [&](int di, int dj, char by, double own) {
        if (i >= di && j >= dj && cost[at(i - di, j - dj)] + own < least)
          least = cost[at(i - di, j - dj)] + own, step = by;
      };
      offer(1, 1, 1, here);
      offer(1, 0, 2, j == 0 || j == columns - 1 ? at_end : here);
      offer(0, 1, 3, i == 0 || i == rows - 1 ? at_end : here);
      cost[at(i, j)] = least;
      from[at(i, j)] = step;
    }
  Pairs out;
  for (int i = rows - 1, j = columns - 1;;) {
    out.emplace_back(i, j);
    const char step = from[at(i, j)];
    if (step == 0)
      break;
    i -= step != 3 ? 1 : 0;
    j -= step != 2 ? 1 : 0;
  }
  std::ranges::reverse(out);
  return out;
}

/// The arc length on `curve` of the point that corresponds to `p`, which is moved by `shift`, near `near`.
double refined(const CurvePoint& p, Point2 shift, const ProfileCurve& curve, double near,
               double reach = spacing) {
  const double low = std::max(near - reach, curve.s_begin()), high = std::min(near + reach, curve.s_end());
  const auto apart = [&](double s) {
    const CurvePoint q = curve.at(s);
    const double turn = direction_length * (p.delta - q.delta);
    const Point2 off = p.position + shift - q.position;
    return dot(off, off) + turn * turn;
  };
  const double found =
      boost::math::tools::brent_find_minima(apart, low, high, std::numeric_limits<double>::digits / 2).first;
  return apart(near) <= apart(found) ? near : found;
}

/// Two profiles that lie beside each other, wherever they are: how far the second must be moved for that, and
/// which of its points then correspond to those of the first.
struct Beside {
  std::vector<CurvePoint> a, b;
  Pairs pairs;
  Point2 shift;

  Beside(const ProfileCurve& first, const ProfileCurve& second, double step = spacing)
      : a(points_along(first, step)), b(points_along(second, step)), second_(second), step_(step) {
    const auto top = [](const std::vector<CurvePoint>& points) {
      return std::ranges::min(points, {}, [](const CurvePoint& p) { return p.position.z; }).position.z;
    };
    const double up = top(a) - top(b);
    move_from({0, up});
    if (misfit() < near_by)
      return;
    Beside best = *this; // a rail that leads to the side: one of its ends lies beside that of the other
    for (const double aside :
         {a.front().position.y - b.front().position.y, a.back().position.y - b.back().position.y}) {
      move_from({aside, up});
      if (moved_fits * misfit() < best.misfit())
        best.take(*this);
    }
    take(best);
  }

  double mean() const {
    double sum = 0;
    for (const auto& [i, j] : pairs)
      sum += difference(a[i], b[j], shift);
    return sum / static_cast<double>(pairs.size());
  }
  /// The same between points and the curve, without what the distance of points adds.
  double mean_off() const {
    double sum = 0;
    for (const auto& [i, j] : pairs) {
      const CurvePoint q = second_.at(refined(a[i], {-shift.y, -shift.z}, second_, b[j].s, step_));
      sum += difference(a[i], q, shift);
    }
    return sum / static_cast<double>(pairs.size());
  }

private:
  void take(const Beside& other) { pairs = other.pairs, shift = other.shift; }
  void move_from(Point2 first) {
    shift = first;
    align();
    for (int i = 0; i < shift_steps; ++i) {
      shift = middle_shift();
      align();
    }
  }
  /// mm. mean(), and what of the shorter profile lies beside nothing.
  double misfit() const {
    const auto share = [](int first, int last, std::size_t count) {
      return 1 - static_cast<double>(last - first + 1) / static_cast<double>(count);
    };
    return mean() +
           without_counterpart * std::min(share(pairs.front().first, pairs.back().first, a.size()),
                                          share(pairs.front().second, pairs.back().second, b.size()));
  }
  void align() {
    pairs = aligned(a, b, shift);
    leave_out_ends();
  }
  /// The median of what points of the first are apart from those of the second that correspond: along y of
  /// steep ones, along z of flat ones. Along a face points say nothing.
  Point2 middle_shift() const {
    std::vector<double> y, z;
    for (const auto& [i, j] : pairs) {
      const Point2 apart =
          a[i].position - second_.at(refined(a[i], {-shift.y, -shift.z}, second_, b[j].s, step_)).position;
      std::abs(std::sin(a[i].delta)) > std::sqrt(0.5) ? y.push_back(apart.y) : z.push_back(apart.z);
    }
    return {y.empty() ? shift.y : median(std::move(y)), z.empty() ? shift.z : median(std::move(z))};
  }
  /// Where one profile goes on beyond the end of the other, only the nearest of its points corresponds to
  /// that end.
  void leave_out_ends() {
    const auto run = [](auto begin, auto end) { // of pairs with the same point of one profile
      auto first = begin, second = begin;
      while (first != end && first->first == begin->first)
        ++first;
      while (second != end && second->second == begin->second)
        ++second;
      return std::max(first, second);
    };
    const auto apart = [&](const std::pair<int, int>& p) {
      return difference(a[p.first], b[p.second], shift);
    };
    for (int end = 0; end < 2; ++end) {
      pairs.erase(pairs.begin(),
                  std::ranges::min_element(pairs.begin(), run(pairs.begin(), pairs.end()), {}, apart));
      std::ranges::reverse(pairs);
    }
  }

  const ProfileCurve& second_;
  double step_; ///< mm
};

/// The place on the second profile that belongs to one on the first, mm.
class Follower {
public:
  Follower(const ProfileCurve& a, const ProfileCurve& b) : a_(a), b_(b) {
    const Beside beside(a, b);
    shift_ = beside.shift;
    for (const auto& [i, j] : beside.pairs)
      pairs_.emplace_back(beside.a[i].s, beside.b[j].s);
    // The end of the shorter one, on the longer.
    const int last = static_cast<int>(beside.a.size()) - 1;
    for (const auto& [pair, end] : {std::pair{&pairs_.front(), beside.pairs.front().first == 0},
                                    std::pair{&pairs_.back(), beside.pairs.back().first == last}})
      if (end)
        pair->second = refined(a.at(pair->first), {-shift_.y, -shift_.z}, b, pair->second);
      else
        pair->first = refined(b.at(pair->second), shift_, a, pair->first);
  }
  double first() const { return pairs_.front().first; }
  double last() const { return pairs_.back().first; }
  double end() const { return b_.s_end(); } ///< of the second profile
  double at(double s) const {
    const auto after = std::ranges::lower_bound(pairs_, s, {}, &std::pair<double, double>::first);
    if (after == pairs_.end())
      return pairs_.back().second;
    if (after == pairs_.begin() || after->first == s)
      return refined(a_.at(s), {-shift_.y, -shift_.z}, b_, after->second);
    const auto& [s0, t0] = *(after - 1);
    const double share = after->first > s0 ? (s - s0) / (after->first - s0) : 0;
    return refined(a_.at(s), {-shift_.y, -shift_.z}, b_, t0 + share * (after->second - t0));
  }

private:
  const ProfileCurve &a_, &b_;
  Point2 shift_{};
  std::vector<std::pair<double, double>> pairs_;
};

/// Lines through the sections so far. Those of one section follow each other without a gap. A line that
/// leaves a section at its end ends there; where a section reaches beyond all lines, others begin.
class FollowedLines {
public:
  explicit FollowedLines(const ProfileCurve& first) { add_section(), begin(first); }

  /// To the next section; false where fewer than two lines go on.
  bool follow(const Follower& next) {
    add_line_at(next.first());
    add_line_at(next.last());
    const auto [first, last] = range_;
    range_ = {last, first};
    const std::vector<double> here = points_.marks.back();
    add_section();
    points_.joined.emplace_back(here.size(), 0);
    double least = -std::numeric_limits<double>::infinity();
    for (int k = first; k < last; ++k) {
      const double s = std::max(next.at(here[k]), least);
      if (here[k] < next.first() - kept_end || here[k] > next.last() + kept_end || s > next.end())
        continue;
      points_.marks.back()[k] = s;
      points_.joined.back()[k] = 1;
      least = s + least_mark_distance;
      range_ = {std::min(range_.first, k), std::max(range_.second, k + 1)};
    }
    return range_.second - range_.first >= 2;
  }

  /// Lines where this section, the last one so far, reaches beyond those that there are.
  void begin(const ProfileCurve& profile) {
    const bool none = range_.first == range_.second;
    const double from = none ? profile.s_end() : points_.marks.back()[range_.first],
                 to = none ? profile.s_end() : points_.marks.back()[range_.second - 1];
    if (const double reach = from - profile.s_begin(); reach > reach_of_new_lines || none) {
      const int count = std::max(1, static_cast<int>(reach / mark_spacing));
      insert_columns(0, std::max(0, count - range_.first));
      for (int k = 1; k <= count; ++k)
        points_.marks.back()[--range_.first] = from - reach * k / count;
      if (none)
        insert_columns(range_.second, 1), points_.marks.back()[range_.second++] = to;
    }
    if (const double reach = profile.s_end() - to; reach > reach_of_new_lines) {
      const int count = static_cast<int>(reach / mark_spacing);
      insert_columns(columns(), std::max(0, range_.second + count - columns()));
      for (int k = 1; k <= count; ++k)
        points_.marks.back()[range_.second++] = to + reach * k / count;
    }
  }

  const CorrespondingPoints& points() const { return points_; }

private:
  int columns() const { return static_cast<int>(points_.marks.front().size()); }
  void add_section() {
    const std::size_t size = points_.marks.empty() ? 0 : points_.marks.front().size();
    points_.marks.emplace_back(size, nowhere);
  }
  /// A line at s of the last section, between two that there are: what goes on ends there. It runs between
  /// these two as far back as both do, and leaves the surface as it is.
  void add_line_at(double s) {
    const std::vector<double>& last = points_.marks.back();
    int k = range_.first;
    while (k + 1 < range_.second && last[k + 1] < s)
      ++k;
    if (k + 1 >= range_.second || s - last[k] < least_mark_distance || last[k + 1] - s < least_mark_distance)
      return;
    const double share = (s - last[k]) / (last[k + 1] - last[k]);
    for (std::vector<double>& of : points_.marks) // nan where one of both is
      of.insert(of.begin() + k + 1, of[k] + share * (of[k + 1] - of[k]));
    for (std::vector<char>& of : points_.joined)
      of.insert(of.begin() + k + 1, of[k] && of[k + 1]);
    ++range_.second;
  }
  void insert_columns(int at, int count) {
    for (std::vector<double>& of : points_.marks)
      of.insert(of.begin() + at, count, nowhere);
    for (std::vector<char>& of : points_.joined)
      of.insert(of.begin() + at, count, 0);
    if (at <= range_.first)
      range_ = {range_.first + count, range_.second + count};
  }
  CorrespondingPoints points_;
  std::pair<int, int> range_{0, 0}; ///< the lines that the last section has
};

} // namespace

CorrespondingPoints given_points(const std::vector<BodySection>& sections) {
  CorrespondingPoints out;
  for (const BodySection& section : sections)
    out.marks.push_back(section.features);
  for (std::size_t j = 0; j + 1 < sections.size(); ++j) {
    std::vector<char>& joined = out.joined.emplace_back();
    for (std::size_t k = 0; k < out.marks[j].size(); ++k)
      joined.push_back(std::isfinite(out.marks[j][k]) && std::isfinite(out.marks[j + 1][k]) ? 1 : 0);
  }
  return out;
}

CorrespondingPoints corresponding_points(const std::vector<BodySection>& sections) {
  FollowedLines lines(sections.front().profile);
  for (std::size_t j = 1; j < sections.size(); ++j) {
    const Follower next(sections[j - 1].profile, sections[j].profile);
    if (!lines.follow(next))
      throw InputError(
          fmt::format("Sections {} ('{}' at {:g} mm) and {} ('{}' at {:g} mm) have nothing in common", j,
                      sections[j - 1].profile.name(), sections[j - 1].at, j + 1, sections[j].profile.name(),
                      sections[j].at),
          "no part of the one was found in the other", "Give the features of all sections.");
    lines.begin(sections[j].profile);
  }
  return lines.points();
}

double distance_of_profiles(const ProfileCurve& a, const ProfileCurve& b) {
  return a.digest() == b.digest() ? 0 : Beside(a, b, wide_spacing).mean_off();
}

ProfileCurve mirrored(const ProfileCurve& profile) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(profile, spacing))
    points.insert(points.begin(), {-p.position.y, p.position.z});
  return ProfileCurve::through_points(profile.name(), points);
}

} // namespace bem_contact
