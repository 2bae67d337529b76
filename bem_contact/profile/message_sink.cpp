#include "bem_contact/profile/message_sink.hpp"

#include "bem_contact/base/message_file.hpp"
#include "bem_contact/base/printable.hpp"

#include <cstdio>
#include <memory>
#include <spdlog/spdlog.h>
#include <utility>

namespace bem_contact {

namespace {

/// Characters. A message that came several times is counted at the end, and quoted up to this length: enough
/// to recognise it. Chosen.
constexpr int repeated_length = 60;

/// Of a message that begins with the name of a file.
std::string without_folder(const std::string& text) {
  const std::size_t end = text.find(": ");
  const std::size_t slash = end == std::string::npos ? end : text.rfind('/', end);
  return slash == std::string::npos ? text : text.substr(slash + 1);
}

} // namespace

void MessageSink::log(const spdlog::details::log_msg& message) {
  std::fflush(stdout);
  const std::string text = printable({message.payload.data(), message.payload.size()});
  spdlog::details::log_msg shown = message;
  shown.payload = text;
  const bool may_repeat = message.level >= spdlog::level::err;
  if (!may_repeat && ++counts_[text] > 1)
    return;
  spdlog::sinks::ansicolor_stderr_sink_mt::log(shown);
  if (message.level >= spdlog::level::warn)
    tell(may_repeat ? Told::error : Told::warning, text);
}

void MessageSink::finish() {
  const std::map<std::string, int> counts = std::exchange(counts_, {});
  for (const auto& [text, count] : counts)
    if (count > 1) {
      const std::string named = without_folder(text);
      spdlog::info("{} times: {}{}", count, named.substr(0, repeated_length),
                   named.size() > static_cast<std::size_t>(repeated_length) ? " ..." : "");
    }
}

std::shared_ptr<MessageSink> install_message_sink() {
  auto sink = std::make_shared<MessageSink>();
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("bem_contact", sink));
  spdlog::set_pattern("%^%l%$: %v");
  return sink;
}

} // namespace bem_contact
