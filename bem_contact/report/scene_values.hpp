#pragma once

#include "bem_contact/record/record.hpp"

#include <string_view>

namespace bem_contact::report {

/// The value of each key of a scene, as texts: "motion.friction" is "0.3". Lists and tables of lists are left
/// out. Empty for what is no TOML. Pages read no scene themselves.
record::Record scene_values(std::string_view scene);

} // namespace bem_contact::report
