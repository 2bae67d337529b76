#pragma once

#include <string>
#include <string_view>

namespace bem_contact {

/// The whole text of a file. Throws InputError when it cannot be read; `what` names it there.
std::string read_text_file(const std::string& file, std::string_view what);

} // namespace bem_contact
