#include "bem_contact/app/study/study_parts.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/study/run_line.hpp"
#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/command_tables.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ostream>

namespace bem_contact::app {

namespace {

bool takes_one_wheel(const StudyCase& study) {
  return std::ranges::any_of(all_parts(), [&](const Part& p) { return p.of_one_wheel && study.has(p.name); });
}

constexpr Part parts_of_studies[] = {
    {"influence", "Influence functions", "", [](const StudyCase& s) { return s.has("influence"); }},
    {"solve", "The contact", "solve",
     [](const StudyCase& s) { return !s.has("wheelset") && !s.has("sweep"); }},
    {"wheelset", "Both wheels", "wheelset",
     [](const StudyCase& s) { return s.has("wheelset") && (!s.has("sweep") || takes_one_wheel(s)); }},
    {"sweep", "All cases", "sweep", [](const StudyCase& s) { return s.has("sweep"); }, false, true, true},
    {"compare", "Models of elasticity", "compare", [](const StudyCase& s) { return s.has("compare"); }, true},
    {"conicity", "Conicity", "conicity", [](const StudyCase& s) { return s.has("conicity"); }},
    {"creep_curves", "Creep curves", "creep-curves", [](const StudyCase& s) { return s.has("creep_curves"); },
     true, true},
    {"table", "Table of forces", "table", [](const StudyCase& s) { return s.has("table"); }, true, true,
     true},
    {"fatigue", "Rolling contact fatigue", "fatigue", [](const StudyCase& s) { return s.has("fatigue"); },
     true},
    {"shakedown", "Shakedown of the steel below", "shakedown",
     [](const StudyCase& s) { return s.has("shakedown"); }, true},
    {"wear", "Wear", "wear", [](const StudyCase& s) { return s.has("wear"); }, false, true},
};

/// One part of a study on its way.
class PartRun {
public:
  PartRun(const Part& part, const StudyCase& study, const StudyFolder& where)
      : part_(part), study_(study), where_(where) {
    if (part.of_one_wheel && study.has("wheelset"))
      scene_ = where.parts() / "wheel.toml";
    else
      scene_ = where.scene;
  }

  PartResult run(std::set<std::string>& said) {
    const LockFile lock(where_.parts() / fmt::format(".{}", part_.name),
                        "Wait for it, or give another folder.");
    PartResult out{.part = &part_, .file = file_of_result()};
    find_digests();
    const nlohmann::json before = state();
    if (!digest_.empty() && before.value("digest", "") == digest_ && may_stay(before.value("code", -1))) {
      out.kept = true;
      take(before, out);
    } else {
      if (before.value("base", "") != base_)
        remove_old();
      write_state({{"base", base_}});
      const Stopwatch watch;
      compute(out, said);
      out.seconds = watch.seconds();
      write_state({{"base", base_},
                   {"digest", digest_},
                   {"code", out.code},
                   {"seconds", out.seconds},
                   {"errors", out.errors},
                   {"warnings", out.warnings}});
    }
    if (!file_exists(out.file))
      out.file.clear();
    return out;
  }

private:
  bool is_wear_study() const { return std::string_view(part_.name) == "wear" && study_.has("sweep"); }
  std::filesystem::path output() const {
    return where_.parts() / fmt::format("{}{}", part_.name, is_wear_study() ? "" : ".h5");
  }
  std::filesystem::path file_of_result() const {
    return !*part_.command ? std::filesystem::path() : is_wear_study() ? output() / "wear.h5" : output();
  }
  std::filesystem::path beside(const char* ending) const {
    return where_.parts() / fmt::format("{}.{}", part_.name, ending);
  }

  /// What the part depends on: `base_` without what may grow later. "": it cannot be said.
  void find_digests() {
    if (!*part_.command) {
      digest_ = base_ = digest_of_bodies();
      return;
    }
    try {
      const SceneText text = read_scene_text(scene_);
      const SweepFile sweep = has_sweep(text) ? parse_sweep_file(text) : SweepFile{text};
      digest_ = digest_of(sweep, part_.name + text_for(text, {part_.name}));
      base_ = digest_of(sweep, part_.name + text_for(text, {part_.name}, {"wear.depth"}));
    } catch (const InputError&) { // the part says it
    }
  }

  std::string digest_of_bodies() const {
    std::string all = study_.influence.program;
    for (const std::string& body : {study_.influence.rail, study_.influence.wheel})
      for (const NamedFile& named : files_of_key("rail.profile", body, study_.text.folder))
        all += "\n" + (is_regular(named.file) ? sha256_of_file(named.file.string()) : named.name);
    return sha256(all);
  }

  nlohmann::json state() const {
    if (!is_regular(beside("json")))
      return nlohmann::json::object();
    const auto read =
        nlohmann::json::parse(read_text_file(beside("json").string(), "state of a part"), nullptr, false);
    return read.is_object() ? read : nlohmann::json::object();
  }
  void write_state(const nlohmann::json& state) const {
    write_whole(beside("json"), [&](std::ostream& out) { out << state.dump(2) << '\n'; });
  }
  static void take(const nlohmann::json& state, PartResult& out) {
    out.code = state.value("code", 0);
    out.errors = state.value("errors", std::vector<std::string>());
    out.warnings = state.value("warnings", std::vector<std::string>());
    out.seconds = state.value("seconds", 0.0);
  }

  /// What was refused costs little, and the reason may lie in what no digest holds. A part that
  /// goes on does so.
  bool may_stay(int code) const {
    const bool there = *part_.command ? file_exists(file_of_result()) : influence_is_there();
    return code == success ? there : code == no_convergence && !part_.goes_on;
  }
  bool influence_is_there() const {
    return std::ranges::all_of(influence_files(),
                               [](const auto& named) { return file_exists(named.second); });
  }

  /// What an earlier study has left of this part.
  void remove_old() const {
    for (const auto& entry : std::filesystem::directory_iterator(where_.parts())) {
      const std::string name = entry.path().filename().string();
      if (name == part_.name || name.starts_with(fmt::format("{}.", part_.name)))
        std::filesystem::remove_all(entry.path());
    }
  }

  void compute(PartResult& out, std::set<std::string>& said) const {
    if (!*part_.command)
      return compute_influence(out, said);
    if (scene_ != where_.scene && !file_exists(scene_)) {
      out.code = wrong_input;
      out.errors.push_back(
          "There is no wheel to answer for (the equilibrium of the wheelset was not found) See what "
          "the part wheelset says.");
      return;
    }
    std::vector<std::string> words{part_.command, scene_.string(), "-o", output().string()};
    if (part_.has_jobs && where_.jobs > 0) // else as the command has it
      words.insert(words.end(), {"--jobs", fmt::format("{}", where_.jobs)});
    if (std::string_view(part_.name) == "sweep")
      words.insert(words.end(), {"--csv", (where_.folder / "sweep.csv").string()});
    const LineOutcome line = run_line(words, beside("txt"), said);
    out.code = line.code;
    out.errors = line.errors;
    out.warnings = line.warnings;
  }

  /// Body files and the influence files that the scene names for them.
  std::vector<std::pair<std::string, std::string>> influence_files() const {
    std::vector<std::pair<std::string, std::string>> out;
    const SceneFile scene = parse_scene_file(study_.text);
    for (const auto& [name, body, file] : {std::tuple{"rail", &study_.influence.rail, &scene.rail.influence},
                                           {"wheel", &study_.influence.wheel, &scene.wheel.influence}}) {
      if (body->empty())
        continue;
      if (file->empty())
        throw InputError(fmt::format("influence.{} has no file to be written to", name),
                         fmt::format("{}.influence is not given", name),
                         fmt::format("Give it, for instance {0}.influence = \"{0}.h5\".", name));
      out.emplace_back((study_.text.folder / *body).string(), (study_.text.folder / *file).string());
    }
    return out;
  }

  void compute_influence(PartResult& out, std::set<std::string>& said) const {
    try {
      for (const auto& [body, file] : influence_files()) {
        const LineOutcome line = run_other({study_.influence.program, body, file}, beside("txt"), said);
        out.errors.insert(out.errors.end(), line.errors.begin(), line.errors.end());
        out.code = std::max(out.code, line.code == 0 && !file_exists(file) ? int(unforeseen) : line.code);
        if (line.errors.empty() && !file_exists(file)) // a program of others need not say it in our words
          out.errors.push_back(fmt::format("There is no influence file '{}' ({} {} ended with exit code {}) "
                                           "Look at what it said above, or call it alone.",
                                           file, study_.influence.program, body, line.code));
      }
    } catch (const InputError& error) {
      out.code = wrong_input;
      out.errors.emplace_back(error.what());
    }
  }

  const Part& part_;
  const StudyCase& study_;
  const StudyFolder& where_;
  std::filesystem::path scene_;
  std::string digest_, base_;
};

/// The scene of one wheel, for the parts that take one. It stays as it is where nothing has changed.
void write_wheel(const StudyCase& study, const StudyFolder& where, const PartResult& wheelset) {
  const std::filesystem::path file = where.parts() / "wheel.toml";
  if (wheelset.file.empty()) {
    std::filesystem::remove(file);
    return;
  }
  const std::string_view dropped[] = {"sweep"}; // its cases are wheelsets
  const std::string text = changed_text(
      {wheel_text(study.text, record::read_hdf5(wheelset.file)), study.text.source, study.text.folder}, {},
      dropped);
  write_whole(file, [&](std::ostream& out) { out << text; });
}

} // namespace

void make_study_folder(const StudyFolder& where) {
  std::error_code failed;
  std::filesystem::create_directories(where.parts(), failed);
  if (failed)
    throw InputError(fmt::format("The folder '{}' cannot be made", where.folder.string()), failed.message(),
                     "Give another one.");
}

std::span<const Part> all_parts() {
  return parts_of_studies;
}

const Part* part_named(std::string_view name) {
  const auto found =
      std::ranges::find_if(parts_of_studies, [&](const Part& part) { return part.name == name; });
  return found == std::ranges::end(parts_of_studies) ? nullptr : found;
}

std::string status_of(const PartResult& result) {
  switch (result.code) {
  case success:
    return "done";
  case wrong_input:
    return "refused";
  case no_convergence:
    return "not certified";
  default:
    return "failed";
  }
}

std::vector<PartResult> run_parts(const StudyCase& study, const StudyFolder& where,
                                  std::set<std::string>& said,
                                  const std::function<void(const PartResult&)>& tell) {
  std::vector<PartResult> out;
  for (const Part& part : all_parts()) {
    const bool wanted = where.wanted.empty() || std::ranges::count(where.wanted, part.name) > 0;
    if (!part.asked(study) || !wanted)
      continue;
    out.push_back(PartRun(part, study, where).run(said));
    if (std::string_view(part.name) == "wheelset")
      write_wheel(study, where, out.back());
    tell(out.back());
  }
  return out;
}

} // namespace bem_contact::app
