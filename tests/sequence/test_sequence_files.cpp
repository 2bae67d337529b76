#include "bem_contact/sequence/numbers/sequence_files.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace bem_contact {
namespace {

const std::filesystem::path small = CONFORMAL_SOURCE_DIR "/data/influence";

/// A pair of bodies of which each has a file of its own.
std::pair<Body, Body> bodies(const TemporaryFolder& folder, const std::string& name) {
  Body rail, wheel;
  rail.influence = folder / (name + "_rail.h5");
  wheel.influence = folder / (name + "_wheel.h5");
  std::filesystem::copy_file(small / "small_rail.h5", rail.influence);
  std::filesystem::copy_file(small / "small_wheel.h5", wheel.influence);
  return {rail, wheel};
}

/// A long computation with ever more files needs no more memory than one with a few.
TEST(SequenceFiles, KeepsNoMoreThanItMay) {
  const TemporaryFolder folder;
  const auto [rail_a, wheel_a] = bodies(folder, "a");
  const auto [rail_b, wheel_b] = bodies(folder, "b");
  for (const double megabytes : {0.0, 1000.0}) {
    SequenceFiles files(1, megabytes);
    const std::weak_ptr<const InfluenceFile> a = files.influence(rail_a, wheel_a).rail;
    EXPECT_FALSE(a.expired()) << "the last one stays, whatever its size";
    EXPECT_EQ(files.influence(rail_a, wheel_a).rail, a.lock());
    const std::weak_ptr<const InfluenceFile> b = files.influence(rail_b, wheel_b).rail;
    EXPECT_FALSE(b.expired());
    EXPECT_EQ(a.expired(), megabytes == 0);
    const auto stations = [&](const Body& rail, const Body& wheel) {
      const auto file = files.influence(rail, wheel).rail;
      return file->around(file->strip().all_stations()).kernel;
    };
    EXPECT_EQ(stations(rail_a, wheel_a), stations(rail_b, wheel_b));
  }
}

/// The two used last stay, which need not be the two read last.
TEST(SequenceFiles, KeepsWhatIsUsed) {
  const TemporaryFolder folder;
  SequenceFiles files(2);
  SceneFile scene;
  scene.wheel.profile = "S1002";
  const auto read_again = [&](const char* rail) { // a file that is kept need not be there
    scene.rail.profile = rail;
    try {
      files.profiles(scene);
      return false;
    } catch (const InputError&) {
      return true;
    }
  };
  scene.folder = folder.path();
  for (const char* rail : {"a.txt", "b.txt", "c.txt"})
    folder.write(rail, "-20 1\n0 0\n20 1\n");
  for (const char* rail : {"a.txt", "b.txt", "a.txt", "c.txt"})
    EXPECT_FALSE(read_again(rail));
  for (const char* rail : {"a.txt", "b.txt", "c.txt"})
    std::filesystem::remove(folder / rail);
  EXPECT_FALSE(read_again("a.txt"));
  EXPECT_FALSE(read_again("c.txt"));
  EXPECT_TRUE(read_again("b.txt"));
}

/// Files that are read again and again give what files that are kept give, to the last bit.
TEST(SequenceFiles, ResultsDoNotDependOnWhatIsKept) {
  const TemporaryFolder folder;
  const std::pair<Body, Body> pairs[] = {bodies(folder, "a"), bodies(folder, "b")};
  const auto pressures = [&](const std::shared_ptr<SequenceFiles>& files) {
    Sequence sequence({}, files);
    std::vector<std::vector<double>> out;
    for (const int pair : {0, 0, 1, 0, 1}) {
      const std::vector<SceneChange> changes{
          {"rail.influence", pairs[pair].first.influence.string()},
          {"wheel.influence", pairs[pair].second.influence.string()},
          {"position.lateral", 6.4 + 0.05 * static_cast<double>(out.size())}};
      const SceneFile scene =
          read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml", changes);
      out.push_back(sequence.solve(with_model(scene, Model::fem)).result.pn);
    }
    return out;
  };
  EXPECT_EQ(pressures(std::make_shared<SequenceFiles>(0, 0.0)), pressures(std::make_shared<SequenceFiles>()));
}

} // namespace
} // namespace bem_contact
