#include "bem_contact/base/provenance.hpp"

#include <conformal_commit.h> // tools/cmake/commit.cmake writes it

namespace bem_contact {

std::string_view version() {
  return CONFORMAL_VERSION;
}

std::string_view commit() {
  return CONFORMAL_COMMIT;
}

std::string provenance(std::string_view program) {
  return std::string(program) + " " + std::string(version());
}

} // namespace bem_contact
