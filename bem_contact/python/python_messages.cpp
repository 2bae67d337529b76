#include "bem_contact/python/python_messages.hpp"

#include "bem_contact/profile/messages.hpp"

#include <memory>
#include <pybind11/pybind11.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/sink.h>
#include <string>

namespace bem_contact {

namespace {

namespace py = pybind11;

/// Has no lock: a thread that holds one and waits for Python would stop the thread that holds Python.
class LoggingSink : public spdlog::sinks::sink {
public:
  void log(const spdlog::details::log_msg& message) override {
    if (!Py_IsInitialized())
      return;
    const py::gil_scoped_acquire python;
    try {
      const char* level = message.level >= spdlog::level::err    ? "error"
                          : message.level >= spdlog::level::warn ? "warning"
                                                                 : "info";
      const py::str text(message.payload.data(), message.payload.size());
      py::module_::import("bem_contact.messages").attr("say")(level, text);
    } catch (py::error_already_set& error) { // a handler of the user's
      error.discard_as_unraisable("bem_contact");
    }
  }
  void flush() override {}
  void set_pattern(const std::string& /*pattern*/) override {}
  void set_formatter(std::unique_ptr<spdlog::formatter> /*formatter*/) override {}
};

} // namespace

void send_messages_to_logging() {
  send_messages_to(std::make_shared<spdlog::logger>("bem_contact", std::make_shared<LoggingSink>()));
}

} // namespace bem_contact
