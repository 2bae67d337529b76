#include "bem_contact/contact_input/rules.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact_input/tables.hpp"

#include <fmt/format.h>
#include <string>

namespace bem_contact::contact_input {

namespace {

using enum Effect;
constexpr Condition always{'*', ""};
constexpr std::string_view new_bodies = "2349"; // values of C that read material

bool holds(const Condition& c, const Digits& digits) {
  return c.digit == '*' || digits.is(c.digit, c.values);
}

void keep(const InputLines& in, const CaseState& state, const DataRule& rule) {
  if (!state.has(rule.data))
    throw InputError(fmt::format("{}{} = {} keeps the {} of the case before", in.where(state.line),
                                 rule.when.digit, state.digits[rule.when.digit], name_of(rule.data)),
                     "no case of this result element has given it", "Give it in the first case.");
}

/// In the order of the files.
constexpr DataRule rules[] = {
    {both_modules, {'G', "02345"}, always, reads, Data::solver, "", read_solver},
    // module 3: the load comes first
    {module_3,
     {'N', "0"},
     {'F', "0"},
     reads,
     Data::kinematics,
     "PEN d, CKSI d, CETA d, CPHI d, SPINXO D, SPINYO D"},
    {module_3,
     {'N', "0"},
     {'F', "1"},
     reads,
     Data::kinematics,
     "PEN d, FX d, CETA d, CPHI d, SPINXO D, SPINYO D"},
    {module_3,
     {'N', "0"},
     {'F', "2"},
     reads,
     Data::kinematics,
     "PEN d, FX d, FY d, CPHI d, SPINXO D, SPINYO D"},
    {module_3,
     {'N', "1"},
     {'F', "0"},
     reads,
     Data::kinematics,
     "FN d, CKSI d, CETA d, CPHI d, SPINXO D, SPINYO D"},
    {module_3,
     {'N', "1"},
     {'F', "1"},
     reads,
     Data::kinematics,
     "FN d, FX d, CETA d, CPHI d, SPINXO D, SPINYO D"},
    {module_3,
     {'N', "1"},
     {'F', "2"},
     reads,
     Data::kinematics,
     "FN d, FX d, FY d, CPHI d, SPINXO D, SPINYO D"},
    {both_modules, {'L', "02346"}, {'V', "012"}, reads, Data::friction, "", read_friction},
    {both_modules, {'L', "1"}, always, keeps, Data::friction, ""},
    {module_3, {'C', new_bodies}, {'T', "23"}, reads, Data::rolling, "CHI a, DQ d, VELOC d, FACPHI D"},
    {module_1, {'C', "4"}, always, reads, Data::inclinations, "IF_METH i, VARIANT i"},
    {module_3, {'C', "4"}, always, reads, Data::inclinations, "", read_inclinations},
    {module_3, {'C', "9"}, always, reads, Data::influence_file, "CFNAME s"},
    {both_modules, {'C', new_bodies}, always, reads, Data::material, "POISS1 d, POISS2 d, GG1 d, GG2 d"},
    {both_modules, {'C', "01"}, always, keeps, Data::material, ""},
    {both_modules, {'C', new_bodies}, {'B', "1"}, reads, Data::sheet, "FLX_Z d"},
    {both_modules, {'C', new_bodies}, {'M', "1"}, reads, Data::viscoelastic, "FG1 d, FG2 d, TC1 d, TC2 d"},
    {both_modules,
     {'C', new_bodies},
     {'M', "2"},
     reads,
     Data::simplified,
     "FLX d, K0_MF d, ALFAMF d, BETAMF d"},
    {both_modules, {'C', new_bodies}, {'M', "35"}, reads, Data::simplified, "K0_MF d, ALFAMF d, BETAMF d"},
    {both_modules, {'C', new_bodies}, {'M', "4"}, reads, Data::layer, "GG3 d, LAYTHK d, TAU_C0 d, K_TAU d"},
    {both_modules, {'B', "1"}, always, keeps, Data::sheet, ""},
    {both_modules, {'M', "1"}, always, keeps, Data::viscoelastic, ""},
    {both_modules, {'M', "2"}, always, keeps, Data::simplified, ""},
    {both_modules, {'M', "4"}, always, keeps, Data::layer, ""},
    {both_modules, {'m', "0"}, always, removes, Data::damping, ""},
    {both_modules, {'m', "2"}, always, reads, Data::damping, "CDAMPN d, CDAMPT d, DFNMAX d, DFTMAX d"},
    {both_modules, {'H', "3"}, always, reads, Data::heat, "", read_heat},
    {both_modules, {'H', "1"}, always, keeps, Data::heat, ""},
    {both_modules, {'H', "3"}, {'M', "4"}, reads, Data::plastic_heat, "BETAPL d"},
    // module 3: grid, distance, friction by row, slip
    {module_3, {'D', "2"}, always, reads, Data::potential, "", read_potential},
    {module_3, {'D', "01"}, always, keeps, Data::potential, ""},
    {module_3, {'Z', "2"}, always, reads, Data::distance, "", read_distance},
    {module_3, {'Z', "01"}, always, keeps, Data::distance, ""},
    {module_3, {'L', "02346"}, {'V', "3"}, reads, Data::friction, "", read_friction},
    {module_3, {'E', "023"}, always, removes, Data::slip, ""},
    {module_3, {'E', "1"}, always, keeps, Data::slip, ""},
    {module_3, {'E', "9"}, always, reads, Data::slip, "", read_slip},
    // module 1: grid, track, wheelset
    {module_1,
     {'D', "23456789"},
     always,
     reads,
     Data::elements,
     "DX d, DS d, DQREL d, A_SEP a, D_SEP d, D_COMB d, D_TURN D, G_MISS D"},
    {module_1, {'D', "01"}, always, keeps, Data::elements, ""},
    {module_1, {'Z', "13"}, {'1', "01"}, reads, Data::track, "GAUGHT d, GAUGSQ d, GAUGWD d, CANT a, CURV D"},
    {module_1,
     {'Z', "13"},
     {'1', "45"},
     reads,
     Data::track,
     "GAUGHT d, GAUGSQ d, GAUGWD d, NOMRADR d, CURV D"},
    {module_1, {'Z', "02"}, always, keeps, Data::track, ""},
    {module_1, {'Z', "3"}, always, reads, Data::rail_profile, "", read_rail_profile},
    {module_1, {'Z', "012"}, always, keeps, Data::rail_profile, ""},
    {module_1, {'Z', "23"}, always, reads, Data::rail_deviation, "DY d, DZ d, ROLL a, VY d, VZ d, VROLL a"},
    {module_1, {'Z', "01"}, always, keeps, Data::rail_deviation, ""},
    {module_1, {'Z', "23"}, {'F', "3"}, reads, Data::rail_springs, "KY d, FY d, KZ d, FZ d, DYSTEP0 D"},
    {module_1, {'F', "3"}, always, keeps, Data::rail_springs, ""},
    {module_1, {'E', "35"}, always, reads, Data::wheelset, "FBDIST d, FBPOS d, NOMRAD d, YTAPE D"},
    {module_1, {'E', "0124"}, always, keeps, Data::wheelset, ""},
    {module_1, {'E', "35"}, always, reads, Data::wheel_profile, "", read_wheel_profile},
    {module_1, {'E', "0124"}, always, keeps, Data::wheel_profile, ""},
    {module_1, {'E', "12345"}, {'N', "0"}, reads, Data::position, "S d, Y d, Z d, ROLL a, YAW a, PITCH a"},
    {module_1, {'E', "12345"}, {'N', "1"}, reads, Data::position, "S d, Y d, FZ d, ROLL a, YAW a, PITCH a"},
    {module_1, {'E', "0"}, always, keeps, Data::position, ""},
    {module_1, {'E', "2345"}, always, reads, Data::velocity, "", read_velocity},
    {module_1, {'E', "01"}, always, keeps, Data::velocity, ""},
    {module_1, {'E', "45"}, always, reads, Data::wheel_deviation, "", read_wheel_deviation},
    {both_modules, {'S', "23"}, always, reads, Data::stresses, "", read_stresses},
    {both_modules, {'S', "1"}, always, keeps, Data::stresses, ""},
};

} // namespace

std::span<const DataRule> data_rules() {
  return rules;
}

void apply_rules(InputLines& in, CaseState& state) {
  for (const DataRule& rule : data_rules()) {
    if ((rule.modules & bit_of(state.module)) == 0 || !holds(rule.when, state.digits) ||
        !holds(rule.also, state.digits))
      continue;
    if (rule.effect == removes)
      state.remove(rule.data);
    else if (rule.effect == keeps)
      keep(in, state, rule);
    else if (rule.read)
      rule.read(in, state);
    else
      state.set(rule.data, Block(rule.format, in.take(rule.format)));
  }
}

} // namespace bem_contact::contact_input
