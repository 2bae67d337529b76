#include "bem_contact/influence/prepared_files.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <set>

namespace bem_contact {

namespace {

namespace fs = std::filesystem;

/// Where folders of prepared files lie beside a program in `bin`: installed, in a portable folder, in the
/// sources beside a build.
constexpr const char* places[] = {"../share/conformal_contact/influence", "../data/influence",
                                  "../../data/influence"};

Schema schema_of(PreparedFile& one, std::string& name) {
  Schema s("prepared influence file");
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

/// Throws InputError for an entry that leads out of the folder, or is not of this kind of files.
void require_entry(const PreparedFile& one, const std::string& name, const std::string& index) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("The index '{}' has a wrong entry of the file '{}'", index, name), why,
                     "Make the folder again: tools/makers/library.");
  };
  const fs::path path = name;
  if (path.empty() || path != path.filename() || path == "." || path == "..")
    refuse("prepared files lie in the folder of their index");
  if (one.kind != name_of(ProfileKind::rail) && one.kind != name_of(ProfileKind::wheel))
    refuse(fmt::format("its kind is '{}', not rail or wheel", one.kind));
  if (one.from >= one.to)
    refuse(fmt::format("its strip goes from s = {:g} to {:g} mm", one.from, one.to));
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
  const auto refuse_empty = [&](const std::string& why) {
    throw InputError(fmt::format("The folder '{}' has no prepared influence files", folder.string()), why,
                     "Name one that tools/makers/library has made, or that came with a release.");
  };
  if (!file_exists(index))
    refuse_empty(fmt::format("there is no {} in it", prepared_index));
  std::vector<PreparedFile> files;
  std::vector<std::string> names;
  Schema schema("index of influence files");
  schema.add("file",
             TableList{[&] {
                         files.clear();
                         names.clear();
                       },
                       [&] { return schema_of(files.emplace_back(), names.emplace_back()); },
                       "[{ name = \"60E1_gauge_corner.h5\", body = \"60E1\", ... }]"},
             "The files of this folder");
  schema.read(read_text_file(index, "index of influence files"), index);
  if (files.empty())
    refuse_empty(fmt::format("its {} names none", prepared_index));
  std::set<std::string> seen;
  for (std::size_t i = 0; i < files.size(); ++i) {
    require_entry(files[i], names[i], index);
    if (!seen.insert(names[i]).second)
      throw InputError(fmt::format("The index '{}' names the file '{}' twice", index, names[i]),
                       "one strip has one file", "Make the folder again: tools/makers/library.");
    files[i].file = folder / names[i];
  }
  return files;
}

std::string verified_bytes(const PreparedFile& prepared) {
  std::string bytes = read_bytes(prepared.file.string(), "prepared influence file");
  if (bytes.size() != static_cast<std::size_t>(prepared.bytes))
    refuse_altered(prepared, fmt::format("it has {} bytes, not {}", bytes.size(), prepared.bytes));
  std::string named = prepared.sha256; // some programs write digests in capital letters
  std::ranges::transform(named, named.begin(), [](unsigned char c) { return std::tolower(c); });
  if (const std::string digest = sha256(bytes); digest != named)
    refuse_altered(prepared,
                   fmt::format("its SHA-256 is {}..., not {}...", digest.substr(0, 12), named.substr(0, 12)));
  return bytes;
}

void require_as_described(const PreparedFile& prepared, const InfluenceStrip& strip) {
  constexpr double rounding = 1e-6; // mm, of numbers in an index
  const std::string kind = name_of(lies_above(strip) ? ProfileKind::wheel : ProfileKind::rail);
  const auto [from, to] = strip.ends();
  if (kind != prepared.kind || std::abs(from - prepared.from) > rounding ||
      std::abs(to - prepared.to) > rounding)
    refuse_altered(prepared,
                   fmt::format("it is of a {} from s = {:g} to {:g} mm, not of a {} from {:g} to {:g} mm",
                               kind, from, to, prepared.kind, prepared.from, prepared.to));
}

} // namespace bem_contact
