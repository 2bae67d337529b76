#include "bem_contact/app/commands/influence_files.hpp"

#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/packed_file.hpp"
#include "bem_contact/influence/prepared_files.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <memory>
#include <ostream>
#include <set>

namespace bem_contact::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_help =
    R"(Influence files of standard bodies take minutes and finite elements to compute. Some are prepared: they came with the
program, or somebody has made a folder of them (tools/makers/library FOLDER). Example:
    bem_contact influence list
You should see a line for each file: body, strip, shortest elements, error, size. The folder is that of --folder, else of
the environment variable CONFORMAL_INFLUENCE, else the one beside this program.)";

constexpr const char* get_help =
    R"(Copies prepared influence files of these bodies here, each verified by its SHA-256, and unpacks them. Example:
    bem_contact influence get 60E1 S1002 -o files
You should see the files, and for each the line of a scene in this folder that uses it. A body has a file for each strip; --strip takes
one of them (`bem_contact influence list` has their names).
A body that is not prepared is computed by `tools/influence NAME`, where finite elements are installed.)";

constexpr const char* pack_help =
    R"(Makes a file smaller that is to be sent: numbers are rounded by less than 1e-6 of a self number and compressed.
Example:
    bem_contact influence pack data/influence/small_rail.h5 -o packed.h5
You should see both sizes. A packed file is used as any other; reading it takes a little longer.)";

struct FilesRequest {
  std::vector<std::string> names;
  std::string folder, strip, output = ".", file, packed;
};

std::string line_of(const PreparedFile& one) {
  const std::string error =
      one.estimated_error < 0 ? "error not known" : fmt::format("error {:.1e}", one.estimated_error);
  return fmt::format("{} {}, {}, s = {:g} .. {:g} mm, elements from {:.3g} mm, {}, {:.1f} MB", one.kind,
                     one.body, one.strip, one.from, one.to, one.shortest_dx, error, 1e-6 * one.bytes);
}

std::vector<PreparedFile> files_there(const FilesRequest& request) {
  const fs::path folder = request.folder.empty() ? prepared_folder() : fs::path(request.folder);
  if (folder.empty())
    throw InputError("There are no prepared influence files",
                     "none came with this program, and CONFORMAL_INFLUENCE is not set",
                     "Name their folder (--folder), or compute them: tools/influence 60E1.");
  return prepared_files(folder);
}

/// Those of one body and strip. Throws InputError where there are none.
std::vector<PreparedFile> files_of(const std::vector<PreparedFile>& all, const std::string& name,
                                   const std::string& strip) {
  const std::string body = standard_name(name); // people use several for one
  std::vector<PreparedFile> found;
  std::set<std::string> bodies, strips;
  for (const PreparedFile& one : all) {
    const bool its = standard_name(one.body) == body;
    bodies.insert(one.body);
    if (its)
      strips.insert(one.strip);
    if (its && (strip.empty() || one.strip == strip))
      found.push_back(one);
  }
  if (!found.empty())
    return found;
  if (!strips.empty())
    throw InputError(
        fmt::format("No prepared influence file of {} has the strip '{}'", body, strip),
        fmt::format("there are: {}", fmt::join(strips, ", ")),
        fmt::format("Choose one of them, or compute it: tools/influence BODY.toml {}.h5.", body));
  throw InputError(fmt::format("There is no prepared influence file of '{}'", body),
                   fmt::format("there are those of {}", fmt::join(bodies, ", ")),
                   is_standard_profile(body) ? fmt::format("Compute it: tools/influence \"{}\".", body)
                                             : advice_on_name(body));
}

/// Of all these names, each file once.
std::vector<PreparedFile> files_of(const std::vector<PreparedFile>& all, const FilesRequest& request) {
  std::vector<PreparedFile> wanted;
  std::set<fs::path> seen;
  for (const std::string& name : request.names)
    for (const PreparedFile& one : files_of(all, name, request.strip))
      if (seen.insert(one.file).second)
        wanted.push_back(one);
  return wanted;
}

void list_files(const FilesRequest& request) {
  const std::vector<PreparedFile> all = files_there(request);
  for (const PreparedFile& one : request.names.empty() ? all : files_of(all, request))
    print_out("{}: {}\n", one.file.filename().string(), line_of(one));
}

/// Writes a prepared file, unless it is there: not packed, because a packed one takes three times as long to
/// read. Throws InputError where another file is.
void put(const PreparedFile& one, const fs::path& target) {
  const InfluenceFunction function = read_influence_file(one.file);
  require_as_described(one, function);
  const TemporaryFolder folder;
  const fs::path made = folder / "made.h5";
  write_influence_file(made, function, read_stress_kernel(one.file));
  if (!file_exists(target))
    return write_whole(target,
                       [&](std::ostream& out) { out << std::ifstream(made, std::ios::binary).rdbuf(); });
  if (seal_of(target) != seal_of(made))
    throw InputError(fmt::format("The file '{}' exists and would be replaced", target.string()),
                     "it is not the prepared one", "Give another folder (-o), or move this file.");
}

void get_files(const FilesRequest& request) {
  const std::vector<PreparedFile> all = files_there(request);
  const std::vector<PreparedFile> wanted = files_of(all, request);
  for (const PreparedFile& one : wanted) // all before the first is copied
    verified_bytes(one);
  make_folder(request.output);
  for (const PreparedFile& one : wanted) {
    const fs::path target = (fs::path(request.output) / one.file.filename()).lexically_normal();
    put(one, target);
    print_out("{}: {}\n    {}.influence = {}\n", target.string(), line_of(one), one.kind,
              toml_text(target.generic_string()));
  }
}

void pack_file(const FilesRequest& request) {
  require_outputs({request.file}, {{"--output", request.packed, OutputForm::whole_file, true}});
  require_replaceable_influence(request.packed);
  write_packed_influence_file(request.packed, read_influence_file(request.file),
                              read_stress_kernel(request.file));
  print_out("{}: {:.2f} MB of {:.2f}\n", request.packed,
            1e-6 * static_cast<double>(fs::file_size(request.packed)),
            1e-6 * static_cast<double>(fs::file_size(request.file)));
}

} // namespace

std::function<bool()> add_influence_files(CLI::App& influence) {
  const auto request = std::make_shared<FilesRequest>();
  FilesRequest& r = *request;
  CLI::App* list = influence.add_subcommand("list", "Which influence files are prepared?");
  list->add_option("names", r.names, "Bodies: 60E1, S1002 (default: all)");
  list->footer(list_help);
  CLI::App* get = influence.add_subcommand("get", "Copy prepared influence files of these bodies");
  get->add_option("names", r.names, "Bodies: 60E1, S1002")->required();
  get->add_option("--strip", r.strip, "This strip alone, as \"gauge corner\"");
  add_output_option(*get, "-o,--output", r.output, "Folder to write to (default: this one)");
  get->footer(get_help);
  for (CLI::App* line : {list, get})
    line->add_option("--folder", r.folder,
                     "Folder of prepared files (default: $CONFORMAL_INFLUENCE, or the program's own)");
  CLI::App* pack = influence.add_subcommand("pack", "Make an influence file smaller");
  pack->add_option("file", r.file, "Influence file")->required();
  add_output_option(*pack, "-o,--output", r.packed, "Influence file to write")->required();
  pack->footer(pack_help);
  return [=] {
    if (list->parsed())
      list_files(*request);
    else if (get->parsed())
      get_files(*request);
    else if (pack->parsed())
      pack_file(*request);
    else
      return false;
    return true;
  };
}

} // namespace bem_contact::app
