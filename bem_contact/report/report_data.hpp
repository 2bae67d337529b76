#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace bem_contact::report {

/// What a page shows of a file that bem_contact wrote: a result, a comparison, a sweep, creep curves,
/// conicity, a wheelset or wear.
///
/// "kind" says which of these, "file" its name, and "data" holds what is in the file, as a tree: a group is
/// an object, its attributes are in "attributes", a dataset is {unit, description, shape, values} (row-major;
/// nan is null), a text {text, description}. Left out is what no figure draws: displacements, fields of
/// single steps, stresses by point, fields of a sweep's cases. Of wear, "steps" has up to five profiles of
/// each body
/// ([y, z] of each point), which lie beside the file. Throws InputError for any other file.
nlohmann::json report_data(const std::filesystem::path& file);

} // namespace bem_contact::report
