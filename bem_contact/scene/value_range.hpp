#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/toml.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// More is a typing error: the records of the cases alone would need gigabytes.
inline constexpr std::size_t most_cases = 10'000'000;

/// What a range has.
inline constexpr std::string_view keys_of_ranges[] = {"from", "to", "step", "count"};

/// The values of { from = a, to = b, step = c } or { from = a, to = b, count = n }. `name`
/// ("sweep.load.force") and `where` ("scene.toml:3: ") are for messages. Throws InputError.
std::vector<SchemaValue> values_of_range(const toml::table& ends, const std::string& name,
                                         const std::string& where);

} // namespace bem_contact
