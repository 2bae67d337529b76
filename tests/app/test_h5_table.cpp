#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace bem_contact;

TEST(H5Table, ComesBackAsItWent) {
  const auto file =
      std::filesystem::path(::testing::TempDir()) / ("table_" + std::to_string(getpid()) + ".h5");
  H5Table table;
  table.datasets["a/b"] = {{2, 3}, {1, 2, 3, 4, 5, 6}, "mm", "six numbers"};
  table.datasets["empty"] = {{0}, {}, "1", "none"};
  table.attributes["text"] = std::string("h\u00e9");
  table.attributes["a/number"] = 0.1;
  table.attributes["c/only_a_group"] = 2.0;
  table.datasets["one"] = {{}, {7}, "N", "a single number"};
  table.texts["scene"] = {std::string(200'000, 'a') + "h\u00e9\n", "longer than an attribute may be"};
  table.texts["a/nothing"] = {"", "an empty text"};
  write_h5(file, table);
  const H5Table back = read_h5(file);
  EXPECT_EQ(back.attributes, table.attributes);
  EXPECT_EQ(back.datasets.at("a/b").values, table.datasets["a/b"].values);
  EXPECT_EQ(back.datasets.at("a/b").shape, table.datasets["a/b"].shape);
  EXPECT_EQ(back.datasets.at("a/b").unit, "mm");
  EXPECT_TRUE(back.datasets.at("empty").values.empty());
  EXPECT_TRUE(back.datasets.at("one").shape.empty());
  EXPECT_EQ(back.datasets.at("one").values, std::vector<double>{7});
  EXPECT_EQ(back.texts, table.texts);
  EXPECT_TRUE(read_h5_top(file).texts.contains("scene"));
  EXPECT_FALSE(read_h5_top(file).datasets.contains("a/b"));
  EXPECT_TRUE(read_h5_top(file, "a").datasets.contains("a/b"));
  table.datasets["a/b"].shape = {4};
  EXPECT_THROW(write_h5(file, table), Error);
  EXPECT_EQ(read_h5(file).datasets.size(), 3u); // the old file is still whole
  std::filesystem::remove(file);
}

/// Tables of 80 kB with 20 datasets, until the limit on the size of files, met as a full disk is. A process
/// of its own: what is tested is also that it can end in order.
[[noreturn]] void write_beyond(std::size_t bytes, const std::filesystem::path& file) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{bytes, RLIM_INFINITY};
  setrlimit(RLIMIT_FSIZE, &small);
  try {
    H5Writer writer(file);
    for (int table = 0; table < 100; ++table) {
      H5Table next;
      for (int set = 0; set < 20; ++set)
        next.datasets[std::to_string(table) + "/" + std::to_string(set)] = {
            {500}, std::vector<double>(500, 1.0), "mm", "as many as fit"};
      writer.add(next);
    }
    writer.finish();
  } catch (const InputError& error) {
    std::exit(5); // the input is right
  } catch (const Error& error) {
    std::fputs(error.what(), stderr);
    std::exit(std::filesystem::exists(file) ? 4 : 3);
  }
  std::exit(0);
}

TEST(H5Writer, AFullDiskIsAnErrorAndTheProcessEndsInOrder) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / ("full_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  for (const std::size_t bytes : {300'000u, 1'000'001u, 3'333'333u})
    EXPECT_EXIT(write_beyond(bytes, folder / "out.h5"), ::testing::ExitedWithCode(3),
                "out.h5' cannot be written");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_EXIT(write_beyond(100'000'000, folder / "out.h5"), ::testing::ExitedWithCode(0), "");
  EXPECT_EQ(read_h5(folder / "out.h5").datasets.size(), 2000u);
  EXPECT_LT(std::filesystem::file_size(folder / "out.h5"), 12'000'000u); // what was reserved is given back
  std::filesystem::remove_all(folder);
}

TEST(H5Writer, KeepsThePermissionsOfTheFileThatItReplaces) {
  const TemporaryFolder folder;
  const auto file = folder.write("out.h5", "old");
  const auto own = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(file, own);
  H5Writer(file).finish();
  EXPECT_TRUE(read_h5(file).datasets.empty());
  EXPECT_EQ(std::filesystem::status(file).permissions(), own);
}

TEST(H5Writer, LeavesNothingWhereTheFileCannotGetItsName) {
  const TemporaryFolder folder;
  {
    H5Writer writer(folder / "out.h5");
    folder.write("out.h5/taken", "a folder took the name");
    EXPECT_THAT(fault_of([&] { writer.finish(); }), testing::HasSubstr("out.h5' cannot be written"));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

/// One file may be open at a time, and the writer needs two. A process of its own keeps that limit.
[[noreturn]] void write_with_one_open_file(const std::filesystem::path& file) {
  const int first = dup(STDIN_FILENO); // the lowest that is free
  close(first);
  const rlimit one{static_cast<rlim_t>(first) + 1, static_cast<rlim_t>(first) + 1};
  if (setrlimit(RLIMIT_NOFILE, &one) != 0)
    std::exit(6);
  const std::string said = fault_of([&] { H5Writer writer(file); });
  std::fputs(said.c_str(), stderr);
  std::exit(0);
}

TEST(H5Writer, LeavesNothingWhereItCannotOpenItsFile) {
  const TemporaryFolder folder;
  EXPECT_EXIT(write_with_one_open_file(folder / "out.h5"), ::testing::ExitedWithCode(0),
              "out.h5' cannot be written .it cannot be created");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
