#include "bem_contact/base/message_file.hpp"

#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace bem_contact {
namespace {

/// The variable is that of a program with one thread.
class Messages : public testing::Test {
protected:
  Messages() { setenv(message_file_variable, file.file().c_str(), true); }
  ~Messages() override { unsetenv(message_file_variable); }

  TemporaryFolder folder;
  MessageFile file{folder / "messages.txt"};
};

TEST_F(Messages, ArriveOnceAndAsTheyWereTold) {
  EXPECT_TRUE(file.next().empty());
  tell(Told::error, "warning: error: progress\t1/2\nof it");
  tell_progress(12, 48);
  const std::vector<ToldMessage> told = file.next();
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].kind, Told::error);
  EXPECT_EQ(told[0].text, "warning: error: progress\t1/2 of it");
  EXPECT_EQ(told[1].kind, Told::progress);
  EXPECT_DOUBLE_EQ(told[1].share, 0.25);
  EXPECT_TRUE(file.next().empty());
  tell(Told::warning, "more");
  ASSERT_EQ(file.next().size(), 1u);
}

/// Whoever writes may be in the middle of a line, and is not always one of our programs.
TEST_F(Messages, HalfLinesWaitAndOthersArePassedOver) {
  std::ofstream out(file.file(), std::ios::app);
  out << "hello\nerror\nprogress\tx/0\nerror\thalf" << std::flush;
  std::vector<ToldMessage> told = file.next();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].share, 0);
  out << " a line\n" << std::flush;
  told = file.next();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].text, "half a line");
}

TEST(NoMessages, WithoutAFileNothingIsTold) {
  tell(Told::error, "lost");
}

} // namespace
} // namespace bem_contact
