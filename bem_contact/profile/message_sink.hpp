#pragma once

#include <spdlog/sinks/ansicolor_sink.h>

#include <map>
#include <string>

namespace bem_contact {

/// Messages on standard error, each once: what comes again is counted. What the program has printed before
/// comes before a message, so that none stands within a line of a table where both go to one file.
class MessageSink : public spdlog::sinks::ansicolor_stderr_sink_mt {
public:
  void log(const spdlog::details::log_msg& message) override;
  /// At the end: says which warnings came more than once.
  void finish();

private:
  std::map<std::string, int> counts_; ///< of each message
};

/// Makes it the sink of all messages of a program. Libraries leave the choice to their host (messages.hpp).
std::shared_ptr<MessageSink> install_message_sink();

} // namespace bem_contact
