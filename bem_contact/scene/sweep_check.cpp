#include "bem_contact/scene/sweep_check.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/messages.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <set>
#include <string>

namespace bem_contact {

namespace {

/// Checking so many scenes takes a second (0.1 ms each), and users are told what takes so long.
constexpr std::size_t many_scenes = 10'000;

/// Adds a case of each value of a list: `values` of them, of which each holds for `stride` cases. Keys allow
/// intervals, so the ends of a range say whether all of it is allowed; the second value says whether it is a
/// whole number.
void add_checked(std::set<std::size_t>& checked, CaseRange cases, std::size_t values, bool range,
                 std::size_t stride) {
  const std::size_t begin = cases.first / stride, end = (cases.last - 1) / stride + 1;
  for (std::size_t k = begin; k < std::min(end, begin + values); ++k)
    if (const std::size_t value = k % values;
        !range || value < 2 || value + 1 == values || k == begin || k + 1 == end)
      checked.insert(std::max(cases.first, k * stride));
}

/// The cases that have every value.
std::set<std::size_t> cases_to_check(const SweepFile& sweep, CaseRange cases) {
  std::set<std::size_t> checked{cases.first};
  std::size_t stride = sweep.size();
  for (auto axis = sweep.axes.begin(); axis != sweep.axes.end();) {
    const auto next = std::find_if(axis + 1, sweep.axes.end(), std::not_fn(&SweepFile::Axis::beside));
    stride /= axis->values.size();
    add_checked(checked, cases, axis->values.size(),
                std::all_of(axis, next, std::mem_fn(&SweepFile::Axis::range)), stride);
    axis = next;
  }
  if (checked.size() >= many_scenes)
    say_info("{} scenes of '{}' are checked before one is solved", checked.size(), sweep.text.source);
  return checked;
}

/// Throws InputError where each case has a swept key that another one overrules.
void require_effects(const SweepFile& sweep, const std::set<std::size_t>& cases) {
  SweepScenes scenes(sweep);
  std::optional<InputError> first;
  for (const std::size_t index : cases) {
    try {
      scenes.scene(index);
    } catch (const InputError&) { // it is refused for a reason of its own
      return;
    }
    try {
      return scenes.require_effect();
    } catch (const InputError& error) {
      if (!first)
        first = error;
    }
  }
  if (first)
    throw *first;
}

} // namespace

void check_values(const SweepFile& sweep, CaseRange cases) {
  const std::set<std::size_t> checked = cases_to_check(sweep, cases);
  require_effects(sweep, checked);
  SweepScenes scenes(sweep);
  for (const std::size_t index : checked)
    scenes.scene(index);
}

void check_cases(const SweepFile& sweep, CaseRange cases) {
  if (std::ranges::all_of(sweep.axes, &std::string::empty, &SweepFile::Axis::table))
    return check_values(sweep, cases);
  sweep.first_scene(); // throws where there is none
  SweepScenes scenes(sweep);
  std::size_t refused = 0;
  std::string why;
  const std::set<std::size_t> checked = cases_to_check(sweep, cases);
  require_effects(sweep, checked);
  for (const std::size_t index : checked)
    try {
      scenes.scene(index);
    } catch (const InputError& error) {
      if (refused++ == 0)
        why = error.what();
    }
  if (refused > 0)
    say_warning("{} of '{}' {} recorded as refused, and the others are solved; the first: {}",
                counted(refused, "case", "cases"), sweep.text.source, refused == 1 ? "is" : "are", why);
}

} // namespace bem_contact
