#include "bem_contact/sequence/derivatives.hpp"

#include <array>

namespace bem_contact {

namespace {

constexpr std::array<std::string_view, 13> total_names{
    "Fx",   "Fy",      "Fz",         "Fs",         "Mz",          "approach",       "vertical",
    "pmax", "T_gamma", "creepage_x", "creepage_s", "reference_s", "reference_delta"};
constexpr std::array<std::string_view, 10> patch_numbers{"Fn", "Fx", "Fs", "Fy",   "Fz",
                                                         "Mx", "Ms", "Mn", "pmax", "T_gamma"};

} // namespace

std::span<const std::string_view> derived_totals() {
  return total_names;
}

std::span<const std::string_view> derived_patch_numbers() {
  return patch_numbers;
}

std::string_view words_of(StateChange change) {
  switch (change) {
  case StateChange::leaves:
    return "an element leaves the contact";
  case StateChange::touches:
    return "an element comes into contact";
  case StateChange::yields:
    return "an element reaches the limit of the pressure";
  case StateChange::recovers:
    return "an element falls below the limit of the pressure";
  case StateChange::slips:
    return "an element begins to slip";
  case StateChange::sticks:
    return "an element begins to stick";
  default:
    return "";
  }
}

} // namespace bem_contact
