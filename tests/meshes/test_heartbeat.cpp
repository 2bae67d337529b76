#include "meshes/heartbeat.hpp"

#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <thread>

namespace {

using namespace bem_contact::meshes;
using namespace std::chrono_literals;

TEST(Heartbeat, ALongStepSaysThatItRuns) {
  std::ostringstream out;
  {
    const Heartbeat heartbeat("meshing a rail", 20ms, out);
    std::this_thread::sleep_for(1s);
  }
  EXPECT_THAT(out.str(), ::testing::StartsWith("meshing a rail: 0 s so far\n"));
}

TEST(Heartbeat, AShortStepSaysNothing) {
  std::ostringstream out;
  { const Heartbeat heartbeat("meshing a rail", 1h, out); }
  EXPECT_EQ(out.str(), "");
}

} // namespace
