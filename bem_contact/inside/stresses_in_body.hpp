#pragma once

#include "bem_contact/inside/stresses_inside.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::inside {

/// The stresses of a result (bem_contact solve -o) inside the real body of a body file, with those of the
/// half-space beside them: the programs mesh_body and fem_influence beside this one, or on PATH, compute
/// them. Or of the body of an influence file that has stresses (stresses_by_file.hpp), without any program.
/// `points`: a file of points of one's own; "": those below each patch. Throws InputError where a program is
/// missing, or refuses the body.
StressesInside stresses_in_body(const std::filesystem::path& result, const std::filesystem::path& body,
                                const std::string& points = "");

/// Those of many results, one after the other: matrices are factorized once for all. `take` gets the number
/// of a result and its stresses.
void stresses_in_body(const std::vector<std::filesystem::path>& results, const std::filesystem::path& body,
                      const std::string& points,
                      const std::function<void(std::size_t, StressesInside)>& take);

} // namespace bem_contact::inside
