#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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

void warn_of_negative_cone(std::span<const RadiusDifference> function) {
  const std::optional<double> middle = middle_of_motion(function);
  if (!middle)
    return;
  const double rise =
      difference_at(function, *middle + middle_reach) - difference_at(function, *middle - middle_reach);
  const double tan_gamma = rise / (4 * middle_reach);
  if (tan_gamma < least_negative_cone)
    messages()->warn("the cone is negative in the middle: at a lateral displacement of {:.2f} mm tan gamma "
                     "is {:.4f} (over {:g} mm "
                     "to either side), so that nothing holds the wheelset there, and it runs to one side "
                     "until its flange root "
                     "steers it back. A conicity whose motion does not pass this place is about another one, "
                     "beside the middle",
                     *middle, tan_gamma, middle_reach);
}

} // namespace

WheelsetOnTrack wheelset_of(const SceneFile& scene, const LeftProfiles& left) {
  if (scene.kind != SceneKind::wheel_rail)
    throw InputError("This scene has no wheelset", "its kind is \"patch\"",
                     "Give a scene with kind = \"wheel_rail\".");
  const WheelRailProfiles right = read_profiles(scene);
  const auto warn = [&](const char* side, const std::string& text) {
    if (!text.empty())
      messages()->warn("{}{}", side, text);
  };
  warn("", inclined_twice(right.rail_inclination, scene.position.rail_inclination));
  WheelsetOnTrack out{.right_rail = right.rail,
                      .right_wheel = right.wheel,
                      .left_rail = right.rail,
                      .left_wheel = right.wheel,
                      .position = scene.position};
  if (!left.rail.empty()) {
    const ProfileCurve rail = named_profile(left.rail, ProfileKind::rail, scene.folder, scene.rail.reading);
    warn("left rail: ",
         inclined_twice(inclination_of_rail(left.rail, rail), scene.position.rail_inclination));
    out.left_rail = TabulatedProfile(rail);
  }
  if (!left.wheel.empty())
    out.left_wheel =
        TabulatedProfile(named_profile(left.wheel, ProfileKind::wheel, scene.folder, scene.wheel.reading));
  if (by_gauge_and_flange(scene)) {
    warn("", no_play(scene.position, out.right_wheel));
    if (!left.wheel.empty())
      warn("left wheel: ", no_play(scene.position, out.left_wheel));
  }
  return out;
}

SceneFile scene_without_file(std::span<const SceneChange> changes) {
  return parse_scene_file({"load.force = 1.0\n", "options"}, changes);
}

WheelsetConicity wheelset_conicity(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes,
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
                       .values = {}};
  std::vector<RadiusDifference> function;
  for (const WheelsetStand& s : out.stands)
    function.push_back({s.lateral, s.difference()});
  warn_of_negative_cone(function);
  const int count = static_cast<int>(largest / step + 1e-9);
  for (int k = 1; k <= count; ++k) {
    end_if_stopped(stop);
    out.values.push_back({k * step, equivalent_conicity(function, k * step, out.lengths)});
  }
  return out;
}

std::span<const ColumnOf<WheelsetStand>> stand_columns() {
  using S = WheelsetStand;
  static constexpr ColumnOf<WheelsetStand> columns[] = {
      {"lateral", "mm", "lateral displacement of the wheelset, to the right",
       [](const S& s) { return s.lateral; }},
      {"difference", "mm", "rolling radius difference, right less left",
       [](const S& s) { return s.difference(); }},
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
      {"to", "mm", "its rightmost displacement", of_motion<&EquivalentConicity::to>}};
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
          {"conicity", record::table_of("amplitude", conicity_columns(), c.values)}};
}

} // namespace bem_contact
