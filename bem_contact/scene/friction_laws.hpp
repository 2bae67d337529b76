#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/contact/friction_law.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <array>
#include <optional>
#include <span>

namespace bem_contact {

/// One law by which friction falls with the slip velocity, as a scene asks for it. friction_laws.cpp has a
/// row for each; keys, checks, warnings and the contact problem are made from it.
struct AskedLaw {
  /// A key of [motion], and its member.
  struct Number {
    const char* key; ///< "motion.polach_a"
    std::optional<double> FrictionCoefficients::*member;
    const char* help;
    KeyRule rule;

    const char* name() const; ///< without "motion."
  };
  std::array<Number, 2> numbers; ///< the first one asks for the law, and the other one belongs to it
  const char* why_both;          ///< why the first is refused without the other
  const char* give_both;         ///< what to do then
  /// Makes the law. `adhesion`: mu without slip.
  FallingFriction (*law)(const FrictionCoefficients& given, double adhesion);
};

/// All laws, in the order of their keys.
std::span<const AskedLaw> friction_laws();
/// The law that these coefficients ask for; null: friction does not fall with the slip velocity.
const AskedLaw* asked_law(const FrictionCoefficients& given);

} // namespace bem_contact
