#pragma once

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <sstream>
#include <string>

/// Catches what is logged while it lives.
class SaidWarnings {
public:
  SaidWarnings() {
    auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(out_);
    auto logger = std::make_shared<spdlog::logger>("test", sink);
    logger->set_pattern("%l: %v");
    spdlog::set_default_logger(logger);
  }
  ~SaidWarnings() { spdlog::set_default_logger(before_); }
  SaidWarnings(const SaidWarnings&) = delete;
  SaidWarnings& operator=(const SaidWarnings&) = delete;
  std::string text() const { return out_.str(); }

private:
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
  std::ostringstream out_;
};
