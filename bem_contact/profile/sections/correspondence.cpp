#include "bem_contact/profile/sections/correspondence.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <limits>

namespace bem_contact {

namespace {

/// mm. Points that are laid beside each other are so far apart: a fillet of 3 mm has some.
constexpr double spacing = 1.0;
/// mm/rad. What a difference of directions counts: a corner of this radius is told from its neighbours.
constexpr double direction_length = 10.0;
/// mm. Pairs that are kept as marks are so far apart: between them arc lengths grow evenly.
constexpr double mark_spacing = 10.0;
/// mm. A mark this far beyond what a neighbour has is its end: rounding.
constexpr double kept_end = 1e-9;
/// 1. How often the second profile is moved to where the first one is: once is enough for a rail that rises,
/// twice for one that widens too.
constexpr int shift_steps = 2;

/// How far two points are apart where the second profile is moved by `shift`.
double difference(const CurvePoint& a, const CurvePoint& b, Point2 shift) {
  return norm(a.position - b.position - shift) + direction_length * std::abs(a.delta - b.delta);
}

using Pairs = std::vector<std::pair<int, int>>;

/// Pairs of points of two profiles in walking order, from end to end, of the least sum of differences.
Pairs aligned(const std::vector<CurvePoint>& a, const std::vector<CurvePoint>& b, Point2 shift) {
  const int rows = static_cast<int>(a.size()), columns = static_cast<int>(b.size());
  std::vector<double> cost(static_cast<std::size_t>(rows) * columns);
  std::vector<char> from(cost.size());
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i) * columns + j; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      double least = i == 0 && j == 0 ? 0 : std::numeric_limits<double>::infinity();
      char step = 0;
      const auto offer = [&](int di, int dj, char by) {
        if (i >= di && j >= dj && cost[at(i - di, j - dj)] < least)
          least = cost[at(i - di, j - dj)], step = by;
      };
      offer(1, 1, 1);
      offer(1, 0, 2);
      offer(0, 1, 3);
      cost[at(i, j)] = least + difference(a[i], b[j], shift);
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
double refined(const CurvePoint& p, Point2 shift, const ProfileCurve& curve, double near) {
  const double low = std::max(near - spacing, curve.s_begin()),
               high = std::min(near + spacing, curve.s_end());
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

  Beside(const ProfileCurve& first, const ProfileCurve& second)
      : a(points_along(first, spacing)), b(points_along(second, spacing)), second_(second) {
    const auto top = [](const std::vector<CurvePoint>& points) {
      return std::ranges::min(points, {}, [](const CurvePoint& p) { return p.position.z; }).position.z;
    };
    shift = {0, top(a) - top(b)};
    pairs = aligned(a, b, shift);
    for (int i = 0; i < shift_steps; ++i) {
      shift = middle_shift();
      pairs = aligned(a, b, shift);
    }
    leave_out_ends();
  }

  double mean() const {
    double sum = 0;
    for (const auto& [i, j] : pairs)
      sum += difference(a[i], b[j], shift);
    return sum / static_cast<double>(pairs.size());
  }

private:
  /// The median of what points of the first are apart from those of the second that correspond, along y and
  /// z.
  Point2 middle_shift() const {
    std::vector<Point2> apart;
    for (const auto& [i, j] : pairs)
      apart.push_back(a[i].position -
                      second_.at(refined(a[i], {-shift.y, -shift.z}, second_, b[j].s)).position);
    const auto median = [&](double Point2::*along) {
      std::ranges::nth_element(apart, apart.begin() + apart.size() / 2, {}, along);
      return apart[apart.size() / 2].*along;
    };
    const double y = median(&Point2::y);
    return {y, median(&Point2::z)};
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
};

/// The place on the second profile that belongs to one on the first, mm.
class Follower {
public:
  Follower(const ProfileCurve& a, const ProfileCurve& b) : a_(a), b_(b) {
    const Beside beside(a, b);
    shift_ = beside.shift;
    for (const auto& [i, j] : beside.pairs)
      pairs_.emplace_back(beside.a[i].s, beside.b[j].s);
    for (auto* end : {&pairs_.front(), &pairs_.back()}) // the end of the shorter one, on the longer
      end->first = refined(b.at(end->second), shift_, a, end->first);
  }
  double first() const { return pairs_.front().first; }
  double last() const { return pairs_.back().first; }
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

} // namespace

std::vector<std::vector<double>> corresponding_points(const std::vector<BodySection>& sections) {
  // Each mark is followed from the first section to the last. Marks that leave a section at its end are
  // dropped, and so is what is too near to the mark before it.
  const ProfileCurve& first = sections.front().profile;
  const int count = std::max(1, static_cast<int>((first.s_end() - first.s_begin()) / mark_spacing));
  std::vector<std::vector<double>> followed(count + 1);
  for (int k = 0; k <= count; ++k)
    followed[k] = {first.s_begin() + (first.s_end() - first.s_begin()) * k / count};
  for (std::size_t j = 1; j < sections.size(); ++j) {
    const Follower next(sections[j - 1].profile, sections[j].profile);
    std::erase_if(followed, [&](const auto& line) {
      return line.back() < next.first() - kept_end || line.back() > next.last() + kept_end;
    });
    for (std::vector<double>& line : followed)
      line.push_back(next.at(line.back()));
  }
  std::vector<std::vector<double>> marks(sections.size());
  const auto keeps = [&](const std::vector<double>& line) {
    for (std::size_t j = 0; j < marks.size(); ++j)
      if (!marks[j].empty() && !(line[j] > marks[j].back() + 0.2 * mark_spacing))
        return false;
    return true;
  };
  for (const std::vector<double>& line : followed)
    if (keeps(line))
      for (std::size_t j = 0; j < marks.size(); ++j)
        marks[j].push_back(line[j]);
  return marks;
}

double distance_of_profiles(const ProfileCurve& a, const ProfileCurve& b) {
  return Beside(a, b).mean();
}

ProfileCurve mirrored(const ProfileCurve& profile) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(profile, spacing))
    points.insert(points.begin(), {-p.position.y, p.position.z});
  return ProfileCurve::through_points(profile.name(), points);
}

} // namespace bem_contact
