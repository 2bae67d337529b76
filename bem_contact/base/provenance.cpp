#include "bem_contact/base/provenance.hpp"

namespace bem_contact {

std::string_view version() {
  return CONFORMAL_VERSION;
}

std::string provenance(std::string_view program) {
  return std::string(program) + " " + std::string(version());
}

} // namespace bem_contact
