#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"

namespace bem_contact::app::from_contact {

/// Solves cases for what others need of them: a normal force to which forces are relative, tractions from
/// which a case goes on.
class SolvedCases {
public:
  /// N = 0 with F >= 1: forces as shares of the friction limit of the normal force at this approach. It is
  /// solved without friction, which is the same where both bodies are equal half-spaces; else the case is
  /// refused.
  void set_forces(ContactCase& one);
  /// motion.start_table of `next`: the tractions in which `before` ends, on the elements of `next`. Refuses
  /// `next` where there are none.
  void set_start(const ContactCase& before, ContactCase& next);

private:
  std::map<std::string, double> normal_forces_; ///< N, by the text of the scene
};

} // namespace bem_contact::app::from_contact
