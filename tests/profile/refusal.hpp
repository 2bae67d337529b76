#pragma once

#include "tests/base/message.hpp"
#include "tests/profile/curves.hpp"
#include "tests/profile/warnings.hpp"

#include <string>

namespace bem_contact {

/// The message with which a profile file of this text is refused.
inline std::string refusal(const std::string& text, ProfileKind kind = ProfileKind::rail) {
  const SaidWarnings warnings;
  return message_of([&] { parse_profile(text, "p.txt", kind); });
}

} // namespace bem_contact
