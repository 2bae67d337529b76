#pragma once

#include <string>
#include <string_view>

namespace bem_contact {

/// The project's version, "major.minor.patch".
std::string_view version();

/// The commit that this was built from, "+changes" added if the sources had others; "unknown" outside git.
std::string_view commit();

/// What a program writes into its results to say who made them: its name and version. No time, host, user
/// or path, so that two runs on the same input write the same bytes.
std::string provenance(std::string_view program);

} // namespace bem_contact
