// Scenes whose profiles come from files: noise, datum, and bodies without gauge face or flange.
#include "bem_contact/profile/measured/profile_noise.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/profile/sampled.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace bem_contact {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A folder of its own that goes with the test.
class ProfileFiles : public testing::Test {
protected:
  void write(const std::string& name, const std::vector<Point2>& points) const {
    std::ofstream(folder_ / name) << as_columns(points);
  }
  SceneFile scene(const std::string& text) const {
    SceneFile file =
        parse_scene_file("load.force = 1e5\nmotion.frictionless = true\nsolver.model = \"halfspace\"\n"
                         "grid.dx = 0.5\ngrid.ds = 0.2\n" +
                         text);
    file.folder = folder_.path();
    return file;
  }

private:
  TemporaryFolder folder_;
};

std::vector<Point2> wheel() {
  return sampled_curve(standard_profile("S1002"), 0.25);
}

struct Contact {
  double pmax = 0, area = 0;
};

Contact contact_of(const SceneFile& scene) {
  const ContactResult result = Sequence().solve(scene).result;
  return {result.totals.pmax, result.totals.area};
}

/// A small version of tools/benchmarks/profile_noise.
TEST_F(ProfileFiles, SmoothingAsAdvisedGivesTheSmoothContact) {
  const std::string on_the_tread = "rail.profile = \"60E1\"\nwheel.profile = \"w.txt\"\n";
  write("w.txt", wheel());
  const Contact exact = contact_of(scene(on_the_tread));
  for (const double scatter : {0.002, 0.01})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const std::vector<Point2> points = noisy(wheel(), scatter, seed);
      write("w.txt", points);
      const Contact rough = contact_of(scene(on_the_tread));
      const Contact smooth = contact_of(
          scene(on_the_tread + fmt::format("wheel.smoothing = {:.2g}\n", measure_noise(points).smoothing)));
      EXPECT_GT(rough.pmax, 1.1 * exact.pmax) << scatter << ' ' << seed;
      EXPECT_NEAR(smooth.pmax, exact.pmax, 0.03 * exact.pmax) << scatter << ' ' << seed;
      EXPECT_NEAR(smooth.area, exact.area, 0.03 * exact.area) << scatter << ' ' << seed;
    }
}

/// In the conformal corner pmax hangs on the small difference of two large curvatures. Smoothing alone misses
/// 3 % there in nine of ten draws with this noise.
TEST_F(ProfileFiles, ANominalProfileGivesTheSmoothContactInTheConformalCorner) {
  const std::string in_the_corner =
      "rail.profile = \"60E1\"\nwheel.profile = \"w.txt\"\nposition.lateral = 6.6\n";
  write("w.txt", wheel());
  const Contact exact = contact_of(scene(in_the_corner));
  for (unsigned seed = 1; seed <= 4; ++seed) {
    write("w.txt", noisy(wheel(), 0.01, seed));
    const Contact smooth = contact_of(scene(in_the_corner + "wheel.nominal = \"S1002\"\n"));
    EXPECT_NEAR(smooth.pmax, exact.pmax, 0.03 * exact.pmax) << seed;
    EXPECT_NEAR(smooth.area, exact.area, 0.03 * exact.area) << seed;
  }
}

TEST_F(ProfileFiles, AWheelMeasuredFromTheBackOfItsFlangeStandsWhereItShould) {
  std::vector<Point2> from_back = wheel();
  for (Point2& p : from_back)
    p.y += 70;
  write("tape.txt", wheel());
  write("back.txt", from_back);
  const std::string rail = "rail.profile = \"60E1\"\nposition.lateral = 3\n";
  const Contact by_tape = contact_of(scene(rail + "wheel.profile = \"tape.txt\"\n"));
  const Contact found = contact_of(scene(rail + "wheel.profile = \"back.txt\"\n"));
  const Contact said = contact_of(scene(rail + "wheel.profile = \"back.txt\"\nwheel.flange_back = 0\n"));
  EXPECT_NEAR(found.pmax, by_tape.pmax, 1e-4 * by_tape.pmax);
  EXPECT_EQ(said.pmax, found.pmax);
}

TEST_F(ProfileFiles, AWheelOnTheTipOfItsFlangeIsSaidByCheckAndSolve) {
  std::vector<Point2> beside = wheel();
  for (Point2& p : beside)
    p.y += 52;
  write("w.txt", beside);
  const SceneFile asked = scene("rail.profile = \"60E1\"\nwheel.profile = \"w.txt\"\n");
  const auto cause = HasSubstr("wheel.flange_back");
  EXPECT_THAT(Sequence().check(asked).warnings.texts(), Contains(cause));
  EXPECT_THAT(Sequence().solve(asked).warnings.texts(), Contains(cause));
}

/// Two cylinders of parallel axes along x, a wheel of radius 460 mm: Hertz's curvatures are known.
TEST_F(ProfileFiles, ARollerInAGrooveNeedsNeitherGaugeFaceNorFlange) {
  std::vector<Point2> groove, roller;
  for (double y = -30; y <= 30; y += 0.25) {
    groove.push_back({y, std::sqrt(6400 - y * y) - 80});  // concave, radius 80, lowest in the middle
    roller.push_back({-y, std::sqrt(3600 - y * y) - 60}); // convex, radius 60
  }
  write("groove.txt", groove);
  write("roller.txt", roller);
  const std::string files =
      "rail.profile = \"groove.txt\"\nwheel.profile = \"roller.txt\"\nrail.profile_z = \"down\"\n"
      "wheel.profile_z = \"down\"\n";
  EXPECT_THAT(message_of([&] { Sequence().solve(scene(files)); }), HasSubstr("rail.place = \"absolute\""));
  const SceneFile placed = scene(files + "rail.place = \"absolute\"\nwheel.place = \"absolute\"\n");
  const SceneResult result = Sequence().solve(placed);
  const Contact contact = {result.result.totals.pmax, result.result.totals.area};
  const Contact hertz = [&] {
    SceneFile closed_form = placed;
    closed_form.solver.model = Model::hertz;
    return contact_of(closed_form);
  }();
  EXPECT_NEAR(contact.pmax, hertz.pmax, 0.02 * hertz.pmax);
  EXPECT_THAT(result.warnings.texts(), Not(Contains(HasSubstr("flange"))));
}

} // namespace
} // namespace bem_contact
