#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Points of the head of 60E1 from y = from to y = to.
void write_part(const std::filesystem::path& file, double from, double to) {
  std::ofstream out(file);
  for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.25))
    if (p.position.y >= from && p.position.y <= to)
      out << fmt::format("{:.12f} {:.12f}\n", p.position.y, p.position.z);
}

/// A narrow head about y = middle, its top at z = top, 24 mm wide.
void write_narrow_head(const std::filesystem::path& file, double middle, double top) {
  std::ofstream out(file);
  for (int i = -48; i <= 48; ++i) {
    const double y = 0.25 * i;
    out << fmt::format("{:.12f} {:.12f}\n", middle + y, top + 60 - std::sqrt(60 * 60 - y * y));
  }
}

SceneResult on_bodies(const std::filesystem::path& folder, const std::string& more) {
  SceneFile scene = parse_scene_file(
      {"wheel.profile = 'S1002'\nrail.profile_z = 'down'\nrail.unit = 'mm'\nrail.place = 'absolute'\n"
       "rail.y = 753\nsolver.model = 'halfspace'\ngrid = { dx = 0.5, ds = 0.4 }\n" +
           more,
       "bodies.toml"});
  scene.folder = folder;
  SceneResult out = Sequence().solve(scene);
  EXPECT_TRUE(certified(out)) << more;
  return out;
}

/// Vertical forces on the bodies 1 and 2, N.
std::array<double, 2> shares(const SceneResult& r) {
  std::array<double, 2> out{};
  for (std::size_t i = 0; i < r.result.patches.size(); ++i)
    out[r.patch_places[i].body > 1 ? 1 : 0] += r.result.patches[i].fz;
  return out;
}

/// A rail that is cut beside the contact is the rail.
TEST(RailBodies, OfARailThatIsCutAreTheRail) {
  const TemporaryFolder folder;
  write_part(folder.path() / "whole.txt", -100, 100);
  write_part(folder.path() / "gauge.txt", -100, 18);
  write_part(folder.path() / "field.txt", 20, 100);
  const std::string load =
      "load.force = 80000\nmotion = { friction = 0.3, xi = 5e-4, rolling_radius = 460 }\n";
  const SceneResult whole = on_bodies(folder.path(), load + "rail.profile = 'whole.txt'\n"),
                    cut = on_bodies(
                        folder.path(),
                        load + "rail.sections = [ { at = 0, profile = 'field.txt', body = 'field' }, "
                               "{ at = 0, profile = 'gauge.txt', body = 'gauge' } ]\n");
  for (const char* name : {"pmax", "area", "Fx", "Fy", "Fz", "approach", "vertical"}) {
    const double one = quantity(name).value(whole);
    EXPECT_NEAR(quantity(name).value(cut), one, 1e-6 * (1 + std::abs(one))) << name;
  }
  ASSERT_EQ(cut.patch_places.size(), 1u);
  EXPECT_EQ(cut.patch_places[0].body, 2);
  EXPECT_EQ(whole.patch_places[0].body, 0);
}

const char* const two_heads = "motion.frictionless = true\nload.force = 20000\n"
                              "rail.sections = [ { at = 0, profile = 'inner.txt', body = 'inner' }, { at = "
                              "0, profile = 'outer.txt', body = "
                              "'outer' } ]\n";

/// On springs that are far softer than the contacts each body takes what its spring says: F1 / k1 - F2 / k2
/// is by how much the second one stood lower under the wheel.
TEST(RailBodies, ShareTheLoadByTheirSprings) {
  const TemporaryFolder folder;
  write_narrow_head(folder.path() / "inner.txt", -3, 0);
  write_narrow_head(folder.path() / "outer.txt", 32, 0);
  const auto lowered = [&](double inner, double outer) {
    return on_bodies(folder.path(),
                     two_heads + fmt::format("rail.bodies = [ {{ name = 'inner', lowered = {} }}, {{ name = "
                                             "'outer', lowered = {} }} ]\n",
                                             inner, outer));
  };
  // Where each of them bears all, the heights of the wheel tell by how much one stands lower.
  const double by_inner = quantity("vertical").value(lowered(0, 30)),
               by_outer = quantity("vertical").value(lowered(30, 0)), gap = by_outer - by_inner;
  const double k1 = 2000, k2 = 5000;
  const SceneResult soft =
      on_bodies(folder.path(),
                two_heads + fmt::format("rail.bodies = [ {{ name = 'inner', stiffness = {} }}, {{ name = "
                                        "'outer', stiffness = {} }} ]\n",
                                        k1, k2));
  const auto [f1, f2] = shares(soft);
  EXPECT_NEAR(f1 + f2, 20000, 1e-3);
  EXPECT_NEAR(f1 / k1 - f2 / k2, gap, 0.1); // the approaches of the contacts
  // The same by the depths themselves, as rigid bodies.
  const SceneResult rigid = lowered(f1 / k1, f2 / k2);
  EXPECT_NEAR(shares(rigid)[0], f1, 1e-3 * f1);
  EXPECT_NEAR(quantity("vertical").value(rigid), quantity("vertical").value(soft), 1e-4);
  // Stiff springs are none.
  const SceneResult stiff =
      on_bodies(folder.path(), two_heads + std::string("rail.bodies = [ { name = 'inner', "
                                                       "stiffness = 1e10 } ]\n"));
  EXPECT_NEAR(shares(stiff)[0], shares(lowered(0, 0))[0], 5);
}

/// A check rail or keeper: its edge is round, and its face upright.
void write_check_rail(const std::filesystem::path& file) {
  constexpr double radius = 13, y = -83.9, z = 21.2; // of the edge, and where its middle is
  std::ofstream out(file);
  const auto add = [&](double at_y, double at_z) { out << fmt::format("{:.12f} {:.12f}\n", at_y, at_z); };
  for (int i = 40; i > 0; --i)
    add(y - i, z - radius);
  for (int i = 0; i <= 180; ++i)
    add(y + radius * std::sin(0.5 * i * std::numbers::pi / 180),
        z - radius * std::cos(0.5 * i * std::numbers::pi / 180));
  for (int i = 1; i <= 30; ++i)
    add(y + radius + 1e-4 * i, z + 0.5 * i);
}

/// The flange's back comes to a check rail beside the running rail. Until it touches nothing changes, though
/// the upright face is near; then both bear the wheel, and in the end the check rail lifts it.
TEST(RailBodies, ACheckRailIsTouchedByTheFlangesBack) {
  const TemporaryFolder folder;
  write_part(folder.path() / "rail.txt", -100, 100);
  write_check_rail(folder.path() / "check.txt");
  const auto solved = [&](double lateral, const char* rails) {
    return on_bodies(folder.path(), fmt::format("load.force = 80000\nmotion.frictionless = true\n"
                                                "position.lateral = {}\n{}\n",
                                                lateral, rails));
  };
  const char *const alone = "rail.profile = 'rail.txt'",
                    *const both =
                        "rail.sections = [ { at = 0, profile = 'rail.txt', body = 'rail' }, { at = 0, "
                        "profile = 'check.txt', body = 'check' } ]";
  for (const double lateral : {0.8, 0.3}) {
    const SceneResult one = solved(lateral, alone), two = solved(lateral, both);
    for (const char* name : {"pmax", "Fy", "approach", "vertical"})
      EXPECT_NEAR(quantity(name).value(two), quantity(name).value(one),
                  1e-5 * (1 + std::abs(quantity(name).value(one))))
          << name << " " << lateral;
    EXPECT_EQ(shares(two)[1], 0) << lateral;
  }
  const SceneResult shared = solved(-0.08, both);
  const auto [on_rail, on_check] = shares(shared);
  EXPECT_GT(on_rail, 1000);
  EXPECT_GT(on_check, 1000);
  EXPECT_NEAR(on_rail + on_check, 80000, 1);
  for (std::size_t i = 0; i < shared.result.patches.size(); ++i)
    if (shared.patch_places[i].body == 2) {
      EXPECT_NEAR(shared.result.patches[i].delta, 1.2, 0.05);
    }
  const SceneResult lifted = solved(-1, both);
  EXPECT_EQ(shares(lifted)[0], 0);
  EXPECT_LT(quantity("vertical").value(lifted), quantity("vertical").value(shared) - 1);
}

TEST(RailBodies, SayWhatIsWrong) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& bodies) {
    return message_of([&] { on_bodies(folder.path(), two_heads + bodies); });
  };
  EXPECT_THAT(message("rail.bodies = [ { name = 'third' } ]\n"),
              HasSubstr("no section has the body 'third'"));
  EXPECT_THAT(message("rail.bodies = [ { name = 'inner' }, { name = 'inner' } ]\n"),
              HasSubstr("is there twice"));
  EXPECT_THAT(message_of([&] {
                on_bodies(folder.path(),
                          "load.approach = 0.1\nrail.sections = [ { at = 0, profile = 'a', body = "
                          "'x' }, { at = 0, profile = 'b', body = 'y' } ]\n"
                          "rail.bodies = [ { name = 'x', stiffness = 5e4 } ]\n");
              }),
              HasSubstr("load.force alone is not given"));
  EXPECT_THAT(message("rail.bodies = [ { name = 'inner', stiffness = 5 } ]\n"),
              HasSubstr("'inner' lies on 5 N/mm"));
  EXPECT_THAT(message_of([&] {
                on_bodies(folder.path(),
                          "load.force = 1e4\nrail.sections = [ { at = 5, profile = '60E1', body = "
                          "'x' }, { at = 0, profile = '60E1', body = 'x' } ]\n");
              }),
              AllOf(HasSubstr("Body 'x' of the rail"), HasSubstr("out of order")));
  EXPECT_THAT(message_of([&] {
                on_bodies(folder.path(),
                          "load.force = 1e4\nrail.sections = [ { at = 0, profile = '60E1', body = "
                          "'x' }, { at = 0, profile = '60E1', body = 'y' } ]\n");
              }),
              AllOf(HasSubstr("Bodies 'x' and 'y' of the rail"), HasSubstr("lie one upon the other")));
}

} // namespace
