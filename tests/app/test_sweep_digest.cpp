#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace bem_contact;

/// A fleet has gigabytes of influence files, and each task of a sweep asks whether they are those of the
/// others. Their seals say it, without the rest; a file whose seal does not hold is refused when it is read.
TEST(SweepDigest, AnInfluenceFileCountsByItsSeal) {
  const TemporaryFolder folder;
  const std::filesystem::path data = CONFORMAL_SOURCE_DIR "/data/influence";
  const auto digest = [&] {
    return digest_of(
        parse_sweep_file({"rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 8e4\n"
                          "[sweep]\nrail.influence = [\"rail.h5\"]\n",
                          "s.toml", folder.path()}),
        "");
  };
  std::filesystem::copy_file(data / "small_rail.h5", folder / "rail.h5");
  const std::string whole = digest();
  std::filesystem::resize_file(folder / "rail.h5", 4096);
  EXPECT_EQ(digest(), whole);
  std::filesystem::copy_file(data / "small_wheel.h5", folder / "rail.h5",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE(digest(), whole);
  folder.write("rail.h5", "no influence file");
  const std::string other = digest();
  folder.write("rail.h5", "no influence file!");
  EXPECT_NE(digest(), other);
}

} // namespace
