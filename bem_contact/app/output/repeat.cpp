#include "bem_contact/app/output/repeat.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <string_view>

namespace bem_contact::app {

namespace {

namespace fs = std::filesystem;

void require_result(const record::Record& file, const fs::path& path) {
  const std::string format(record::text_at(file, "format").value_or(""));
  const FileKind* kind = kind_of(format);
  if (kind == kind_of(result_format) && record::text_at(file, "scene_with_defaults"))
    return;
  const std::string name = path.string();
  if (kind && *kind->command)
    throw InputError(fmt::format("'{}' cannot be repeated by solve", name),
                     fmt::format("it holds {}", kind->holds),
                     fmt::format("Write its scene with bem_contact info --scene '{}' and give it to "
                                 "bem_contact {}.",
                                 name, kind->command));
  throw InputError(fmt::format("'{}' cannot be repeated", name),
                   kind ? "it does not say what was solved" : "it is no result file",
                   "Name a file that bem_contact solve -o wrote, or a scene.");
}

/// "FILE#2" has a file and a number behind it.
std::string part_of(const std::string& name) {
  const auto hash = name.rfind('#');
  return hash == std::string::npos ? "" : name.substr(hash);
}

/// Where the scene's file should lie today.
fs::path place_of(const InputRecord& input, const fs::path& folder) {
  return names_profile(input.key) ? profile_file_name(input.name, folder).file : folder / input.name;
}

/// Throws InputError unless the file is there with the same bytes.
void require_unchanged(const InputRecord& input, const fs::path& place) {
  const char* what = names_influence(input.key) ? "influence file" : "file";
  if (!is_regular(place))
    throw InputError(fmt::format("The {} '{}' is missing", what, input.name),
                     fmt::format("{} named it; its SHA-256 was {}, and there is no file '{}'", input.key,
                                 input.sha256, place.string()),
                     "Put it there, or say with --folder where the scene's relative paths start.");
  const std::string now = sha256_of_file(place.string());
  if (now != input.sha256)
    throw InputError(fmt::format("The {} '{}' has changed since the result was made", what, place.string()),
                     fmt::format("{} named it; its SHA-256 was {} and is {}", input.key, input.sha256, now),
                     "Bring back the former file, or name another folder with --folder.");
}

/// Prepares all inputs and points the scene's keys to them.
class InputsAgain {
public:
  InputsAgain(const record::Record& file, fs::path folder)
      : inputs_(stored_inputs(file)), folder_(std::move(folder)) {}

  void point_to(SceneReader& reader, Warnings& warnings) {
    for (const InputRecord& input : inputs_) // all of them before one is written
      require_names(input, reader);
    for (const InputRecord& input : inputs_) {
      if (input.sha256.empty()) // a standard profile
        continue;
      if (input.content)
        reader.set({input.key, unpack(input, warnings).string() + part_of(input.name)});
      else if (const std::string_view by = named_by(input.key); !by.empty())
        require_unchanged(input, place_of(input, file_of(by).parent_path()));
      else {
        const fs::path place = place_of(input, folder_);
        require_unchanged(input, place);
        reader.set({input.key, fs::absolute(place).string() + part_of(input.name)});
      }
    }
  }

private:
  /// The names of a result file may be anybody's, and become those of a copy's folder and file.
  static void require_names(const InputRecord& input, const SceneReader& reader) {
    if (input.content)
      reader.require_key(input.key);
    const fs::path name = fs::path(input.name).filename();
    if (name.empty() || name == "." || name == "..")
      throw InputError("The result file is damaged",
                       fmt::format("the file of its input {} is '{}'", input.key, input.name),
                       "Copy the result file again from where it was whole.");
  }

  fs::path file_of(std::string_view key) const {
    for (const InputRecord& input : inputs_)
      if (input.key == key)
        return place_of(input, folder_);
    return folder_;
  }

  fs::path unpack(const InputRecord& input, Warnings& warnings) const {
    if (sha256(*input.content) != input.sha256)
      throw InputError(fmt::format("The result file's copy of '{}' is damaged", input.name),
                       fmt::format("{}: its SHA-256 should be {} and is {}", input.key, input.sha256,
                                   sha256(*input.content)),
                       "Copy the result file again from where it was whole.");
    const fs::path place = place_of(input, folder_);
    if (is_regular(place)) {
      const std::string now = sha256_of_file(place.string());
      if (now != input.sha256)
        warnings.add(WarningKind::changed_input,
                     fmt::format("'{}' ({}) has changed since: its SHA-256 was {} and is {}; the copy in the "
                                 "result file is used",
                                 place.string(), input.key, input.sha256, now),
                     input.key);
    }
    const bool profile = names_profile(input.key);
    const fs::path name = profile ? profile_file_name(input.name).file : fs::path(input.name);
    return folder_of_copies_.write(input.key / name.filename(), *input.content);
  }

  std::vector<InputRecord> inputs_;
  fs::path folder_;
  TemporaryFolder folder_of_copies_;
};

/// `body`: "rail" or "wheel".
void compare_geometry(const record::Record& file, const std::string& body, std::uint64_t now,
                      std::vector<std::string>& others) {
  const auto text = [&](const std::string& path) {
    return std::string(record::text_at(file, path).value_or(""));
  };
  const std::string input = fmt::format("inputs/{}.profile/", body);
  const std::string before = text("geometry/" + body);
  const std::string digest = fmt::format("{:016x}", now);
  if (!before.empty() && before != digest)
    others.push_back(
        fmt::format("{}.profile '{}': this program makes another curve of it (its checksum was {} "
                    "and is {})",
                    body, text(input + "name"), before, digest));
}

/// The numbers of the result.
std::map<std::string, double> numbers_before(const record::Record& file) {
  std::map<std::string, double> before;
  const record::Content* quantities = record::find(file, "quantities");
  if (const auto* all = quantities ? std::get_if<record::Record>(quantities) : nullptr)
    for (const record::Entry& entry : all->entries())
      if (const auto* number = std::get_if<record::Number>(&entry.content))
        before[entry.name] = number->value;
  return before;
}

} // namespace

bool is_hdf5(const fs::path& file) {
  if (!is_regular(file))
    return false;
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::string first(signature.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  return in.read(first.data(), static_cast<std::streamsize>(first.size())) && first == signature;
}

Repetition repeat_result(const fs::path& file, const fs::path& folder) {
  const record::Record stored = record::read_hdf5(file);
  require_result(stored, file);
  const auto text = [&](const char* path) { return std::string(record::text_at(stored, path).value_or("")); };
  const fs::path start =
      folder.empty() ? (file.parent_path() / text("scene_folder")).lexically_normal() : folder;
  Repetition out;
  out.program = text("program");
  out.commit = text("commit");
  SceneReader reader(
      {text("scene_with_defaults"), fmt::format("scene_with_defaults of '{}'", file.string()), start});
  InputsAgain inputs(stored, start);
  inputs.point_to(reader, out.warnings);
  out.result = Sequence().solve(reader.scene());

  out.model = text("model");
  out.differences = differing_quantities(numbers_before(stored), out.result);
  if (out.model != name_of(out.result.choice.model))
    out.others.push_back(
        fmt::format("the model was {} and is {}", out.model, name_of(out.result.choice.model)));
  compare_geometry(stored, "rail", out.result.bodies.rail_geometry, out.others);
  compare_geometry(stored, "wheel", out.result.bodies.wheel_geometry, out.others);
  return out;
}

std::string to_text(const Repetition& r) {
  std::string out =
      fmt::format("made by {} (commit {}), repeated by {} (commit {}), model {}\n", r.program, r.commit,
                  provenance("bem_contact"), commit(), name_of(r.result.choice.model));
  const double tolerance = r.result.result.trust.certificate.tolerance;
  if (r.same())
    return out + fmt::format("the same: every total agrees with the file within the certificate's tolerance "
                             "({:.0e} of its scale)\n",
                             tolerance);
  for (const std::string& other : r.others)
    out += other + "\n";
  if (!r.differences.empty())
    out += fmt::format("{:<20} {:>14} {:>14} {:>11} {:>11} {:>11}\n", "differs", "in the file", "now",
                       "difference", "allowed", "its error");
  for (const QuantityDifference& d : r.differences) {
    const Quantity& q = *d.quantity;
    const double error = q.measured(r.result).error;
    out += fmt::format("{:<20} {:>14.9g} {:>14.9g} {:>11.2e} {:>11.1e} {:>11} {}\n", q.name, d.before, d.now,
                       d.now - d.before, d.allowed, std::isnan(error) ? "-" : fmt::format("{:.1e}", error),
                       q.unit.of(is_shift(r.result)));
  }
  return out + fmt::format("allowed: {:.0e} of the scale of the quantity, by the certificate; its error: by "
                           "the size of the elements\n",
                           tolerance);
}

std::string stored_scene(const fs::path& file, bool with_defaults) {
  const record::Record top = record::read_hdf5_top(file);
  const auto text = record::text_at(top, with_defaults ? "scene_with_defaults" : "scene_text");
  if (!text)
    throw InputError(
        fmt::format("'{}' holds no scene", file.string()),
        "it is no file of this version that says what was solved",
        "Name a file that solve, compare, sweep, creep-curves, fit, conicity or wheelset wrote.");
  return std::string(*text);
}

} // namespace bem_contact::app
