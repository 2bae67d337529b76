#include "bem_contact/record/outcome.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>
#include <numeric>

namespace bem_contact::record {

Outcome outcome_of(const std::exception& error) {
  if (dynamic_cast<const Stopped*>(&error))
    return Outcome::replaced;
  if (dynamic_cast<const InputError*>(&error))
    return Outcome::refused;
  if (dynamic_cast<const ConvergenceError*>(&error))
    return Outcome::not_certified;
  if (dynamic_cast<const std::bad_alloc*>(&error)) // says nothing of the input: more memory may do
    return Outcome::died;
  return Outcome::failed;
}

std::string count_name(Outcome outcome) {
  std::string name(name_of(outcome));
  std::ranges::replace(name, ' ', '_');
  return name + "_count";
}

std::string counts_text(std::span<const std::size_t, outcomes_of_cases> counts) {
  const auto of = [&](Outcome outcome) { return counts[static_cast<std::size_t>(outcome)]; };
  const std::size_t cases = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  std::string out = fmt::format("{} of {} certified", of(Outcome::certified),
                                counted(std::ptrdiff_t(cases), "case is", "cases are"));
  for (const Outcome other :
       {Outcome::not_certified, Outcome::refused, Outcome::died, Outcome::failed, Outcome::missing})
    if (of(other) > 0)
      out += fmt::format("; {}: {}", name_of(other), of(other));
  return out + ".";
}

} // namespace bem_contact::record
