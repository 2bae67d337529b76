#include "bem_contact/base/error.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/explore/answers.hpp"
#include "bem_contact/explore/computer.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace bem_contact {

namespace {

using explore::Computed;
using explore::Computer;
using explore::NamedBody;
using nlohmann::json;
using testing::HasSubstr;

/// Programs of our own in the place of mesh_body and fem_influence.
class Computers : public testing::Test {
protected:
  void SetUp() override {
    write("mesh_body", "echo mesh >> $CALLS\ntouch \"$3\"\n");
    setenv("CALLS", (folder_ / "calls").c_str(), 1);
    setenv("CONFORMAL_BIN", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("CONFORMAL_BIN"); }

  void write(const std::string& name, const std::string& lines) const {
    const auto file = folder_.write(name, "#!/bin/sh\n" + lines);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  static Computed wait_for(const Computer& computer, const auto& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition(computer.now()) && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return computer.now();
  }
  static Computed end_of(const Computer& computer) {
    return wait_for(computer, [](const Computed& now) { return now.stage != Computed::Stage::running; });
  }
  std::string calls() const {
    std::ostringstream out;
    out << std::ifstream(folder_ / "calls").rdbuf();
    return out.str();
  }

  TemporaryFolder folder_;
  std::vector<NamedBody> bodies_{{.side = "rail", .name = "rail_1", .shown = "", .toml = "a rail"},
                                 {.side = "wheel", .name = "wheel_1", .shown = "", .toml = "a wheel"}};
};

TEST_F(Computers, TellHowFarTheyAreAndKeepWhatIsThere) {
  write("fem_influence",
        "echo fem >> $CALLS\necho 'info: a word' >&2\nprintf 'progress\\t3/4\\n' >> $BEM_CONTACT_MESSAGES\n"
        "while [ ! -e \"$CALLS.go\" ]; do sleep 0.02; done\ncp \"$1\" \"$4\"\n");
  const std::unique_ptr<Computer> computer = explore::program_computer();
  EXPECT_EQ(computer->missing(), "");
  computer->start(bodies_);
  const Computed half = wait_for(*computer, [](const Computed& now) { return now.share > 0.3; });
  EXPECT_EQ(half.share, 0.375); // three quarters of the first of two
  EXPECT_EQ(half.what, "influence functions of the rail");
  EXPECT_THROW(computer->start(bodies_), InputError);
  std::ofstream(folder_ / "calls.go") << "x";
  const Computed done = end_of(*computer);
  ASSERT_EQ(done.stage, Computed::Stage::done) << done.what;
  std::ostringstream text;
  text << std::ifstream(done.bodies.at(1).influence).rdbuf();
  EXPECT_EQ(text.str(), "a wheel");
  computer->start(bodies_);
  EXPECT_EQ(end_of(*computer).stage, Computed::Stage::done);
  EXPECT_EQ(calls(), "mesh\nfem\nmesh\nfem\n");
}

TEST_F(Computers, EndWithWhoeverHasStartedThem) {
  write("fem_influence", "echo $$ > $CALLS.pid\nexec sleep 600\n");
  const auto process = [&] {
    pid_t out = 0;
    std::ifstream(folder_ / "calls.pid") >> out;
    return out;
  };
  const auto started = [&](Computer& computer) {
    computer.start(bodies_);
    wait_for(computer, [&](const Computed&) { return process() > 0; });
    return process();
  };
  std::unique_ptr<Computer> computer = explore::program_computer();
  const pid_t first = started(*computer);
  ASSERT_GT(first, 0);
  computer->cancel();
  EXPECT_EQ(end_of(*computer).stage, Computed::Stage::cancelled);
  EXPECT_NE(kill(first, 0), 0);
  std::filesystem::remove(folder_ / "calls.pid");
  const pid_t second = started(*computer);
  ASSERT_GT(second, 0);
  computer.reset();
  EXPECT_NE(kill(second, 0), 0);
}

TEST_F(Computers, AFailureIsAMessage) {
  write("fem_influence", "printf 'error\\tThere is no room (the disk is full) Make some.\\n' >> "
                         "$BEM_CONTACT_MESSAGES\nexit 1\n");
  const std::unique_ptr<Computer> computer = explore::program_computer();
  computer->start(bodies_);
  const Computed end = end_of(*computer);
  EXPECT_EQ(end.stage, Computed::Stage::failed);
  EXPECT_THAT(end.what, HasSubstr("fem_influence: There is no room (the disk is full)"));
}

/// What the page hears, and that a scene may then name the files.
TEST_F(Computers, AnswersTakeTheirFiles) {
  write("fem_influence", "case $1 in *rail*) side=rail;; *) side=wheel;; esac\nexec cp " CONFORMAL_SOURCE_DIR
                         "/data/influence/small_$side.h5 \"$4\"\n");
  const std::string text =
      "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 1e5\nposition.lateral = 6.6\n"
      "solver.model = \"halfspace\"\nmotion = { friction = 0.3, free_rolling = false }\n"
      "grid = { dx = 1.0, ds = 1.0 }\n";
  const std::unique_ptr<Computer> computer = explore::program_computer();
  explore::Answers answers({.scene = {text}}, computer.get());
  json question{{"text", text}};
  EXPECT_EQ(json::parse(answers.compute(question.dump()).body).at("stage"), "running");
  ASSERT_EQ(end_of(*computer).stage, Computed::Stage::done);
  const json state = json::parse(answers.computing("{}").body);
  EXPECT_EQ(state.at("missing"), "");
  question["changes"] = state.at("changes");
  question["changes"]["solver.model"] = "fem";
  const json reply = json::parse(answers.answer(question.dump()).body);
  ASSERT_TRUE(reply.contains("data")) << reply.dump();
  EXPECT_EQ(reply["data"]["attributes"]["model"], "fem");
  const std::string scene = answers.scene(question.dump()).body;
  EXPECT_THAT(scene, HasSubstr(state["changes"]["rail.influence"].get<std::string>()));
}

TEST_F(Computers, AreMissed) {
  const std::unique_ptr<Computer> computer = explore::program_computer();
  if (std::filesystem::exists(std::filesystem::read_symlink("/proc/self/exe").parent_path() /
                              "fem_influence"))
    GTEST_SKIP() << "the program is there";
  EXPECT_THAT(computer->missing(), HasSubstr("the program fem_influence is neither"));
  EXPECT_THROW(computer->start(bodies_), InputError);
}

} // namespace

} // namespace bem_contact
