#pragma once

#include "bem_contact/app/run_program.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <wordexp.h>

namespace bem_contact {

struct Outcome {
  int code = -1;
  std::string out, err;
};

/// A folder of its own for each test. The program runs in the test's process: a start takes 40 ms, and 140 ms
/// under sanitizers. tests/hostile starts it as a user does.
class ProgramTest : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("bem_contact_") + std::to_string(getpid()) + "_" + info->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  Outcome run(const std::string& arguments) const {
    wordexp_t words{};
    const int wrong = wordexp(("bem_contact " + arguments).c_str(), &words, WRDE_NOCMD | WRDE_UNDEF);
    EXPECT_EQ(wrong, 0) << arguments;
    if (wrong != 0)
      return {};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = app::run_program(static_cast<int>(words.we_wordc), words.we_wordv);
    std::cout.flush();
    wordfree(&words);
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
  }
  static std::string text_of(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder_;
};

} // namespace bem_contact
