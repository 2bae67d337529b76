#pragma once

#include <string>

namespace bem_contact::fem {

/// `fem_influence BODY.toml MESH.msh -o OUT.h5`: the harmonic method, from files to a file. Called by all
/// processes together. Throws InputError for files or settings that do not fit.
void harmonic_command(const std::string& body_file, const std::string& mesh, const std::string& output);

} // namespace bem_contact::fem
