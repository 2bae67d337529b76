#include "bem_contact/base/input_file.hpp"

#include "message.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <thread>

namespace bem_contact {
namespace {

using testing::HasSubstr;

TEST(InputFile, ComesBackWhole) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 300000u}) {
    std::string text(size, 'x');
    for (std::size_t i = 0; i < size; i += 7)
      text[i] = static_cast<char>(i % 251);
    EXPECT_EQ(read_text_file(folder.write("a", text), "file"), text) << size;
  }
}

TEST(InputFile, APipeIsReadToItsEnd) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "kind = 1\n"; });
  EXPECT_EQ(read_text_file(pipe, "file"), "kind = 1\n");
  writer.join();
}

TEST(InputFile, TooLargeIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.write("a", std::string(1001, ' '));
  EXPECT_EQ(read_text_file(file, "file", 1001).size(), 1001u);
  EXPECT_THAT(message_of([&] { read_text_file(file, "file", 1000); }), HasSubstr("more than 1000 bytes"));
  const auto pipe = folder / "pipe"; // whose size only reading tells
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << std::string(1001, ' '); });
  EXPECT_THAT(message_of([&] { read_text_file(pipe, "file", 1000); }), HasSubstr("more than 1000 bytes"));
  writer.join();
}

TEST(InputFile, WhatNeedNotEndIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of([&] { read_text_file(folder / "none", "file"); }), HasSubstr("no such file"));
  EXPECT_THAT(message_of([&] { read_text_file(folder / "", "file"); }), HasSubstr("folder"));
  const auto zeros = folder / "zeros"; // a node of our own, like /dev/zero
  if (mknod(zeros.c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0)
    GTEST_SKIP() << "only root can make a device";
  EXPECT_THAT(message_of([&] { read_text_file(zeros, "file"); }), HasSubstr("device"));
}

} // namespace
} // namespace bem_contact
