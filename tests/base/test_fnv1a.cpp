#include "bem_contact/base/fnv1a.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace bem_contact {
namespace {

std::uint64_t hash_of(std::string_view text) {
  Fnv1a hash;
  hash.add(std::as_bytes(std::span(text)));
  return hash.value();
}

// Values published with the algorithm (Fowler, Noll, Vo).
TEST(Fnv1a, HasThePublishedValues) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, DoesNotDependOnHowTheBytesAreCut) {
  Fnv1a hash;
  for (const std::string_view part : {"fo", "", "obar"})
    hash.add(std::as_bytes(std::span(part)));
  EXPECT_EQ(hash.value(), hash_of("foobar"));
}

} // namespace
} // namespace bem_contact
