#include "bem_contact/base/quick_checksum.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace bem_contact {
namespace {

/// By xxhsum -H2 of xxHash 0.8.1.
TEST(QuickChecksum, OfATextAndAStream) {
  const std::string many(1'000'000, 'a');
  for (const auto& [text, sum] : {std::pair<std::string, const char*>{"", "99aa06d3014798d86001c324468d497f"},
                                  {"abc", "06b05ab6733a618578af5f94892f3950"},
                                  {many, "a545df8e384a9579b1fd6fae5285c4eb"}})
    for (const std::size_t first : {std::size_t(0), text.size() / 3, text.size()}) {
      EXPECT_EQ(quick_checksum(text.substr(0, first), std::as_bytes(std::span(text).subspan(first))), sum);
      std::istringstream following(text.substr(first));
      EXPECT_EQ(quick_checksum(text.substr(0, first), following), sum);
    }
}

} // namespace
} // namespace bem_contact
