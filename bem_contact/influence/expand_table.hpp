#pragma once

#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/expand_scope.hpp"

/// Private to this room.
namespace bem_contact {

/// Sums of a table's numbers. Throws InputError where the table does not serve the options.
InfluenceNumbers expand_table(const InfluenceFunction& function, const ExpandOptions& options,
                              StationRange range, const Scaling& scaling);

} // namespace bem_contact
