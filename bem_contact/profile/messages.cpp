#include "bem_contact/profile/messages.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace bem_contact {

std::shared_ptr<spdlog::logger> messages() {
  if (std::shared_ptr<spdlog::logger> set = spdlog::default_logger(); set && !set->name().empty())
    return set;
  static const std::shared_ptr<spdlog::logger> own = [] {
    auto logger = std::make_shared<spdlog::logger>("bem_contact",
                                                   std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    logger->set_pattern("%^%l%$: %v");
    return logger;
  }();
  return own;
}

} // namespace bem_contact
