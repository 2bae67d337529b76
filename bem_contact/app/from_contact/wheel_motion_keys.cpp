#include "bem_contact/app/from_contact/wheel_motion_keys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>

namespace bem_contact::app::from_contact {

namespace {

using contact_input::Block;
using contact_input::CaseState;
using contact_input::Data;

/// T = 1 of a wheelset that does not turn.
void add_shift(const CaseState& state, ContactCase& out) {
  const Block& v = state[Data::velocity];
  if (v["VROLL"] != 0 || v["VYAW"] != 0 || v["VY"] != 0 || v["VZ"] != 0)
    return out.refuse(
        "T = 1 with VPITCH = 0: a wheelset that slides along y or z, or turns about x or z; a scene "
        "has the shift at the contact");
  out.set("motion.xi", v["VS"]);
  if (state.has(Data::wheel_deviation)) {
    const Block& d = state[Data::wheel_deviation];
    if (std::ranges::any_of(std::initializer_list<const char*>{"VX", "VY", "VZ", "VROLL", "VYAW", "VPITCH"},
                            [&](const char* name) { return d[name] != 0; }))
      out.refuse("T = 1: a shift of the wheel in its wheelset");
  }
}

/// The wheel of a flexible wheelset. There it turns about the axle of the rigid wheelset, however it is
/// inclined; here about its own. The difference is a yaw and a roll rate, and a forward velocity where its
/// centre lies off the axle.
void add_velocity_of_wheel(const CaseState& state, double scale, ContactCase& out) {
  const double pitch_rate = -scale * state[Data::velocity].number("VPITCH", 0);
  const Block& d = state[Data::wheel_deviation];
  const double radius = state[Data::wheelset]["NOMRAD"], roll = d["DROLL"], yaw = d["DYAW"];
  if (state.digits['F'] == 1 && (roll != 0 || yaw != 0 || d["DZ"] != 0))
    return out.refuse(
        "F = 1 with DZ, DROLL or DYAW of the wheel: it depends on the pitch rate, which is to be found");
  const double below = d["DZ"] + radius * (1 - std::cos(roll)); // of the wheel's centre, below the axle
  out.set("motion.wheel_forward_velocity", scale * d["VX"] - pitch_rate * below);
  out.set("motion.wheel_lateral_velocity", scale * d["VY"] + radius * std::cos(roll) * scale * d["VROLL"]);
  out.set("motion.wheel_vertical_velocity", scale * d["VZ"] + radius * std::sin(roll) * scale * d["VROLL"]);
  out.set("motion.wheel_roll_rate", scale * d["VROLL"] - pitch_rate * std::tan(yaw));
  out.set("motion.wheel_yaw_rate", scale * d["VYAW"] + pitch_rate * std::tan(roll));
  out.set("motion.wheel_pitch_rate",
          -scale * d["VPITCH"] + pitch_rate * (1 / (std::cos(roll) * std::cos(yaw)) - 1));
}

/// Velocities, times `scale`: only their ratio to the forward speed counts.
void add_rates(const CaseState& state, double scale, ContactCase& out) {
  const Block& v = state[Data::velocity];
  out.set("motion.lateral_velocity", scale * v["VY"]);
  out.set("motion.vertical_velocity", scale * v["VZ"]);
  out.set("motion.roll_rate", scale * v["VROLL"]);
  out.set("motion.yaw_rate", scale * v["VYAW"]);
  if (v.has("VPITCH") && state.digits['F'] != 1)
    // about y, to the right: a wheel that rolls forwards turns the other way
    out.set("motion.pitch_rate", -scale * v["VPITCH"]);
  else if (v.has("FX") && state.digits['F'] == 1) {
    out.set("load.force_x", v["FX"]);
    if (const double yaw = state[Data::position]["YAW"]; yaw != 0)
      out.refuse(fmt::format(
          "F = 1 with YAW = {}: FX lies along the axis of the wheelset, load.force_x along the track", yaw));
  } else
    out.refuse(fmt::format("F = {}: its {} is not given", state.digits['F'],
                           state.digits['F'] == 1 ? "FX" : "VPITCH"));
  if (state.has(Data::wheel_deviation))
    add_velocity_of_wheel(state, scale, out);
}

/// T = 1 of a wheelset that turns: it rolls over one element, while the bodies slide over each other as far
/// as in a given distance.
void add_rolling_shift(const CaseState& state, ContactCase& out) {
  const double distance = state[Data::velocity]["VS"], dx = state[Data::elements]["DX"];
  if (distance <= 0)
    return out.refuse(fmt::format("T = 1 with VS = {}: a wheelset that turns and does not roll", distance));
  if (state.digits['F'] == 1)
    return out.refuse("T = 1 with F = 1: a shift that is to be found");
  out.set_text("motion.kind", "transient");
  out.set("motion.speed", dx);
  if (std::abs(distance / dx - 1) > 1e-9)
    out.set("motion.first_shift", distance / dx);
  out.leave(
      "T = 1: each step is one of rolling over dx; motion.speed and the rates are distances and angles of "
      "one step");
  add_rates(state, dx / distance, out);
}

} // namespace

bool on_roller(const CaseState& state) {
  return state.digits.is('1', "45");
}

void add_velocity(const CaseState& state, ContactCase& out) {
  const Block& v = state[Data::velocity];
  if (state.digits['T'] == 1) { // the velocities are distances and angles of one step
    if (on_roller(state))
      return out.refuse("T = 1: shifts on a roller");
    out.place = state[Data::position]["S"];
    return v.number("VPITCH", 0) != 0 || v.has("FX") ? add_rolling_shift(state, out) : add_shift(state, out);
  }
  const double speed = on_roller(state) ? v["RPITCH"] * state[Data::track]["NOMRADR"] : v["VS"];
  if (on_roller(state))
    out.set("motion.roller_speed", v["RPITCH"]);
  if (speed <= 0)
    return out.refuse(speed < 0 ? "VS below 0: a wheelset that runs backwards"
                                : "VS = 0: a wheelset that does not roll");
  out.set("motion.speed", speed);
  add_rates(state, 1, out);
}

} // namespace bem_contact::app::from_contact
