#pragma once

#include "bem_contact/base/enum_names.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Where in `known` the names of a text stand that has commas between them. `key`: the scene's, for messages.
/// Throws InputError for an unknown name, with the nearest known one, and for none.
std::vector<std::size_t> places_of_names(std::string_view key, const std::string& text,
                                         std::span<const std::string_view> known);

/// The same as values of an enum.
template <NamedEnum E> std::vector<E> name_list(std::string_view key, const std::string& text) {
  std::vector<E> out;
  for (const std::size_t place : places_of_names(key, text, EnumNames<E>::names))
    out.push_back(static_cast<E>(place));
  return out;
}

} // namespace bem_contact
