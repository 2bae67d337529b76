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
  // Around whole blocks; by sha256sum of GNU coreutils.
  for (const auto& [size, digest] :
       {std::pair<std::size_t, const char*>{
            0, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {55, "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318"},
        {56, "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a"},
        {64, "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb"},
        {119, "31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb"}})
    EXPECT_EQ(sha256(std::string(size, 'a')), digest) << size;
  const std::string whole(100, 'c'); // in pieces, empty ones too
  EXPECT_EQ(
      sha256({std::as_bytes(std::span(whole).first(7)), {}, std::as_bytes(std::span(whole).subspan(7))}),
      sha256(whole));
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
