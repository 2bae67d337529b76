#include "bem_contact/base/told_program.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/message_file.hpp"

#include <fmt/format.h>

namespace bem_contact {

std::string run_told_program(std::vector<std::string> words, const std::filesystem::path& folder,
                             const std::atomic<bool>* stop, const std::function<void(double)>& progress) {
  const std::string name = std::filesystem::path(words.front()).filename().string();
  MessageFile told(folder / (name + "_messages.txt"));
  std::error_code unknown;
  std::filesystem::remove(told.file(), unknown); // of a call before
  std::string errors, how;
  const auto take = [&] {
    for (const ToldMessage& message : told.next())
      if (message.kind == Told::progress && progress)
        progress(message.share);
      else if (message.kind == Told::error)
        errors += (errors.empty() ? "" : " ") + message.text;
  };
  ChildProcess child(
      folder / (name + "_printed.txt"),
      {.words = std::move(words), .variables = {{message_file_variable, told.file().string()}}});
  std::string last; // of what stands on standard error: a library may end the program
  while (const auto said = child.next_line(stop, take)) {
    last = *said;
    take();
  }
  if (stop && *stop)
    return "";
  const int code = child.wait(how);
  take();
  if (code == 0)
    return "";
  return fmt::format("{}: {}", name,
                     !errors.empty() ? errors
                     : !last.empty() ? last
                     : how.empty()   ? fmt::format("exit code {}", code)
                                     : how);
}

} // namespace bem_contact
