#include "bem_contact/base/file_lock.hpp"

#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <optional>

namespace bem_contact {
namespace {

using ::testing::HasSubstr;

TEST(FileLock, OneProcessHoldsIt) {
  const TemporaryFolder folder;
  const auto file = folder / "lock";
  std::optional<LockFile> first(std::in_place, file, "Wait.");
  EXPECT_EQ(first->warning(), "");
  EXPECT_EQ(message_of([&] { LockFile(file, "Wait."); }),
            "The file '" + file.string() + "' is in use (another process writes it) Wait.");
  EXPECT_TRUE(std::filesystem::exists(file)) << "the refused one took it away";
  first.reset();
  EXPECT_FALSE(std::filesystem::exists(file));
  folder.write("lock", ""); // a killed process left it
  EXPECT_EQ(LockFile(file, "Wait.").warning(), "");
}

/// Where nothing can be locked that is said, and nothing else: no other process has the file. What was opened
/// only as a name cannot be locked, as nothing can on a file system without locks.
TEST(FileLock, SaysWhereThereAreNoLocks) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const int name = open((folder / "file").c_str(), O_PATH);
  ASSERT_GE(name, 0);
  const std::string warning = lock_file(name, folder / "file", "Wait.");
  close(name);
  EXPECT_THAT(warning, HasSubstr("cannot be locked (Bad file descriptor;"));
  EXPECT_THAT(warning, HasSubstr("do not start one"));
  EXPECT_THAT(message_of([&] { LockFile(folder / "none" / "lock", ""); }), HasSubstr("cannot be made"));
}

} // namespace
} // namespace bem_contact
