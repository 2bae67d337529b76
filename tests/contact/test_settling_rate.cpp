#include "bem_contact/contact/coupled/settling_rate.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace bem_contact::contact {
namespace {

constexpr int allowed = 50;
constexpr double enough = 1e-5;

/// After how many iterations it is known that they will not settle; 0: they settle, or all that are allowed
/// pass.
int given_up_after(const std::function<double(int)>& change) {
  SettlingRate rate;
  for (int k = 0; k < allowed; ++k) {
    if (change(k) <= enough)
      return 0;
    if (rate.is_hopeless(change(k), enough, allowed - k - 1))
      return k + 1;
  }
  return 0;
}

/// Whatever settles within the iterations that are allowed is never given up: also where accelerated
/// iterations fall in steps, or rise for a while.
TEST(SettlingRate, WhatSettlesIsNotGivenUp) {
  for (const double rate : {0.3, 0.6, 0.8}) {
    EXPECT_EQ(given_up_after([&](int k) { return 0.1 * std::pow(rate, k); }), 0) << rate;
    EXPECT_EQ(given_up_after([&](int k) { return 0.1 * std::pow(rate, k) * (k % 3 == 1 ? 20 : 1); }), 0)
        << rate;
    EXPECT_EQ(given_up_after([&](int k) { return 0.1 * std::pow(rate, k - k % 5); }), 0) << rate;
  }
}

TEST(SettlingRate, WhatDoesNotSettleIsGivenUpAtHalf) {
  EXPECT_EQ(given_up_after([](int) { return 1e-3; }), 2 * iterations_of_a_rate);
  EXPECT_EQ(given_up_after([](int k) { return 1e-3 * (2 + std::sin(k)); }), 2 * iterations_of_a_rate);
  EXPECT_EQ(given_up_after([](int k) { return 0.1 * std::pow(0.97, k); }), 2 * iterations_of_a_rate);
  EXPECT_EQ(given_up_after([](int k) { return 1e-3 * std::pow(1.1, k); }), 2 * iterations_of_a_rate);
}

} // namespace
} // namespace bem_contact::contact
