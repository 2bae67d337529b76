#include "bem_contact/app/study/input_spread.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/profile/noisy_profile.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/uses/wear/worn_profile.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <ostream>

namespace bem_contact::app {

namespace {

/// 1. A drawn coefficient of friction is no smaller: nothing rolls on less.
constexpr double least_drawn_friction = 0.01;

/// Of one draw.
struct DrawFolder {
  std::filesystem::path path;
  OutputFolder* made; ///< null: this process does not solve it
};

void add_noisy_profile(const char* name, const SceneFile::Side& side, ProfileKind kind,
                       const SceneFile& scene, const DrawFolder& folder, double noise, NormalDraws& draws,
                       std::vector<SceneChange>& changes) {
  const std::vector<Point2> points =
      noisy_points(named_profile(side.profile, kind, scene.folder, side.reading), noise, draws);
  const std::string file_name = fmt::format("{}.txt", name);
  const std::filesystem::path file = std::filesystem::absolute(folder.path / file_name);
  if (folder.made) {
    wear::write_profile(folder.made->take(file_name), points);
    folder.made->done(file_name);
  }
  changes.push_back({fmt::format("{}.profile", name), file.string()});
  changes.push_back({fmt::format("{}.profile_z", name), std::string("down")});
  changes.push_back({fmt::format("{}.smoothing", name), smoothing_of(points, side.reading.smoothing)});
}

/// What a draw changes. Each draw takes the same count of random numbers for the same inputs. Drawn profiles
/// are written where the draw is solved.
std::vector<SceneChange> changes_of_draw(const StudyCase& study, const SceneFile& scene,
                                         const DrawFolder& folder, NormalDraws& draws) {
  const Uncertainty& u = study.uncertainty;
  std::vector<SceneChange> out;
  if (u.friction > 0)
    out.push_back({"motion.friction",
                   std::max(least_drawn_friction, scene.motion.friction + u.friction * draws.next())});
  if (u.load > 0) {
    const bool axle = scene.wheelset.force.has_value();
    const std::optional<double> load = axle ? scene.wheelset.force : scene.load.force;
    if (!load)
      throw InputError("uncertainty.load has nothing to scatter",
                       "neither load.force nor wheelset.force is given",
                       "Give one of them, or leave it out.");
    out.push_back({axle ? "wheelset.force" : "load.force", std::max(1.0, *load + u.load * draws.next())});
  }
  if (u.lateral > 0)
    out.push_back({"position.lateral", scene.position.lateral + u.lateral * draws.next()});
  if (u.profile_noise > 0) {
    add_noisy_profile("rail", scene.rail, ProfileKind::rail, scene, folder, u.profile_noise, draws, out);
    add_noisy_profile("wheel", scene.wheel, ProfileKind::wheel, scene, folder, u.profile_noise, draws, out);
  }
  return out;
}

std::vector<std::string> drawn_parts(const StudyCase& study) {
  std::vector<std::string> out;
  for (const std::string& name : study.uncertainty.parts) {
    const Part* part = part_named(name);
    if (!part->asked(study)) {
      std::vector<std::string> known;
      for (const Part& one : all_parts())
        if (one.asked(study))
          known.emplace_back(one.name);
      throw InputError(fmt::format("uncertainty.parts has '{}'", name), "the study has no such part",
                       fmt::format("It has {}.", fmt::join(known, ", ")));
    }
    out.push_back(name);
    if (part->of_one_wheel && study.has("wheelset"))
      out.emplace_back("wheelset"); // which puts the wheel in its place
  }
  return out;
}

FolderUse use_of_draw(const StudyFolder& where) {
  return {.maker = study_maker, .list = "draw", .inputs = where.inputs};
}

/// The study with other inputs, as one of its own in `made`.
std::vector<PartResult> solve_changed(const StudyCase& study, const StudyFolder& where, OutputFolder& made,
                                      const std::vector<SceneChange>& changes, std::set<std::string>& said) {
  const std::filesystem::path file = made.path() / "scene.toml";
  const StudyFolder changed{file, made.path(), where.jobs, drawn_parts(study), where.program, where.inputs};
  make_study_folder(changed);
  const std::string_view dropped[] = {"uncertainty", "influence"};
  const std::string text = changed_text(study.text, changes, dropped);
  made.write("scene.toml", [&](std::ostream& to) { to << text; });
  return run_parts(study_case(read_scene_text(file)), changed, said, [](const auto&) {});
}

/// The numbers of the headline in one draw: nan where it has none.
std::vector<double> values_in(const std::vector<HeadlineNumber>& headline,
                              const std::vector<HeadlineNumber>& drawn) {
  std::vector<double> out;
  for (const HeadlineNumber& number : headline) {
    const auto found = std::ranges::find_if(
        drawn, [&](const HeadlineNumber& d) { return d.part == number.part && d.name == number.name; });
    out.push_back(found == drawn.end() ? std::nan("") : found->value);
  }
  return out;
}

void take_spread(std::vector<HeadlineNumber>& headline, const std::vector<std::vector<double>>& draws) {
  for (std::size_t k = 0; k < headline.size(); ++k) {
    double sum = 0, squares = 0;
    int count = 0;
    for (const std::vector<double>& draw : draws)
      if (const double off = draw[k] - headline[k].value; std::isfinite(off)) // off: keeps the digits
        sum += off, squares += off * off, ++count;
    headline[k].draws = count;
    if (count >= 2)
      headline[k].input_spread = std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1)));
  }
}

} // namespace

int draws_of(const StudyCase& study) {
  return study.uncertainty.asked() ? study.uncertainty.draws : 0;
}

std::vector<std::vector<PartResult>> solve_draws(const StudyCase& study, const StudyFolder& where,
                                                 std::set<std::string>& said,
                                                 const std::function<bool(int draw)>& wanted) {
  const SceneText& text = study.text;
  const SceneFile scene = has_sweep(text) ? parse_sweep_file(text).first_scene() : parse_scene_file(text);
  drawn_parts(study); // refuses parts that there are not
  NormalDraws draws(static_cast<std::uint64_t>(study.uncertainty.seed));
  std::vector<std::vector<PartResult>> out;
  Progress progress("draws", study.uncertainty.draws);
  for (int k = 1; k <= study.uncertainty.draws; ++k) {
    const std::filesystem::path folder = where.parts() / "draws" / fmt::format("{:04}", k);
    std::optional<OutputFolder> made;
    if (wanted(k)) {
      make_folder(folder.parent_path());
      made.emplace(folder, use_of_draw(where));
    }
    const std::vector<SceneChange> changes =
        changes_of_draw(study, scene, {folder, made ? &*made : nullptr}, draws);
    if (made)
      out.push_back(solve_changed(study, where, *made, changes, said));
    progress.step();
  }
  progress.finish();
  return out;
}

std::vector<std::vector<PartResult>>
solve_states(const StudyCase& study, const StudyFolder& where, std::set<std::string>& said,
             const std::function<bool(const std::string& state)>& wanted) {
  std::vector<std::vector<PartResult>> out;
  const std::vector<std::string>& states = study.uncertainty.states;
  Progress progress("states", static_cast<int>(states.size()));
  for (const std::string& state : states) {
    if (wanted(state)) {
      make_folder(where.parts() / "states");
      OutputFolder made(where.parts() / "states" / state, use_of_draw(where));
      out.push_back(solve_changed(study, where, made, {{"layer.state", state}}, said));
    }
    progress.step();
  }
  progress.finish();
  return out;
}

std::vector<std::string> vary_states(const StudyCase& study, const StudyFolder& where,
                                     std::set<std::string>& said, std::vector<HeadlineNumber>& headline) {
  const std::vector<std::string>& states = study.uncertainty.states;
  std::vector<std::string> without;
  std::size_t at = 0;
  for (const std::vector<PartResult>& results :
       solve_states(study, where, said, [](const std::string&) { return true; })) {
    if (std::ranges::any_of(results, [](const PartResult& r) { return r.code != 0; }))
      without.push_back(states[at]);
    ++at;
    const std::vector<double> values = values_in(headline, headline_of(results));
    for (std::size_t k = 0; k < headline.size(); ++k)
      headline[k].by_state.push_back(values[k]);
  }
  if (without.empty())
    return {};
  return {fmt::format("With layer.state = {} a part has no certified answer: its numbers are missing",
                      fmt::join(without, ", "))};
}

std::vector<std::string> draw_inputs(const StudyCase& study, const StudyFolder& where,
                                     std::set<std::string>& said, std::vector<HeadlineNumber>& headline) {
  std::vector<std::vector<double>> values;
  int without = 0;
  for (const std::vector<PartResult>& results : solve_draws(study, where, said, [](int) { return true; })) {
    without += std::ranges::any_of(results, [](const PartResult& r) { return r.code != 0; });
    values.push_back(values_in(headline, headline_of(results)));
  }
  take_spread(headline, values);
  if (without == 0)
    return {};
  return {fmt::format(
      "{} of {} draws have a part without a certified answer: their numbers are missing in the spread",
      without, study.uncertainty.draws)};
}

} // namespace bem_contact::app
