#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace bem_contact {

/// The surfaces of the bodies that bear a wheel on one side of the track: one rail; or several beside each
/// other with a gap between, such as a wing rail and a nose, a stock rail and a blade, a running rail and a
/// check rail.
///
/// It is one surface over (u, t) like that of each of them: t runs through the bodies, one after the other
/// from the track's centre outwards, and leaves a wide gap between two. Each is there from its own first
/// section to its last one.
class RailSurfaces {
public:
  /// One of them.
  struct Body {
    std::shared_ptr<const SectionedSurface> surface;
    double lowered = 0; ///< it is moved down by this, mm
  };
  explicit RailSurfaces(std::vector<Body> bodies);

  double from() const; ///< u of the first section of all, mm
  double to() const;   ///< and of the last one

  /// The last section of all at u or before it, and the first one behind it, mm.
  std::pair<double, double> places_about(double u) const;

  /// As SectionedSurface::at().
  SectionedSurface::Point at(double u, double t, int side = 1) const;
  /// Whether a body is there.
  bool has(double u, double t) const;
  /// All t at which curves are tabulated, rising.
  const std::vector<double>& nodes() const { return nodes_; }

  int count() const { return static_cast<int>(bodies_.size()); }
  /// The surface of one of them, as they were given.
  const SectionedSurface& surface(int body) const;
  /// Which of the bodies, as they were given, t belongs to, or is nearest to.
  int body_of(double t) const { return order_[place_of(t)]; }
  /// And t on that body's own surface.
  double on_body(double t) const { return t - begin_[place_of(t)]; }

private:
  int place_of(double t) const; ///< in `bodies_`

  std::vector<Body> bodies_;          ///< from the track's centre outwards
  std::vector<int> order_;            ///< which of those given each is
  std::vector<double> begin_, nodes_; ///< t at which each begins
};

} // namespace bem_contact
