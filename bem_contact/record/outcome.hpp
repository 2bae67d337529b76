#pragma once

#include "bem_contact/base/enum_names.hpp"

#include <array>
#include <cstddef>
#include <exception>
#include <span>
#include <string>
#include <string_view>

namespace bem_contact::record {

/// How an answer ended: of solve, of a part of a study, of a case of a sweep, of what the window asks for.
/// Files hold the numbers, and pages and messages say the names. Certified is one word: every step of an
/// answer satisfies its contact conditions (certified(result)).
enum class Outcome {
  missing = 0,       ///< not computed yet
  certified = 1,     ///< every step is a solution
  not_certified = 2, ///< a step is none, or the solvers did not converge
  refused = 3,       ///< the input is wrong, or has no solution in this model: the reason says what
  died = 4,          ///< its process ended, or memory ran out
  failed = 5,        ///< an error that the program did not foresee
  done = 6,          ///< computed, and there is nothing to certify: no contact is solved
  replaced = 7       ///< nobody waits for it any more
};

/// Cases of a sweep end in the first of them.
inline constexpr std::size_t outcomes_of_cases = 6;

/// How what threw this has ended.
Outcome outcome_of(const std::exception& error);

/// "not_certified_count": under this name a file has how many cases ended so.
std::string count_name(Outcome outcome);

/// "3 of 4 cases are certified; refused: 1." Counts by outcome.
std::string counts_text(std::span<const std::size_t, outcomes_of_cases> counts);

} // namespace bem_contact::record

template <> struct bem_contact::EnumNames<bem_contact::record::Outcome> {
  static constexpr std::array<std::string_view, 8> names{"missing", "certified", "not certified", "refused",
                                                         "died",    "failed",    "done",          "replaced"};
};
