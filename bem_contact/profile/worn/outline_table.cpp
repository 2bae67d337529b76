#include "bem_contact/profile/worn/outline_table.hpp"

#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/worn/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact {

namespace {

/// 1. Of so many chords one is looked at where a point is far from the one before.
constexpr std::size_t looked_at_chords = 6;
/// mm. A point that is farther from the chord of the point before may be nearer to another part of the curve.
constexpr double far_from_chord = 6.0;

} // namespace

OutlineTable::OutlineTable(const ProfileCurve& curve, const std::vector<double>& s) {
  Point2 from = curve.at(s.front()).position;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const Point2 to = curve.at(s[i + 1]).position, chord = to - from;
    const double length = norm(chord);
    const Point2 along = (1 / length) * chord, normal{-along.z, along.y};
    chords_.push_back({from, along, length, dot(curve.at((s[i] + s[i + 1]) / 2).position - from, normal)});
    from = to;
  }
}

OutlineTable OutlineTable::of_joints(const ProfileCurve& curve, double step) {
  const std::vector<double> joints = curve.joints();
  std::vector<double> s{joints.front()};
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const double length = joints[i] - joints[i - 1];
    if (length < crowded)
      continue;
    const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 1; k <= count; ++k)
      s.push_back(joints[i - 1] + length * k / count);
  }
  return {curve, s};
}

OutlineTable OutlineTable::of_equal(const ProfileCurve& curve, int chords) {
  std::vector<double> s;
  for (int i = 0; i <= chords; ++i)
    s.push_back(curve.s_begin() + (curve.s_end() - curve.s_begin()) * i / chords);
  return {curve, s};
}

Point2 OutlineTable::middle_of(std::size_t chord) const {
  const Chord& c = chords_[chord];
  return c.from + (c.length / 2) * c.along + c.bulge * Point2{-c.along.z, c.along.y};
}

double OutlineTable::squared(std::size_t chord, Point2 p) const {
  const Chord& c = chords_[chord];
  const Point2 r = p - c.from - (c.length / 2) * c.along;
  return dot(r, r);
}

double OutlineTable::walk(Point2 p, std::size_t& near) const {
  double square = squared(near, p);
  for (const std::size_t step : {std::size_t{1}, static_cast<std::size_t>(-1)}) // on, or back by one
    while (near + step < chords_.size()) {
      const double next = squared(near + step, p);
      if (next >= square)
        break;
      square = next;
      near += step;
    }
  return square;
}

std::size_t OutlineTable::nearest_of_some(Point2 p) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chords_.size(); i += looked_at_chords)
    if (const double square = squared(i, p); square < least) {
      least = square;
      best = i;
    }
  return best;
}

OutlineTable::Seen OutlineTable::see(Point2 p, std::size_t& near) const {
  if (walk(p, near) > far_from_chord * far_from_chord) { // another part of the curve may be nearer
    near = nearest_of_some(p);
    walk(p, near);
  }
  if (const double over = dot(p - chords_[near].from, chords_[near].along); over < 0 && near > 0)
    --near;
  else if (over > chords_[near].length && near + 1 < chords_.size())
    ++near;
  const Chord& c = chords_[near];
  const Point2 r = p - c.from, normal{-c.along.z, c.along.y};
  const double along = dot(r, c.along), u = std::clamp(along / c.length, 0.0, 1.0);
  // The curve over its chord is a parabola.
  const double height = 4 * c.bulge * u * (1 - u), slope = 4 * c.bulge * (1 - 2 * u) / c.length;
  const double scale = 1 / std::sqrt(1 + slope * slope);
  const bool before = near == 0 && along < -beyond_end,
             after = near + 1 == chords_.size() && along > c.length + beyond_end;
  return {(dot(r, normal) - height) * scale, scale * (normal - slope * c.along), before || after};
}

} // namespace bem_contact
