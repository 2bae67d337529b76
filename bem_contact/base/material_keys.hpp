#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/base/schema.hpp"

#include <string>

namespace bem_contact {

/// Adds the keys of a material under `table`: shear_modulus or young (one of the two), and poisson. `young`
/// must live as long as the schema.
void add_material(Schema& schema, const std::string& table, Material& material, double& young);

/// Sets the shear modulus after reading, where the file gives young. Throws InputError where it gives both.
void settle_material(const Schema& schema, const std::string& table, Material& material, double young);

} // namespace bem_contact
