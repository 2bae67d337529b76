#pragma once

#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace spdlog {
class logger;
} // namespace spdlog

namespace bem_contact {

enum class Importance { information, warning };

/// Goes to who collects messages on this thread, else to spdlog's default logger if the host has set one,
/// else to standard error. spdlog's own default is standard output, which belongs to the host: a Python or C
/// program may write its results there.
void say(Importance importance, const std::string& text);

/// Text and values as fmt::format() takes them.
template <typename... Values> void say_warning(fmt::format_string<Values...> text, Values&&... values) {
  say(Importance::warning, fmt::format(text, std::forward<Values>(values)...));
}
template <typename... Values> void say_info(fmt::format_string<Values...> text, Values&&... values) {
  say(Importance::information, fmt::format(text, std::forward<Values>(values)...));
}

/// Sends messages to another logger where the host has set none: a module whose own host has one of another
/// kind. To be called before anything else is.
void send_messages_to(std::shared_ptr<spdlog::logger> logger);

/// Keeps what this thread says while it lives, in place of printing it: a window shows it itself.
class CollectedMessages {
public:
  CollectedMessages();
  ~CollectedMessages();
  CollectedMessages(const CollectedMessages&) = delete;
  CollectedMessages& operator=(const CollectedMessages&) = delete;

  /// In the order in which they came, each once; what only informs is left out.
  const std::vector<std::string>& warnings() const { return *warnings_; }

private:
  std::shared_ptr<std::vector<std::string>> warnings_;
  std::shared_ptr<spdlog::logger> before_; ///< that of an outer one
};

} // namespace bem_contact
