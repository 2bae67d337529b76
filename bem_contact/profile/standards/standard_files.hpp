#pragma once

#include <string_view>

namespace bem_contact {

/// The text of a file of data/standards, as it was when the program was built. The build writes its source,
/// so that the library needs no file when it runs. Empty for an unknown name.
std::string_view standard_file(std::string_view name);

} // namespace bem_contact
