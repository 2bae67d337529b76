#include "bem_contact/base/toml.hpp"

#include <cstdint>
#include <vector>

namespace bem_contact {

namespace {

/// Levels. No key of ours has more than five; the library takes some 50,000 before its stack ends. Chosen.
constexpr std::size_t most_levels = 1000;

/// Where a text begins to be nested deeper than that: its line. 0: nowhere.
///
/// Each dot of a dotted key is a level. Texts and comments are passed over; a number has one dot.
class DepthScan {
public:
  explicit DepthScan(std::string_view text) : text_(text) {}

  std::uint32_t line_too_deep() {
    for (at_ = 0; at_ < text_.size(); ++at_)
      if (!step(text_[at_]))
        return line_;
    return 0;
  }

private:
  bool step(char c) {
    switch (c) {
    case '"':
    case '\'':
      pass_text(c);
      break;
    case '#':
      while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n')
        ++at_;
      break;
    case '\n':
      ++line_;
      [[fallthrough]];
    case ',':
      dots_ = 0;
      break;
    case '{':
    case '[': // the value of a dotted key lies below it
      around_.push_back(dots_);
      levels_ += dots_ + 1;
      dots_ = 0;
      break;
    case '}':
    case ']':
      if (!around_.empty()) {
        levels_ -= around_.back() + 1;
        around_.pop_back();
      }
      dots_ = 0;
      break;
    case '.':
      return levels_ + ++dots_ <= most_levels;
    default:
      break;
    }
    return true;
  }

  /// Moves to the quote that ends a text.
  void pass_text(char quote) {
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool long_text = text_.substr(at_).starts_with(three);
    for (at_ += long_text ? 3 : 1; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        if (!long_text)
          return; // not TOML; the library says so
      }
      if (text_[at_] == '\\' && quote == '"')
        ++at_;
      else if (long_text ? text_.substr(at_).starts_with(three) : text_[at_] == quote) {
        at_ += long_text ? 2 : 0;
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, dots_ = 0, levels_ = 0;
  std::vector<std::size_t> around_; ///< dots before each open bracket
  std::uint32_t line_ = 1;
};

} // namespace

toml::table parse_toml(std::string_view text, std::string_view source) {
  if (const std::uint32_t line = DepthScan(text).line_too_deep())
    throw toml::parse_error("A key or a table is nested more than 1000 levels deep",
                            toml::source_region{{line, 1}, {line, 1}, nullptr});
  return toml::parse(text, source);
}

} // namespace bem_contact
