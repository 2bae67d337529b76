#pragma once

#include <algorithm>
#include <string_view>

namespace bem_contact {

// What HDF5 and JSON say under "format": the kind, and a number that rises when a name or a role in it
// changes. Files of another number are refused.
inline constexpr const char* result_format = "bem_contact result 5";
inline constexpr const char* case_format = "bem_contact case 5"; ///< of a sweep
inline constexpr const char* comparison_format = "bem_contact comparison 5";
inline constexpr const char* sweep_format = "bem_contact sweep 6";
inline constexpr const char* sweep_part_format = "bem_contact sweep part 2";
inline constexpr const char* wheelset_format = "bem_contact wheelset 4";
inline constexpr const char* conicity_format = "bem_contact conicity 2";
inline constexpr const char* conicity_map_format = "bem_contact conicity map 1";
inline constexpr const char* creep_curves_format = "bem_contact creep curves 3";
inline constexpr const char* fit_format = "bem_contact fit 2";
inline constexpr const char* fatigue_format = "bem_contact fatigue 3";
inline constexpr const char* stresses_format = "bem_contact stresses 2";
inline constexpr const char* shakedown_format = "bem_contact shakedown 2";
inline constexpr const char* table_format = "bem_contact table 4";
inline constexpr const char* wear_format = "bem_contact wear 2";
inline constexpr const char* contact_wear_format = "bem_contact wear of one contact 1";
inline constexpr const char* from_contact_format = "bem_contact from-contact 1";
inline constexpr const char* study_format = "bem_contact study 2";
inline constexpr const char* profile_format = "bem_contact profile 1"; ///< JSON alone
inline constexpr const char* numbers_format = "conformal-contact influence numbers 2";

/// A kind of file that stands for itself.
struct FileKind {
  const char *format, *title;
  const char* page = "";                 ///< what a page of the room report calls it; "": it has none
  const char *holds = "", *command = ""; ///< of one whose scene another command than solve solves again
};
inline constexpr FileKind file_kinds[] = {
    {result_format, "A result of bem_contact", "result"},
    {comparison_format, "A comparison of bem_contact", "comparison", "a comparison", "compare"},
    {sweep_format, "A sweep of bem_contact; cases/000000/ has the fields of case 0", "sweep",
     "the cases of a sweep", "sweep"},
    {sweep_part_format, "Some cases of a sweep; bem_contact sweep --join makes the whole of its parts"},
    {wheelset_format, "Both wheels of a wheelset", "wheelset", "both wheels of a wheelset", "wheelset"},
    {conicity_format, "The conicity of a wheelset", "conicity", "the conicity of a wheelset", "conicity"},
    {conicity_map_format, "Conicities of many wheelsets", "conicity map", "the conicities of many wheelsets",
     "conicity"},
    {creep_curves_format, "Creep curves", "creep curves", "creep curves", "creep-curves"},
    {fit_format, "Keys of a scene, fitted to measured forces", "fit", "a fit to measured forces", "fit"},
    {fatigue_format, "Fatigue of each patch of a load collective", "fatigue",
     "the fatigue of a load collective", "fatigue"},
    {stresses_format, "Stresses inside a body while a contact passes", "stresses",
     "the stresses of a contact", "stresses"},
    {shakedown_format, "Does the steel below a contact yield never, once or for ever?", "shakedown",
     "the shakedown of a contact", "shakedown"},
    {table_format, "A table of contact forces", "table"},
    {wear_format, "Wear of a rail and a wheel, step by step", "wear"},
    {contact_wear_format, "What one contact wears away", "wear of one contact", "the wear of one contact",
     "wear"},
    {study_format, "A study: all answers to one scene", "study", "the answers of a study", "study"},
    {numbers_format, "Plain influence numbers"},
};

/// A format without its number.
constexpr std::string_view kind_name(std::string_view format) {
  const std::size_t last = format.find_last_not_of("0123456789");
  format = format.substr(0, last == format.npos ? 0 : last + 1);
  return format.ends_with(' ') ? format.substr(0, format.size() - 1) : format;
}
/// The kind of a file with that format, of any number; null: none.
constexpr const FileKind* kind_of(std::string_view format) {
  const auto* kind = std::ranges::find_if(
      file_kinds, [&](const FileKind& known) { return kind_name(known.format) == kind_name(format); });
  return kind == std::ranges::end(file_kinds) ? nullptr : kind;
}

} // namespace bem_contact
