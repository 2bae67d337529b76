#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/contact_input/blocks.hpp"

#include <string>

namespace bem_contact::app::from_contact {

/// What both modules have: motion.kind, friction, bodies, layer, heat, model. Digits that neither a key nor
/// another method stands for are refused by name.
void add_common_keys(const contact_input::CaseState& state, ContactCase& out);

/// Contact modulus of the pair, MPa.
double contact_modulus(const contact_input::Block& material);

/// The law of friction as keys; `row` of the block's table. Sets out.friction.
void add_friction(const contact_input::CaseState& state, std::size_t row, ContactCase& out);
/// The coefficient in adhesion of one row.
double friction_in_adhesion(const contact_input::CaseState& state, std::size_t row);
/// Row by row: where (inclination or s) and the coefficient; a law that differs by more is refused. `header`:
/// "s" or "inclination"; `sign` is that of the place.
void add_friction_table(const contact_input::CaseState& state, const std::string& header,
                        const std::vector<double>& places, ContactCase& out);

/// Index of the first coefficient in a row of the friction table: 1 behind ALPHA or SVF.
std::size_t first_coefficient(const contact_input::CaseState& state);

} // namespace bem_contact::app::from_contact
