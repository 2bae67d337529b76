#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact {

/// The section of a body at one place.
struct BodySection {
  double at = 0; ///< place along the track, mm; of a wheel: angle, rad
  ProfileCurve profile;
  /// Arc lengths on the profile of the feature lines, in walking order, mm; nan: this section does not have
  /// the feature. All sections have as many; what lies before the first and beyond the last is left out.
  /// None: they are found (correspondence.hpp).
  std::vector<double> features = {};
  /// The surface has an edge across the track here: its slope along the track may jump.
  bool kink = false;
};

/// What messages say of sections, and how the surface runs between them.
struct SectionsAre {
  std::string body = "rail", unit = "mm"; ///< of the places
  double unit_length = 1;                 ///< mm: what a unit of the places is on the surface, nearly
  /// The surface does not go through the sections: along u it is the cubic B-spline whose control points
  /// their points are, where places lie evenly (CONTACT's way 2). In between weights keep straight lines
  /// straight. It is smoother than the sections: each lies at 1/6, 4/6, 1/6 of itself and its neighbours.
  bool approximated = false;
};

/// A surface whose section changes along the track: (u, y(u, t), z(u, t)).
///
/// u is the place along the track and t, in mm, counts along the section: points of the same t correspond.
/// Feature lines have whole lines of t; between two of them the arc lengths of the sections run as a
/// monotone cubic of t (Fritsch and Carlson 1980), the same one on both sides of a line. Along u points of
/// the same t lie on the interpolating cubic spline through the sections ("not a knot" at its ends; a
/// parabola of three sections, a straight line of two), one spline from kink to kink. Across, the curves are
/// tabulated with their tangents, at most 0.1 mm apart (cubic Hermite). So the surface is C2 along u, and
/// along t as smooth as its sections.
///
/// Where neighbouring sections do not both have a feature, what lies between it and the next one is not
/// there from the one section to the other: a nose or a blade begins with an upright end. What is there must
/// be one piece.
class SectionedSurface {
public:
  /// Throws InputError, which names section and place: for fewer than two sections, places that do not rise,
  /// features that are off the profile, out of order or not as many everywhere, pieces with a hole between
  /// them, and a section that is the mirror image of its neighbour.
  explicit SectionedSurface(std::vector<BodySection> sections, const SectionsAre& are = {});

  double from() const { return at_.front(); } ///< u of the first section, mm
  double to() const { return at_.back(); }    ///< and of the last one

  struct Point {
    Point2 position, by_t, by_u; ///< (y, z), mm; its derivatives
  };
  /// Beyond the first and the last section the surface goes on straight. Where tangents jump, they are those
  /// just beyond t (side = 1) or just before it (-1).
  Point at(double u, double t, int side = 1) const;
  /// t of both ends of what is there at u, mm.
  std::pair<double, double> extent(double u) const;
  /// Whether t is on what is there at u, or at its end.
  bool has(double u, double t) const;
  /// All t at which curves are tabulated, rising: tangents may jump there and nowhere else.
  const std::vector<double>& nodes() const { return t_; }
  /// The feature lines, given or found: t of each.
  const std::vector<double>& lines() const { return lines_; }
  /// The places of the sections, rising; that of a kink twice.
  const std::vector<double>& places() const { return at_; }
  /// The arc length on the profile of the section at `place` (one of places()) of the point of this t, mm;
  /// nothing where that section does not have it.
  std::optional<double> arc_length(double place, double t) const;
  /// The curve at u = const, and the t of its joints.
  ProfileCurve section(double u, std::vector<double>& t) const;

private:
  /// One node of one section: the point, its tangents by t on both sides, and what each of these changes by
  /// along u.
  struct Node {
    Point2 position, before, after, position_u, before_u, after_u;
  };
  void tabulate(const std::vector<BodySection>& sections, const std::vector<std::vector<double>>& marks,
                bool approximated);
  void join(int stretch, bool approximated);
  int interval(double u) const;
  Point in_cell(double u, double t, int cell) const;

  std::vector<double> at_, t_, lines_;
  std::vector<std::vector<double>> marks_; ///< [section][line] arc lengths (CorrespondingPoints)
  std::vector<int> first_node_;            ///< of each stretch between two lines, and the end
  std::vector<std::vector<char>> there_;   ///< [interval][stretch]
  /// [stretch][section][node of the stretch]: both ends of a stretch are in it.
  std::vector<std::vector<std::vector<Node>>> nodes_;
};

} // namespace bem_contact
