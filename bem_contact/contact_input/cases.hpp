#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact_input/blocks.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace bem_contact::contact_input {

/// The cases of an input file, each with all that holds in it.
struct CasesRead {
  std::vector<CaseState> cases;
  std::optional<InputError> broken; ///< why reading ended before the file did; the cases before it stand
};

/// Reads an input file of CONTACT to its end. `source` names it in messages.
CasesRead read_cases(std::string_view text, const std::string& source);

} // namespace bem_contact::contact_input
