#include "bem_contact/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace bem_contact;

TEST(Parts, CoverEachIndexOnce) {
  for (const int threads : {1, 2, 3, 8})
    for (const int count : {0, 1, 2, 7, 100}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
      in_parts(threads, count, [&](int first, int end, int part) {
        EXPECT_GE(part, 0);
        EXPECT_LT(part, threads);
        for (; first < end; ++first)
          ++visits[static_cast<std::size_t>(first)];
      });
      for (const std::atomic<int>& n : visits)
        EXPECT_EQ(n, 1) << threads << " threads, " << count;
    }
}

TEST(Parts, OneThreadIsTheCaller) {
  std::thread::id there;
  in_parts(1, 10, [&](int first, int end, int) {
    there = std::this_thread::get_id();
    EXPECT_EQ(first, 0);
    EXPECT_EQ(end, 10);
  });
  EXPECT_EQ(there, std::this_thread::get_id());
}

TEST(Parts, WhatOneThrowsIsThrownAfterAllHaveEnded) {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> ended{0};
    const auto body = [&](int, int end, int) {
      ++ended;
      if (end == 6)
        throw std::runtime_error("the last one");
    };
    EXPECT_THROW(in_parts(threads, 6, body), std::runtime_error);
    EXPECT_EQ(ended, threads);
  }
}
