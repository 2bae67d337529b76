#pragma once

#include "bem_contact/geometry/conformity.hpp"
#include "bem_contact/record/column.hpp"
#include "bem_contact/record/record.hpp"

#include <optional>
#include <span>
#include <string>

namespace bem_contact {

/// The numbers of a Conformity, in the order of the outputs.
std::span<const ColumnOf<Conformity>> conformity_columns();
/// Its numbers and its class in words; nothing where there is none.
record::Content conformity_of(const std::optional<Conformity>& conformity);
/// For people, in one line without its end. `where`: "first touch", "flange root at the gauge corner".
std::string conformity_text(const Conformity& conformity, const std::string& where);

} // namespace bem_contact
