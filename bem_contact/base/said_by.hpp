#pragma once

#include <exception>
#include <string>

namespace bem_contact {

/// What an exception says; of one that memory ran out, what to do about it.
std::string said_by(const std::exception& error);

} // namespace bem_contact
