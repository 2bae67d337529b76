#include "bem_contact/scene/accuracy_of.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>
#include <sstream>

namespace bem_contact {

namespace {

/// "Did you mean pmax? " or nothing.
std::string nearest_text(const std::string& name, std::span<const std::string_view> known) {
  const std::vector<std::string> candidates(known.begin(), known.end());
  const std::vector<std::string> like = nearest_names(name, candidates, 1);
  return like.empty() ? "" : fmt::format("Did you mean {}? ", like.front());
}

/// `key`: the scene's, for messages.
template <NamedEnum E> std::vector<E> name_list(std::string_view key, const std::string& text) {
  const auto& known = EnumNames<E>::names;
  const std::string choose = fmt::format("Choose from {}, with commas between.", fmt::join(known, ", "));
  std::vector<E> out;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    name = trimmed(name);
    const auto at = std::ranges::find(known, name);
    if (at == known.end())
      throw InputError(fmt::format("{} = \"{}\" cannot be used", key, text),
                       fmt::format("there is no quantity '{}'", name), nearest_text(name, known) + choose);
    out.push_back(static_cast<E>(at - known.begin()));
  }
  if (out.empty())
    throw InputError(fmt::format("{} is empty", key), "an accuracy is of something", choose);
  return out;
}

} // namespace

std::vector<AccuracyOf> accuracy_of(const std::string& names) {
  return name_list<AccuracyOf>("grid.accuracy_of", names);
}

std::vector<ModelErrorOf> model_tolerance_of(const std::string& names) {
  return name_list<ModelErrorOf>("solver.model_tolerance_of", names);
}

} // namespace bem_contact
