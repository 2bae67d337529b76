#include "bem_contact/contact_input/input_lines.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact_input/words.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace bem_contact::contact_input {

namespace {

char lower(char type) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(type)));
}

bool optional(const Field& field) {
  return std::isupper(static_cast<unsigned char>(field.type)) != 0;
}

const char* expected(char type) {
  switch (lower(type)) {
  case 'i':
    return "a whole number";
  case 'a':
    return "an angle";
  case 's':
    return "a text in single quotes";
  default:
    return "a number";
  }
}

/// Reads a word as the field's value into `item`. False for what is none.
bool read_word(const Field& field, const std::string& word, Item& item) {
  if (lower(field.type) == 's') {
    const auto text = quoted(word);
    if (text)
      item.texts.push_back(*text);
    return text.has_value();
  }
  if (lower(field.type) == 'i') {
    const auto whole = fortran_integer(word);
    if (whole)
      item.numbers.push_back(static_cast<double>(*whole));
    return whole.has_value();
  }
  const auto number = lower(field.type) == 'a' ? fortran_angle(word) : fortran_real(word);
  if (number)
    item.numbers.push_back(*number);
  return number.has_value();
}

std::string names_of(const std::vector<Field>& fields) {
  std::string out;
  for (const Field& field : fields)
    out += (out.empty() ? "" : ", ") + field.name + (optional(field) ? " (may be missing)" : "");
  return out;
}

} // namespace

std::vector<Field> fields_of(std::string_view format) {
  std::vector<Field> out;
  while (!format.empty()) {
    const std::size_t end = std::min(format.find(", "), format.size());
    out.push_back({std::string(format.substr(0, end - 2)), format[end - 1]});
    format.remove_prefix(std::min(end + 2, format.size()));
  }
  return out;
}

InputLines::InputLines(std::string_view text, std::string source) : source_(std::move(source)) {
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (std::vector<std::string> words = words_of(text.substr(0, end)); !words.empty())
      lines_.push_back({number, std::move(words)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool InputLines::ended() const {
  return next_ >= lines_.size();
}

int InputLines::line() const {
  return ended() ? lines_.empty() ? 1 : lines_.back().number : lines_[next_].number;
}

std::string InputLines::where(int line) const {
  return fmt::format("{}:{}: ", source_, line);
}

Item InputLines::take(std::string_view format) {
  const std::vector<Field> fields = fields_of(format);
  Item item;
  item.line = line();
  std::size_t word = 0;
  const auto refuse = [&](const Field& field, const std::string& why) {
    throw InputError(
        fmt::format("{}{} cannot be read", where(line()), field.name), why,
        fmt::format("CONTACT takes {} here, of the values {}.", expected(field.type), names_of(fields)));
  };
  for (const Field& field : fields) {
    if (optional(field) && (ended() || word >= lines_[next_].words.size()))
      break;
    if (!ended() && word >= lines_[next_].words.size())
      ++next_, word = 0;
    if (ended())
      refuse(field, "the file ends here");
    const std::string& given = lines_[next_].words[word];
    if (!read_word(field, given, item)) {
      if (!optional(field))
        refuse(field, fmt::format("'{}' is not {}", given, expected(field.type)));
      break; // a remark, or note_numbers_beyond() says what it is
    }
    ++word;
  }
  note_numbers_beyond(fields, word);
  ++next_;
  return item;
}

void InputLines::note_numbers_beyond(const std::vector<Field>& fields, std::size_t word) {
  const Line& at = lines_[next_];
  if (word < at.words.size() && fortran_angle(at.words[word]))
    beyond_.push_back(fmt::format("line {}: '{}' stands behind {}, where CONTACT reads a remark", at.number,
                                  at.words[word], names_of(fields)));
}

Item InputLines::take_array(const std::string& name, char type, std::size_t count) {
  Item item;
  item.line = line();
  const Field field{name, type};
  while (item.numbers.size() < count) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(
          fmt::format("{}{} cannot be read", where(line()), name), why,
          fmt::format("CONTACT takes {} numbers here, and {} are read.", count, item.numbers.size()));
    };
    if (ended())
      refuse("the file ends here");
    for (const std::string& word : lines_[next_].words)
      if (item.numbers.size() < count && !read_word(field, word, item))
        refuse(fmt::format("'{}' is not {}", word, expected(type)));
    ++next_;
  }
  return item;
}

long InputLines::take_count(std::string_view format, long least, long most) {
  const Item item = take(format);
  const long value = static_cast<long>(item.numbers[0]);
  if (value < least || value > most)
    throw InputError(fmt::format("{}{} is {}", where(item.line), fields_of(format)[0].name, value),
                     fmt::format("it lies between {} and {}", least, most), "Correct the line.");
  return value;
}

} // namespace bem_contact::contact_input
