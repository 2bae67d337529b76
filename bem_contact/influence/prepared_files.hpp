#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

struct InfluenceStrip;

/// An influence file that somebody has made before, as the index of its folder describes it: `index.toml`
/// (data/INFLUENCE_FORMAT.md, "Prepared files").
struct PreparedFile {
  std::filesystem::path file;  ///< with its folder
  std::string body, kind;      ///< name of the standard or the body; "rail" or "wheel"
  std::string strip;           ///< tread, gauge corner, flange root, flange ...
  double from = 0, to = 0;     ///< mm, arc length of the strip's ends
  double shortest_dx = 0;      ///< mm, of the elements that it serves
  double estimated_error = 0;  ///< 1 (self numbers)
  int bytes = 0;               ///< of the file
  std::string sha256, version; ///< of the file; of the program that made it
};

inline constexpr std::string_view prepared_index = "index.toml";
/// The environment variable that names the folder. Where it is set, no other is looked at.
inline constexpr const char* prepared_variable = "CONFORMAL_INFLUENCE";

/// The folder of prepared files: what the variable names, or the one that was installed with this program, or
/// that of the sources. "": none has an index.
std::filesystem::path prepared_folder();

/// The files of a folder, in the order of its index. Throws InputError for an index that is missing, empty or
/// wrong, and for an entry that leads out of the folder.
std::vector<PreparedFile> prepared_files(const std::filesystem::path& folder);

/// The bytes of a prepared file. Throws InputError where they are not those that the index describes.
std::string verified_bytes(const PreparedFile& prepared);
/// Throws InputError unless the file that was read is of the kind and the strip of its index.
void require_as_described(const PreparedFile& prepared, const InfluenceStrip& strip);

} // namespace bem_contact
