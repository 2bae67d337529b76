#pragma once

#include "bem_contact/inside/stresses_inside.hpp"

#include <filesystem>
#include <string>

namespace bem_contact::app {

/// The stresses of a result (bem_contact solve -o) inside the real body of a body file, with those of the
/// half-space beside them: the programs mesh_body and fem_influence compute them. `points`: a file of points
/// of one's own; "": those below each patch. Throws InputError where a program is missing, or refuses the
/// body.
inside::StressesInside stresses_in_body(const std::filesystem::path& result,
                                        const std::filesystem::path& body, const std::string& points = "");

} // namespace bem_contact::app
