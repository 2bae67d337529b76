// A contact that comes near the ends of the strips of its influence files: what check says, and what solve
// does.
#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/halfspace/strip_kernel.hpp"
#include "tests/sanitized.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <memory>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// What check says of the rail's influence file.
enum class Verdict { covered, closely, refused };

/// A steel wheel with a profile of radius 10 mm in a softer groove of radius 10.02 mm. Both have the numbers
/// of flat half-spaces as their influence functions, on strips of +-8.25 mm: good enough for a contact that
/// gets wider with the load, and that shear moves along s.
class GrooveStrips : public testing::Test {
protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    write("rail.h5", soft, named_profile(groove, ProfileKind::rail));
    write("wheel.h5", Material{}, named_profile(wheel, ProfileKind::wheel));
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static SceneFile scene(double force, const std::string& more) {
    return parse_scene_file(
        fmt::format("rail = {{ profile = '{}', influence = '{}', place = 'absolute', material = {{ "
                    "shear_modulus = {}, poisson = {} }} }}\n"
                    "wheel = {{ profile = '{}', influence = '{}', place = 'absolute' }}\n"
                    "position.wheel_radius = 420\nload.force = {}\ngrid = {{ dx = {}, ds = {} }}\n{}",
                    groove, file("rail.h5").string(), soft.shear_modulus, soft.poisson, wheel,
                    file("wheel.h5").string(), force, dx, ds, more));
  }

  static std::string rail_line(const SceneFile& scene) {
    for (const std::string& line : Sequence().check(scene).lines)
      if (line.starts_with("rail: influence file"))
        return line;
    return "none";
  }
  static Verdict verdict(const SceneFile& scene) {
    const std::string line = rail_line(scene);
    if (line.find("fem refuses the contact without friction") != std::string::npos)
      return Verdict::refused;
    if (line.find("covered, but closely") != std::string::npos)
      return Verdict::closely;
    EXPECT_TRUE(line.ends_with("covered")) << line;
    return Verdict::covered;
  }

  /// Whether fem solves the scene. A solution is certified, and its contact ends before the strip does.
  static bool served(const SceneFile& scene) {
    try {
      const SceneResult r = Sequence().solve(with_model(scene, Model::fem));
      EXPECT_TRUE(r.result.trust.certificate.holds());
      EXPECT_FALSE(r.result.trust.touches_border);
      return true;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("reaches the end of a strip"), HasSubstr("-8.25 .. 8.25 mm"),
                                      HasSubstr("longer strips")));
      return false;
    }
  }

  static constexpr Material soft{23000, 0.0}; // unlike the wheel's: so shear and pressure act on each other
  static constexpr int stations = 33;
  static constexpr double dx = 1.0, ds = 0.5;
  static constexpr const char* groove = CONFORMAL_SOURCE_DIR "/data/bodies/groove.toml";
  static constexpr const char* wheel = CONFORMAL_SOURCE_DIR "/data/bodies/wheel_in_groove.toml";

private:
  static std::filesystem::path file(const char* name) { return *folder_ / name; }
  static void write(const char* name, const Material& material, const ProfileCurve& curve) {
    InfluenceFunction f = halfspace_function(material, stations, ds, dx, 600, 4);
    f.body = curve.name();
    f.profile = curve.name();
    f.profile_digest = curve.digest();
    for (Station& station : f.stations) {
      const CurvePoint p = curve.at(station.s);
      station.position = p.position;
      station.delta = p.delta;
    }
    write_influence_file(file(name), f);
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
};

constexpr double loads[] = {2000, 3000, 3500, 4000, 4500, 6000};

TEST_F(GrooveStrips, WithoutFrictionCheckAndSolveAgreeAtEveryLoad) {
  int covered = 0, refused = 0;
  for (const double load : loads) {
    const SceneFile frictionless = scene(load, "motion.frictionless = true\nsolver.model = 'fem'\n");
    const Verdict said = verdict(frictionless);
    EXPECT_EQ(said, served(frictionless) ? Verdict::covered : Verdict::refused) << load;
    ++(said == Verdict::covered ? covered : refused);
  }
  EXPECT_GT(covered, 0);
  EXPECT_GT(refused, 0);
}

/// Side creepage drives the contact along s, up to the end of the strip and away from the other.
TEST_F(GrooveStrips, WhatCheckCallsCoveredSolveServes) {
  NEEDS_NO_SANITIZER();
  int closely_refused = 0, closely_served = 0;
  for (const std::string model : {"fem", "auto"})
    for (const double load : loads)
      for (const double eta : {0.0, 0.01}) {
        const SceneFile rolling =
            scene(load, fmt::format("motion = {{ friction = 0.6, eta = {}, free_rolling = false }}\n"
                                    "solver.model = '{}'\n",
                                    eta, model));
        const Verdict said = verdict(rolling);
        const bool solved = served(rolling);
        if (said == Verdict::covered) {
          EXPECT_TRUE(solved) << load << " N, eta " << eta << ", " << rail_line(rolling);
        }
        if (said == Verdict::closely)
          ++(solved ? closely_served : closely_refused);
      }
  EXPECT_GT(closely_refused, 0) << "some case must be one that check once called covered";
  EXPECT_GT(closely_served, 0);
}

} // namespace
} // namespace bem_contact
