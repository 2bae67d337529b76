#include "bem_contact/scene/accuracy_of.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace bem_contact {

std::vector<AccuracyOf> accuracy_of(const std::string& names) {
  const auto& known = EnumNames<AccuracyOf>::names;
  std::vector<AccuracyOf> out;
  std::istringstream in(names);
  for (std::string name; std::getline(in, name, ',');) {
    const auto from = name.find_first_not_of(' '), to = name.find_last_not_of(' ');
    name = from == std::string::npos ? "" : name.substr(from, to - from + 1);
    const auto at = std::ranges::find(known, name);
    if (at == known.end())
      throw InputError(fmt::format("grid.accuracy_of = \"{}\" cannot be used", names),
                       fmt::format("there is no quantity '{}'", name),
                       fmt::format("Choose from {}, with commas between.", fmt::join(known, ", ")));
    out.push_back(static_cast<AccuracyOf>(at - known.begin()));
  }
  if (out.empty())
    throw InputError("grid.accuracy_of is empty", "an accuracy is of something",
                     fmt::format("Choose from {}, with commas between.", fmt::join(known, ", ")));
  return out;
}

} // namespace bem_contact
