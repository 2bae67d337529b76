#pragma once

namespace bem_contact {

// The attribute "format" of the HDF5 files that the programs write.
inline constexpr const char* result_format = "bem_contact result 2";
inline constexpr const char* case_format = "bem_contact case 2"; ///< of a sweep
inline constexpr const char* comparison_format = "bem_contact comparison 2";
inline constexpr const char* sweep_format = "bem_contact sweep 2";
inline constexpr const char* wheelset_format = "bem_contact wheelset 1";
inline constexpr const char* conicity_format = "bem_contact conicity 1";
inline constexpr const char* creep_curves_format = "bem_contact creep curves 1";
inline constexpr const char* fatigue_format = "bem_contact fatigue 1";
inline constexpr const char* table_format = "bem_contact table 3";
inline constexpr const char* wear_format = "bem_contact wear";
inline constexpr const char* numbers_format = "conformal-contact influence numbers 1";

/// A kind of file that stands for itself.
struct FileKind {
  const char *format, *title;
  const char* page = "";                 ///< what a page of the room report calls it; "": it has none
  const char *holds = "", *command = ""; ///< of one whose scene another command than solve solves again
};
inline constexpr FileKind file_kinds[] = {
    {result_format, "A result of bem_contact", "result"},
    {comparison_format, "A comparison of bem_contact", "comparison", "a comparison", "compare"},
    {sweep_format, "A sweep of bem_contact; cases/000012/ has the fields of a case", "sweep",
     "the cases of a sweep", "sweep"},
    {wheelset_format, "Both wheels of a wheelset", "wheelset", "both wheels of a wheelset", "wheelset"},
    {conicity_format, "The conicity of a wheelset", "conicity", "the conicity of a wheelset", "conicity"},
    {creep_curves_format, "Creep curves", "creep curves", "creep curves", "creep-curves"},
    {fatigue_format, "Fatigue of each patch of a load collective", "", "the fatigue of a load collective",
     "fatigue"},
    {table_format, "A table of contact forces"},
    {wear_format, "Wear of a rail and a wheel, step by step", "wear"},
    {numbers_format, "Plain influence numbers"},
};

} // namespace bem_contact
