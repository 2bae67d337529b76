#include "bem_contact/app/from_contact/wheel_rail_keys.hpp"

#include "bem_contact/app/from_contact/common_keys.hpp"
#include "bem_contact/app/from_contact/profile_keys.hpp"
#include "bem_contact/app/from_contact/wheel_motion_keys.hpp"

#include <cmath>
#include <fmt/format.h>
#include <optional>

// Places, signs and rates are those of CONTACT's user guide, chapter "Module 1: wheel/rail contact". y points
// to the right on both sides there; a scene's rail.y counts towards the side of its wheel.
namespace bem_contact::app::from_contact {

namespace {

using contact_input::Block;
using contact_input::CaseState;
using contact_input::Data;

bool left(const CaseState& state) {
  return state.digits.is('1', "04");
}

void refuse_digits_of_module_1(const CaseState& state, ContactCase& out) {
  const auto& d = state.digits;
  if (d['F'] == 3)
    out.refuse("F = 3: a rail on springs");
  if (!d.is('T', "12") || state.first)
    return;
  if (d['P'] == 0)
    out.goes_on_from = state.number - 1;
  else if (d['P'] == 3)
    out.refuse("P = 3: it starts from the tractions of the case before the one before");
}

/// The row of coefficients at the place s along the track, linear in between (V = 2).
void add_friction_at(const CaseState& state, double s, ContactCase& out) {
  const Block& f = state[Data::friction];
  for (std::size_t row = 0; row + 1 < f.rows(); ++row)
    if (s > f.at(row, 0) && s < f.at(row + 1, 0)) {
      if (state.effective['L'] != 0)
        return out.refuse("V = 2: a law of friction between two places along the track");
      const double share = (s - f.at(row, 0)) / (f.at(row + 1, 0) - f.at(row, 0));
      add_friction(state, row, out);
      out.friction += share * (friction_in_adhesion(state, row + 1) - out.friction);
      if (state.digits['T'] != 0)
        out.set("motion.friction", out.friction);
      return;
    }
  std::size_t row = 0;
  while (row + 1 < f.rows() && s >= f.at(row + 1, 0))
    ++row;
  add_friction(state, row, out);
}

void add_friction_of_module_1(const CaseState& state, ContactCase& out) {
  const Block& f = state[Data::friction];
  if (state.effective['V'] == 0)
    return add_friction(state, 0, out);
  if (state.effective['V'] == 2)
    return add_friction_at(state, state[Data::position]["S"], out);
  std::vector<double> places;
  for (std::size_t row = 0; row < f.rows(); ++row)
    places.push_back(f.at(row, 0));
  f.rows() == 1 ? add_friction(state, 0, out) : add_friction_table(state, "inclination", places, out);
}

void add_elements(const CaseState& state, ContactCase& out) {
  const Block& g = state[Data::elements];
  out.set("grid.dx", g["DX"]);
  out.set("grid.ds", g["DS"]);
  if (const int method = state.effective['D']; method != 4) { // each patch in a plane of its own
    out.set("grid.planar", "true");
    if (method != 3)
      out.leave(fmt::format(
          "D = {}: slip that is linear about the reference point; here each element has its own", method));
  }
  if (g["DQREL"] != 1 && state.digits['T'] == 2)
    out.refuse(fmt::format("DQREL = {}: a rolling step is dx here", g["DQREL"]));
  else if (g["DQREL"] != 1 && state.digits['T'] == 3)
    out.leave(fmt::format("DQREL = {}: steady rolling has steps of dx here", g["DQREL"]));
}

/// Where the rail lies: by its gauge face, or where CONTACT puts the origin of its file.
void add_rail_place(const CaseState& state, const ProfileKeys& rail, ContactCase& out) {
  const Block &t = state[Data::track], &r = state[Data::rail_deviation];
  const bool by_gauge = t["GAUGHT"] > 0;
  if (by_gauge && t["GAUGSQ"] > 1)
    out.refuse(fmt::format("GAUGSQ = {}: the gauge point is the innermost one here", t["GAUGSQ"]));
  if (by_gauge && rail.is_of_sections())
    return out.refuse(
        "GAUGHT of a rail that changes along the track: give RAILY0 and RAILZ0 with GAUGHT = -1");
  const std::optional<GaugePoint> gauge =
      by_gauge ? rail.gauge_point(t.number("CANT", 0), t["GAUGHT"], out) : std::nullopt;
  if (by_gauge && !gauge)
    return;
  if (by_gauge && gauge->on_face && !on_roller(state) && (r["ROLL"] == 0 || rail.keeps_origin())) {
    out.set("position.gauge_height", t["GAUGHT"]);
    out.set("position.gauge", t["GAUGWD"]);
    out.set("position.rail_vertical", r["DZ"]);
    return;
  }
  // RAILY0 and RAILZ0 stand in the places of GAUGSQ and GAUGWD. The axle of a roller stays where it is,
  // whatever DZ.
  const double side = left(state) ? -1 : 1;
  const double z = !by_gauge ? t["GAUGWD"] : on_roller(state) ? 0 : -gauge->top;
  out.set_text("rail.place", "absolute");
  out.set("rail.y", by_gauge ? t["GAUGWD"] / 2 - gauge->y : side * t["GAUGSQ"]);
  out.set("rail.z", z + (on_roller(state) ? r["DZ"] : 0));
  if (!on_roller(state))
    out.set("position.rail_vertical", r["DZ"]);
}

void add_track(const CaseState& state, const ProfileKeys& rail, ContactCase& out) {
  const Block &t = state[Data::track], &r = state[Data::rail_deviation];
  add_rail_place(state, rail, out);
  if (on_roller(state))
    out.set("rail.roller_radius", t["NOMRADR"]);
  else
    out.set("position.rail_inclination", t["CANT"]);
  if (const double curvature = t.number("CURV", 0); curvature != 0) {
    if (on_roller(state))
      out.refuse("CURV on a roller rig");
    out.set("track.curve_radius", 1 / curvature);
  }
  out.set("position.rail_lateral", r["DY"]);
  out.set("position.rail_roll", r["ROLL"]);
  if (r["VY"] != 0 || r["VZ"] != 0 || r["VROLL"] != 0)
    out.refuse("VY, VZ, VROLL of the rail: here it stands still");
}

void add_wheelset(const CaseState& state, ContactCase& out) {
  const Block& w = state[Data::wheelset];
  out.set("position.wheel_radius", w["NOMRAD"]);
  constexpr double no_tape_circle = 999; // mm; from here on YTAPE says that there is none
  if (const double tape = w.number("YTAPE", 1000); std::abs(tape) < no_tape_circle) {
    out.set("position.back_to_back", w["FBDIST"]);
    out.set("wheel.flange_back", w["FBPOS"]);
    out.set("position.tape_circle", tape - w["FBPOS"]);
    return;
  }
  // CONTACT has the nominal radius at z = 0 of the profile, wherever that lies.
  out.set_text("wheel.place", "absolute");
  out.set("wheel.y", w["FBDIST"] / 2 - w["FBPOS"]);
}

void add_pose(const CaseState& state, ContactCase& out) {
  const Block& p = state[Data::position];
  out.set("position.lateral", p["Y"]);
  out.set("position.roll", p["ROLL"]);
  out.set("position.yaw", p["YAW"]);
  if (on_roller(state) && p["S"] != 0)
    out.refuse(fmt::format("X_WS = {}: a wheel that does not stand on top of its roller", p["S"]));
  if (state.digits['N'] == 1 && p.has("FZ"))
    out.set("load.force", p["FZ"]);
  else if (state.digits['N'] == 0 && p.has("Z"))
    out.set("position.vertical", p["Z"]);
  else
    out.refuse(
        fmt::format("N = {}: its {} is not given", state.digits['N'], state.digits['N'] == 1 ? "FZ" : "Z"));
  if (!state.has(Data::wheel_deviation))
    return;
  const Block& d = state[Data::wheel_deviation];
  if (d["DX"] != 0)
    out.refuse(fmt::format("DX = {} of the wheel: a wheel before or behind its axle", d["DX"]));
  // There the wheel rolls about the origin of its profile, here about its centre, so far above. There its
  // deviation lies along the axes of the wheelset, which rolls, here along those of the track.
  const double radius = state[Data::wheelset]["NOMRAD"], roll = p["ROLL"];
  const double along = d["DY"] + radius * std::sin(d["DROLL"]),
               down = d["DZ"] + radius * (1 - std::cos(d["DROLL"]));
  out.set("position.wheel_lateral", along * std::cos(roll) - down * std::sin(roll));
  out.set("position.wheel_vertical", down * std::cos(roll) + along * std::sin(roll));
  out.set("position.wheel_roll", d["DROLL"]);
  out.set("position.wheel_yaw", d["DYAW"]);
}

/// Keys with their default value say nothing.
void leave_out_zeros(ContactCase& out) {
  std::erase_if(out.keys, [](const auto& entry) {
    const auto& [key, value] = entry;
    return value == "0" && (key.starts_with("position.") || key.starts_with("motion.")) &&
           key != "position.vertical";
  });
}

} // namespace

void add_wheel_rail_keys(const CaseState& state, const std::filesystem::path& folder, ContactCase& out) {
  out.set_text("kind", "wheel_rail");
  out.set_text("position.side", left(state) ? "left" : "right");
  refuse_digits_of_module_1(state, out);
  add_common_keys(state, out);
  add_friction_of_module_1(state, out);
  const ProfileKeys rail(state[Data::rail_profile], folder, "rail"),
      wheel(state[Data::wheel_profile], folder, "wheel");
  rail.add(out);
  wheel.add(out);
  if (!out.refused.empty())
    return;
  add_elements(state, out);
  add_track(state, rail, out);
  add_wheelset(state, out);
  add_pose(state, out);
  if (rail.is_of_sections())
    out.set("position.along", state[Data::position]["S"]);
  if (wheel.is_of_sections()) // PITCH turns what is below the axle forwards; here the wheel has rolled from 0
    out.set("wheel.sections_angle",
            state[Data::position].number("PITCH", 0) +
                (rail.is_of_sections() ? state[Data::position]["S"] / state[Data::wheelset]["NOMRAD"] : 0));
  add_velocity(state, out);
  leave_out_zeros(out);
}

} // namespace bem_contact::app::from_contact
