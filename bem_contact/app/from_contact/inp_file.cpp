#include "bem_contact/app/from_contact/inp_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <sstream>

namespace bem_contact::app {

namespace {

/// Words between blanks, tabs and commas; a text in quotes is one, with its first quote. Nothing behind % or
/// !.
std::vector<std::string> words_of_line(const std::string& line) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < line.size();) {
    const char c = line[at];
    if (c == '%' || c == '!')
      break;
    if (c == '\'' || c == '"') {
      const std::size_t end = std::min(line.find(c, at + 1), line.size());
      out.push_back("'" + line.substr(at + 1, end - at - 1));
      at = end + 1;
    } else if (std::isspace(static_cast<unsigned char>(c)) || c == ',')
      ++at;
    else {
      const std::size_t end = std::min(line.find_first_of(" \t\r,%!", at), line.size());
      out.push_back(line.substr(at, end - at));
      at = end;
    }
  }
  return out;
}

/// A number as Fortran writes it ("1.5d-3", ".3", "+2"); of an angle "1.5d" are degrees.
std::optional<double> number_in(std::string word, bool angle) {
  double unit = 1;
  if (angle && (word.ends_with('d') || word.ends_with('D'))) {
    unit = std::numbers::pi / 180;
    word.pop_back();
  } else if (angle && (word.ends_with('r') || word.ends_with('R')))
    word.pop_back();
  for (char& c : word)
    if (c == 'd' || c == 'D')
      c = 'e';
  const char *begin = word.data() + (word.starts_with('+') ? 1 : 0), *end = word.data() + word.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc() && rest == end && begin != end && std::isfinite(value)
             ? std::optional(unit * value)
             : std::nullopt;
}

} // namespace

InpFile::InpFile(const std::filesystem::path& file)
    : InpFile(read_text_file(file.string(), "input file of CONTACT"), file.string()) {}

InpFile::InpFile(std::string_view text, std::string source) : source_(std::move(source)) {
  std::istringstream in{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (std::vector<std::string> words = words_of_line(line); !words.empty())
      lines_.push_back({number, std::move(words)});
  }
}

bool InpFile::ended() const {
  return next_ >= lines_.size();
}

int InpFile::line() const {
  return ended() ? lines_.empty() ? 1 : lines_.back().number : lines_[next_].number;
}

std::string InpFile::where() const {
  return fmt::format("{}:{}: ", source_, line());
}

InpFile::Values InpFile::take(const std::string& item, std::string_view types) {
  Values out;
  std::size_t word = 0;
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}{} cannot be read", where(), item), why,
                     "Correct the line; CONTACT's user guide says what stands there.");
  };
  for (const char type : types) {
    const bool optional = std::isupper(static_cast<unsigned char>(type));
    if (optional && (ended() || word >= lines_[next_].words.size()))
      break;
    if (!ended() && word >= lines_[next_].words.size())
      ++next_, word = 0;
    if (ended())
      refuse("the file ends here");
    const std::string& given = lines_[next_].words[word];
    if (type == 's') {
      if (!given.starts_with('\''))
        refuse(fmt::format("'{}' is no name in quotes", given));
      out.text = given.substr(1);
    } else if (const auto number = number_in(given, type == 'a')) {
      if ((type == 'i' || type == 'I') && *number != std::round(*number))
        refuse(fmt::format("'{}' is no whole number", given));
      out.numbers.push_back(*number);
    } else if (optional)
      break; // the remark
    else
      refuse(fmt::format("'{}' is no number", given));
    ++word;
  }
  ++next_;
  return out;
}

std::vector<int> InpFile::digits(const std::string& item, std::size_t count) {
  const std::string place = where();
  const double number = take(item, "i")[0];
  std::string text = number >= 0 && number < 1e9 ? fmt::format("{:.0f}", number) : "";
  if (text.size() > count + 1 || text.empty()) // one more: X of X-H-G-I-A-O-W-R
    throw InputError(fmt::format("{}{} cannot be read", place, item),
                     fmt::format("there are {} control digits", count), "Correct the line.");
  text.insert(0, count + 1 - text.size(), '0');
  std::vector<int> out;
  for (const char c : text)
    out.push_back(c - '0');
  return out;
}

} // namespace bem_contact::app
