#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <cstddef>
#include <vector>

namespace bem_contact {

/// A profile curve as chords with their bulges, so that many points can be seen from it: a point costs some
/// tens of nanoseconds. Distances are those of the curve to some micrometres at most.
class OutlineTable {
public:
  /// Chords from joint to joint of the curve, at most `step` mm long.
  static OutlineTable of_joints(const ProfileCurve& curve, double step);
  /// This many chords, equally long along the curve, whatever its joints.
  static OutlineTable of_equal(const ProfileCurve& curve, int chords);

  /// A point as seen from the curve.
  struct Seen {
    double depth = 0;    ///< along the normal, into the body, mm
    Point2 normal;       ///< of the curve there, into the body
    bool beyond = false; ///< it lies more than beyond_end (settings.hpp) beyond an end
  };
  /// `near`: the chord of the point before, from which the nearest one is looked for; it becomes this
  /// point's.
  Seen see(Point2 p, std::size_t& near) const;

  struct Chord {
    Point2 from, along; ///< unit vector
    double length = 0;  ///< mm
    double bulge = 0;   ///< of the curve's middle over the chord, along the normal, mm
  };
  const std::vector<Chord>& chords() const { return chords_; }
  Point2 middle_of(std::size_t chord) const;

private:
  OutlineTable(const ProfileCurve& curve, const std::vector<double>& s);
  /// Square of the distance to the middle of a chord.
  double squared(std::size_t chord, Point2 p) const;
  /// Walks to the chord whose neighbours are farther, and returns the square of its distance.
  double walk(Point2 p, std::size_t& near) const;
  std::size_t nearest_of_some(Point2 p) const;

  std::vector<Chord> chords_;
};

} // namespace bem_contact
