#include "bem_contact/base/counted.hpp"
#include "bem_contact/record/found_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

/// What is found in a replay, which is a sweep with more columns.
namespace bem_contact::record {

namespace {

/// What a replay adds to the columns of a sweep (uses/sweep/replay_steps.hpp): this one, and for each number
/// that is compared NAME_of_run and NAME_difference.
constexpr std::string_view solved_column = "solved";

/// The run's own column of a quantity; "": none.
std::string_view of_run(const Record& r, std::string_view quantity) {
  for (const Entry& entry : r.entries())
    if (const auto* field = std::get_if<Field>(&entry.content);
        field && field->role == Role::of_run && field->of == quantity)
      return entry.name;
  return {};
}

/// Where the run's own number differs most from ours, of each that is compared.
std::vector<std::string> differences_text(const Record& r) {
  std::vector<std::string> out;
  for (const Entry& entry : r.entries()) {
    const auto* difference = std::get_if<Field>(&entry.content);
    if (!difference || difference->role != Role::difference)
      continue;
    const std::span<const double> values = difference->values;
    const auto least = smallest_of(r, entry.name), most = largest_of(r, entry.name);
    if (!least || !most)
      continue;
    const std::size_t at = -values[*least] > values[*most] ? *least : *most;
    const auto theirs = stated_at(r, std::string(of_run(r, difference->of)), at),
               time = stated_at(r, "note.time", at);
    if (!theirs)
      continue;
    const auto off = *stated_at(r, entry.name, at);
    out.push_back(fmt::format(
        "The run's own {} differs most at {}: it is {}, {} {} than ours.", difference->of,
        time ? fmt::format("{} (case {})", text_of(*time), at) : fmt::format("case {}", at), text_of(*theirs),
        text_of({std::abs(off.value), off.error, off.unit}), off.value < 0 ? "less" : "more"));
  }
  return out;
}

std::string solved_text(const Record& r) {
  const std::span<const double> solved = values_at(r, solved_column);
  const auto count = std::ranges::count(solved, 1.0), all = std::ssize(solved);
  return fmt::format("{} of {} {} solved{}.", count, counted(all, "step", "steps"),
                     count == 1 ? "was" : "were", count < all ? "; the others lie between them" : "");
}

} // namespace

bool is_replay(const Record& r) {
  return has(r, solved_column);
}

bool is_of_replay(std::string_view name) {
  constexpr std::string_view run = "_of_run", difference = "_difference";
  return name == solved_column || name.ends_with(run) || name.ends_with(difference) ||
         name.ends_with(error_name(difference));
}

std::vector<std::string> sentences_of_replay(const Record& r) {
  std::vector<std::string> out = differences_text(r);
  out.push_back(solved_text(r));
  return out;
}

} // namespace bem_contact::record
