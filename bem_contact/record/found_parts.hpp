#pragma once

#include "bem_contact/record/found.hpp"

#include <optional>
#include <string>

/// Private to this room: what the sentences are made of.
namespace bem_contact::record {

/// A number of an answer with its error (nan: none is known) and unit.
struct Stated {
  double value = 0, error = 0;
  std::string unit;
};

/// What stands at a path: a number, or the entry `at` of a column or a field. Nothing where there is none, or
/// where it is not known.
std::optional<Stated> stated_at(const Record& record, const std::string& path, std::size_t at = 0);
/// "2630 +- 32 MPa": rounded to two digits of the error (error_text.hpp).
std::string text_of(const Stated& number);
/// The text of what stands at a path; "" where there is nothing.
std::string said(const Record& record, const std::string& path);
/// Index of the largest known number of a column or a field.
std::optional<std::size_t> largest_of(const Record& record, const std::string& path);
std::optional<std::size_t> smallest_of(const Record& record, const std::string& path);

/// A record below another one; an empty one where there is none.
const Record& part(const Record& record, std::string_view path);

/// Adds a line that is not empty.
void add_if(std::vector<std::string>& lines, std::string line);

/// "Does the steel below yield? bem_contact shakedown curve.toml"
NextQuestion question(const Record& answer, const char* asks, const char* command);

/// Of a sweep: whether it is a replay, whether the sentences of one need this entry, and these sentences:
/// where the run's own numbers differ most from ours, and how many steps were solved.
bool is_replay(const Record& record);
bool is_of_replay(std::string_view name);
std::vector<std::string> sentences_of_replay(const Record& record);

Found of_result(const Record&);
Found of_comparison(const Record&);
Found of_wheelset(const Record&);
Found of_sweep(const Record&);
Found of_creep_curves(const Record&);
Found of_fit(const Record&);
Found of_conicity(const Record&);
Found of_conicity_map(const Record&);
Found of_table(const Record&);
Found of_wear(const Record&);
Found of_contact_wear(const Record&);
Found of_fatigue(const Record&);
Found of_shakedown(const Record&);
Found of_stresses(const Record&);
Found of_study(const Record&);

} // namespace bem_contact::record
