#pragma once

#include "bem_contact/record/record.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::record {

/// What may be asked next, and the command that asks it.
struct NextQuestion {
  std::string asks, command = {}; ///< "": `asks` says all

  std::string text() const { return command.empty() ? asks : asks + " " + command; }
};

/// What an answer says before any table. Text, JSON, Python and pages take it from here, so that they say the
/// same.
struct Found {
  std::vector<std::string>
      sentences; ///< what was found, with numbers and their errors; the most important first
  std::vector<NextQuestion> next;
};

/// Of an answer with a "format" (file_kinds.hpp). Empty for what has no answer in words, such as influence
/// functions.
Found found_in(const Record& answer);
/// Of an answer without one. `kind`: as FileKind::page has it, "result".
Found found_in(const Record& answer, std::string_view kind);

/// Says whether the sentences of a sweep need this entry.
bool is_found_in_sweep(const std::string& name);

/// The answer with its sentences in front, as "found" and "next".
Record with_found(Record answer);
/// The sentences as lines of text; "" where there are none.
std::string found_text(const Record& answer);

} // namespace bem_contact::record
