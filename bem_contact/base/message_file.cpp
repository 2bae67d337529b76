#include "bem_contact/base/message_file.hpp"

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/base/number_text.hpp"
#include "bem_contact/base/printable.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>

template <> struct bem_contact::EnumNames<bem_contact::Told> {
  static constexpr std::array<std::string_view, 3> names{"error", "warning", "progress"};
};

namespace bem_contact {

namespace {

/// The number with which the text begins; 0 where it begins with none.
double first_number(std::string_view text) {
  return number_of_text(text.substr(0, text.find_first_not_of("0123456789."))).value_or(0);
}

/// 0 where the text has not this form.
double share_of(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const double done = first_number(text),
               all = slash < text.size() ? first_number(text.substr(slash + 1)) : 0;
  return all > 0 ? std::clamp(done / all, 0.0, 1.0) : 0;
}

} // namespace

void tell(Told kind, std::string_view text) {
  const char* file = std::getenv(message_file_variable);
  if (!file || !*file)
    return;
  std::string line = fmt::format("{}\t{}", name_of(kind), text);
  std::ranges::replace(line, '\n', ' ');
  std::ofstream(std::filesystem::path(file), std::ios::app | std::ios::binary)
      << line + "\n"; // in one piece: others may write to it
}

void tell_progress(std::size_t done, std::size_t all) {
  tell(Told::progress, fmt::format("{}/{}", done, all));
}

void say_error(std::string_view text) {
  print_error("error: {}\n", text);
  tell(Told::error, text);
}

std::vector<ToldMessage> MessageFile::next() {
  std::vector<ToldMessage> out;
  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(read_));
  for (std::string line; std::getline(in, line) && !in.eof();) { // a line without its end is still written
    read_ += line.size() + 1;
    const std::size_t tab = line.find('\t');
    const auto kind = value_named<Told>(std::string_view(line).substr(0, tab));
    if (!kind || tab == std::string::npos)
      continue;
    const std::string text = line.substr(tab + 1);
    out.push_back({*kind, text, *kind == Told::progress ? share_of(text) : 0});
  }
  return out;
}

} // namespace bem_contact
