#include "bem_contact/base/child_process.hpp"

#include "bem_contact/base/told_program.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

using namespace bem_contact;

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> lines_of(ChildProcess& child) {
  std::vector<std::string> out;
  while (const auto line = child.next_line())
    out.push_back(*line);
  return out;
}

std::string printed_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What is said comes back, what is printed is kept, and of an environment one value alone is changed.
TEST(ChildProcess, AnotherProgramSaysPrintsAndEnds) {
  const TemporaryFolder folder;
  set_variable("CONFORMAL_TEST_CHILD", "before");
  ChildProcess child(
      folder / "text",
      {.words = {"sh", "-c",
                 "echo printed; printf 'one\\r\\ntwo words\\n%s' \"$CONFORMAL_TEST_CHILD\" >&2; exit 7"},
       .variables = {{"CONFORMAL_TEST_CHILD", "with spaces = and more"}}});
  EXPECT_EQ(child.why_not_started(), "");
  EXPECT_THAT(lines_of(child), ElementsAre("one", "two words", "with spaces = and more"));
  std::string how;
  EXPECT_EQ(child.wait(how), 7);
  EXPECT_EQ(printed_in(folder / "text"), "printed\n");
  EXPECT_STREQ(std::getenv("CONFORMAL_TEST_CHILD"), "before");
}

TEST(ChildProcess, WorkOfThisProgramIsDoneInACopy) {
  const TemporaryFolder folder;
  int here = 0;
  ChildProcess child(
      folder / "text",
      {.words = {"none"}, .variables = {{"CONFORMAL_TEST_CHILD", "in the copy"}}, .here = [&here] {
         here = 1;
         std::cout << std::getenv("CONFORMAL_TEST_CHILD");
         std::cerr << "said";
         return 3;
       }});
  EXPECT_THAT(lines_of(child), ElementsAre("said"));
  std::string how;
  EXPECT_EQ(child.wait(how), 3);
  EXPECT_EQ(printed_in(folder / "text"), "in the copy");
  EXPECT_EQ(here, 0);
}

TEST(ChildProcess, AProgramThatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  ChildProcess child(folder / "text", {.words = {"conformal_no_such_program"}});
  EXPECT_THAT(child.why_not_started(), HasSubstr("No such file"));
  EXPECT_TRUE(lines_of(child).empty());
  std::string how;
  EXPECT_EQ(child.wait(how), -1);
  EXPECT_THAT(how, HasSubstr("it cannot be started: No such file"));
  EXPECT_THAT(run_told_program({"conformal_no_such_program"}, folder.path()),
              HasSubstr("conformal_no_such_program: it cannot be started: No such file"));
}

TEST(ChildProcess, OneThatIsStoppedEndsWithItsObject) {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  int looked = 0;
  {
    ChildProcess child(folder / "text", {.words = {"sleep", "60"}});
    EXPECT_EQ(child.next_line(&stop, [&] { stop = ++looked == 2; }), std::nullopt);
  }
  EXPECT_EQ(looked, 2);
}

TEST(ChildProcess, ASignalIsNoExitCode) {
  const TemporaryFolder folder;
  ChildProcess child(folder / "text", {.words = {"sh", "-c", "kill -9 $$"}});
  std::string how;
  EXPECT_EQ(child.wait(how), -1);
  EXPECT_THAT(how, HasSubstr("signal 9"));
}

} // namespace
