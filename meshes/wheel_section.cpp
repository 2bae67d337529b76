#include "meshes/wheel_section.hpp"

#include "bem_contact/base/error.hpp"
#include "meshes/settings.hpp"

#include <fmt/format.h>

#include <numbers>

namespace bem_contact::meshes {
namespace {

using std::numbers::pi;

/// A side of the web, vertical at both ends.
Piece web_side(Point2 from, Point2 to) {
  const double third = (to.z - from.z) / 3;
  return bezier(from, {from.y, from.z + third}, {to.y, to.z - third}, to);
}

} // namespace

std::vector<Piece> wheel_body(Point2 profile_end, Point2 profile_begin, std::string_view held,
                              const WheelSection& wheel) {
  const auto group = [held](std::string_view part) { return held == part ? Group::held : Group::free; };
  const double rim = wheel.rim_inner_radius - wheel.tape_radius, hub = wheel.hub_radius - wheel.tape_radius;
  const double bore = wheel.bore_radius - wheel.tape_radius;
  const double middle = (wheel.rim_back + wheel.rim_front) / 2;
  // A measured profile may end a little inside or outside the nominal faces.
  const double back = std::min(wheel.rim_back, profile_end.y);
  const double front = std::max(wheel.rim_front, profile_begin.y);
  const double chamfer_back = profile_end.z - (profile_end.y - back);
  const double chamfer_front = profile_begin.z - (front - profile_begin.y);
  if (profile_end.y > middle || profile_begin.y < middle || std::min(chamfer_back, chamfer_front) < rim / 2)
    throw InputError(
        fmt::format("The wheel profile from ({:.3f}, {:.3f}) to ({:.3f}, {:.3f}) mm does not fit the rim",
                    profile_begin.y, profile_begin.z, profile_end.y, profile_end.z),
        fmt::format("the rim reaches from y = {} to {} mm and z = 0 is the tape circle", wheel.rim_back,
                    wheel.rim_front),
        "Check the profile's frame, unit and walking order.");

  const double r = wheel.fillet;
  const double upper = rim - r, lower = hub + r;
  const double back_rim = wheel.web_at_rim - wheel.thickness_at_rim / 2,
               back_hub = wheel.web_at_hub - wheel.thickness_at_hub / 2;
  const double front_rim = wheel.web_at_rim + wheel.thickness_at_rim / 2,
               front_hub = wheel.web_at_hub + wheel.thickness_at_hub / 2;

  std::vector<Piece> pieces;
  if (profile_end.y - back > coinciding)
    pieces.push_back(line(profile_end, {back, chamfer_back}));
  pieces.push_back(line({back, chamfer_back}, {back, rim}));
  pieces.push_back(line({back, rim}, {back_rim - r, rim}, group("rim")));
  pieces.push_back(arc({back_rim - r, upper}, r, pi / 2, 0));
  pieces.push_back(web_side({back_rim, upper}, {back_hub, lower}));
  pieces.push_back(arc({back_hub - r, lower}, r, 0, -pi / 2));
  pieces.push_back(line({back_hub - r, hub}, {wheel.hub_back, hub}));
  pieces.push_back(line({wheel.hub_back, hub}, {wheel.hub_back, bore}));
  pieces.push_back(line({wheel.hub_back, bore}, {wheel.hub_front, bore}, group("bore")));
  pieces.push_back(line({wheel.hub_front, bore}, {wheel.hub_front, hub}));
  pieces.push_back(line({wheel.hub_front, hub}, {front_hub + r, hub}));
  pieces.push_back(arc({front_hub + r, lower}, r, -pi / 2, -pi));
  pieces.push_back(web_side({front_hub, lower}, {front_rim, upper}));
  pieces.push_back(arc({front_rim + r, upper}, r, pi, pi / 2));
  pieces.push_back(line({front_rim + r, rim}, {front, rim}, group("rim")));
  pieces.push_back(line({front, rim}, {front, chamfer_front}));
  if (front - profile_begin.y > coinciding)
    pieces.push_back(line({front, chamfer_front}, profile_begin));
  return pieces;
}

} // namespace bem_contact::meshes
