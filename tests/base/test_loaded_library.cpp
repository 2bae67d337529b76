#include "bem_contact/base/error.hpp"
#include "bem_contact/base/loaded_library.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <string>

namespace bem_contact {

namespace {

constexpr LoadedLibrary mathematics("libm.so.6"), nowhere("libbem_contact_nowhere.so");
constinit const LoadedFunction<double(double, int*)> log_gamma(mathematics, "lgamma_r");
constinit const LoadedVariable<int> sign_of_gamma(mathematics, "signgam");
constinit const LoadedFunction<double(double)> missing_function(mathematics, "of_no_library"),
    missing_library(nowhere, "cbrt");

TEST(LoadedLibrary, ItsFunctionsAndVariablesAreAsOfAnyOther) {
  int sign = 0;
  EXPECT_NEAR(log_gamma(-0.5, &sign), std::log(2 * std::sqrt(std::numbers::pi)), 1e-14);
  EXPECT_EQ(sign, -1);
  double (*const pointer)(double, int*) = log_gamma;
  EXPECT_NEAR(pointer(5, &sign), std::log(24.0), 1e-13);
  const int before = sign_of_gamma;
  EXPECT_TRUE(before == 0 || std::abs(before) == 1);
}

TEST(LoadedLibrary, WhatIsMissingIsAnErrorThatSaysIt) {
  const auto said = [](const auto& function) -> std::string {
    try {
      function(8.0);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(said(missing_library), testing::HasSubstr("libbem_contact_nowhere.so"));
  EXPECT_THAT(said(missing_function), testing::HasSubstr("of_no_library"));
}

} // namespace

} // namespace bem_contact
