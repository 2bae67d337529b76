#include "temporary_folder.hpp"

#include "bem_contact/base/error.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsGoneWithAllThatItHoldsWhenItsObjectIs) {
  fs::path place;
  {
    const TemporaryFolder folder;
    place = folder.path();
    EXPECT_EQ(text_of(folder.write("wheel/worn.txt", "0 0\n")), "0 0\n");
    EXPECT_TRUE(fs::exists(place / "wheel" / "worn.txt"));
  }
  EXPECT_FALSE(fs::exists(place));
}

TEST(TemporaryFolder, WritesNothingOutsideOfIt) {
  const TemporaryFolder folder;
  const std::filesystem::path outside = folder / "outside";
  for (const char* name : {"../x", "a/../../x", "..", "/tmp/x"})
    EXPECT_THROW(folder.write(name, "text"), bem_contact::InputError) << name;
  EXPECT_THROW(folder.write(outside, "text"), bem_contact::InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TemporaryFolder, SaysWhyNoneCanBeMade) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", "/no/such/folder", 1);
  try {
    const TemporaryFolder folder;
    ADD_FAILURE() << "a folder in one that does not exist";
  } catch (const bem_contact::Error& error) {
    EXPECT_STREQ(error.what(), "No temporary folder can be made (No such file or directory) "
                               "Set TMPDIR to a folder that you may write to.");
  }
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}
