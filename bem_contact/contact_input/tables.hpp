#pragma once

#include "bem_contact/contact_input/blocks.hpp"

namespace bem_contact::contact_input {

// Data that are more than one item of the file: for the table of rules alone (rules.hpp).

void read_solver(InputLines& in, CaseState& state);
/// Rows of [place, ] coefficients: FSTAT, FKIN (L = 0); FKIN, F1, SABSH1, F2, SABSH2 (L = 2, 3, 4); FREF,
/// TREF, DFHEAT, DTHEAT (L = 6). The place is an angle (V = 1) or a length (V = 2).
void read_friction(InputLines& in, CaseState& state);
void read_inclinations(InputLines& in, CaseState& state); ///< rows y, angle
void read_heat(InputLines& in, CaseState& state);         ///< names end with 1 (rail, lower body) and 2
void read_potential(InputLines& in, CaseState& state);
void read_distance(InputLines& in,
                   CaseState& state); ///< values: of the distance by IBASE; of the planform by IPLAN not kept
void read_slip(InputLines& in, CaseState& state); ///< rows wx, wy of each element
void read_rail_profile(InputLines& in, CaseState& state);
void read_wheel_profile(InputLines& in, CaseState& state);
void read_velocity(InputLines& in, CaseState& state);
void read_wheel_deviation(InputLines& in, CaseState& state);
void read_stresses(InputLines& in, CaseState& state);

} // namespace bem_contact::contact_input
