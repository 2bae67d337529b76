#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"
#include "bem_contact/sequence/conformity_record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace bem_contact {

namespace {

/// mm. The table reaches so much farther than the largest amplitude, because a motion need not have its
/// middle at y = 0.
constexpr double beyond_amplitude = 2.0;
/// mm. The cone in the middle is looked at so far to either side: the smallest amplitude that is usual.
constexpr double middle_reach = 1.0;
/// 1. tan gamma in the middle below which the cone is called negative: less is a cylinder, and rounding.
constexpr double least_negative_cone = -1e-5;

template <double EquivalentConicity::*member> double of_motion(const WheelsetConicity::Value& v) {
  return v.motion ? (*v.motion).*member : std::numeric_limits<double>::quiet_NaN();
}

/// The difference at a displacement, between the values of the table; the table's last value beyond it.
double difference_at(std::span<const RadiusDifference> f, double lateral) {
  const auto after = std::ranges::lower_bound(f, lateral, {}, &RadiusDifference::lateral);
  if (after == f.begin() || after == f.end())
    return after == f.begin() ? f.front().difference : f.back().difference;
  const RadiusDifference &a = *(after - 1), &b = *after;
  const double h = b.lateral - a.lateral;
  return h > 0 ? a.difference + (b.difference - a.difference) * (lateral - a.lateral) / h : b.difference;
}

/// The place nearest to displacement 0 at which both wheels roll on equal radii, if there is one.
std::optional<double> middle_of_motion(std::span<const RadiusDifference> f) {
  std::optional<double> nearest;
  for (const RadiusDifference& at : with_zeros(f))
    if (at.difference == 0 && (!nearest || std::abs(at.lateral) < std::abs(*nearest)))
      nearest = at.lateral;
  return nearest;
}

std::vector<RadiusDifference> differences(std::span<const WheelsetStand> stands) {
  std::vector<RadiusDifference> out;
  std::ranges::transform(stands, std::back_inserter(out), [](const WheelsetStand& s) {
    return RadiusDifference{s.lateral, s.difference()};
  });
  return out;
}

void warn_of_negative_cone(std::span<const RadiusDifference> function) {
  const std::optional<double> middle = middle_of_motion(function);
  if (!middle)
    return;
  const double rise =
      difference_at(function, *middle + middle_reach) - difference_at(function, *middle - middle_reach);
  const double tan_gamma = rise / (4 * middle_reach);
  if (tan_gamma < least_negative_cone)
    say_warning("the cone is negative in the middle: at a lateral displacement of {:.2f} mm tan gamma "
                "is {:.4f} (over {:g} mm "
                "to either side), so that nothing holds the wheelset there, and it runs to one side "
                "until its flange root "
                "steers it back. A conicity whose motion does not pass this place is about another one, "
                "beside the middle",
                *middle, tan_gamma, middle_reach);
}

/// mm. The active faces of a wheelset are so far below its tape circles (EN 15302, EN 15313).
constexpr double active_face_depth = 10.0;
/// mm. Half of the difference of the two amplitudes between which the nonlinearity is taken (4 and 2 mm).
constexpr double rated_step = 1.0;

/// y of a wheel's active face, in its own frame; nothing of a wheel without a flange.
std::optional<double> active_face(const TabulatedProfile& wheel) {
  const auto nodes = wheel.nodes();
  const double tread = wheel.nearest({0, 0}).position.z;
  for (std::size_t k = 1; k < nodes.size(); ++k) { // walked from the field side to the flange
    const Point2 a = nodes[k - 1].position, b = nodes[k].position;
    if (b.y < 0 && a.z < tread + active_face_depth && b.z >= tread + active_face_depth)
      return a.y + (b.y - a.y) * (tread + active_face_depth - a.z) / (b.z - a.z);
  }
  return std::nullopt;
}

double play_of(const WheelsetOnTrack& w) {
  const auto right = active_face(w.right_wheel), left = active_face(w.left_wheel);
  if (!right || !left || w.position.wheel_origin || w.position.rail_origin)
    return std::numeric_limits<double>::quiet_NaN();
  return w.position.gauge - (w.contact_distance() + *right + *left); // both are on the -y side
}

double rated_amplitude(double play) {
  return play < 5 ? 2 : play < 7 ? (play - 1) / 2 : 3; // 3 for nan too
}

/// Largest less smallest y of the right contact during a motion.
double travel(const std::vector<WheelsetStand>& stands, const std::optional<EquivalentConicity>& motion,
              Point2 WheelTouch::*point) {
  if (!motion)
    return std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const WheelsetStand& s : stands)
    if (s.lateral >= motion->from - 1e-9 && s.lateral <= motion->to + 1e-9) {
      low = std::min(low, (s.right.*point).y);
      high = std::max(high, (s.right.*point).y);
    }
  return std::max(high - low, 0.0);
}

std::vector<Conformity> conformity_of(const WheelsetOnTrack& w) {
  WheelsetPosition position = w.position;
  position.side = WheelSide::right;
  position.lateral = position.roll = position.rail_lateral = position.rail_vertical = position.rail_roll = 0;
  position.deviation = {};
  std::vector<Conformity> out{conformity_at(position, w.right_rail, w.right_wheel)};
  if (const auto flange = conformity_at_flange(position, w.right_rail, w.right_wheel))
    out.push_back(*flange);
  return out;
}

} // namespace

WheelsetOnTrack wheelset_of(const SceneFile& scene, const LeftProfiles& left) {
  if (scene.kind != SceneKind::wheel_rail)
    throw InputError("This scene has no wheelset", "its kind is \"patch\"",
                     "Give a scene with kind = \"wheel_rail\".");
  if (scene.changes_along())
    refuse_uneven(
        "There is no conicity of an uneven wheel or rail",
        "a wheelset steers by the mean of many turns, and a flat, a polygon or a joint is at one place");
  const WheelRailProfiles right = read_profiles(scene);
  const auto warn = [&](const char* side, const std::string& text) {
    if (!text.empty())
      say_warning("{}{}", side, text);
  };
  warn("", inclined_twice(right.rail_inclination, scene.position.rail_inclination));
  WheelsetOnTrack out{.right_rail = right.rail,
                      .right_wheel = right.wheel,
                      .left_rail = right.rail,
                      .left_wheel = right.wheel,
                      .position = scene.position,
                      .left_rail_inclination = scene.wheelset.left_rail_inclination};
  const SceneFile other = one_wheel(scene, WheelSide::left); // with [left_rail] and [left_wheel]
  const std::string rail_name = !left.rail.empty() ? left.rail : scene.wheelset.left_rail.profile,
                    wheel_name = !left.wheel.empty() ? left.wheel : scene.wheelset.left_wheel.profile;
  if (!rail_name.empty()) {
    const ProfileCurve rail = named_profile(rail_name, ProfileKind::rail, scene.folder, other.rail.reading);
    warn("left rail: ",
         inclined_twice(inclination_of_rail(rail_name, rail), other.position.rail_inclination));
    out.left_rail = TabulatedProfile(rail);
  }
  if (!wheel_name.empty())
    out.left_wheel =
        TabulatedProfile(named_profile(wheel_name, ProfileKind::wheel, scene.folder, other.wheel.reading));
  if (by_gauge_and_flange(scene)) {
    warn("", no_play(scene.position, out.right_wheel));
    if (!wheel_name.empty())
      warn("left wheel: ", no_play(scene.position, out.left_wheel));
  }
  return out;
}

SceneFile scene_without_file(std::span<const SceneChange> changes) {
  return parse_scene_file({"load.force = 1.0\n", "options"}, changes);
}

WheelsetConicity steering_of(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes,
                             const std::atomic<bool>* stop) {
  const double largest = amplitudes.largest, step = amplitudes.step;
  if (!(step > 0 && largest >= step && largest <= 45 && largest / step <= 10000))
    throw InputError(
        fmt::format("The conicity cannot be given for amplitudes up to {:g} mm in steps of {:g} mm", largest,
                    step),
        "the step must be above 0 and not above the largest, the largest at most 45 mm, and 10000 of them "
        "are allowed",
        "Give both in mm, as 10 and 1.");
  WheelsetConicity out{.lengths = {wheelset.contact_distance(), wheelset.position.wheel_radius},
                       .stands = rolling_radius_difference(wheelset, largest + beyond_amplitude, stop),
                       .values = {},
                       .conformity = {}};
  const std::vector<RadiusDifference> function = differences(out.stands);
  const int count = static_cast<int>(largest / step + 1e-9);
  for (int k = 1; k <= count; ++k) {
    end_if_stopped(stop);
    const auto motion = equivalent_conicity(function, k * step, out.lengths);
    out.values.push_back({k * step, motion, travel(out.stands, motion, &WheelTouch::rail),
                          travel(out.stands, motion, &WheelTouch::wheel)});
  }
  out.play = play_of(wheelset);
  out.rated_amplitude = rated_amplitude(out.play);
  const auto rated = [&](double more) {
    const auto motion = equivalent_conicity(function, out.rated_amplitude + more, out.lengths);
    return motion ? motion->tan_gamma : std::numeric_limits<double>::quiet_NaN();
  };
  out.nonlinearity = (rated(rated_step) - rated(-rated_step)) / (2 * rated_step);
  return out;
}

WheelsetConicity wheelset_conicity(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes,
                                   const std::atomic<bool>* stop) {
  WheelsetConicity out = steering_of(wheelset, amplitudes, stop);
  warn_of_negative_cone(differences(out.stands));
  out.conformity = conformity_of(wheelset);
  return out;
}

std::span<const ColumnOf<WheelsetStand>> stand_columns() {
  using S = WheelsetStand;
  static constexpr ColumnOf<WheelsetStand> columns[] = {
      {"lateral", "mm", "lateral displacement of the wheelset, to the right",
       [](const S& s) { return s.lateral; }},
      {"difference", "mm", "rolling radius difference, right less left",
       [](const S& s) { return s.difference(); }},
      {"tan_difference", "1", "tangent of the contact angle, right less left",
       [](const S& s) { return std::tan(s.left.delta) - std::tan(s.right.delta); }},
      {"roll", "rad", "roll of the wheelset, right side down", [](const S& s) { return s.roll; }},
      {"right_radius", "mm", "rolling radius of the right wheel", [](const S& s) { return s.right.radius; }},
      {"right_wheel_y", "mm", "contact on the right wheel, from the tape circle to the field side",
       [](const S& s) { return s.right.wheel.y; }},
      {"right_wheel_s", "mm", "the same, arc length", [](const S& s) { return s.right.wheel_s; }},
      {"right_rail_y", "mm", "contact on the right rail, from its origin to the field side",
       [](const S& s) { return s.right.rail.y; }},
      {"right_rail_s", "mm", "the same, arc length", [](const S& s) { return s.right.rail_s; }},
      {"right_delta", "rad", "inclination of the right contact", [](const S& s) { return s.right.delta; }},
      {"left_radius", "mm", "rolling radius of the left wheel", [](const S& s) { return s.left.radius; }},
      {"left_wheel_y", "mm", "contact on the left wheel, from the tape circle to the field side",
       [](const S& s) { return s.left.wheel.y; }},
      {"left_wheel_s", "mm", "the same, arc length", [](const S& s) { return s.left.wheel_s; }},
      {"left_rail_y", "mm", "contact on the left rail, from its origin to the field side",
       [](const S& s) { return s.left.rail.y; }},
      {"left_rail_s", "mm", "the same, arc length", [](const S& s) { return s.left.rail_s; }},
      {"left_delta", "rad", "inclination of the left contact, in the mirror image",
       [](const S& s) { return s.left.delta; }}};
  return columns;
}

std::span<const ColumnOf<WheelsetConicity::Value>> conicity_columns() {
  static constexpr ColumnOf<WheelsetConicity::Value> columns[] = {
      {"amplitude", "mm", "half of the way from the leftmost to the rightmost point",
       [](const WheelsetConicity::Value& v) { return v.amplitude; }},
      {"tan_gamma", "1", "equivalent conicity", of_motion<&EquivalentConicity::tan_gamma>},
      {"wavelength", "mm", "wavelength of the free lateral motion",
       of_motion<&EquivalentConicity::wavelength>},
      {"from", "mm", "its leftmost displacement", of_motion<&EquivalentConicity::from>},
      {"to", "mm", "its rightmost displacement", of_motion<&EquivalentConicity::to>},
      {"rail_travel", "mm", "width over which the right contact travels on the rail during it",
       [](const WheelsetConicity::Value& v) { return v.rail_travel; }},
      {"wheel_travel", "mm", "the same on the wheel",
       [](const WheelsetConicity::Value& v) { return v.wheel_travel; }}};
  return columns;
}

record::Record record_of(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  using record::Number;
  const auto side = [](const std::string& rail, const std::string& wheel) {
    return record::Record{{"rail", record::Text{rail}}, {"wheel", record::Text{wheel}}};
  };
  return {{"right", side(w.right_rail.name(), w.right_wheel.name())},
          {"left", side(w.left_rail.name(), w.left_wheel.name())},
          {"wheel_radius", Number{c.lengths.wheel_radius, "mm", "at the tape circle"}},
          {"contact_distance", Number{c.lengths.contact_distance, "mm", "of the contact circles"}},
          {"rolls", w.rolls},
          {"function", record::table_of("lateral displacement", stand_columns(), c.stands)},
          {"conicity", record::table_of("amplitude", conicity_columns(), c.values)},
          {"play", Number{c.play, "mm", "gauge less the distance of the active faces"}},
          {"rated_amplitude", Number{c.rated_amplitude, "mm", "at which the conicity is rated, by the play"}},
          {"nonlinearity", Number{c.nonlinearity, "1/mm",
                                  "slope of tan gamma over the amplitude, from 1 mm below to 1 mm above it"}},
          {"conformity", record::table_of("place: in the middle, at the gauge corner", conformity_columns(),
                                          c.conformity)}};
}

} // namespace bem_contact
