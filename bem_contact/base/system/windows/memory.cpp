#include "bem_contact/base/system/memory.hpp"

namespace bem_contact::system {

/// Large pages need a right there that hardly any user has.
void ask_for_large_pages(void*, std::size_t) {}

} // namespace bem_contact::system
