#include "bem_contact/base/error.hpp"

#include "bem_contact/base/printable.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace bem_contact {

namespace {

std::string lower(std::string_view word) {
  std::string out(word);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

/// Bytes of a value in a message: a longer one is cut to its begin and its end. Paths of files are shorter.
constexpr std::size_t longest_value = 200, value_begin = 90, value_end = 60;
/// The same of a whole message, for values that do not look like one.
constexpr std::size_t longest_message = 4000, message_begin = 2500, message_end = 1000;

/// The text without its middle, between two characters, where it is longer than `longest`.
std::string without_middle(std::string_view text, std::size_t longest, std::size_t begin, std::size_t end) {
  if (text.size() <= longest)
    return std::string(text);
  const auto in_character = [&](std::size_t at) { return (text[at] & 0xc0) == 0x80; };
  std::size_t from = begin, to = text.size() - end;
  while (in_character(from))
    --from;
  while (in_character(to))
    ++to;
  return std::string(text.substr(0, from)).append(" ... ").append(text.substr(to));
}

/// Of a text that begins with a quote or a bracket: up to the one that closes it. Else a word, or what stands
/// between two words.
std::size_t value_length(std::string_view text) {
  constexpr std::string_view opening = "'\"[", closing = "'\"]", between = " \n(";
  if (between.find(text.front()) != between.npos)
    return 1;
  if (const std::size_t kind = opening.find(text.front()); kind != opening.npos)
    for (std::size_t at = 1; at < text.size(); at += text[at] == '\\' ? 2 : 1)
      if (text[at] == closing[kind])
        return at + 1;
  return std::min(text.find_first_of(" \n"), text.size());
}

/// What the input holds may be of any length.
std::string without_long_values(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = value_length(text);
    out += without_middle(text.substr(0, length), longest_value, value_begin, value_end);
    text.remove_prefix(length);
  }
  return without_middle(out, longest_message, message_begin, message_end);
}

/// Damerau-Levenshtein distance (restricted): insertions, deletions, replacements, neighbours swapped.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

} // namespace

Error::Error(std::string_view problem, std::string_view why, std::string_view what_to_do)
    : std::runtime_error(without_long_values(
          printable(std::string(problem).append(" (").append(why).append(") ").append(what_to_do)))) {}

std::vector<std::string> nearest_names(std::string_view word, std::span<const std::string> candidates,
                                       std::size_t most) {
  constexpr std::size_t longest_name = 100; // the distance takes as many steps as the product of both lengths
  if (word.size() > longest_name)
    return {};
  const std::string wanted = lower(word);
  std::vector<std::pair<std::size_t, const std::string*>> scored;
  for (const std::string& candidate : candidates) {
    const std::string name = lower(candidate);
    std::size_t distance = edit_distance(wanted, name);
    // A word that is part of the other ("width" for "station_width") is like it, however long the rest.
    if (wanted.size() >= 3 && name.size() >= 3 &&
        (name.find(wanted) != std::string::npos || wanted.find(name) != std::string::npos))
      distance = std::min<std::size_t>(distance, 2);
    const std::size_t longest = std::max(wanted.size(), name.size());
    if (distance <= std::max<std::size_t>(1, longest / 2) && distance < longest)
      scored.emplace_back(distance, &candidate);
  }
  std::stable_sort(scored.begin(), scored.end(), [](auto& a, auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(most, scored.size()); ++i)
    names.push_back(*scored[i].second);
  return names;
}

} // namespace bem_contact
