#include "bem_contact/explore/answers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/explore/bodies.hpp"
#include "bem_contact/explore/settings.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/record/outcome.hpp"
#include "bem_contact/report/report_page.hpp"
#include "bem_contact/report/scene_values.hpp"
#include "bem_contact/scene/absolute_names.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::explore {

namespace {

using record::Record;

constexpr const char* json_type = "application/json";
constexpr const char* page_type = "text/html; charset=utf-8";
constexpr const char* text_type = "text/plain; charset=utf-8";
constexpr const char* no_computer =
    "This page computes no influence functions (it has no finite elements) Save the bodies, and give "
    "the commands below, or open the scene with bem_contact explore.";

Reply problem(record::Outcome outcome, const std::string& message) {
  const nlohmann::json said{{"problem", {{"kind", name_of(outcome)}, {"message", message}}}};
  return {json_type, said.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

/// What the page draws: it asks for an answer many times in a second.
bool not_drawn(std::string_view path) {
  constexpr std::string_view data = "data/";
  for (const std::string_view wheel : {"data/wheels/right/", "data/wheels/left/"})
    if (path.starts_with(wheel))
      return not_drawn(fmt::format("{}{}", data, path.substr(wheel.size())));
  constexpr std::array names{
      "data/u_x",           "data/u_s",       "data/u_n",           "data/friction_work_density",
      "data/friction_work", "data/gap",       "data/largest_shear", "data/deformed_distance",
      "data/step_fields",   "data/structure", "data/rigid_slip_x",  "data/rigid_slip_s"};
  return std::ranges::find(names, path) != names.end();
}

/// The record of a result, with the result at whose fields it looks.
template <class Result, class Make> KeptRecord kept(Result result, const Make& make) {
  auto owner = std::make_shared<const Result>(std::move(result));
  record::Record record = make(*owner);
  return {std::move(owner), std::move(record)};
}

/// What a command prints of it.
Record printed(const SceneResult& r, const RecordParts& parts) {
  return headed(result_format).append(record_of(r, parts));
}
Record printed(const WheelsetResult& r, const RecordParts& parts) {
  return headed(wheelset_format).append(record_of(r, parts));
}

/// What a command keeps in a file.
Record kept_in(const std::filesystem::path& file, const SceneResult& r, const GivenScene& given) {
  return result_file(r, given, file);
}
Record kept_in(const std::filesystem::path& file, const WheelsetResult& r, const GivenScene& given) {
  return headed(wheelset_format, given, file).append(record_of(r));
}

/// Both wheels, each as the page draws one.
Record wheels_of(const WheelsetResult& r) {
  return {{"wheelset", record::numbers_of(wheelset_quantities(), false, r)},
          {"wheels", Record{{"right", record_of(r.state.right)}, {"left", record_of(r.state.left)}}}};
}

} // namespace

/// Nobody waits for the answer before.
Answers::Stop Answers::newest(const std::string& window) {
  const std::scoped_lock lock(counting_);
  if (ended_)
    throw Stopped();
  auto stop = std::make_shared<std::atomic<bool>>(false);
  if (const auto before = std::ranges::find(windows_, window, [](const auto& one) { return one.first; });
      before != windows_.end()) {
    *before->second = true;
    windows_.erase(before);
  }
  windows_.emplace_front(window, stop);
  if (windows_.size() > most_windows)
    windows_.pop_back();
  return stop;
}

SceneResult Answers::solve(const Question& question, Sequence& sequence, const Stop& stop) {
  const SceneFile scene = scenes_.scene(question);
  refuse_derivatives(scene, "this page");
  const std::scoped_lock lock(solving_);
  end_if_stopped(stop.get());
  return sequence.solve(scene, stop.get());
}

WheelsetResult Answers::solve_both(const SceneFile& scene, const Stop& stop) {
  const std::scoped_lock lock(solving_);
  end_if_stopped(stop.get());
  return solve_wheelset(scene, stop.get());
}

Record Answers::remarks_on(const SceneFile& scene) {
  const std::scoped_lock lock(solving_);
  return remarks_.of(scene, [&](const std::string& text) { return scenes_.in_plain_names(text); });
}

template <class Answer> Reply Answers::replied(const std::string& text, const Answer& answer) {
  const CollectedMessages of_profiles; // the page shows them (remarks_on()), not the terminal
  try {
    return answer(parse_question(text));
  } catch (const std::exception& error) {
    return problem(record::outcome_of(error), scenes_.in_plain_names(said_by(error)));
  }
}

Reply Answers::answer(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    const Stop stop = newest(asked.window);
    const SceneFile to_solve = scenes_.scene(asked);
    const KeptRecord found =
        to_solve.wheelset.force
            ? kept(solve_both(to_solve, stop), [](const WheelsetResult& r) { return wheels_of(r); })
            : kept(solve(asked, sequence_, stop), [](const SceneResult& r) { return record_of(r); });
    const std::string scene = scenes_.in_plain_names(scene_with_defaults(to_solve));
    Record data{{"scene_with_defaults", record::Text{scene, "the scene with every key"}},
                {"scene_values", report::scene_values(scene)},
                {"remarks", remarks_on(to_solve)}};
    data.append(found.record);
    return Reply{json_type, record::to_described_json({{"data", std::move(data)}}, not_drawn)};
  });
}

Reply Answers::needs(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    const SceneFile scene = scenes_.scene(asked);
    const bool named = std::ranges::any_of(named_files(scene), names_influence, &NamedFile::key),
               taken = !scene.solver.model || has_files(*scene.solver.model);
    return Reply{json_type, nlohmann::json{{"influence", named && taken}}.dump()};
  });
}

Reply Answers::scene(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    return Reply{text_type, scenes_.given(asked).text.toml};
  });
}

/// Solved as the command does it, from nothing.
template <class Make> KeptRecord Answers::as_by_the_command(const Question& question, const Make& make) {
  const SceneFile scene = scenes_.scene(question);
  const Stop stop = newest(question.window);
  if (scene.wheelset.force)
    return kept(solve_both(scene, stop), make);
  Sequence cold;
  return kept(solve(question, cold, stop), make);
}

KeptRecord Answers::file_of(const Question& question) {
  const GivenScene given = scenes_.given(question);
  const std::filesystem::path file = given.text.folder / "explored.h5";
  return as_by_the_command(question, [&](const auto& r) { return kept_in(file, r, given); });
}

Reply Answers::printed_as(const std::string& question, const RecordParts& parts) {
  return replied(question, [&](const Question& asked) {
    const KeptRecord answer = as_by_the_command(asked, [&](const auto& r) { return printed(r, parts); });
    return Reply{json_type, record::to_json(answer.record)};
  });
}

Reply Answers::numbers(const std::string& question) {
  return printed_as(question, {.fields = false});
}

Reply Answers::fields(const std::string& question) {
  return printed_as(question, {.fields = true});
}

Reply Answers::described(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    const KeptRecord answer =
        as_by_the_command(asked, [](const auto& r) { return printed(r, {.fields = true}); });
    const auto nothing_left_out = [](std::string_view) { return false; };
    return Reply{json_type, record::to_described_json(record::with_found(answer.record), nothing_left_out)};
  });
}

Reply Answers::names(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    auto list = nlohmann::json::array();
    for (const NamedFile& named : scenes_.names(asked))
      list.push_back({{"key", named.key},
                      {"name", named.name},
                      {"influence", names_influence(named.key)},
                      {"advice", names_profile(named.key) ? advice_on_name(named.name)
                                                          : "Correct the name, or put the file there."}});
    return Reply{json_type, nlohmann::json{{"files", list}}.dump()};
  });
}

Reply Answers::result(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    return Reply{"application/x-hdf5", record::hdf5_bytes(file_of(asked).record)};
  });
}

Reply Answers::report(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    return Reply{page_type, report::page_of_record(file_of(asked).record, "explored.h5")};
  });
}

/// Solved by the half-space: it says where the strips must lie, and how fine.
std::vector<NamedBody> Answers::named_bodies(const Question& question) {
  Question asked = question;
  for (const char* side : {"rail", "wheel"})
    asked.changes.push_back({fmt::format("{}.influence", side), std::string()});
  asked.changes.push_back({"solver.model", std::string(name_of(Model::halfspace))});
  Sequence cold;
  SceneFile scene = scenes_.scene(asked);
  const Stop stop = newest(question.window);
  const bool both = scene.wheelset.force.has_value(); // the bodies of the right wheel serve the left one too
  const SceneResult solved = both ? solve_both(scene, stop).state.right : solve(asked, cold, stop);
  if (both)
    scene = one_wheel(std::move(scene), WheelSide::right);
  std::vector<NamedBody> out;
  for (const BodyToCompute& body : bodies_of(scene, solved)) {
    const std::string toml = with_absolute_names({body.toml, body.side, scene.folder});
    constexpr std::size_t digits = 8; // enough to tell the bodies of a day
    out.push_back(
        {body.side, fmt::format("{}_{}", body.side, sha256(toml).substr(0, digits)), body.toml, toml});
  }
  return out;
}

Reply Answers::bodies(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    auto list = nlohmann::json::array();
    for (const NamedBody& body : named_bodies(asked))
      list.push_back(
          {{"side", body.side}, {"name", body.name}, {"text", scenes_.in_plain_names(body.shown)}});
    return Reply{json_type, nlohmann::json{{"bodies", list}}.dump()};
  });
}

Reply Answers::compute(const std::string& question) {
  return replied(question, [&](const Question& asked) {
    if (!computer_)
      throw InputError(no_computer);
    computer_->start(named_bodies(asked));
    return computing("");
  });
}

Reply Answers::computing(const std::string& /*question*/) {
  const Computed now = computer_ ? computer_->now() : Computed{};
  constexpr std::array stages{"idle", "running", "done", "failed", "cancelled"};
  auto changes = nlohmann::json::object();
  if (now.stage == Computed::Stage::done)
    for (const NamedBody& body : now.bodies) {
      const std::string name = body.name + ".h5";
      scenes_.hold(name, body.influence);
      changes[body.side + ".influence"] = name;
    }
  const nlohmann::json said{{"stage", stages.at(static_cast<std::size_t>(now.stage))},
                            {"what", scenes_.in_plain_names(now.what)},
                            {"share", now.share},
                            {"missing", computer_ ? computer_->missing() : no_computer},
                            {"changes", changes}};
  return {json_type, said.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

Reply Answers::cancel(const std::string& question) {
  if (computer_)
    computer_->cancel();
  return computing(question);
}

void Answers::end() {
  const std::scoped_lock lock(counting_);
  ended_ = true;
  for (const auto& [window, stop] : windows_)
    *stop = true;
}

} // namespace bem_contact::explore
