// Whoever answers the portions of a task, the answers are the same, and what goes wrong is said in the same
// words.

#include "bem_contact/base/error.hpp"
#include "bem_contact/task/packing.hpp"
#include "bem_contact/task/tasks.hpp"

#include <csignal>
#include <gmock/gmock.h>

namespace bem_contact::task {

namespace {

constexpr const char* patch = R"(kind = "patch"
load.force = 5e3
motion.friction = 0.3
grid = { dx = 0.8, ds = 0.8, mx = 14, ms = 14 }
gap = { a = 1e-3, b = 1e-3 }
)";

HeldContact held() {
  return {.model = Model::halfspace, .dx = 0.8, .ds = 0.8};
}

std::vector<Creepages> some_points(double largest) {
  std::vector<Creepages> out;
  for (int i = 0; i < 9; ++i)
    out.push_back({largest * (i - 4) / 4.0, 2e-4, 0});
  return out;
}

std::string said_by_engine(const Engine& engine, const std::string& scene) {
  try {
    creep_points_by(engine, {scene})(held(), some_points(1e-3));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string die(const std::string&, const std::string&, const std::atomic<bool>*) {
  std::raise(SIGKILL);
  return "";
}

/// What a portion is asked comes back, behind what is common.
std::string echo(const std::string& common, const std::string& portion, const std::atomic<bool>*) {
  return common + portion;
}

} // namespace

TEST(Engines, FindTheSame) {
  const std::vector<SceneChange> changes{{"motion.friction", 0.25}};
  const std::vector<Creepages> points = some_points(1e-3);
  const auto alone = creep_points_by(here(), {patch}, changes)(held(), points),
             shared = creep_points_by(in_children(2), {patch}, changes)(held(), points);
  const auto first = creep_points(parse_scene_file({patch}, changes), held(), std::span(points).first(4));
  ASSERT_EQ(alone.size(), points.size());
  ASSERT_EQ(shared.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(pack(shared[i]), pack(alone[i])) << i; // bit by bit
    if (i < first.size()) {
      EXPECT_EQ(double(alone[i].forces[0]), double(first[i].forces[0])) << "portions are chunks";
    }
    EXPECT_TRUE(alone[i].certified) << i;
  }
}

TEST(Engines, SayWhatIsWrongInTheSameWords) {
  const std::string wrong = std::string(patch) + "load.farce = 3\n";
  EXPECT_THAT(said_by_engine(here(), wrong), testing::HasSubstr("load.force"));
  EXPECT_EQ(said_by_engine(in_children(2), wrong), said_by_engine(here(), wrong));
}

TEST(Engines, NameThePortionWhoseProcessDied) {
  const Task deadly{"die", die};
  try {
    in_children(1)({.task = deadly,
                    .common = {},
                    .asked = {"one"},
                    .name = [](std::size_t) { return "The first portion"; },
                    .take = [](std::size_t, const std::string&) { FAIL() << "it has no answer"; }});
    FAIL() << "it is not said";
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr(
                    "The first portion has no result (the process that solved it was ended by signal 9"));
  }
}

TEST(Engines, HandOverBytesAsTheyAre) {
  const Task task{"echo", echo};
  const std::string bytes("\0\xff\r\n", 4);
  std::vector<std::string> found(3);
  in_children(2)({.task = task,
                  .common = "c",
                  .asked = {bytes, "", std::string(70000, 'x')},
                  .name = [](std::size_t) { return ""; },
                  .take = [&](std::size_t i, const std::string& answer) { found[i] = answer; }});
  EXPECT_THAT(found, testing::ElementsAre("c" + bytes, "c", "c" + std::string(70000, 'x')));
}

TEST(Packing, KeepsEveryBit) {
  const double tiny = 4.9e-324, nothing = std::nan("");
  const table::PointValues values{{0.1, -0.0, tiny, 1e308, 1.0 / 3, 2}, {nothing, INFINITY}};
  const auto back = unpack<table::PointValues>(pack(values));
  EXPECT_EQ(back.values, values.values);
  EXPECT_TRUE(std::signbit(back.values[1]));
  EXPECT_TRUE(std::isnan(back.element_errors[0]));
  EXPECT_EQ(back.element_errors[1], INFINITY);
  EXPECT_EQ(unpack<std::optional<double>>(pack(std::optional<double>())), std::nullopt);
  for (const SchemaValue& value : {SchemaValue(2.0), SchemaValue(std::int64_t(2)), SchemaValue(true),
                                   SchemaValue(std::string("2")), SchemaValue(std::vector<double>{1, 2.5})})
    EXPECT_EQ(unpack<SceneChange>(pack(SceneChange{"key", value})).value, value);
  const SceneText scene = unpack<SceneText>(pack(SceneText("a = 1", "s.toml", "/folder")));
  EXPECT_EQ(scene.toml + scene.source + scene.folder.string(), "a = 1s.toml/folder");
}

TEST(Tasks, HaveNames) {
  EXPECT_STREQ(task_named("creep points").name, "creep points");
  EXPECT_THROW(task_named("creep"), Error);
}

} // namespace bem_contact::task
