#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/halfspace/strip_kernel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string materials = "[rail.material]\nshear_modulus = 80769.230769\npoisson = 0.3\n"
                              "[wheel.material]\nshear_modulus = 80769.230769\npoisson = 0.3\n";

std::string depths(double from, double to, double step) {
  std::string list;
  for (double z = from; z < to; z += step)
    list += std::to_string(z) + ", ";
  return "[stresses]\ndepths = [" + list + "]\n";
}

std::size_t place_of_largest(const std::vector<double>& v) {
  return static_cast<std::size_t>(std::max_element(v.begin(), v.end()) - v.begin());
}

/// Sphere R 50, F 1000 (Hertz; Johnson 1985, eq. 4.22 to 4.24): a 0.68753, p0 1010.07; nu 0.3: tau_max 0.310
/// p0 at 0.48 a.
TEST(StressesBelow, HertzOnACircle) {
  const SceneResult r = Sequence().solve(
      parse_scene_file("kind = \"patch\"\nload.force = 1000\nmotion.frictionless = true\n" + materials +
                       "[grid]\ndx = 0.04\nds = 0.04\nmx = 40\nms = 40\n[gap]\na = 0.01\nb = 0.01\n" +
                       depths(0.02, 0.8, 0.01)));
  ASSERT_TRUE(r.stresses);
  const StressesBelow& b = *r.stresses;
  const std::size_t at = place_of_largest(b.largest_shear);
  EXPECT_NEAR(b.largest_shear[at], 0.310 * 1010.07, 0.01 * 0.310 * 1010.07);
  EXPECT_NEAR(b.depths[at], 0.48 * 0.68753, 0.015);
  // Johnson 1985, eq. 3.45
  for (std::size_t i = 0; i < b.depths.size(); i += 10) {
    const double z = b.depths[i] / 0.68753443;
    EXPECT_NEAR(b.stress[i].nn, -1010.07 / (1 + z * z), 0.012 * 1010.07) << z;
  }
  EXPECT_TRUE(r.warnings.empty());
}

/// Line contact: tau_max 0.300 p0 at 0.786 b; sigma_x = nu (sigma_s + sigma_n).
TEST(StressesBelow, LineContact) {
  const double radius = 500, semi = 1, modulus = 80769.230769 / 0.7;
  const double force = std::numbers::pi * semi * semi * modulus / (4 * radius),
               p0 = 2 * force / std::numbers::pi;
  const SceneResult r = Sequence().solve(parse_scene_file(
      "kind = \"patch\"\nload.force = " + std::to_string(force) + "\nmotion.frictionless = true\n" +
      materials + "[grid]\nplane_strain = true\nds = 0.025\nmx = 1\nms = 96\n[gap]\nb = 0.001\n" +
      depths(0.4, 1.2, 0.01)));
  ASSERT_TRUE(r.stresses);
  const StressesBelow& b = *r.stresses;
  const std::size_t at = place_of_largest(b.largest_shear);
  EXPECT_NEAR(b.largest_shear[at], 0.300 * p0, 0.005 * p0);
  EXPECT_NEAR(b.depths[at], 0.786, 0.02);
  for (const halfspace::Stress& t : b.stress)
    EXPECT_NEAR(t.xx, 0.3 * (t.ss + t.nn), 1e-4 * p0);
}

/// On every horizontal plane the tractions have the resultant of the surface's. Beyond the square |x|, |s| <
/// l lies the share 3 sqrt(2) z/(pi l) of the shear (Cerruti's point force far away; of the pressure
/// (z/l)^3).
TEST(StressesBelow, CarryTheForcesDown) {
  SceneFile scene =
      parse_scene_file("kind = \"patch\"\nload.force = 2e4\n[motion]\nfriction = 0.3\nxi = 3e-4\n"
                       "eta = 2e-4\nphi = 1e-4\n[grid]\ndx = 0.5\nds = 0.5\nmx = 20\nms = 20\n"
                       "[gap]\na = 1e-3\nb = 1.5e-3\n[stresses]\ndepths = [1.5]\n");
  scene.stresses.x.clear();
  for (double x = -60; x <= 60; x += 1)
    scene.stresses.x.push_back(x);
  scene.stresses.s = scene.stresses.x;
  const SceneResult r = Sequence().solve(scene);
  ASSERT_TRUE(r.stresses);
  double fx = 0, fs = 0, fn = 0;
  for (const halfspace::Stress& t : r.stresses->stress) {
    fx -= t.xn;
    fs -= t.sn;
    fn -= t.nn;
  }
  const double inside = 1 - 3 * std::numbers::sqrt2 * 1.5 / (std::numbers::pi * 60.5);
  EXPECT_NEAR(fn, 2e4, 1e-3 * 2e4);
  EXPECT_NEAR(fx, inside * r.result.totals.Fx, 1e-3 * r.result.totals.Fx);
  EXPECT_NEAR(fs, inside * r.result.totals.Fy, 1e-3 * r.result.totals.Fx);
}

TEST(StressesBelow, SayWhereTheyAreAnApproximation) {
  SceneFile scene = parse_scene_file("kind = \"patch\"\nload.force = 2000\nmotion.frictionless = true\n"
                                     "[grid]\ndx = 0.5\nds = 0.25\nmx = 20\nms = 40\n[gap]\na = 1e-3\n"
                                     "[strip]\nradius = -10\nupper_radius = 9.8\n[stresses]\ndepths = [1]\n");
  scene.solver.model = Model::halfspace;
  const SceneResult r = Sequence().solve(scene);
  ASSERT_TRUE(r.stresses);
  EXPECT_THAT(r.warnings.texts(),
              ::testing::Contains(HasSubstr("those of a half-space under these tractions")));
  scene.stresses.depths.clear();
  EXPECT_FALSE(Sequence().solve(scene).stresses) << "not asked for";
}

TEST(StressesBelow, AreRefusedAtTheSurfaceAndInMillions) {
  EXPECT_THROW(parse_scene_file("kind = \"patch\"\nload.force = 1\n[grid]\nmx = 2\nms = 2\n"
                                "[stresses]\ndepths = [1, 0]\n"),
               InputError);
  SceneFile::Stresses asked;
  asked.x.assign(2000, 0);
  asked.s.assign(2000, 0);
  asked.depths = {1};
  EXPECT_THROW(stresses_below(asked, {}, 0), InputError);
}

/// Half-spaces as influence files that have stresses: what a body has more is the same everywhere, ss =
/// `more` (MPa) for each N/mm2 of the load over a whole period.
class StressesInBodies : public testing::Test {
protected:
  static constexpr int stations = 33;
  static constexpr double width = 0.5, half_period = 600;

  static StressKernel kernel(double more) {
    StressKernel out;
    constexpr int places = 45;
    for (int i = 0; i < places; ++i) {
      const double s = (i - 22) * width;
      out.places.push_back({s, {s, 0}, 0});
    }
    out.depths = {0.75, 1.5, 3};
    out.there.assign(places * out.depths.size(), 1);
    StressForm& form = out.remainder;
    form.wavenumber = sampled_wavenumbers(half_period, 1, 4);
    for (std::size_t d = 0; d < out.depths.size(); ++d) {
      form.left_rank.push_back(1);
      form.right_rank.push_back(1);
      for (int i = 0; i < 6 * places; ++i)
        form.left.push_back(i % 6 == 1 ? float(1 / std::sqrt(double(places))) : 0);
      for (int i = 0; i < 3 * stations; ++i)
        form.right.push_back(i % 3 == 2 ? float(1 / std::sqrt(double(stations))) : 0);
    }
    form.core.assign(form.wavenumber.size() * out.depths.size(), 0); // the mean alone
    for (std::size_t d = 0; d < out.depths.size(); ++d)
      form.core[d] = float(more * 2 * half_period * std::sqrt(double(places * stations)));
    return out;
  }
  void write(const char* name, const StressKernel& stresses) {
    write_influence_file(folder_ / name, halfspace_function({80769.230769, 0.3}, stations, width, 1),
                         stresses);
  }
  SceneFile scene(const std::string& stresses, const std::string& bodies) {
    return parse_scene_file(SceneText{"kind = \"patch\"\nload.force = 1000\nmotion.frictionless = true\n"
                                      "solver.model = \"halfspace\"\n" +
                                          bodies + materials +
                                          "[grid]\ndx = 0.04\nds = 0.04\nmx = 40\nms = 40\n[gap]\na = 0.01\n"
                                          "b = 0.01\n[stresses]\nin = \"bodies\"\n" +
                                          stresses,
                                      "scene", folder_.path()});
  }

  TemporaryFolder folder_;
};

TEST_F(StressesInBodies, AreThoseOfTheHalfspaceAndWhatTheFilesSay) {
  write("rail.h5", kernel(0.01));
  write("wheel.h5", kernel(0.02));
  const SceneResult r = Sequence().solve(scene(
      "x = [0, 0.4]\ns = [0, 0.3]\ndepths = [0.2, 1, 2.5]\n",
      "rail.influence = \"rail.h5\"\nwheel.influence = \"wheel.h5\"\n[strip]\nrail_s0 = 2\nwheel_s0 = -1\n"));
  ASSERT_TRUE(r.stresses);
  ASSERT_EQ(r.stresses->bodies.size(), 2U);
  const StressesInBody &rail = r.stresses->bodies[0], &wheel = r.stresses->bodies[1];
  EXPECT_EQ(rail.side, inside::Side::rail);
  EXPECT_EQ(wheel.side, inside::Side::wheel);
  EXPECT_THAT(rail.s, testing::ElementsAre(testing::DoubleNear(2, 1e-9), testing::DoubleNear(2.3, 1e-9)));
  EXPECT_THAT(wheel.s, testing::ElementsAre(testing::DoubleNear(-1, 1e-9), testing::DoubleNear(-1.3, 1e-9)));
  const double pressed = 1000 / width; // sum over the stations of what presses on a mm of each
  ASSERT_EQ(rail.in_body.stress.size(), 12U);
  for (std::size_t i = 0; i < rail.in_body.stress.size(); ++i) {
    const halfspace::Stress &flat = r.stresses->stress[i], &of_rail = rail.in_body.stress[i],
                            &of_wheel = wheel.in_body.stress[i];
    EXPECT_NEAR(rail.halfspace.stress[i].ss, flat.ss, 1e-6);
    EXPECT_NEAR(wheel.halfspace.stress[i].nn, flat.nn, 1e-6) << "opposite, and the same by symmetry";
    EXPECT_NEAR(of_rail.ss - flat.ss, 0.01 * pressed, 1e-3);
    EXPECT_NEAR(of_wheel.ss - flat.ss, 0.02 * pressed, 1e-3);
    EXPECT_NEAR(of_rail.nn, flat.nn, 1e-3);
    EXPECT_NEAR(rail.in_body.von_mises[i], von_mises(of_rail), 1e-12);
  }
  EXPECT_EQ(rail.error.size(), 6U);
  EXPECT_THAT(r.warnings.kinds(), testing::Not(testing::Contains("rough_stresses")));
}

TEST_F(StressesInBodies, AreRefusedBeforeAnythingIsSolved) {
  write("rail.h5", kernel(0.01));
  write("bare.h5", {});
  const auto refused = [&](const std::string& depths, const std::string& bodies) {
    return message_of([&] { Sequence().solve(scene("depths = [" + depths + "]\n", bodies)); });
  };
  EXPECT_THAT(
      refused("1", "rail.influence = \"bare.h5\"\n"),
      AllOf(HasSubstr("has no stresses of the inside"), HasSubstr("fem_influence BODY.toml BODY.msh")));
  EXPECT_THAT(refused("1", "rail.influence = \"rail.h5\"\nwheel.influence = \"bare.h5\"\n"),
              HasSubstr("bare.h5"));
  EXPECT_THAT(refused("1, 4", "rail.influence = \"rail.h5\"\n"), HasSubstr("to a depth of 3 mm"));
  EXPECT_THAT(refused("1", ""), AllOf(HasSubstr("stresses.in"), HasSubstr("none is given")));
}

} // namespace
