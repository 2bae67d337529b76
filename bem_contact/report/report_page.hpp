#pragma once

#include "bem_contact/record/record.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::report {

inline constexpr const char* mesh_ending = ".msh";

/// Reads a file that bem_contact wrote (file_kinds.hpp says which have a page), an influence file or a
/// mesh of mesh_body (.msh), and writes its page to `output`, whole or not at all: HTML that needs no other
/// file and no network. Throws InputError for any other file, where `output` is `file` or cannot be written,
/// and if this build has no plotting library.
void write_report(const std::filesystem::path& file, const std::filesystem::path& output);

/// The page of what such a file holds; `name`: of the file. Throws as write_report() does.
std::string page_of_record(const record::Record& file, const std::string& name);

/// What differs between pages. `html` has the places @STYLE@, @SCRIPT@, @LIBRARY@ (of plotting) and @DATA@.
struct PageParts {
  std::string_view html, style, script;
};
/// A page whose script comes behind the figures and words of reports. `data`: JSON that the page holds.
/// Throws InputError if this build has no plotting library.
std::string page_with_figures(const PageParts& parts, std::string data);

/// Points along a profile, in the frame of its file's curve.
struct DrawnProfile {
  std::string name;
  std::vector<double> y, z;      ///< mm, z down
  std::vector<double> curvature; ///< 1/mm, > 0 convex
};

/// Writes a page of profiles: `words` as they stand, then outlines and curvature over y. The first profile is
/// in front of the others. Throws InputError if this build has no plotting library.
void write_profile_page(const std::string& name, const std::string& words,
                        const std::vector<DrawnProfile>& profiles, const std::filesystem::path& output);

/// Writes a page of the sections of a rail or wheel: `words`, and which of their points correspond (`points`:
/// SectionLines of the room sequence). Throws InputError if this build has no plotting library.
void write_sections_page(const std::string& name, const std::string& words, const record::Table& points,
                         const std::filesystem::path& output);

} // namespace bem_contact::report
