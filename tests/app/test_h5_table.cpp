#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <hdf5.h>
#include <set>
#include <string>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

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

TEST(H5Reader, ReadsWhatWasWrittenRunByRun) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.h5";
  {
    H5Writer writer(file);
    writer.add_line("group/x", 5,
                    {.unit = "mm", .description = "a line", .role = "swept", .choices = {"a", "b c"}});
    writer.add_line("none", 0, {.unit = "1", .description = "no number"});
    const std::vector<double> first{1, 2}, last{3, 4, 5};
    writer.put("group/x", first);
    writer.put("group/x", last);
    H5Table more;
    more.attributes["cases/000007/reason"] = std::string("why");
    more.attributes["cases/000007/right/model"] = std::string("fem");
    more.datasets["cases/000007/p"] = H5Dataset::line({6, 7}, "MPa", "pressure");
    more.datasets["count"] = H5Dataset::single(3, "1", "how many");
    writer.add(more);
    writer.finish();
  }
  EXPECT_EQ(read_h5(file).datasets.at("group/x").values, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(read_h5(file).datasets.at("group/x").unit, "mm");
  EXPECT_EQ(read_h5(file).datasets.at("group/x").role, "swept");
  EXPECT_EQ(read_h5(file).datasets.at("group/x").choices, (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(read_h5(file).datasets.at("none").role, "");
  const H5Reader reader(file);
  EXPECT_EQ(reader.line("group/x", 1, 3), (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(reader.size("group/x"), 5U);
  EXPECT_EQ(reader.size("none") + reader.size("group/y") + reader.size("other/x"), 0U);
  EXPECT_EQ(reader.number("count"), 3);
  EXPECT_TRUE(std::isnan(reader.number("group/x")) && std::isnan(reader.number("absent")));
  EXPECT_EQ(reader.members("cases"), std::set<std::string>{"000007"});
  EXPECT_EQ(reader.text("cases/000007", "reason"), "why");
  EXPECT_EQ(reader.text("cases/000008", "reason"), "");
  const H5Table group = reader.group("cases/000007");
  EXPECT_EQ(text_attribute(group, "reason"), "why");
  EXPECT_EQ(text_attribute(group, "right/model"), "fem");
  EXPECT_EQ(group.datasets.at("p").values, (std::vector<double>{6, 7}));
  EXPECT_TRUE(reader.group("cases/000008").attributes.empty());
  EXPECT_THROW(reader.line("group/x", 3, 3), InputError);
  EXPECT_THROW(reader.line("cases", 0, 1), InputError);
  EXPECT_THROW(reader.require("group/x", 4), InputError);
  EXPECT_THROW(reader.require("none", 1), InputError);
  EXPECT_NO_THROW(reader.require("none", 0));
}

/// A long line is deflated chunk by chunk, each with a checksum; reading some rows looks at their chunks
/// alone.
TEST(H5Writer, DeflatesLongLines) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.h5";
  const std::size_t size = 3 * rows_of_a_chunk + 7;
  std::vector<double> values(size);
  for (std::size_t i = 0; i < size; ++i)
    values[i] = 1e5 * std::sin(1e-3 * double(i / 10));
  {
    H5Writer writer(file);
    writer.add_line("x", size, {.unit = "N", .description = "a force"});
    for (std::size_t first = 0; first < size; first += 1000)
      writer.put("x", std::span(values).subspan(first, std::min<std::size_t>(1000, size - first)));
    writer.finish();
  }
  EXPECT_LT(std::filesystem::file_size(file), size * sizeof(double) / 4);
  EXPECT_EQ(read_h5(file).datasets.at("x").values, values);
  EXPECT_TRUE(read_h5(file).checksums);
  const std::string whole = text_of(file);
  for (std::size_t place = whole.size() / 4; place < whole.size(); place += whole.size() / 50 + 1) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    std::ofstream(file, std::ios::binary) << damaged;
    std::vector<double> found;
    try {
      found = H5Reader(file).line("x", 0, size);
    } catch (const InputError&) {
      continue;
    }
    EXPECT_EQ(found, values) << "a changed bit was read";
  }
}

TEST(H5Writer, RefusesALineThatIsNotFull) {
  const TemporaryFolder folder;
  H5Writer writer(folder.path() / "out.h5");
  const std::vector<double> three{1, 2, 3};
  writer.add_line("x", 4, {.unit = "1", .description = "four"});
  writer.put("x", three);
  EXPECT_THAT(fault_of([&] { writer.put("x", three); }), testing::HasSubstr("has not so many numbers"));
  EXPECT_THAT(fault_of([&] { writer.finish(); }), testing::HasSubstr("are missing"));
}

/// What was reserved so that a full disk is an error is given back.
TEST(H5Writer, ASmallFileIsSmall) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.h5";
  H5Writer writer(file);
  for (int i = 0; i < 10; ++i) {
    H5Table table;
    table.datasets[std::to_string(i)] = H5Dataset::line({1, 2}, "mm", "some");
    writer.add(table);
  }
  writer.finish();
  EXPECT_LT(std::filesystem::file_size(file), 32'000U);
  EXPECT_EQ(read_h5(file).datasets.size(), 10U);
}

/// A group that lies in another file is not there: that file may be a pipe, or one that others may not read.
TEST(H5Reader, FollowsNoLink) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.h5", other = folder.path() / "other.h5";
  H5Table table;
  table.attributes["cases/000000/reason"] = std::string("why");
  write_h5(other, table);
  H5Writer(file).finish();
  {
    const H5Handle h5(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    ASSERT_GE(H5Lcreate_external(other.c_str(), "cases", h5, "cases", H5P_DEFAULT, H5P_DEFAULT), 0);
    ASSERT_GE(H5Lcreate_soft("/cases", h5, "soft", H5P_DEFAULT, H5P_DEFAULT), 0);
  }
  const H5Reader reader(file);
  for (const char* group : {"cases", "soft"}) {
    EXPECT_TRUE(reader.members(group).empty());
    EXPECT_TRUE(reader.group(std::string(group) + "/000000").attributes.empty());
  }
}

TEST(H5Writer, TheSameNumbersAreTheSameBytes) {
  const TemporaryFolder folder;
  const auto written = [&](const char* name) {
    const auto file = folder.path() / name;
    H5Writer writer(file);
    H5Table table;
    table.checksums = true;
    table.datasets["a/b"] = H5Dataset::line({1, 2}, "mm", "some");
    table.attributes["c/d/e"] = 1.0;
    table.texts["f/g"] = {"text", "words"};
    writer.add(table);
    writer.finish();
    return text_of(file);
  };
  const std::string first = written("a.h5");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // HDF5 would write seconds
  EXPECT_EQ(first, written("b.h5"));
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
