#pragma once

#include <spdlog/logger.h>

#include <memory>

namespace bem_contact {

/// Where warnings of profiles go: spdlog's default logger if the host has set one, else standard error.
/// spdlog's own default is standard output, which belongs to the host: a Python or C program may write its
/// results there.
std::shared_ptr<spdlog::logger> messages();

} // namespace bem_contact
