#pragma once

#include "bem_contact/geometry/pose.hpp"
#include "bem_contact/geometry/rail_frame.hpp"
#include "bem_contact/profile/contact_row.hpp"
#include "bem_contact/profile/sections/rail_surfaces.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace bem_contact {

/// A rail whose section changes along the track, seen from a wheel.
///
/// It is looked at in a RailFrame whose x lies along its surface where the wheel touches it first. In that
/// frame it is a prism, its section there, and a relief: how far along the prism's normals the true surface
/// lies deeper. Near the contact the relief is small and of second order in x, so that rows, columns, the
/// contact locus and the half-space are those of the prism, and distances are exact along its normals.
///
/// Several bodies are one prism, with straight lines where there is nothing between them (RailSurfaces).
class SectionedRail {
public:
  /// `along`: u of the wheelset's centre, mm; the pose is that of all sections.
  SectionedRail(std::shared_ptr<const RailSurfaces> surface, const Pose& pose, double along);

  /// The section across the frame's x, through its origin, in the frame of the pose; the view changes to
  /// this frame.
  ProfileCurve look_from(const RailFrame& frame);
  const RailFrame& frame() const { return frame_; }
  /// How many bodies there are, and to which one a row belongs, counted as they were given.
  int bodies() const { return surface_->count(); }
  int body_of(const ContactRow& row) const { return surface_->body_of(start(row).t); }

  /// How much deeper than the prism the rail is along the normal of a row, mm, at x of the frame; nothing
  /// where there is no rail.
  std::optional<double> depth(double x, const ContactRow& row) const;
  /// By what it grows along x over `length` about there, 1; 0 where there is no rail.
  double slope(double x, const ContactRow& row, double length) const;
  /// The same point of the rail, in the frame, mm; without a rail that of the prism.
  Vector3 point(double x, const ContactRow& row) const;

  /// Where that point is on the surface of its body; without a rail the nearest that there is.
  struct OnBody {
    double u = 0; ///< place along the track, mm
    int body = 0; ///< as body_of()
    double t = 0; ///< across, on that body (SectionedSurface), mm
  };
  OnBody on_body(double x, const ContactRow& row) const;
  /// The same of the row itself, on the prism; nothing where there is no rail.
  std::optional<OnBody> on_section(const ContactRow& row) const;
  /// The arc length of a point of a body on the profile of its section at `place`, mm
  /// (SectionedSurface::arc_length()).
  std::optional<double> arc_length(const OnBody& point, double place) const {
    return surface_->surface(point.body).arc_length(place, point.t);
  }

  /// Unit vector in the rail's surface at a point of the frame, track frame: along its line of corresponding
  /// points, which is straight where a section moves as a whole and the rail is a prism seen from there. And
  /// by how much a wheel that rolls over it moves down where its y stays, over V.
  struct Direction {
    Vector3 ahead{1, 0, 0};
    double sinking = 0;
  };
  Direction direction(double x, const ContactRow& row) const;

private:
  struct Place {
    double u, t;
  };
  /// A point of the surface in the frame, with its derivatives.
  struct Seen {
    Vector3 position, by_u, by_t;
  };
  Seen seen(const Place& at, int side = 1) const;
  std::optional<Place> found(double x, const ContactRow& row) const;
  std::optional<double> u_across(double t) const;
  Place start(const ContactRow& row) const;

  std::shared_ptr<const RailSurfaces> surface_;
  Pose pose_;
  double along_ = 0;
  RailFrame frame_;
  std::vector<double> s_, t_, u_; ///< of the nodes of the section
};

} // namespace bem_contact
