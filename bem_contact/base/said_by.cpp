#include "bem_contact/base/said_by.hpp"

#include "bem_contact/base/error.hpp"

#include <new>

namespace bem_contact {

std::string said_by(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr)
    return error.what();
  return Error(
             "Memory ran out", "this machine, or a limit for this process, gives no more",
             "Ask for fewer elements (a smaller grid, or larger grid.dx and grid.ds), or end other programs.")
      .what();
}

} // namespace bem_contact
