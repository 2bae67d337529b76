#include "bem_contact/uses/wheelset/quantities.hpp"

#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bem_contact {

namespace {

using Result = WheelsetResult;
using State = WheelsetState;

/// What changes sign in the mirror.
double sign(WheelSide side) {
  return side == WheelSide::left ? -1 : 1;
}

/// Of the first patch; `Of` gets what changes sign in the mirror.
template <double (*Of)(const PatchSummary&, double sign)> double of_patch(const State& s, WheelSide side) {
  const auto& patches = s.solved(side).result.patches;
  return patches.empty() ? PatchPlace::none : Of(patches.front(), sign(side));
}

template <double PatchPlace::*Member> double place(const State& s, WheelSide side) {
  const auto& places = s.solved(side).patch_places;
  return places.empty() ? PatchPlace::none : places.front().*Member;
}

template <double PatchPlace::*Member> double mirrored_place(const State& s, WheelSide side) {
  return sign(side) * place<Member>(s, side);
}

template <std::size_t I> double moment(const State& s, WheelSide side) {
  return s.wrench(side).moment[I];
}
template <std::size_t I> double sum_of_forces(const Result& r) {
  return r.state.sum().force[I];
}

/// The name of one of quantities(), as an argument of a template.
template <std::size_t size> struct Name {
  consteval Name(const char (&from)[size]) { std::ranges::copy(from, text); }
  char text[size];
};
/// A number of the wheel's own result, with its error.
template <Name name>
constexpr auto own =
    [](const State& s, WheelSide side) { return quantity(name.text).measured(s.solved(side)); };
/// The same without an error.
template <Name name>
constexpr auto own_value = [](const State& s, WheelSide side) -> double { return own<name>(s, side); };
/// The same with the unit and the description that it has there.
template <Name name> WheelQuantity as_in_result() {
  const Quantity& q = quantity(name.text);
  return {q.name, q.unit, q.meaning, own<name>};
}
/// A force in the track frame. The wheel's own result has its size and its error.
template <std::size_t I, Name name>
constexpr auto force = [](const State& s, WheelSide side) {
  return Measured{s.wrench(side).force[I], own<name>(s, side).error};
};

/// Of the wheel at the contact, mm.
double radius(const State& s, WheelSide side) {
  return s.radius(side) + place<&PatchPlace::wheel_z>(s, side);
}

constexpr WheelsetQuantity of_wheelset[] = {
    {"lateral", "mm", "lateral displacement, to the right; its error: of one that was found",
     [](const Result& r) {
       return Measured{r.state.pose.lateral, r.lateral_error};
     }},
    {"vertical", "mm", "of the centre below wheel_radius above the rails",
     [](const Result& r) { return r.state.pose.vertical; }},
    {"roll", "rad", "right side down", [](const Result& r) { return r.state.pose.roll; }},
    {"yaw", "rad", "front to the right", [](const Result& r) { return r.state.yaw; }},
    {"rolling_radius", "mm", "forward over angular speed of the axle, found for the torque; nan: given",
     [](const Result& r) {
       return r.state.pose.rolling_radius.value_or(std::numeric_limits<double>::quiet_NaN());
     }},
    {"radius_difference", "mm", "of the wheels at their contacts, right less left",
     [](const Result& r) { return radius(r.state, WheelSide::right) - radius(r.state, WheelSide::left); }},
    {"curve_radius_difference", "mm",
     "the same, as it would be if both wheels rolled through the curve without longitudinal creepage; nan: "
     "straight",
     [](const Result& r) { return r.curve.radius_difference; }},
    {"curve_force", "N",
     "on the axle, to the right: what superelevation leaves of the centrifugal force; in Fy where force_y is "
     "given; nan: straight",
     [](const Result& r) { return r.curve.force; }},
    {"Fx", "N", "on both rails", sum_of_forces<0>},
    {"Fy", "N", "on both rails", sum_of_forces<1>},
    {"Fz", "N", "on both rails", sum_of_forces<2>},
    {"roll_moment", "N mm", "on both rails, about the forward axis through the wheelset's centre",
     [](const Result& r) { return r.state.roll_moment(r.state.sum()); }},
    {"yaw_moment", "N mm", "on both rails, about the vertical through the wheelset's centre",
     [](const Result& r) { return r.state.sum().moment[2]; }},
    {"torque", "N mm", "that drives the axle against the forces on the rails",
     [](const Result& r) { return r.state.torque(r.state.sum()); }},
    {"T_gamma", "N", "work of friction per unit of rolled distance",
     [](const Result& r) {
       return own<"T_gamma">(r.state, WheelSide::right) + own<"T_gamma">(r.state, WheelSide::left);
     }},
    {"residual", "1", "of the equilibrium, over wheelset.force", [](const Result& r) { return r.residual; }},
    {"lateral_residual", "1", "of the lateral force, over wheelset.force; nan: not given",
     [](const Result& r) { return r.lateral_residual; }},
    {"contact_problems", "1", "solved on the way",
     [](const Result& r) { return static_cast<double>(r.contact_problems); }},
};

const WheelQuantity of_wheel[] = {
    {"share", "1", "of the vertical force",
     [](const State& s, WheelSide side) { return s.wrench(side).force[2] / s.sum().force[2]; }},
    {"Fx", "N", "on the rail", force<0, "Fx">},
    {"Fy", "N", "on the rail, to the right", force<1, "Fy">},
    {"Fz", "N", "on the rail", force<2, "Fz">},
    {"Y_over_Q", "1", "|Fy| / Fz: derailment quotient",
     [](const State& s, WheelSide side) {
       return std::abs(s.wrench(side).force[1]) / s.wrench(side).force[2];
     }},
    {"Mx", "N mm", "on the rail, about the wheelset's centre", moment<0>},
    {"My", "N mm", "on the rail, about the wheelset's centre", moment<1>},
    {"Mz", "N mm", "on the rail, about the wheelset's centre", moment<2>},
    {"y", "mm", "of the contact, from the track's centre line to the right",
     of_patch<[](const PatchSummary& p, double sign) { return sign * p.position.y; }>},
    {"z", "mm", "of the contact, below the top of the rail",
     of_patch<[](const PatchSummary& p, double) { return p.position.z; }>},
    {"delta", "rad", "inclination of the rail there, right side down",
     of_patch<[](const PatchSummary& p, double sign) { return sign * p.delta; }>},
    {"rail_y", "mm", "of the contact on the rail's profile, to the field side", place<&PatchPlace::rail_y>},
    {"wheel_y", "mm", "of the contact on the wheel's profile, to the field side",
     place<&PatchPlace::wheel_y>},
    {"radius", "mm", "of the wheel at the contact", radius},
    {"xi", "1", "longitudinal creepage", place<&PatchPlace::xi>},
    {"eta", "1", "lateral creepage, to the right", mirrored_place<&PatchPlace::eta>},
    {"phi", "1/mm", "spin creepage", mirrored_place<&PatchPlace::phi>},
    as_in_result<"approach">(),
    as_in_result<"pmax">(),
    as_in_result<"area">(),
    {"patches", "1", "connected areas in contact", own_value<"patch_count">},
    as_in_result<"adhesion_share">(),
    {"T_gamma", "N", "work of friction per unit of rolled distance", own<"T_gamma">},
};

} // namespace

std::span<const WheelsetQuantity> wheelset_quantities() {
  return of_wheelset;
}

std::span<const WheelQuantity> wheel_quantities() {
  return of_wheel;
}

record::Record record_of(const WheelsetResult& r, const RecordParts& parts) {
  const auto wheel = [&](WheelSide side) {
    return record::Record{{"track", record::numbers_of(wheel_quantities(), false, r.state, side)},
                          {"result", record_of(r.state.solved(side), parts)}};
  };
  record::Record out{{"certified", certified(r.state)}};
  out.append(record_of(r.warnings));
  return out.append({{"wheelset", record::numbers_of(wheelset_quantities(), false, r)},
                     {"right", wheel(WheelSide::right)},
                     {"left", wheel(WheelSide::left)},
                     {"seconds", record::Number{r.seconds, "s", "wall clock"}}});
}

} // namespace bem_contact
