#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::report {

/// One HTML page that needs no other file and no network: report_data() as JSON, the plotting library, and
/// the scripts that draw. Throws InputError if this build has no plotting library.
std::string report_page(const nlohmann::json& data);

/// Reads `file` (see report_data()) and writes its page to `output`, whole or not at all. Throws InputError
/// also where `output` is `file` or cannot be written.
void write_report(const std::filesystem::path& file, const std::filesystem::path& output);

} // namespace bem_contact::report
