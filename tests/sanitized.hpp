#pragma once

#include <gtest/gtest.h>

/// Under sanitizers a test takes five to ten times as long. They look for reads and writes beyond what is
/// there and for undefined arithmetic: each line has to run there with inputs of each kind, but not with
/// hundreds that are alike. The half of tools/test without sanitizers runs all.
namespace tests {

#ifdef CONFORMAL_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How many of `all` alike cases a test takes.
constexpr int alike(int all) {
  return sanitized ? (all + 4) / 5 : all;
}

} // namespace tests

/// The first line of a test that only compares numbers or steps of solutions, if other tests run the same
/// lines.
#define NEEDS_NO_SANITIZER()                                                                                 \
  if (tests::sanitized)                                                                                      \
  GTEST_SKIP() << "what it compares sanitizers do not change (the other half runs it)"
