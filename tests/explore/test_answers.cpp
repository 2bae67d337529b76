#include "bem_contact/explore/answers.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace bem_contact {

namespace {

using explore::Answers;
using explore::Start;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* small = R"(rail.profile = "60E1"
wheel.profile = "S1002"
load.force = 5e4
solver.model = "halfspace"
motion = { friction = 0.3, free_rolling = false }
grid = { dx = 1.0, ds = 1.0 }
)";

json answer_of(Answers& answers, const std::string& text, const json& changes = json::object(),
               const json& files = json::object()) {
  const json question{{"text", text}, {"changes", changes}, {"files", files}, {"window", "test"}};
  return json::parse(answers.answer(question.dump()).body);
}

std::string problem_of(const json& reply) {
  return reply.contains("problem") ? reply["problem"]["message"].get<std::string>() : "";
}

double quantity_of(const json& reply, const char* name) {
  return reply.at("data").at("quantities").at(name).at("values").at(0);
}

/// Points of a rail's head with steep sides, as a file has them.
std::string rail_points() {
  std::string out;
  for (double y = -36; y <= 36; y += 0.5)
    out += std::to_string(y) + " " + std::to_string(y * y / 600 + 36 * std::pow(std::abs(y) / 36, 10)) + "\n";
  return out;
}

} // namespace

TEST(Answers, AreThoseOfTheSolver) {
  Answers answers(Start{.scene = {small}});
  const json reply = answer_of(answers, small, {{"position.lateral", 1.0}, {"load.force", 60000}});
  const SceneResult alone = Sequence().solve(
      parse_scene_file({small}, std::vector<SceneChange>{{"position.lateral", 1.0}, {"load.force", 6e4}}));
  EXPECT_NEAR(quantity_of(reply, "Fz"), 6e4, 1e-2);
  EXPECT_NEAR(quantity_of(reply, "Fy"), alone.result.totals.Fy, 1e-5 * 6e4);
  EXPECT_EQ(reply["data"]["attributes"]["certified"], 1);
  EXPECT_THAT(reply["data"]["scene_with_defaults"]["text"].get<std::string>(), HasSubstr("lateral = 1"));
}

/// A wheelset is shown with both its wheels, by the solution that the command finds.
TEST(Answers, OfAWheelsetHaveBothWheels) {
  std::string axle = small;
  axle.replace(axle.find("load.force = 5e4"), 16, "wheelset.force = 1e5\nposition.lateral = 2");
  Answers answers(Start{.scene = {axle}});
  const json reply = answer_of(answers, axle);
  ASSERT_EQ(problem_of(reply), "");
  const WheelsetResult alone = solve_wheelset(parse_scene_file({axle}));
  for (const WheelSide side : both_sides) {
    const json& wheel = reply["data"]["wheels"][std::string(name_of(side))];
    EXPECT_EQ(wheel["attributes"]["certified"], 1);
    EXPECT_EQ(wheel["quantities"]["pmax"]["values"][0], double(alone.state.solved(side).result.totals.pmax));
    EXPECT_TRUE(wheel.contains("p_n") && !wheel.contains("u_x"));
  }
  const json question{
      {"text", axle}, {"changes", json::object()}, {"files", json::object()}, {"window", "test"}};
  EXPECT_THAT(answers.report(question.dump()).body, HasSubstr("<html"));
}

/// A page in the browser loads such files where they are needed, and reads no scene itself.
TEST(Answers, SayWhetherInfluenceFilesAreNeeded) {
  const std::string folder = CONFORMAL_SOURCE_DIR "/data/influence/";
  const std::string named = std::string(small) + "rail.influence = \"" + folder +
                            "small_rail.h5\"\nwheel.influence = \"" + folder + "small_wheel.h5\"\n";
  Answers answers(Start{.scene = {named}});
  const auto needs = [&](const std::string& text, const json& changes) {
    const json question{{"text", text}, {"changes", changes}, {"files", json::object()}, {"window", "test"}};
    return json::parse(answers.needs(question.dump()).body);
  };
  EXPECT_EQ(needs(named, json::object()), json({{"influence", false}})); // its model is the half-space
  EXPECT_EQ(needs(named, {{"solver.model", "fem"}}), json({{"influence", true}}));
  EXPECT_EQ(needs(named, {{"solver.model", "auto"}}), json({{"influence", true}}));
  EXPECT_EQ(needs(small, {{"solver.model", "auto"}}), json({{"influence", false}}));
  EXPECT_TRUE(needs(named, {{"load.farce", 1}}).contains("problem"));
  EXPECT_EQ(answer_of(answers, small)["data"]["scene_values"]["attributes"]["solver.model"], "halfspace");
}

/// Programs that send a scene's files along ask which these are. None of them is there, and none is opened.
TEST(Answers, NameTheFilesOfAScene) {
  Answers answers(Start{.scene = {small}});
  const auto names = [&](const std::string& text, const json& changes = json::object()) {
    const json question{{"text", text}, {"changes", changes}, {"files", json::object()}, {"window", "test"}};
    json reply = json::parse(answers.names(question.dump()).body);
    for (json& one : reply["files"]) {
      EXPECT_THAT(one["advice"].get<std::string>(), Not(testing::IsEmpty()));
      one.erase("advice");
    }
    return reply;
  };
  EXPECT_EQ(names(small)["files"], json::array()); // standard profiles alone
  const std::string scene =
      "# not \"this.txt\"\nrail.profile = 'worn\\rail.mini#2'\nwheel.profile = \"S1002\"\nload.force = 5e4\n"
      "rail.influence = \"rail.h5\"\nwheel.influence = \"wheel.h5\"\n";
  const auto file = [](const char* key, const char* name, bool influence) {
    return json{{"key", key}, {"name", name}, {"influence", influence}};
  };
  EXPECT_THAT(names(scene)["files"],
              testing::UnorderedElementsAre(file("rail.profile", "worn\\rail.mini", false),
                                            file("rail.influence", "rail.h5", true),
                                            file("wheel.influence", "wheel.h5", true)));
  EXPECT_THAT(names(scene, {{"wheel.profile", "mine.whl"}})["files"],
              testing::Contains(file("wheel.profile", "mine.whl", false)));
  EXPECT_THAT(problem_of(names(scene, {{"load.farce", 1}})), HasSubstr("load.force"));
}

/// Errors stand beside their values, so that nobody tells them by their names.
TEST(Answers, AreDescribed) {
  Answers answers(Start{.scene = {small}});
  const json question{
      {"text", small}, {"changes", json::object()}, {"files", json::object()}, {"window", "test"}};
  const json said = json::parse(answers.described(question.dump()).body),
             plain = json::parse(answers.numbers(question.dump()).body);
  const json& pmax = said.at("quantities").at("pmax");
  EXPECT_EQ(pmax.at("values").at(0), plain.at("quantities").at("pmax"));
  EXPECT_EQ(pmax.at("errors").at(0), plain.at("quantities").at("pmax_error"));
  EXPECT_EQ(pmax.at("unit"), "MPa");
  EXPECT_EQ(said.at("attributes").at("certified"), 1);
  EXPECT_THAT(said.at("found").at("text").get<std::string>(),
              HasSubstr(plain.at("found").at(0).get<std::string>()));
  EXPECT_FALSE(said.at("quantities").contains("pmax_error"));
}

TEST(Answers, SayWhatIsWrong) {
  Answers answers(Start{.scene = {small}});
  EXPECT_THAT(problem_of(answer_of(answers, small, {{"position.latteral", 1.0}})),
              HasSubstr("position.lateral"));
  EXPECT_THAT(problem_of(answer_of(answers, small, {{"position.lateral", 500.0}})), Not(testing::IsEmpty()));
  for (const char* question :
       {"", "[]", "{", R"({"text": 3})", R"({"text": "", "changes": []})",
        R"({"text": "", "changes": {"load.force": null}})", R"({"text": "", "files": {"a": 1}})"})
    EXPECT_THAT(answers.answer(question).body, HasSubstr("cannot be read")) << question;
  EXPECT_NE(quantity_of(answer_of(answers, small), "pmax"), 0); // and answers go on
}

TEST(Answers, ReadNoOtherFiles) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "explore_files";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "named.txt") << rail_points();
  std::ofstream(folder / "secret.txt") << rail_points();
  std::ofstream(folder / "body.toml") << "[body]\nkind = \"rail\"\nprofile = \"secret.txt\"\n";
  std::string with_file = small;
  with_file.replace(with_file.find("60E1"), 4, "named.txt");
  Answers answers(Start{.scene = {with_file, "scene", folder}});
  EXPECT_EQ(problem_of(answer_of(answers, with_file)), "");
  EXPECT_EQ(problem_of(answer_of(answers, with_file, {{"rail.profile", "../explore_files/named.txt"}})), "");
  for (const char* other : {"secret.txt", "/etc/passwd", "body.toml", "named.txt/../secret.txt"})
    EXPECT_THAT(problem_of(answer_of(answers, with_file, {{"rail.profile", other}})),
                HasSubstr("is not read"))
        << other;
  for (const char* key : {"rail.influence", "motion.friction_table", "layer.table"})
    EXPECT_THAT(problem_of(answer_of(answers, with_file, {{key, "secret.txt"}})), HasSubstr("is not read"))
        << key;
  // A body file that is dropped may not lead to others.
  const json dropped{
      {"mine.toml", "[body]\nkind = \"rail\"\nprofile = \"" + (folder / "secret.txt").string() + "\"\n"}};
  EXPECT_THAT(problem_of(answer_of(answers, with_file, {{"rail.profile", "mine.toml"}}, dropped)),
              HasSubstr("is not read"));
  std::filesystem::remove_all(folder);
}

TEST(Answers, TakeProfilesThatAreDropped) {
  Answers answers(Start{.scene = {small}});
  const json changes{{"rail.profile", "mine.txt"}}, files{{"mine.txt", rail_points()}};
  const json reply = answer_of(answers, small, changes, files);
  EXPECT_EQ(problem_of(reply), "");
  EXPECT_THAT(reply["data"]["scene_with_defaults"]["text"].get<std::string>(),
              HasSubstr("profile = \"mine.txt\""));
  const std::string bad = problem_of(answer_of(answers, small, changes, {{"mine.txt", "no points\n"}}));
  EXPECT_THAT(bad, HasSubstr("mine.txt"));
  EXPECT_THAT(bad, Not(HasSubstr("bem_contact_"))); // the folder of copies is nobody's business
  // The result holds the profile, and its scene names it as the page does.
  const json question{{"text", small}, {"changes", changes}, {"files", files}};
  const std::string file = answers.result(question.dump()).body;
  EXPECT_TRUE(file.starts_with("\x89HDF"));
  EXPECT_THAT(answers.scene(question.dump()).body, HasSubstr("rail.profile = \"mine.txt\""));
}

/// The strips hold the contact, and the files name what the page names.
TEST(Answers, HaveBodyFilesForInfluenceFunctions) {
  Answers answers(Start{.scene = {small}});
  const json changes{{"rail.profile", "mine.txt"},    {"position.lateral", 2.0},      {"solver.model", "fem"},
                     {"rail.influence", "gone.h5"},   {"wheel.influence", "gone.h5"}, {"rail.smoothing", 4.0},
                     {"wheel.material.poisson", 0.25}};
  const json question{{"text", small}, {"changes", changes}, {"files", {{"mine.txt", rail_points()}}}};
  const json bodies = json::parse(answers.bodies(question.dump()).body).at("bodies");
  ASSERT_EQ(bodies.size(), 2U);
  const BodyFile rail = parse_body_file(bodies[0]["text"].get<std::string>()),
                 wheel = parse_body_file(bodies[1]["text"].get<std::string>());
  EXPECT_EQ(rail.body.kind, BodyKind::rail);
  EXPECT_EQ(rail.body.profile, "mine.txt");
  EXPECT_EQ(rail.body.reading.smoothing, 4);
  EXPECT_EQ(wheel.body.kind, BodyKind::wheel);
  EXPECT_EQ(wheel.body.profile, "S1002");
  EXPECT_EQ(wheel.material.poisson, 0.25);
  EXPECT_LE(rail.strip.station_width, 1);
  EXPECT_EQ(rail.harmonic.shortest_dx, 1);
  json plain = changes;
  plain.erase("rail.influence"), plain.erase("wheel.influence"), plain["solver.model"] = "halfspace";
  const json solved = answer_of(answers, small, plain, question["files"]);
  const json patches = solved.at("data").at("patches");
  for (const auto& [body, s] : {std::pair{&rail, "s"}, {&wheel, "wheel_s"}})
    for (const double place : patches.at(s).at("values")) {
      EXPECT_GT(place, body->strip.from + 2) << s;
      EXPECT_LT(place, body->strip.to - 2) << s;
    }
  const json other{{"text", small}, {"changes", {{"position.lateral", -2.0}}}};
  EXPECT_NE(json::parse(answers.bodies(other.dump()).body)["bodies"][0]["name"], bodies[0]["name"]);
  const json big{{"text", small}, {"changes", {{"position.wheel_radius", 500.0}}}};
  EXPECT_THAT(answers.bodies(big.dump()).body, HasSubstr("position.wheel_radius is 500 mm"));
  EXPECT_THAT(answers.compute(other.dump()).body, HasSubstr("no finite elements"));
  EXPECT_THAT(answers.computing("{}").body, HasSubstr("\"stage\":\"idle\""));
}

TEST(Answers, ANewerQuestionOfAWindowReplacesTheOneBefore) {
  Answers answers(Start{.scene = {small}});
  json slow{{"text", small}, {"changes", {{"grid.dx", 0.03}, {"grid.ds", 0.03}}}, {"window", "a"}};
  std::string first;
  std::thread asking([&] { first = answers.answer(slow.dump()).body; });
  while (first.empty()) { // until the first question is known, the second one cannot replace it
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    slow["changes"] = {{"load.force", 1e4}};
    EXPECT_EQ(problem_of(json::parse(answers.answer(slow.dump()).body)), "");
  }
  asking.join();
  EXPECT_THAT(first, HasSubstr("\"replaced\""));
  answers.end();
  EXPECT_THAT(answers.answer(slow.dump()).body, HasSubstr("\"replaced\""));
}

} // namespace bem_contact
