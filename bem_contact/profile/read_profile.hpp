#pragma once

#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Reads a profile file: Simpack .prr/.prw, MiniProf .ban/.whl (told by their contents), else plain columns
/// "y z". The curve's frame is that of ProfileCurve: mm, y to the right (rail: 0 where the file has it,
/// wheel: 0 at the tape circle), z down.
///
/// Points may come in either walking order. Repaired, with a warning (spdlog): metres for millimetres, z
/// upward, a wheel's flange at y > 0, shuffled points, doubled or crowded points (nearer than 0.01 mm),
/// single points that zig-zag, loops shorter than 1 mm.
///
/// Throws InputError: no such file, empty, truncated, not a number, a size that no rail or wheel has, a file
/// of the other kind, smoothing asked for (approx.smooth), zig-zag and loops beyond repair.
ProfileCurve read_profile(const std::filesystem::path& file, ProfileKind kind);
ProfileCurve parse_profile(std::string_view text, std::string_view source_name, ProfileKind kind);

/// A standard profile by its name; of a body file (*.toml) the contact curve of the body; else a profile
/// file. Relative paths start in `folder`. Throws InputError where a standard or a body is of the other kind
/// (upper bodies are wheels); and names the nearest standards where there is no such file.
ProfileCurve named_profile(std::string_view name_or_file, ProfileKind kind,
                           const std::filesystem::path& folder = {});

} // namespace bem_contact
