#include "bem_contact/profile/message_sink.hpp"

#include "bem_contact/profile/messages.hpp"

#include <gmock/gmock.h>
#include <spdlog/spdlog.h>

namespace bem_contact {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A program that reads a profile twice says once what it found; of several processes one says it.
TEST(MessageSink, says_each_message_once) {
  const auto before = spdlog::default_logger();
  testing::internal::CaptureStderr();
  {
    const auto sink = install_message_sink();
    for (int k = 0; k < 3; ++k)
      say_info("folder/rail.txt: smoothed");
    sink->set_level(spdlog::level::off);
    say_warning("rail.txt: its points scatter");
    sink->set_level(spdlog::level::trace);
    sink->finish();
  }
  const std::string said = testing::internal::GetCapturedStderr();
  spdlog::set_default_logger(before);
  EXPECT_EQ(said.find("info: folder/rail.txt"), said.rfind("info: folder/rail.txt"));
  EXPECT_THAT(said, HasSubstr("3 times: rail.txt: smoothed"));
  EXPECT_THAT(said, Not(HasSubstr("scatter")));
}

} // namespace
} // namespace bem_contact
