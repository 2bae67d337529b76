#include "bem_contact/influence/prepared_files.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/sha256.hpp"

#include <cstdlib>
#include <fmt/format.h>

namespace bem_contact {

namespace {

namespace fs = std::filesystem;

/// Where folders of prepared files lie beside a program in `bin`: installed, in a portable folder, in the
/// sources beside a build.
constexpr const char* places[] = {"../share/conformal_contact/influence", "../data/influence",
                                  "../../data/influence"};

Schema schema_of(PreparedFile& one, std::string& name) {
  Schema s("entry of an index of influence files");
  s.add("file.name", name, "The influence file, in this folder", {.needed = true});
  s.add("file.body", one.body, "Name of the standard, or of the body", {.needed = true});
  s.add("file.kind", one.kind, "rail or wheel", {.needed = true});
  s.add("file.strip", one.strip, "Which part of the profile", {.needed = true});
  s.add("file.from", one.from, "Where the strip begins, arc length", {.unit = "mm", .needed = true});
  s.add("file.to", one.to, "Where it ends", {.unit = "mm", .needed = true});
  s.add("file.shortest_dx", one.shortest_dx, "Length of the shortest elements",
        {.unit = "mm", .at_least = 0, .needed = true});
  s.add("file.estimated_error", one.estimated_error,
        "Of influence numbers, relative to self; below 0: unknown", {.needed = true});
  s.add("file.bytes", one.bytes, "Size of the file", {.at_least = 1, .needed = true});
  s.add("file.sha256", one.sha256, "Digest of the file", {.needed = true});
  s.add("file.version", one.version, "Version of the program that made it", {.needed = true});
  return s;
}

[[noreturn]] void refuse_altered(const PreparedFile& prepared, const std::string& why) {
  throw InputError(
      fmt::format("The prepared influence file '{}' is not the one of its index", prepared.file.string()),
      why, "Copy the folder again from where it was whole.");
}

} // namespace

fs::path prepared_folder() {
  if (const char* named = std::getenv(prepared_variable); named != nullptr && *named != '\0')
    return named;
  const fs::path bin = this_program().parent_path();
  for (const char* place : places)
    if (const fs::path folder = (bin / place).lexically_normal(); is_regular(folder / prepared_index))
      return folder;
  return {};
}

std::vector<PreparedFile> prepared_files(const fs::path& folder) {
  const std::string index = (folder / prepared_index).string();
  std::vector<PreparedFile> files;
  std::vector<std::string> names;
  Schema schema("an index of influence files");
  schema.add("file",
             TableList{[&] {
                         files.clear();
                         names.clear();
                       },
                       [&] { return schema_of(files.emplace_back(), names.emplace_back()); },
                       "[{ name = \"60E1_gauge_corner.h5\", body = \"60E1\", ... }]"},
             "The files of this folder");
  schema.read(read_text_file(index, "index of influence files"), index);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path name = names[i];
    if (name.empty() || name != name.filename() || name == "." || name == "..")
      throw InputError(fmt::format("The index '{}' names the file '{}'", index, names[i]),
                       "prepared files lie in the folder of their index", "Make the folder again.");
    files[i].file = folder / name;
  }
  return files;
}

std::string verified_bytes(const PreparedFile& prepared) {
  std::string bytes = read_bytes(prepared.file.string(), "prepared influence file");
  if (bytes.size() != static_cast<std::size_t>(prepared.bytes))
    refuse_altered(prepared, fmt::format("it has {} bytes, not {}", bytes.size(), prepared.bytes));
  if (const std::string digest = sha256(bytes); digest != prepared.sha256)
    refuse_altered(prepared, fmt::format("its SHA-256 is {}..., not {}...", digest.substr(0, 12),
                                         prepared.sha256.substr(0, 12)));
  return bytes;
}

} // namespace bem_contact
