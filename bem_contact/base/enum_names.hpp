#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bem_contact {

/// The names of an enum's values as files, commands and messages write them. This table is the only one:
///
///     enum class WheelSide { right, left };
///     template <> struct EnumNames<WheelSide> {
///       static constexpr std::array<std::string_view, 2> names{"right", "left"};
///     };
///
/// The values must count from 0 in the order of the names.
template <class E> struct EnumNames;

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires {
  EnumNames<E>::names.size();
};

template <NamedEnum E> constexpr std::string_view name_of(E value) {
  return EnumNames<E>::names[static_cast<std::size_t>(value)];
}

/// The value of this name, if there is one.
template <NamedEnum E> constexpr std::optional<E> value_named(std::string_view name) {
  for (std::size_t i = 0; i < EnumNames<E>::names.size(); ++i)
    if (EnumNames<E>::names[i] == name)
      return static_cast<E>(i);
  return std::nullopt;
}

/// "red, green"
template <NamedEnum E> std::string names_of(const std::vector<E>& values) {
  std::string out;
  for (const E value : values)
    out.append(out.empty() ? "" : ", ").append(name_of(value));
  return out;
}

} // namespace bem_contact
