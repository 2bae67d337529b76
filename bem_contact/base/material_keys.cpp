#include "bem_contact/base/material_keys.hpp"

namespace bem_contact {

void add_material(Schema& schema, const std::string& table, Material& material, double& young) {
  SchemaTable t(schema, table);
  young = material.young();
  t.add("shear_modulus", material.shear_modulus, "G; give either this or young", {.unit = "MPa", .above = 0});
  t.add("young", young, "E; give either this or shear_modulus = E/(2 (1 + poisson))",
        {.unit = "MPa", .above = 0, .commented_out = true});
  t.add("poisson", material.poisson, "Poisson's ratio", {.at_least = 0, .below = 0.5});
}

void settle_material(const Schema& schema, const std::string& table, Material& material, double young) {
  if (!schema.has(table + ".young"))
    return;
  if (schema.has(table + ".shear_modulus"))
    schema.refuse(table + ".young", "shear_modulus is given too", "Give exactly one of the two.");
  material.shear_modulus = young / (2 * (1 + material.poisson));
}

} // namespace bem_contact
