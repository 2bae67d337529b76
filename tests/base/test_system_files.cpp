#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/system/files.hpp"

#include "tests/base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>

using namespace bem_contact;
using system::OpenFor;

namespace {

/// An open file that ends with its object.
struct Open {
  int file;
  ~Open() { system::close_file(file); }
};

TEST(SystemFiles, WhatIsWrittenComesBackAndIsCutOff) {
  const TemporaryFolder folder;
  const auto name = folder / "with space \u00e4.bin";
  const Open open{system::open_file(name, OpenFor::changing)};
  ASSERT_GE(open.file, 0);
  EXPECT_TRUE(system::write_all(open.file, "one\r\ntwo"));
  EXPECT_TRUE(system::set_size(open.file, 5));
  EXPECT_TRUE(system::write_all(open.file, "three")) << "at the new end";
  EXPECT_EQ(text_of(name), "one\r\nthree");
  std::array<char, 3> begin{};
  EXPECT_TRUE(system::read_begin(open.file, begin));
  EXPECT_EQ(std::string(begin.data(), 3), "one");
  std::array<char, 100> more{};
  EXPECT_FALSE(system::read_begin(open.file, more)) << "there are fewer bytes";
  EXPECT_TRUE(system::put_on_disk(name));
}

TEST(SystemFiles, RoomIsTakenBehindWhatIsThere) {
  const TemporaryFolder folder;
  const auto name = folder / "file";
  const Open open{system::open_file(name, OpenFor::changing)};
  EXPECT_TRUE(system::write_all(open.file, "abc"));
  EXPECT_TRUE(system::reserve(open.file, 3, 4096));
  EXPECT_GE(std::filesystem::file_size(name), 4099U);
  EXPECT_EQ(text_of(name).substr(0, 3), "abc");
}

TEST(SystemFiles, WhatIsOpenForAppendingMustBeThere) {
  const TemporaryFolder folder;
  EXPECT_LT(system::open_file(folder / "none", OpenFor::appending), 0);
  EXPECT_LT(system::open_file(folder / "none", OpenFor::reading), 0);
  folder.write("list", "a\n");
  {
    const Open open{system::open_file(folder / "list", OpenFor::appending)};
    EXPECT_TRUE(system::write_all(open.file, "b\n"));
  }
  EXPECT_EQ(text_of(folder / "list"), "a\nb\n");
}

TEST(SystemFiles, ALockIsForOneAndEndsWithItsFile) {
  const TemporaryFolder folder;
  const auto name = folder / "lock";
  const int first = system::open_file(name, OpenFor::locking);
  EXPECT_TRUE(system::is_empty_file(first));
  EXPECT_TRUE(system::is_named(first, name));
  EXPECT_EQ(system::lock(first), system::Locked::here);
  {
    const Open second{system::open_file(name, OpenFor::locking)};
    EXPECT_EQ(system::lock(second.file), system::Locked::elsewhere);
  }
  system::remove_locked(first, name);
  EXPECT_FALSE(std::filesystem::exists(name));
  const Open third{system::open_file(name, OpenFor::locking)};
  EXPECT_EQ(system::lock(third.file), system::Locked::here);
  EXPECT_TRUE(system::write_all(third.file, "x"));
  EXPECT_FALSE(system::is_empty_file(third.file));
}

TEST(SystemFiles, APatternNamesWhatIsThere) {
  const TemporaryFolder folder;
  for (const char* name : {"b 1.whl", "a.whl", "a.rail"})
    folder.write(name, "");
  EXPECT_EQ(system::files_like((folder / "*.whl").string()),
            (std::vector{(folder / "a.whl").string(), (folder / "b 1.whl").string()}));
  EXPECT_TRUE(system::files_like((folder / "*.none").string()).empty());
}

TEST(SystemFiles, ThisProcessRunsAndMayWriteHere) {
  const TemporaryFolder folder;
  EXPECT_TRUE(system::is_running(system::this_process()));
  EXPECT_TRUE(system::may_write_into(folder.path()));
  EXPECT_FALSE(system::may_write(folder / "none"));
  EXPECT_FALSE(system::is_standard_output(folder / "none"));
  EXPECT_TRUE(std::filesystem::is_regular_file(this_program()));
}

TEST(Programs, EndWithTheirCode) {
  std::string why = "?";
  EXPECT_TRUE(run_and_wait({"true"}, why));
  EXPECT_EQ(why, "");
  EXPECT_FALSE(run_and_wait({"false"}, why));
  EXPECT_EQ(why, "") << "it could be started";
  EXPECT_FALSE(run_and_wait({"no such program"}, why));
  EXPECT_NE(why, "");
  set_variable("CONFORMAL_TEST_OF_VARIABLES", "two words");
  EXPECT_TRUE(run_and_wait({"sh", "-c", "test \"$CONFORMAL_TEST_OF_VARIABLES\" = 'two words'"}, why));
}

} // namespace
