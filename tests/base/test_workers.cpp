#include "bem_contact/base/workers.hpp"

#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <map>
#include <thread>

using namespace bem_contact;

namespace {

TEST(Workers, EndWithTheirCodesInAnyOrder) {
  Workers workers;
  for (const int number : {3, 5, 40})
    workers.start(static_cast<std::size_t>(number), [number] { return 2 * number; });
  EXPECT_EQ(workers.size(), 3U);
  std::map<std::size_t, int> codes;
  while (workers.size() > 0) {
    const EndOfWork end = workers.wait();
    codes[end.number] = end.code;
  }
  EXPECT_EQ(codes, (std::map<std::size_t, int>{{3, 6}, {5, 10}, {40, 80}}));
}

TEST(Workers, OneThatDiesTakesNobodyWithIt) {
  Workers workers;
  workers.start(1, [] { return std::raise(SIGKILL); });
  const EndOfWork end = workers.wait();
  EXPECT_EQ(end.code, -1);
  EXPECT_THAT(end.how, ::testing::HasSubstr("signal 9"));
}

/// Above all a lock, which must end with its owner.
TEST(Workers, HaveNothingOpenOfTheirParents) {
  const TemporaryFolder folder;
  std::ofstream open(folder / "file");
  Workers workers;
  workers.start(1, [] {
    int others = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
      others += std::stoi(entry.path().filename().string()) > 2;
    return others; // the folder that is listed, and no more
  });
  EXPECT_EQ(workers.wait().code, 1);
}

/// A child that is killed leaves its folder behind, and its parent's goes with all that is in it.
TEST(Workers, MakeTheirTemporaryFoldersWhereTheyAreTold) {
  const TemporaryFolder folder;
  Workers workers(folder.path());
  workers.start(1, [] {
    const TemporaryFolder own;
    return std::raise(SIGKILL);
  });
  EXPECT_EQ(workers.wait().code, -1);
  const auto left = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(left), end(left)), 1);
}

TEST(Workers, EndWhenNobodyWaits) {
  const TemporaryFolder folder;
  {
    Workers workers;
    workers.start(1, [&] {
      std::this_thread::sleep_for(std::chrono::seconds(20));
      folder.write("done", "");
      return 0;
    });
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "done"));
}

} // namespace
