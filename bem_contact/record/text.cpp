#include "bem_contact/record/text.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/record/error_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::record {

namespace {

std::string unit_text(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " " + unit;
}

std::string meaning_text(const std::string& meaning) {
  return meaning.empty() ? "" : ": " + meaning;
}

/// Lists what the group `path` holds ("" or with its last slash): heads before data.
class ToText {
public:
  ToText(std::string& heads, std::string& data, std::string path)
      : heads_(&heads), data_(&data), path_(std::move(path)) {}

  void add(const Record& record) {
    for (const Entry& entry : record.entries()) {
      name_ = path_ + entry.name;
      std::visit(*this, entry.content);
    }
  }

  void operator()(std::monostate) {}
  void operator()(bool flag) { *heads_ += fmt::format("  {}: {}\n", name_, flag ? "yes" : "no"); }
  void operator()(const Number& number) {
    const double error = number.error.value_or(0);
    *data_ += fmt::format("  {} = {}{}{}{}\n", name_, digits_within(number.value, error, 6),
                          plus_minus(error), unit_text(number.unit), meaning_text(number.meaning));
  }
  void operator()(const Text& text) {
    *heads_ += text.meaning.empty()
                   ? fmt::format("  {}: {}\n", name_, text.text)
                   : fmt::format("  {}: {} characters, {}\n", name_, text.text.size(), text.meaning);
  }
  void operator()(const Texts& texts) {
    *heads_ += fmt::format("  {}: {}{}\n", name_, counted(texts.lines.size(), "line", "lines"),
                           meaning_text(texts.meaning));
  }
  void operator()(const Field& values) {
    *data_ += fmt::format("  {} [{}]{}{}\n", name_, fmt::join(values.shape, "]["), unit_text(values.unit),
                          meaning_text(values.meaning));
  }
  void operator()(const Table& table) {
    for (const Column& column : table.columns)
      *data_ += fmt::format("  {}/{} [{}]{}{}\n", name_, column.name, table.size(), unit_text(column.unit),
                            meaning_text(column.meaning));
  }
  void operator()(const Record& record) { ToText(*heads_, *data_, name_ + "/").add(record); }

private:
  std::string *heads_, *data_;
  std::string path_, name_;
};

} // namespace

std::string to_text(const Record& record) {
  std::string heads, data;
  ToText(heads, data, "").add(record);
  return heads + (data.empty() ? "" : "Numbers\n" + data);
}

} // namespace bem_contact::record
