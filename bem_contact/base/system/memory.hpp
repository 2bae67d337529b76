#pragma once

#include <cstddef>

namespace bem_contact::system {

/// Asks for large pages in this memory, before it is touched. Where they cannot be had all is as before.
void ask_for_large_pages(void* begin, std::size_t bytes);

} // namespace bem_contact::system
