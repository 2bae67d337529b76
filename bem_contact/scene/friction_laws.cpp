#include "bem_contact/scene/friction_laws.hpp"

#include <algorithm>
#include <string_view>

namespace bem_contact {

const char* AskedLaw::Number::name() const {
  return key + std::string_view("motion.").size();
}

std::span<const AskedLaw> friction_laws() {
  using Given = FrictionCoefficients;
  static const AskedLaw rows[] = {
      {{{{"motion.falling_friction",
          &Given::falling_friction,
          "Coefficient that friction falls to at high slip velocity w: mu = falling_friction + (friction - "
          "falling_friction) 2^(-w / half_slip_velocity); 0: it does not fall. With friction_table: of the "
          "largest, and in proportion elsewhere. Needs speed",
          {.at_least = 0, .zero_is_none = true}},
         {"motion.half_slip_velocity",
          &Given::half_slip_velocity,
          "Slip velocity at which half of the difference is left (1 m/s is 1000 mm/s)",
          {.unit = "mm/s", .at_least = 0, .zero_is_none = true}}}},
       "motion.half_slip_velocity is not given",
       "Give the slip velocity at which half of the difference is left, in mm/s.",
       [](const Given& given, double adhesion) {
         const double ratio = *given.falling_friction / adhesion;
         return exponential_friction(ratio, 1 - ratio, given.half_slip_velocity.value_or(0));
       }},
      {{{{"motion.polach_a",
          &Given::polach_a,
          "Instead, Polach's A: friction at high slip velocity over friction; mu = friction [(1 - A) "
          "exp(-B w) + A]; 0: it does not fall. Dry and clean: 0.40, wet: 0.40. Needs speed",
          {.at_least = 0, .at_most = 1, .zero_is_none = true}},
         {"motion.polach_b",
          &Given::polach_b,
          "Polach's B. Dry and clean: 0.60, wet: 0.20",
          {.unit = "s/m", .at_least = 0, .zero_is_none = true}}}},
       "Polach's law has both A and B",
       "Give motion.polach_a and motion.polach_b.",
       [](const Given& given, double) {
         return polach_friction(*given.polach_a, given.polach_b.value_or(0));
       }},
  };
  return rows;
}

const AskedLaw* asked_law(const FrictionCoefficients& given) {
  const std::span<const AskedLaw> laws = friction_laws();
  const auto found = std::ranges::find_if(
      laws, [&](const AskedLaw& law) { return (given.*law.numbers[0].member).has_value(); });
  return found == laws.end() ? nullptr : &*found;
}

} // namespace bem_contact
