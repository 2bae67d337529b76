#include "bem_contact/uses/conicity/rolling_radius.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/level_roll.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// mm. Lateral displacements of the table are at most this far apart. The standard's reference functions have
/// this step.
constexpr double lateral_step = 0.1;
/// mm, arc length on a profile. Where a contact point moves by more between two displacements, another one is
/// put between them: a jump of the contact becomes a steep stretch. Chosen: a twentieth of a contact's width.
constexpr double largest_move = 0.5;
/// mm. No two displacements get nearer. A jump of 2 mm in the radius difference, placed 2e-3 mm off, changes
/// the conicity of an amplitude of 3 mm by less than 1e-3 of itself.
constexpr double smallest_lateral_step = 2e-3;
/// mm. Both wheels stand on their rails when the heights of the axle that they ask for differ by less.
constexpr double height_difference = 1e-9;

struct Lowered {
  double down = 0; ///< how far the axle went down until the wheel touched, mm
  WheelTouch touch;
};

Lowered lowered(const WheelsetOnTrack& wheelset, WheelSide side, double lateral, double roll) {
  const WheelsetPosition& p = wheelset.position;
  const bool right = side == WheelSide::right;
  const WheelsetPosition position{.side = side,
                                  .lateral = lateral,
                                  .gauge = p.gauge,
                                  .gauge_height = p.gauge_height,
                                  .back_to_back = p.back_to_back,
                                  .tape_circle = p.tape_circle,
                                  .rail_inclination =
                                      right ? p.rail_inclination
                                            : wheelset.left_rail_inclination.value_or(p.rail_inclination),
                                  .roll = roll,
                                  .wheel_radius = p.wheel_radius,
                                  .rail_origin = p.rail_origin,
                                  .wheel_origin = p.wheel_origin};
  WheelOnRail pair = place(position, right ? wheelset.right_rail : wheelset.left_rail,
                           right ? wheelset.right_wheel : wheelset.left_wheel);
  const double before = pair.wheel_pose.origin.z;
  const TouchPoint touch = lower_to_touch(pair).front();
  const Point2 wheel = pair.wheel.at(touch.wheel_s).position;
  return {pair.wheel_pose.origin.z - before,
          {touch.rail_s, touch.wheel_s, pair.rail.at(touch.rail_s).position, wheel, touch.delta,
           p.wheel_radius + wheel.z}};
}

/// At the roll at which both wheels ask for the same height of the axle.
WheelsetStand rolled(const WheelsetOnTrack& wheelset, double lateral) {
  Lowered right, left;
  const auto unequal = [&](double roll) {
    right = lowered(wheelset, WheelSide::right, lateral, roll);
    left = lowered(wheelset, WheelSide::left, lateral, roll);
    return right.down - left.down;
  };
  const double roll = level_roll(unequal, 0, wheelset.contact_distance(), height_difference);
  return {lateral, roll, right.touch, left.touch};
}

double move(const WheelTouch& a, const WheelTouch& b) {
  return std::max(std::abs(a.rail_s - b.rail_s), std::abs(a.wheel_s - b.wheel_s));
}

/// Puts all stands after `from` up to and with `to` at the end of `out`.
void refine(const WheelsetOnTrack& wheelset, const WheelsetStand& from, const WheelsetStand& to,
            std::vector<WheelsetStand>& out, const std::atomic<bool>* stop) {
  end_if_stopped(stop);
  const bool fast = std::max(move(from.right, to.right), move(from.left, to.left)) > largest_move;
  if (fast && std::abs(to.lateral - from.lateral) > 2 * smallest_lateral_step) {
    const WheelsetStand middle = stand(wheelset, 0.5 * (from.lateral + to.lateral));
    refine(wheelset, from, middle, out, stop);
    refine(wheelset, middle, to, out, stop);
  } else {
    out.push_back(to);
  }
}

/// From `middle` to `end`, the middle left out.
std::vector<WheelsetStand> one_side(const WheelsetOnTrack& wheelset, const WheelsetStand& middle, double end,
                                    const std::atomic<bool>* stop) {
  std::vector<WheelsetStand> stands;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(end) / lateral_step - 1e-9)));
  try {
    WheelsetStand last = middle;
    for (int i = 1; i <= steps; ++i) {
      const WheelsetStand next = stand(wheelset, end * i / steps);
      refine(wheelset, last, next, stands, stop);
      last = next;
    }
  } catch (const InputError&) {
    // The wheel leaves the rail: the table ends at the last displacement that has two contacts.
  }
  return stands;
}

} // namespace

double WheelsetOnTrack::contact_distance() const {
  return position.wheel_origin ? 2 * position.wheel_origin->y
                               : position.back_to_back + 2 * position.tape_circle;
}

WheelsetStand stand(const WheelsetOnTrack& wheelset, double lateral) {
  if (wheelset.rolls)
    return rolled(wheelset, lateral);
  return {lateral, 0, lowered(wheelset, WheelSide::right, lateral, 0).touch,
          lowered(wheelset, WheelSide::left, lateral, 0).touch};
}

std::vector<WheelsetStand> rolling_radius_difference(const WheelsetOnTrack& wheelset, double reach,
                                                     const std::atomic<bool>* stop) {
  if (!(reach > 0 && reach <= 50))
    throw InputError(fmt::format("The wheelset cannot be moved by {:g} mm to either side", reach),
                     "this is not above 0 and at most 50 mm", "Give the largest displacement in mm.");
  const WheelsetStand middle = stand(wheelset, 0);
  std::vector<WheelsetStand> stands = one_side(wheelset, middle, -reach, stop);
  std::ranges::reverse(stands);
  stands.push_back(middle);
  const std::vector<WheelsetStand> right = one_side(wheelset, middle, reach, stop);
  stands.insert(stands.end(), right.begin(), right.end());
  return stands;
}

} // namespace bem_contact
