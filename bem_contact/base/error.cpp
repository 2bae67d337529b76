#include "bem_contact/base/error.hpp"

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

/// A message quotes what is wrong, and what() would end at the character NUL.
std::string without_nul(std::string text) {
  std::replace(text.begin(), text.end(), '\0', '?');
  return text;
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
    : std::runtime_error(
          without_nul(std::string(problem) + " (" + std::string(why) + ") " + std::string(what_to_do))) {}

std::vector<std::string> nearest_names(std::string_view word, std::span<const std::string> candidates,
                                       std::size_t most) {
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
