#include "bem_contact/scene/value_range.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 6.3, not 6.300000000000001.
double rounded(double value) {
  return number_of_text(fmt::format("{:.12g}", value)).value_or(value);
}

} // namespace

std::vector<SchemaValue> values_of_range(const toml::table& t, const std::string& of,
                                         const std::string& where) {
  const auto refuse = [&](const std::string& problem, const std::string& why, const std::string& what_to_do) {
    throw InputError(where + problem, why, what_to_do);
  };
  const std::string example = "Give { from = a, to = b, step = c } or { from = a, to = b, count = n }.";
  for (const auto& [name, node] : t)
    if (std::ranges::find(keys_of_ranges, name.str()) == std::end(keys_of_ranges)) {
      const std::vector<std::string> known{std::begin(keys_of_ranges), std::end(keys_of_ranges)};
      const auto like = nearest_names(name.str(), known, 1);
      refuse(fmt::format("unknown key '{}' in the range of {}", name.str(), of),
             "a range has from, to and step or count",
             like.empty() ? example : fmt::format("Did you mean {}?", like[0]));
    }
  const auto from = t["from"].value<double>(), to = t["to"].value<double>();
  const auto step = t["step"].value<double>();
  const auto count = t["count"].value<std::int64_t>();
  if (!from || !to || (step.has_value() == count.has_value()) || (t.contains("count") && !count) ||
      !std::isfinite(*from) || !std::isfinite(*to))
    refuse(fmt::format("the range of {} is not complete", of),
           "it needs finite numbers from, to and one of step and count", example);
  if (step && (!std::isfinite(*step) || *step == 0 || (*to - *from) / *step < 0 ||
               (*to - *from) / *step > double(most_cases)))
    refuse(fmt::format("the range of {} never ends", of),
           fmt::format("a step of {} does not lead from {} to {}", *step, *from, *to), "Correct the step.");
  if (count && (*count < 1 || *count > std::int64_t(most_cases) || (*count == 1 && *from != *to)))
    refuse(fmt::format("the range of {} cannot have {}", of, counted(*count, "value", "values")),
           fmt::format("at least 2 and at most {} lie between two ends", most_cases), "Correct the count.");
  const bool whole = t["from"].is_integer() && t["step"].is_integer();
  // `to` belongs to the range if a step hits it up to rounding.
  const std::int64_t n =
      count ? *count : static_cast<std::int64_t>(std::floor((*to - *from) / *step + 1e-9)) + 1;
  std::vector<SchemaValue> out;
  for (std::int64_t i = 0; i < n; ++i)
    if (whole)
      out.emplace_back(*t["from"].value<std::int64_t>() + i * *t["step"].value<std::int64_t>());
    else if (count)
      out.emplace_back(i + 1 == n ? *to : rounded(*from + (*to - *from) * double(i) / double(n - 1)));
    else
      out.emplace_back(rounded(*from + double(i) * *step));
  return out;
}

} // namespace bem_contact
