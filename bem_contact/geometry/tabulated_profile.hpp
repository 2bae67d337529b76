#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <memory>
#include <span>

namespace bem_contact {

/// A profile curve with a table of it, made once for a sequence of cases: positions and unit tangents at
/// the joints of its pieces and at most 0.1 mm apart, cubic Hermite between. The table is as near to the
/// curve as 1e-9 mm and a point of it costs a fiftieth. Cheap to copy: copies share curve and table.
class TabulatedProfile {
public:
  TabulatedProfile(ProfileCurve curve); // a ProfileCurve serves wherever one is asked for

  const ProfileCurve& curve() const { return data_->curve; }
  const std::string& name() const { return curve().name(); }
  double s_begin() const { return curve().s_begin(); }
  double s_end() const { return curve().s_end(); }
  CurvePoint at(double s) const { return curve().at(s); }
  CurvePoint nearest(Point2 p) const { return curve().nearest(p); }
  std::uint64_t digest() const { return data_->digest; } ///< ProfileCurve::digest

  /// Unit tangents differ where the profile has a kink.
  struct Node {
    double s = 0; ///< mm
    Point2 position;
    Point2 before, after; ///< tangent of the piece that ends and of the one that begins
    double delta = 0;     ///< inclination of `after`, rad, continuous along the curve
  };
  std::span<const Node> nodes() const { return data_->nodes; }

  struct Point {
    Point2 position, tangent; ///< tangent: d(position)/ds of the table
  };
  /// Between nodes k and k + 1, 0 <= t <= 1.
  Point between(int k, double t) const;
  /// Index k of the interval that holds s; the first or last where s is off the curve. Searched from `near`.
  int interval(double s, int near) const;
  /// Position, tangent and mean curvature of the interval; `near` as for interval(), which it becomes.
  CurvePoint quick(double s, int& near) const;

private:
  struct Data {
    ProfileCurve curve;
    std::vector<Node> nodes;
    std::uint64_t digest = 0;
  };
  std::shared_ptr<const Data> data_;
};

} // namespace bem_contact
