#include "bem_contact/conicity/conicity_columns.hpp"

#include <limits>

namespace bem_contact {

namespace {

template <double EquivalentConicity::*member> double of_motion(const WheelsetConicity::Value& v) {
  return v.motion ? (*v.motion).*member : std::numeric_limits<double>::quiet_NaN();
}

template <class Range, class Of> std::vector<double> values_of(const Range& range, const Of& of) {
  std::vector<double> out;
  for (const auto& one : range)
    out.push_back(of(one));
  return out;
}

} // namespace

std::span<const StandColumn> stand_columns() {
  using S = WheelsetStand;
  static constexpr StandColumn columns[] = {
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

std::span<const ConicityColumn> conicity_columns() {
  static constexpr ConicityColumn columns[] = {
      {"amplitude", "mm", "half of the way from the leftmost to the rightmost point",
       [](const WheelsetConicity::Value& v) { return v.amplitude; }},
      {"tan_gamma", "1", "equivalent conicity", of_motion<&EquivalentConicity::tan_gamma>},
      {"wavelength", "mm", "wavelength of the free lateral motion",
       of_motion<&EquivalentConicity::wavelength>},
      {"from", "mm", "its leftmost displacement", of_motion<&EquivalentConicity::from>},
      {"to", "mm", "its rightmost displacement", of_motion<&EquivalentConicity::to>}};
  return columns;
}

std::vector<double> StandColumn::values(const WheelsetConicity& conicity) const {
  return values_of(conicity.stands, value);
}

std::vector<double> ConicityColumn::values(const WheelsetConicity& conicity) const {
  return values_of(conicity.values, value);
}

} // namespace bem_contact
