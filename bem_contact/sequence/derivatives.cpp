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

} // namespace bem_contact
