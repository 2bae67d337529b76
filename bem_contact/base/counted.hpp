#pragma once

#include <cstddef>
#include <string>

namespace bem_contact {

/// "1 patch", "2 patches".
inline std::string counted(std::ptrdiff_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace bem_contact
