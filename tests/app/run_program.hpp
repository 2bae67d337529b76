#pragma once

#include "bem_contact/app/run_program.hpp"

#include <cstdio>
#include <fcntl.h>
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

/// While it lives, what is written to a standard stream goes to a file.
class Redirected {
public:
  Redirected(std::FILE* stream, const std::filesystem::path& file) : stream_(stream) {
    flush();
    before_ = dup(fileno(stream));
    const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(to, fileno(stream));
    close(to);
  }
  ~Redirected() {
    flush();
    dup2(before_, fileno(stream_));
    close(before_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

private:
  static void flush() {
    std::cout.flush();
    std::fflush(nullptr);
  }
  std::FILE* stream_;
  int before_ = -1;
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
    const auto out = folder_ / "stdout", err = folder_ / "stderr";
    wordexp_t words{};
    const int wrong = wordexp(("bem_contact " + arguments).c_str(), &words, WRDE_NOCMD | WRDE_UNDEF);
    EXPECT_EQ(wrong, 0) << arguments;
    int code = -1;
    if (wrong == 0) {
      const Redirected to_out(stdout, out), to_err(stderr, err);
      code = app::run_program(static_cast<int>(words.we_wordc), words.we_wordv);
    }
    wordfree(&words);
    return {code, text_of(out), text_of(err)};
  }
  static std::string text_of(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder_;
};

} // namespace bem_contact
