#pragma once

namespace bem_contact {

enum class ProfileKind { rail, wheel };

inline const char* name_of(ProfileKind kind) {
  return kind == ProfileKind::rail ? "rail" : "wheel";
}

} // namespace bem_contact
