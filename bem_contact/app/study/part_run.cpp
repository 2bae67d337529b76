#include "bem_contact/app/study/part_run.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/study/run_line.hpp"
#include "bem_contact/app/sweep/sweep_on_cores.hpp"
#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ostream>

namespace bem_contact::app {

namespace {

/// One part of a study on its way.
class PartRun {
public:
  PartRun(const Part& part, const StudyCase& study, const StudyFolder& where)
      : part_(part), study_(study), where_(where),
        lock_(where.parts() / fmt::format(".{}", part.name), "Wait for it, or give another folder."),
        made_(where.parts(), {.maker = study_maker, .list = part.name, .inputs = where.inputs}) {
    if (part.of_one_wheel && study.has("wheelset"))
      scene_ = where.parts() / "wheel.toml";
    else if (part.of_one_wheelset && study.has("wheelset") && study.has("sweep"))
      scene_ = where.parts() / unswept;
    else
      scene_ = where.scene;
  }

  PartResult run(std::set<std::string>& said) {
    PartResult out{.part = &part_, .about = about_wheel(), .file = file_of_result()};
    find_digests();
    const State before = state();
    if (!digest_.empty() && before.digest == digest_ && may_stay(before.code)) {
      require_result_unchanged();
      out.kept = true;
      out.code = before.code;
      out.seconds = before.seconds;
      out.errors = before.errors;
      out.warnings = before.warnings;
    } else {
      if (before.base != base_)
        remove_old();
      begin();
      write_state({.base = base_});
      const Stopwatch watch;
      compute(out, said);
      out.seconds = watch.seconds();
      for (const std::string& name : own_files())
        if (made_.lists(name))
          made_.done(name);
      write_state({base_, digest_, out.code, out.seconds, out.errors, out.warnings});
    }
    if (!file_exists(out.file))
      out.file.clear();
    return out;
  }

  /// What an earlier study has left of this part.
  void remove_old() {
    for (const std::string& name : own_files())
      made_.remove(name);
    made_.remove(state_name());
    if (part_.kind == PartKind::wear)
      remove_wear();
    if (part_.kind == PartKind::sweep)
      remove_parts_of_sweep(where_.parts() / (part_.name + std::string(".h5")));
    for (const std::string& name : csv_files_beside())
      OutputFolder(where_.folder, in_the_folder()).remove(name);
  }

private:
  /// What is kept of a part in NAME.json.
  struct State {
    std::string base, digest = {};
    int code = -1;
    double seconds = 0;
    std::vector<std::string> errors = {}, warnings = {};
  };

  std::string state_name() const { return part_.name + std::string(".json"); }
  /// Of the result and of what was printed; a study of wear has a folder of its own.
  std::vector<std::string> own_files() const {
    return {part_.name + std::string(".txt"), part_.name + std::string(".h5")};
  }
  /// A sweep's tables lie in the folder of the answers.
  std::vector<std::string> csv_files_beside() const {
    return part_.kind == PartKind::sweep
               ? std::vector<std::string>{"sweep.csv", "sweep_patches.csv", "sweep_units.csv"}
               : std::vector<std::string>{};
  }
  FolderUse in_the_folder() const {
    return {.maker = study_maker, .list = part_.name, .alone = false, .inputs = where_.inputs};
  }

  void remove_wear() const {
    const std::filesystem::path folder = where_.parts() / part_.name;
    const FolderUse use{.maker = wear_maker};
    if (OutputFolder::has_list(folder, use))
      OutputFolder(folder, use).remove_all();
  }

  /// Whatever its command will write is ours, or not there.
  void begin() {
    for (const std::string& name : own_files())
      made_.take(name);
    if (!csv_files_beside().empty()) {
      OutputFolder folder(where_.folder, in_the_folder());
      for (const std::string& name : csv_files_beside())
        folder.take(name);
    }
  }

  /// A result that somebody has changed or replaced is neither used nor removed.
  void require_result_unchanged() const {
    if (is_wear_study())
      OutputFolder(output(), {.maker = wear_maker}).require_unchanged();
    else if (part_.kind != PartKind::influence)
      made_.require(output().filename().string());
  }

  bool is_wear_study() const {
    return part_.kind == PartKind::wear && study_.has("sweep") && !study_.has("wheelset");
  }
  std::filesystem::path output() const {
    return where_.parts() / fmt::format("{}{}", part_.name, is_wear_study() ? "" : ".h5");
  }
  std::filesystem::path file_of_result() const {
    return part_.kind == PartKind::influence ? std::filesystem::path()
           : is_wear_study()                 ? output() / "wear.h5"
                                             : output();
  }
  std::filesystem::path beside(const char* ending) const {
    return where_.parts() / fmt::format("{}.{}", part_.name, ending);
  }

  /// Of a part of one wheel: which, and by which model.
  std::string about_wheel() const {
    const std::filesystem::path found = where_.parts() / "wheelset.h5";
    if (scene_ == where_.parts() / unswept)
      return "of the scene without [sweep], whose cases are wheelsets of their own";
    if (scene_ == where_.scene || !file_exists(found) || !file_exists(scene_))
      return "";
    const WheelOfStudy wheel = wheel_of(record::read_hdf5(found));
    const std::string of = fmt::format("{} wheel where wheelset has put it", name_of(wheel.side));
    if (part_.has_models)
      return of + fmt::format(", elements {:.3g} x {:.3g} mm, models of its own", wheel.dx, wheel.ds);
    const std::string own = study_.model_of(part_.name);
    return of + (own.empty()
                     ? fmt::format(", by {} on its elements of {:.3g} x {:.3g} mm", wheel.model, wheel.dx,
                                   wheel.ds)
                     : fmt::format(", by {} as [{}] says; wheelset by {}", own, part_.name, wheel.model));
  }

  /// What the part depends on: `base_` without what may grow later. "": it cannot be said.
  void find_digests() {
    if (part_.kind == PartKind::influence) {
      digest_ = base_ = digest_of_bodies();
      return;
    }
    try {
      const SceneText text = read_scene_text(scene_);
      const SweepFile sweep = has_sweep(text) ? parse_sweep_file(text) : SweepFile{text};
      const std::string files = digests_of_files(text);
      digest_ = digest_of(sweep, part_.name + text_for(text, {part_.name}) + files);
      base_ = digest_of(sweep, part_.name + text_for(text, {part_.name}, {"wear.depth"}) + files);
    } catch (const InputError&) { // the part says it
    }
  }

  /// Of the files that the part's table names: measured points, stresses.
  std::string digests_of_files(const SceneText& text) const {
    std::string out;
    for (const std::string& file : files_of_table(text, part_.name))
      out += "\n" + sha256_of_file(file);
    return out;
  }

  std::string digest_of_bodies() const {
    std::string all = study_.influence.program;
    for (const std::string& body : {study_.influence.rail, study_.influence.wheel})
      for (const NamedFile& named : files_of_key("rail.profile", body, study_.text.folder))
        all += "\n" + (is_regular(named.file) ? sha256_of_file(named.file.string()) : named.name);
    return sha256(all);
  }

  /// Empty where there is none, or another than was written: then the part is computed again.
  State state() {
    if (made_.lists(state_name()) && is_regular(beside("json")) && !made_.owns(state_name()))
      made_.adopt(state_name());
    else if (made_.owns(state_name()))
      try {
        const auto read = nlohmann::json::parse(read_text_file(beside("json").string(), "state of a part"));
        return {read.at("base"),    read.at("digest"), read.at("code"),
                read.at("seconds"), read.at("errors"), read.at("warnings")};
      } catch (const nlohmann::json::exception&) { // a kill left it unfinished
      }
    return {};
  }
  void write_state(const State& state) {
    const nlohmann::json all{{"base", state.base},     {"digest", state.digest},
                             {"code", state.code},     {"seconds", state.seconds},
                             {"errors", state.errors}, {"warnings", state.warnings}};
    made_.write(state_name(), [&](std::ostream& out) {
      out << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    });
  }

  /// What was refused costs little, and the reason may lie in what no digest holds. A part that
  /// goes on does so.
  bool may_stay(int code) const {
    const bool there =
        part_.kind == PartKind::influence ? influence_is_there() : file_exists(file_of_result());
    return code == success ? there : code == no_convergence && !part_.goes_on;
  }
  bool influence_is_there() const {
    return std::ranges::all_of(influence_files(),
                               [](const auto& named) { return file_exists(named.second); });
  }

  void compute(PartResult& out, std::set<std::string>& said) const {
    if (part_.kind == PartKind::influence)
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
    if (part_.kind == PartKind::wear && !where_.program.empty())
      words.insert(words.end(), {"--influence", where_.program});
    if (part_.kind == PartKind::sweep)
      words.insert(words.end(), {"--csv", (where_.folder / "sweep.csv").string()});
    const LineOutcome line = run_line(words, beside("txt"), said);
    out.code = line.code;
    out.errors = line.errors;
    out.warnings = line.warnings;
    if (csv_files_beside().empty())
      return;
    OutputFolder folder(where_.folder, in_the_folder());
    for (const std::string& name : csv_files_beside())
      folder.done(name);
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
      const bool standard = is_standard_profile(*body); // tools/influence knows its body
      out.emplace_back(standard ? *body : (study_.text.folder / *body).string(),
                       (study_.text.folder / *file).string());
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
  LockFile lock_;
  OutputFolder made_;
  std::filesystem::path scene_;
  std::string digest_, base_;
};

} // namespace

PartResult run_part(const Part& part, const StudyCase& study, const StudyFolder& where,
                    std::set<std::string>& said) {
  return PartRun(part, study, where).run(said);
}

void remove_part(const Part& part, const StudyCase& study, const StudyFolder& where) {
  PartRun(part, study, where).remove_old();
}

} // namespace bem_contact::app
