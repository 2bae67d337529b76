#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What a program says to the program that has called it, beside what people read on its standard error.
namespace bem_contact {

/// The environment variable that names the file of messages. Nothing is told where it is not set.
inline constexpr const char* message_file_variable = "BEM_CONTACT_MESSAGES";

/// A message in the file is one line: "error", "warning" or "progress", a tab, and its text (of progress
/// "done of all" with a slash: "12/39").
enum class Told { error, warning, progress };
struct ToldMessage {
  Told kind;
  std::string text = {};
  double share = 0; ///< of progress: what is done of all
};

void tell(Told kind, std::string_view text);
void tell_progress(std::size_t done, std::size_t all);

/// "error: ..." on standard error, and told.
void say_error(std::string_view text);

/// Reads a file of messages while it grows.
class MessageFile {
public:
  explicit MessageFile(std::filesystem::path file) : file_(std::move(file)) {}

  const std::filesystem::path& file() const { return file_; }
  /// What has come since the last call; nothing where there is no such file yet.
  std::vector<ToldMessage> next();

private:
  std::filesystem::path file_;
  std::size_t read_ = 0; ///< bytes
};

} // namespace bem_contact
