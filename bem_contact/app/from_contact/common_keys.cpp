#include "bem_contact/app/from_contact/common_keys.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact::app::from_contact {

namespace {

using contact_input::Block;
using contact_input::CaseState;
using contact_input::Data;

void add_motion(const CaseState& state, ContactCase& out) {
  static constexpr const char* kinds[] = {"steady", "shift", "transient", "steady"};
  out.set_text("motion.kind", kinds[state.digits['T']]);
  if (state.digits['T'] == 0)
    out.set("motion.frictionless", "true");
}

/// Digits without a counterpart that would make the scene another problem.
void refuse_digits(const CaseState& state, ContactCase& out) {
  const auto& d = state.digits;
  if (d.is('B', "23456"))
    out.refuse(
        fmt::format("B = {}: an approximate pressure; here the contact conditions are solved", d['B']));
  if (d['M'] == 1)
    out.refuse("M = 1: viscoelastic bodies");
  if (d.is('M', "23567"))
    out.refuse(fmt::format("M = {}: the simplified theory with flexibilities and slope reduction of its own; "
                           "solver.model = \"simplified\" has those of Kalker's coefficients",
                           d['M']));
  if (d.is('R', "23"))
    out.refuse(fmt::format("R = {}: CONTACT reads this case and does not solve it", d['R']));
  if (d['g'] != 0 && state.module == 3)
    out.leave("the weight of the gap in front of M2");
  if (state.has(Data::damping)) {
    const Block& damping = state[Data::damping];
    if (damping["CDAMPN"] != 0 || damping["CDAMPT"] != 0)
      out.refuse("M2: damping");
  }
  if (d['S'] != 0)
    out.leave(fmt::format("S = {}: points below the surface; give [stresses] with depths", d['S']));
  for (const std::string& remark : state.remarks)
    out.leave(remark);
}

void add_model(const CaseState& state, ContactCase& out) {
  const int model = state.effective['C'];
  if (model == 9)
    out.refuse("C = 9: influence coefficients of a file; here solver.model = \"fem\" takes influence files "
               "of both bodies");
  if (model == 3)
    out.leave("C = 3: bilinear elements; here they are constant");
  out.set_text("solver.model", model == 4 ? "tangent_plane" : "halfspace");
}

void add_bodies(const CaseState& state, ContactCase& out) {
  const Block& m = state[Data::material];
  out.set("rail.material.poisson", m["POISS1"]);
  out.set("wheel.material.poisson", m["POISS2"]);
  out.set("rail.material.shear_modulus", m["GG1"]);
  out.set("wheel.material.shear_modulus", m["GG2"]);
  if (state.digits['B'] == 1)
    out.set("layer.normal_compliance", state[Data::sheet]["FLX_Z"]);
  if (state.digits['M'] != 4)
    return;
  constexpr double never_yields = 1e10; // MPa; from here on CONTACT takes none
  const Block& layer = state[Data::layer];
  if (state.digits['T'] == 0)
    return;
  if (layer["LAYTHK"] != 0) { // without thickness it has no compliance
    out.set("layer.shear_modulus", layer["GG3"]);
    out.set("layer.thickness", layer["LAYTHK"]);
  }
  if (layer["TAU_C0"] != 0 && layer["TAU_C0"] < never_yields) {
    out.set("layer.yield_shear", layer["TAU_C0"]);
    out.set("layer.hardening", layer["K_TAU"]);
  }
}

void add_heat(const CaseState& state, ContactCase& out) {
  if (state.digits['H'] == 0)
    return;
  out.set("temperature.flash", "true");
  // CONTACT has W/(mm K) and kg/mm3.
  for (const auto& [body, n] : {std::pair{"rail", "1"}, {"wheel", "2"}}) {
    const Block& heat = state[Data::heat];
    const std::string key = fmt::format("temperature.{}", body), end = n;
    out.set(key, heat["BKTEMP" + end]);
    out.set(key + "_heat_capacity", heat["HEATCP" + end]);
    out.set(key + "_conductivity", heat["LAMBDA" + end] * 1e3);
    out.set(key + "_density", heat["DENS" + end] * 1e9);
  }
}

/// L = 4, friction that falls: FKIN + FEXP1 2^(-w / SABSH1) + the same of the second pair.
void add_exponential(const Block& f, std::size_t row, std::size_t at, ContactCase& out) {
  const double kinetic = f.at(row, at), first = f.at(row, at + 1), second = f.at(row, at + 3);
  if (first == 0 && second == 0)
    return;
  if (first != 0 && second != 0)
    return out.refuse("L = 4 with FEXP1 and FEXP2: friction falls in two steps; here it has one");
  if (kinetic == 0)
    return out.refuse("L = 4 with FKIN = 0: friction that falls to nothing");
  out.set("motion.falling_friction", kinetic);
  out.set("motion.half_slip_velocity", f.at(row, first != 0 ? at + 2 : at + 4));
  if (f["MEMDST"] > 0) {
    out.set("motion.friction_memory", f["MEMDST"]);
    out.set("motion.memory_velocity", f["MEM_S0"]);
  }
}

/// L = 6: FREF up to TREF, FREF + DFHEAT from TREF + DTHEAT on.
void add_hot(const Block& f, std::size_t row, std::size_t at, ContactCase& out) {
  const double change = f.at(row, at + 2);
  if (change == 0)
    return;
  if (change > 0)
    return out.refuse("L = 6 with DFHEAT above 0: friction that grows with the temperature");
  if (f.at(row, at) + change <= 0)
    return out.refuse("L = 6 with FREF + DFHEAT = 0: friction that falls to nothing");
  out.set("temperature.hot_friction", f.at(row, at) + change);
  out.set("temperature.falls_from", f.at(row, at + 1));
  out.set("temperature.falls_to", f.at(row, at + 1) + f.at(row, at + 3));
}

bool is_constant(const Block& f, int law, std::size_t row, std::size_t at) {
  return law == 0 || (law == 6 ? f.at(row, at + 2) == 0 : f.at(row, at + 1) == 0 && f.at(row, at + 3) == 0);
}

void refuse_friction(const CaseState& state, std::size_t row, ContactCase& out) {
  const Block& f = state[Data::friction];
  const int law = state.effective['L'];
  const std::size_t at = first_coefficient(state);
  if (law == 0 && std::abs(f.at(row, at) - f.at(row, at + 1)) > 1e-3 * std::abs(f.at(row, at + 1)))
    out.refuse(fmt::format("L = 0 with FSTAT = {} and FKIN = {}: CONTACT itself asks for equal ones",
                           f.at(row, at), f.at(row, at + 1)));
  if (is_constant(f, law, row, at))
    return;
  if (law == 2 || law == 3)
    out.refuse(fmt::format("L = {}: friction that falls by a {} law; here it falls exponentially", law,
                           law == 2 ? "linear" : "rational"));
  if (f["MEMDST"] > 0 && (law != 4 || state.digits['T'] != 3))
    out.refuse(fmt::format("L = {} with MEMDST = {}: here friction remembers in steady rolling, where it "
                           "falls with the slip velocity",
                           law, f["MEMDST"]));
}

} // namespace

std::size_t first_coefficient(const CaseState& state) {
  return state.effective['V'] == 1 || state.effective['V'] == 2 ? 1 : 0;
}

double friction_in_adhesion(const CaseState& state, std::size_t row) {
  const Block& f = state[Data::friction];
  const std::size_t at = first_coefficient(state);
  const int law = state.effective['L'];
  return law == 0 || law == 6 ? f.at(row, at) : f.at(row, at) + f.at(row, at + 1) + f.at(row, at + 3);
}

void add_friction(const CaseState& state, std::size_t row, ContactCase& out) {
  refuse_friction(state, row, out);
  out.friction = friction_in_adhesion(state, row);
  if (state.digits['T'] == 0)
    return;
  out.set("motion.friction", out.friction);
  if (state.effective['L'] == 4)
    add_exponential(state[Data::friction], row, first_coefficient(state), out);
  else if (state.effective['L'] == 6)
    add_hot(state[Data::friction], row, first_coefficient(state), out);
}

void add_friction_table(const CaseState& state, const std::string& header, const std::vector<double>& places,
                        ContactCase& out) {
  const Block& f = state[Data::friction];
  const std::size_t at = first_coefficient(state);
  std::size_t largest = 0;
  std::string text = header + ",mu\n";
  for (std::size_t row = 0; row < f.rows(); ++row) {
    const double mu = friction_in_adhesion(state, row);
    largest = mu > friction_in_adhesion(state, largest) ? row : largest;
    text += fmt::format("{},{}\n", places.at(row), mu);
    if (state.effective['L'] != 0 &&
        (!is_constant(f, state.effective['L'], row, at) || !is_constant(f, state.effective['L'], 0, at)))
      for (std::size_t k = at; k < f.columns; ++k) { // one law in proportion is all that a table has here
        const bool coefficient =
            state.effective['L'] == 6 ? k == at || k == at + 2 : (k - at) % 2 != 0 || k == at;
        const double expected = coefficient ? f.at(0, k) * mu / friction_in_adhesion(state, 0) : f.at(0, k);
        if (std::abs(f.at(row, k) - expected) > 1e-6 * (std::abs(expected) + 1e-12))
          return out.refuse(fmt::format("V = {} with L = {}: laws of friction that are not in proportion",
                                        state.effective['V'], state.effective['L']));
      }
  }
  add_friction(state, largest, out);
  if (state.digits['T'] == 0)
    return;
  out.keys.erase("motion.friction");
  out.tables.push_back({"motion.friction_table", std::move(text)});
}

double contact_modulus(const Block& m) {
  return 1 / ((1 - m["POISS1"]) / (2 * m["GG1"]) + (1 - m["POISS2"]) / (2 * m["GG2"]));
}

void add_common_keys(const CaseState& state, ContactCase& out) {
  refuse_digits(state, out);
  add_motion(state, out);
  add_model(state, out);
  add_bodies(state, out);
  add_heat(state, out);
}

} // namespace bem_contact::app::from_contact
