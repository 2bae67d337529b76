#include "bem_contact/profile/messages.hpp"

#include <algorithm>
#include <mutex>
#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <utility>

namespace bem_contact {

namespace {

thread_local std::shared_ptr<spdlog::logger> collecting;

class Collector : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
public:
  explicit Collector(std::shared_ptr<std::vector<std::string>> warnings) : warnings_(std::move(warnings)) {}

private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const std::string text(message.payload.begin(), message.payload.end());
    if (message.level >= spdlog::level::warn && std::ranges::find(*warnings_, text) == warnings_->end())
      warnings_->push_back(text);
  }
  void flush_() override {}

  std::shared_ptr<std::vector<std::string>> warnings_;
};

std::shared_ptr<spdlog::logger>& own_logger() {
  static std::shared_ptr<spdlog::logger> own = [] {
    auto logger = std::make_shared<spdlog::logger>("bem_contact",
                                                   std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    logger->set_pattern("%^%l%$: %v");
    return logger;
  }();
  return own;
}

std::shared_ptr<spdlog::logger> logger() {
  if (collecting)
    return collecting;
  if (std::shared_ptr<spdlog::logger> set = spdlog::default_logger(); set && !set->name().empty())
    return set;
  return own_logger();
}

} // namespace

void say(Importance importance, const std::string& text) {
  logger()->log(importance == Importance::warning ? spdlog::level::warn : spdlog::level::info, "{}", text);
}

void send_messages_to(std::shared_ptr<spdlog::logger> logger) {
  own_logger() = std::move(logger);
}

CollectedMessages::CollectedMessages()
    : warnings_(std::make_shared<std::vector<std::string>>()), before_(std::move(collecting)) {
  collecting = std::make_shared<spdlog::logger>("bem_contact", std::make_shared<Collector>(warnings_));
}
CollectedMessages::~CollectedMessages() {
  collecting = std::move(before_);
}

} // namespace bem_contact
