#include "bem_contact/base/sha256.hpp"
#include "message.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

/// The examples of FIPS 180-2, appendix B: of three bytes and of a million.
TEST(Sha256, OfATextAndOfAFile) {
  const TemporaryFolder folder;
  for (const auto& [text, digest] :
       {std::pair<std::string, const char*>{
            "abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {std::string(1'000'000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"}}) {
    EXPECT_EQ(sha256(text), digest);
    EXPECT_EQ(sha256_of_file(folder.write("file", text).string()), digest);
    EXPECT_EQ(sha256(text).size(), sha256_size);
  }
  const std::string two(1 << 21, 'b'); // more than one piece
  EXPECT_EQ(sha256_of_file(folder.write("two", two).string()), sha256(two));
}

TEST(Sha256, OfAFileThatCannotBeReadIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of([&] { sha256_of_file((folder / "none").string()); }),
              testing::HasSubstr("there is no such file"));
  EXPECT_THAT(message_of([&] { sha256_of_file(folder.path().string()); }),
              testing::HasSubstr("it is a folder"));
}

} // namespace
} // namespace bem_contact
