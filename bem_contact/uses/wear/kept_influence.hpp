#pragma once

#include "bem_contact/uses/wear/worn_profile.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::wear {

/// Influence functions that a body keeps while it wears.
///
/// They were computed for one shape. A load on an element moves the surface near it as it would on any
/// surface that has the same inclination between the elements, whatever the depth of the wear. So it is the
/// turn of the surface that says how far they still serve, and they are used at the same arc lengths.
struct KeptInfluence {
  std::filesystem::path file; ///< empty: none
  /// The profile that they are of: (y, z) of its points in walking order, in the profile's own frame, mm. As
  /// many points as the body has now.
  std::vector<Point2> shape;
};

/// What is kept of both bodies.
struct KeptPair {
  KeptInfluence rail, wheel; ///< each has a file, or none
};

/// Largest angle between an edge of one polygon and the same edge of the other, rad. Both are (y, z) of
/// profile points, mm, in the same frame, and equally many.
double turn_between(std::span<const Point2> before, std::span<const Point2> after);

/// Throws InputError: the surface of `body` ("rail" or "wheel") has turned by `turn`, rad, more than the
/// `limit` up to which it keeps its influence functions. `since`: a clause that says when these were
/// computed.
[[noreturn]] void refuse_outgrown(std::string_view body, double turn, double limit, std::string_view since,
                                  const std::string& advice);

/// Throws InputError if there is a file and the shape has turned by more than `limit`, rad, or has another
/// number of points. `body`: "rail" or "wheel". `now`: its present shape, as KeptInfluence::shape.
void require_kept(std::string_view body, const KeptInfluence& influence, std::span<const Point2> now,
                  double limit);

} // namespace bem_contact::wear
