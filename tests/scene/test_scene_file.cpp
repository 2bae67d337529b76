#include "bem_contact/scene/scene_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "tests/base/message.hpp"

#include <filesystem>
#include <gmock/gmock.h>
#include <vector>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string refusal(const std::string& toml) {
  return message_of([&] { parse_scene_file({toml, "scene.toml"}); });
}

const std::string rolling = R"(
[rail]
profile = "60E1"
[wheel]
profile = "S1002"
)";
const std::string patch = "kind = 'patch'\n[grid]\nmx = 20\nms = 10\n[load]\nforce = 1000\n";

/// Every scene that is shipped, and materials by Young's modulus, rows asked for, an absolute place.
TEST(SceneFile, with_its_defaults_it_is_the_same_scene) {
  std::vector<SceneFile> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(CONFORMAL_SOURCE_DIR "/data/scenes"))
    if (entry.path().extension() == ".toml" && !entry.path().filename().string().starts_with("cases_"))
      scenes.push_back(read_scene_file(entry.path()));
  scenes.push_back(parse_scene_file(rolling +
                                    "place = 'absolute'\ny = 3\nmaterial.young = 2e5\n[load]\nforce = 1e4\n"
                                    "[grid]\ns_from = -3\ns_to = 5\n"));
  EXPECT_GT(scenes.size(), 15u);
  for (const SceneFile& scene : scenes) {
    const std::string text = scene_with_defaults(scene);
    SceneFile again = parse_scene_file(text);
    again.folder = scene.folder;
    again.unused = scene.unused;
    EXPECT_TRUE(again == scene) << text;
    EXPECT_EQ(scene_with_defaults(again), text);
  }
}

TEST(SceneFile, the_printed_schema_is_a_valid_scene) {
  const SceneFile f = parse_scene_file(default_scene_file());
  EXPECT_EQ(f.kind, SceneKind::wheel_rail);
  EXPECT_EQ(f.rail.profile, "60E1");
  EXPECT_EQ(f.wheel.profile, "S1002");
  EXPECT_TRUE(f.load.force.has_value());
  EXPECT_FALSE(f.load.approach.has_value());
  EXPECT_EQ(f.load.force, 1e5);
  EXPECT_EQ(f.position.back_to_back, 1360);
  EXPECT_EQ(f.solver.tolerance, 1e-8);
}

TEST(SceneFile, what_must_be_given_has_no_default) {
  const std::string printed = default_scene_file();
  EXPECT_THAT(printed, HasSubstr("no default, for instance \"60E1\""));
  EXPECT_THAT(printed, HasSubstr("no default, for instance \"S1002\""));
  EXPECT_THAT(printed, HasSubstr("no default, for instance 100000.0"));
  EXPECT_THAT(refusal("[load]\nforce = 1e5\n"), HasSubstr("a wheel on a rail needs the rail's profile"));
  EXPECT_THAT(refusal("rail.profile = '60E1'\n[load]\nforce = 1e5\n"),
              HasSubstr("a wheel on a rail needs the wheel's profile"));
  EXPECT_THAT(refusal(rolling), HasSubstr("neither force nor approach is given"));
}

TEST(SceneFile, a_patch_has_no_profiles) {
  EXPECT_THAT(refusal(patch + "[rail]\nprofile = '60E1'\n"),
              AllOf(StartsWith("scene.toml:"), HasSubstr("rail.profile = \"60E1\""),
                    HasSubstr("no meaning where kind is \"patch\"")));
}

TEST(SceneFile, a_wheel_on_a_rail) {
  const SceneFile f = parse_scene_file(rolling + R"(
    influence = "wheel.h5"
    structural = "included"
    [wheel.material]
    poisson = 0.3
    [position]
    lateral = 6.5
    rail_inclination = 0.025
    [load]
    approach = -0.1
    [motion]
    friction = 0.4
    phi = 1e-4
    [grid]
    dx = 0.4
    s_from = -40
    s_to = -20
    [solver]
    model = "fem"
    max_outer = 7)");
  EXPECT_EQ(f.wheel.influence, "wheel.h5");
  EXPECT_EQ(f.wheel.structural, StructuralCompliance::included);
  EXPECT_EQ(f.wheel.material.poisson, 0.3);
  EXPECT_EQ(f.rail.material, Material{});
  EXPECT_EQ(f.position.lateral, 6.5);
  EXPECT_EQ(f.position.rail_inclination, 0.025);
  EXPECT_TRUE(f.load.approach.has_value());
  EXPECT_FALSE(f.load.force.has_value());
  EXPECT_EQ(f.load.approach, -0.1);
  EXPECT_EQ(f.motion.friction, 0.4);
  EXPECT_EQ(f.motion.phi, 1e-4);
  EXPECT_EQ(f.grid.rows->from, -40);
  EXPECT_EQ(f.solver.model, Model::fem);
  EXPECT_EQ(f.solver.max_outer, 7);
}

TEST(SceneFile, a_patch) {
  const SceneFile f = parse_scene_file(patch + R"(
    [gap]
    a = 1e-3
    b = 2e-3
    [strip]
    radius = -10.2
    upper_radius = 10
    rail_s0 = 1
    [motion]
    frictionless = true
    friction = 0)");
  EXPECT_EQ(f.kind, SceneKind::patch);
  EXPECT_EQ(f.grid.mx, 20);
  EXPECT_EQ(f.gap.b, 2e-3);
  EXPECT_EQ(f.strip.radius, -10.2);
  EXPECT_EQ(f.strip.upper_radius, 10);
  EXPECT_EQ(f.strip.rail_s0, 1);
  EXPECT_TRUE(f.motion.frictionless);
}

TEST(SceneFile, each_body_has_G_or_E) {
  const SceneFile f = parse_scene_file(patch + "[rail.material]\nyoung = 210000\npoisson = 0.3\n"
                                               "[wheel.material]\nshear_modulus = 1000\n");
  EXPECT_NEAR(f.rail.material.shear_modulus, 210000 / 2.6, 1e-9);
  EXPECT_EQ(f.wheel.material.shear_modulus, 1000);
  EXPECT_THAT(refusal(patch + "[wheel.material]\nyoung = 2\nshear_modulus = 1\n"),
              HasSubstr("wheel.material.young = 2.0 (shear_modulus is given too)"));
}

TEST(SceneFile, exactly_one_load) {
  EXPECT_EQ(refusal(rolling), "scene.toml: load (neither force nor approach is given) "
                              "Give load.force or load.approach.");
  EXPECT_THAT(refusal(rolling + "[sweep]\nload.force = [1e4, 1e5]"), HasSubstr("is for bem_contact sweep"));
  EXPECT_EQ(refusal(rolling + "[load]\nforce = 1\napproach = 2"),
            "scene.toml:8: load.approach = 2.0 (load.force is given too) "
            "Give exactly one of load.force and load.approach.");
  EXPECT_THAT(refusal(rolling + "[load]\nforce = -5"),
              HasSubstr("load.force = -5.0 (out of range) Give a value > 0 N."));
  EXPECT_THAT(refusal(rolling + "[grid]\nelements = 12001"), HasSubstr("(out of range)"));
}

TEST(SceneFile, zero_friction_is_told_about_frictionless) {
  EXPECT_EQ(refusal(patch + "[motion]\nfriction = 0"),
            "scene.toml:8: motion.friction = 0.0 (zero friction leaves nothing to roll on) "
            "Set motion.frictionless = true for the normal problem alone, or give friction > 0.");
  EXPECT_THAT(refusal(patch + "[motion]\nfriction = -0.3"), HasSubstr("(out of range) Give a value >= 0."));
}

TEST(SceneFile, a_wheel_on_a_rail_needs_profiles) {
  EXPECT_THAT(refusal("[load]\nforce = 1"),
              HasSubstr("rail.profile (a wheel on a rail needs the rail's profile)"));
  EXPECT_THAT(refusal("[rail]\nprofile = '60E1'\n[load]\nforce = 1"), HasSubstr("needs the wheel's profile"));
}

TEST(SceneFile, a_patch_needs_its_grid) {
  EXPECT_THAT(refusal("kind = 'patch'\n[load]\nforce = 1"), HasSubstr("Give grid.mx >= 1."));
  EXPECT_THAT(refusal("kind = 'patch'\n[grid]\nmx = 3\n[load]\nforce = 1"), HasSubstr("Give grid.ms >= 1."));
  EXPECT_THAT(refusal("kind='patch'\n[grid]\nmx=2\nms=9\nplane_strain=true\n[load]\nforce=1"),
              HasSubstr("Give grid.mx = 1."));
}

TEST(SceneFile, what_excludes_each_other_is_not_given_together) {
  EXPECT_THAT(refusal(patch + "[gap]\na = 1\ntable = 'h.csv'"),
              HasSubstr("Give either the table or a, b and c."));
  EXPECT_THAT(refusal(patch + "[motion]\nxi = 1e-3\nslip_table = 'w.csv'"),
              HasSubstr("Give either the table or xi, eta and phi."));
  EXPECT_THAT(refusal(patch + "[strip]\nradius = 9\ninclination = 'd.csv'"),
              HasSubstr("Give either the table or the radius."));
  EXPECT_THAT(refusal("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1\ngrid.ms = "
                      "9\ngrid.s_from = -30\ngrid.s_to = -20\n"),
              HasSubstr("(grid.s_from and grid.s_to say where the rows begin and end) Leave out grid.ms"));
  EXPECT_THAT(refusal("kind='patch'\n[grid]\nmx=1\nms=9\nplane_strain=true\n[load]\nforce=1"),
              HasSubstr("(rolling and shifts need elements along x) Set motion.frictionless = true"));
}

const std::string wheel = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1\n";
const std::string flat = "kind = 'patch'\ngrid.mx = 20\ngrid.ms = 10\nload.force = 1000\n";

TEST(SceneFile, a_curve_needs_a_speed_and_superelevation_a_curve) {
  EXPECT_THAT(refusal(wheel + "track.curve_radius = 3e5\n"), HasSubstr("motion.speed, which is not given"));
  EXPECT_THAT(refusal(wheel + "motion.speed = 1e4\ntrack.superelevation = 100\n"),
              HasSubstr("(straight track has no outer rail, and track.curve_radius is not given)"));
  EXPECT_THAT(refusal(wheel + "motion.speed = 1e4\ntrack.curve_radius = 300\n"),
              HasSubstr("between the rails, which are 1500"));
  EXPECT_THAT(refusal(wheel + "motion.speed = 1e4\ntrack.curve_radius = 3e5\nmotion.kind = 'shift'\n"),
              HasSubstr("a shift does not roll through a curve"));
  EXPECT_THAT(refusal("kind = 'patch'\ntrack.curve_radius = 3e5\n"), HasSubstr("track.curve_radius"));
  const SceneFile f = parse_scene_file(wheel + "motion.speed = 1e4\ntrack.curve_radius = -3e5\n");
  EXPECT_EQ(f.track.curve_radius, -3e5);
  EXPECT_THAT(f.unused, IsEmpty());
}

TEST(SceneFile, rollers_and_flexible_wheels) {
  const std::string roller = wheel + "rail.roller_radius = 500\n";
  const SceneFile f = parse_scene_file(roller + "motion.speed = 1e4\nmotion.roller_speed = 20\n");
  EXPECT_EQ(f.position.roller_radius, 500);
  EXPECT_THAT(f.unused, IsEmpty());
  EXPECT_THAT(refusal(wheel + "motion.speed = 1e4\nmotion.roller_speed = 20\n"),
              HasSubstr("the rail is straight"));
  EXPECT_THAT(refusal(roller + "motion.roller_speed = 20\n"), HasSubstr("motion.speed is not given"));
  EXPECT_EQ(parse_scene_file(roller + "rail.influence = 'a.h5'\n").rail.influence, "a.h5");
  EXPECT_THAT(refusal(roller + "motion.speed = 1e4\ntrack.curve_radius = 3e5\n"), HasSubstr("has no curve"));
  EXPECT_THAT(refusal(wheel + "motion.wheel_yaw_rate = 1e-3\n"), HasSubstr("motion.speed is not given"));
  const std::string axle = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nwheelset.force = 2e5\n";
  EXPECT_EQ(parse_scene_file(axle + "rail.roller_radius = 500\n").position.roller_radius, 500);
  EXPECT_THAT(refusal(axle + "position.wheel_yaw = 1e-3\n"), HasSubstr("deviation of one wheel"));
}

TEST(SceneFile, uneven_wheels_and_rails) {
  const SceneFile f =
      parse_scene_file(wheel + "position.along = 12\nwheel.flat = { length = 60, depth = 0.9, angle = 0.1 }\n"
                               "wheel.polygon = { orders = [3, 20], amplitudes = [0.1, 0.02] }\n"
                               "rail.joint = { at = 5, gap = 8, dip = 2 }\n");
  EXPECT_EQ(f.position.uneven.flat.depth, 0.9);
  EXPECT_EQ(f.position.uneven.polygon.orders, (std::vector<double>{3, 20}));
  EXPECT_EQ(f.position.uneven.joint.gap, 8);
  EXPECT_EQ(f.position.uneven.along, 12);
  EXPECT_THAT(f.unused, IsEmpty());

  const std::string flat = wheel + "wheel.flat.length = 60\n";
  EXPECT_THAT(refusal(flat + "wheel.flat.depth = 1.5\n"), HasSubstr("a chord of 60 mm is 0.9793 mm deep"));
  EXPECT_THAT(refusal(flat + "wheel.flat.rounding = 40\n"), HasSubstr("the flat is 60 mm long"));
  EXPECT_THAT(refusal(wheel + "wheel.flat.angle = 1\n"), HasSubstr("neither length nor depth"));
  EXPECT_THAT(refusal(wheel + "wheel.flat.length = 500\n"), HasSubstr("the wheel's radius is 460 mm"));
  EXPECT_THAT(refusal(wheel + "wheel.polygon.orders = [3]\n"), HasSubstr("0 of them and 1 orders"));
  EXPECT_THAT(refusal(wheel + "wheel.polygon = { orders = [2.5], amplitudes = [0.1] }\n"),
              HasSubstr("2.5 waves do not close"));
  EXPECT_THAT(refusal(wheel + "wheel.polygon = { orders = [2], amplitudes = [0.1], phases = [0, 1] }\n"),
              HasSubstr("2 of them and 1 orders"));
  EXPECT_THAT(refusal(wheel + "rail.joint.at = 3\n"), HasSubstr("neither gap, step nor dip"));
  EXPECT_THAT(refusal(wheel + "rail.joint = { dip = 10, dip_length = 200 }\n"), HasSubstr("slope by 0.2"));
  for (const std::string other : {"solver.model = 'fem'\nrail.influence = 'a.h5'\nwheel.influence = 'b.h5'\n",
                                  "wheel.influence = 'b.h5'\n"})
    EXPECT_THAT(refusal(flat + other), AllOf(HasSubstr("wheel.flat ("), HasSubstr("of a round wheel")))
        << other;
  EXPECT_THAT(refusal(flat + "rail.roller_radius = 500\n"), HasSubstr("on a roller rig"));
  EXPECT_THAT(refusal(flat + "motion = { kind = 'transient', steps = 3 }\n"),
              HasSubstr("sweep position.along"));
}

TEST(SceneFile, wheels_of_sections) {
  const std::string own = "rail.profile = '60E1'\nload.force = 1e5\n",
                    two = own +
                          "wheel.sections = [ { at = 0, profile = 'S1002' }, { at = 3, profile = 'P8', kink "
                          "= true } ]\n";
  const SceneFile f = parse_scene_file(two + "position.along = 12\nwheel.sections_angle = 0.5\n");
  ASSERT_EQ(f.wheel.sections.size(), 2u);
  EXPECT_EQ(f.wheel.sections[1].at, 3);
  EXPECT_TRUE(f.wheel.sections[1].kink && f.wheel.reading.keep_origin && f.changes_along());
  EXPECT_EQ(f.position.uneven.sections_angle, 0.5);
  EXPECT_THAT(f.unused, IsEmpty());
  const SceneFile again = parse_scene_file(scene_with_defaults(f));
  EXPECT_EQ(again.wheel.sections, f.wheel.sections);
  EXPECT_EQ(again.wheel.profile, "S1002");
  EXPECT_THAT(refusal(two + "wheel.profile = 'S1002'\n"), HasSubstr("wheel.sections is given too"));
  EXPECT_THAT(refusal(two + "wheel.flat.depth = 0.5\n"), HasSubstr("wheel.flat is given too"));
  EXPECT_THAT(refusal("load.force = 1e5\nwheel.profile = 'a.slcw'\nrail.profile = 'b.SLCS'\n"),
              HasSubstr("Give sections of one of the two"));
  EXPECT_THAT(refusal(two + "solver.model = 'fem'\nrail.influence = 'a.h5'\nwheel.influence = 'b.h5'\n"),
              AllOf(HasSubstr("wheel.sections ("), HasSubstr("Choose solver.model")));
  EXPECT_THAT(refusal(two + "solver.model = 'simplified'\n"), HasSubstr("the wheel as round"));
}

TEST(SceneFile, rails_of_sections) {
  const std::string own = "wheel.profile = 'S1002'\nload.force = 1e5\n",
                    two = own +
                          "rail.sections = [ { at = 0, profile = '60E1' }, { at = 90, profile = '54E1', "
                          "features = [1, 2], without = [2] } ]\n";
  const SceneFile f = parse_scene_file(two + "position.along = 12\n");
  ASSERT_EQ(f.rail.sections.size(), 2u);
  EXPECT_EQ(f.rail.sections[1].at, 90);
  EXPECT_EQ(f.rail.sections[1].features, (std::vector<double>{1, 2}));
  EXPECT_EQ(f.rail.sections[1].without, (std::vector<double>{2}));
  EXPECT_TRUE(f.rail.reading.keep_origin);
  EXPECT_TRUE(f.changes_along());
  EXPECT_THAT(f.unused, IsEmpty());
  EXPECT_EQ(parse_scene_file(scene_with_defaults(f)).rail.sections, f.rail.sections);
  EXPECT_THAT(refusal(two + "rail.profile = '60E1'\n"), HasSubstr("rail.sections is given too"));
  EXPECT_THAT(refusal(two + "wheel.flat.length = 40\n"), HasSubstr("wheel.flat is given too"));
  EXPECT_THAT(refusal(two + "rail.roller_radius = 500\n"),
              AllOf(HasSubstr("rail.sections ("), HasSubstr("on a roller rig")));
  EXPECT_THAT(refusal(two + "motion = { kind = 'transient', steps = 3 }\n"),
              HasSubstr("sweep position.along"));
  EXPECT_THAT(refusal(two + "wheel.influence = 'b.h5'\n"), HasSubstr("no section has an influence file"));
  EXPECT_THAT(refusal(two + "solver.model = 'simplified'\n"), HasSubstr("simplified theory"));
  EXPECT_THAT(refusal(own + "rail.sections = [ { at = 0, profile = '60E1', without = [3] } ]\n"),
              HasSubstr("section 1 is without feature 3"));
  EXPECT_THAT(refusal(own + "rail.sections = [ { at = 0 } ]\n"), HasSubstr("rail.sections.profile"));
  EXPECT_THAT(refusal(own + "rail.profile = 'a.slcs'\nrail.joint.step = 1\n"),
              HasSubstr("rail.profile = \"a.slcs\" (rail.joint is given too"));
}

TEST(SceneFile, keys_without_effect_are_said) {
  const auto unused = [](const std::string& text) {
    std::vector<std::string> texts;
    for (const Warning& warning : parse_scene_file(text).unused)
      texts.push_back(warning.text);
    return texts;
  };
  const auto keys = [](const std::string& names) {
    return ElementsAre(StartsWith(names + ": without effect ("));
  };
  EXPECT_THAT(unused(default_scene_file()), IsEmpty());
  EXPECT_THAT(unused(wheel + "motion.xi = 1e-3\nmotion.speed = 2e4\nmotion.yaw_rate = 0.1\n"
                             "motion.rolling_radius = 460\nmotion.friction_table = 'mu.csv'\n"),
              IsEmpty());
  EXPECT_THAT(unused(flat + "motion.frictionless = true\nmotion.xi = 1e-3\nmotion.friction = 0.2\n"),
              ElementsAre("motion.friction, motion.xi: without effect (motion.frictionless = true leaves the "
                          "normal problem alone)"));
  EXPECT_THAT(unused(flat + "[sweep]\nmotion.xi = [1e-3, 2e-3]\n"),
              ElementsAre(StartsWith("[sweep]: one case is solved here")));
  EXPECT_THAT(unused(flat + "motion.frictionless = true\nmotion.slip_table = 'w.csv'\n"),
              keys("motion.slip_table"));
  EXPECT_THAT(unused(wheel + "motion.frictionless = true\nmotion.speed = 1e4\nmotion.pitch_rate = 20\n"),
              keys("motion.speed, motion.pitch_rate"));
  EXPECT_THAT(unused(flat + "motion.frictionless = true\nmotion.kind = 'shift'\n"), keys("motion.kind"));
  const std::string curve = "motion.speed = 1e4\ntrack.curve_radius = 3e5\n";
  EXPECT_THAT(unused(wheel + "motion.frictionless = true\n" + curve),
              keys("motion.speed, track.curve_radius"));
  EXPECT_THAT(unused(wheel + curve + "track.superelevation = 90\n"), keys("track.superelevation"));
  const std::string axle = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nwheelset.force = 2e5\n";
  EXPECT_THAT(unused(axle + "motion.frictionless = true\ntrack.superelevation = 90\n" + curve), IsEmpty());
  EXPECT_THAT(unused(flat + "motion.friction = 0.2\nmotion.friction_table = 'mu.csv'\n"),
              keys("motion.friction"));
  EXPECT_THAT(unused(wheel + "motion.kind = 'shift'\nmotion.rolling_radius = 460\n"),
              keys("motion.rolling_radius"));
  EXPECT_THAT(unused(wheel + "motion.speed = 1e4\n"), keys("motion.speed"));
  EXPECT_THAT(unused(wheel + "grid.dx = 0.4\ngrid.accuracy = 0.02\n"), keys("grid.dx"));
  EXPECT_THAT(unused(wheel + "grid.ds = 0.5\ngrid.elements = 200\n"), keys("grid.ds"));
  EXPECT_THAT(unused("kind = 'patch'\nload.force = 1\ngrid.mx = 1\ngrid.ms = 9\ngrid.dx = 0.1\ngap.a = 1\n"
                     "grid.plane_strain = true\nmotion.frictionless = true\n"),
              keys("grid.dx, gap.a"));
  EXPECT_THAT(unused(flat + "stresses.s = [1.0]\n"), keys("stresses.s"));
  EXPECT_THAT(unused(flat + "stresses.s = [1.0]\nstresses.depths = [1.0]\n"), IsEmpty());
  EXPECT_THAT(unused(wheel + "rail.structural = 'included'\n"), keys("rail.structural"));
  EXPECT_THAT(unused(wheel + "wheel.structural = 'included'\n"), keys("wheel.structural"));
  EXPECT_THAT(unused(wheel + "rail.influence = 'rail.h5'\n"), keys("rail.influence"));
  EXPECT_THAT(
      unused(wheel + "rail.influence = 'r.h5'\nwheel.influence = 'w.h5'\nrail.structural = 'included'\n"),
      IsEmpty());
  EXPECT_THAT(unused(flat + "strip.radius = 9\nstrip.wheel_s0 = 1\n"), keys("strip.wheel_s0"));
  EXPECT_THAT(unused(flat + "strip.radius = -9\nstrip.upper_radius = 8\ngap.table = 'h.csv'\n"),
              keys("strip.upper_radius"));
}

TEST(SceneFile, a_sweep_changes_what_has_an_effect) {
  const std::vector<SceneChange> changes{{"motion.frictionless", SchemaValue(true), 3}};
  EXPECT_THAT(parse_scene_file(flat + "motion.xi = 1e-3\n").unused, IsEmpty());
  EXPECT_THAT(parse_scene_file(flat + "motion.xi = 1e-3\n", changes).unused,
              ElementsAre(testing::Field(&Warning::text, StartsWith("motion.xi: without effect"))));
}

TEST(SceneFile, keys_of_the_other_kind_are_refused) {
  EXPECT_THAT(
      refusal(patch + "[position]\nlateral = 1"),
      StartsWith("scene.toml:8: position.lateral = 1.0 (the key has no meaning where kind is \"patch\""));
  EXPECT_THAT(refusal(rolling + "[load]\nforce = 1\n[gap]\na = 1"), HasSubstr("only where it is patch"));
}

TEST(SceneFile, geometry_that_cannot_be) {
  const std::string loaded = rolling + "[load]\nforce = 1\n";
  EXPECT_THAT(refusal(loaded + "[position]\nback_to_back = 1500"), HasSubstr("the gauge is only 1435 mm"));
  EXPECT_THAT(refusal(loaded + "[position]\ngauge = 1.435"),
              HasSubstr("position.gauge = 1.435 (the flange backs are 1360 mm apart)"));
  EXPECT_THAT(refusal(loaded + "[position]\ncant = 1.4"), HasSubstr("(out of range)"));
  EXPECT_THAT(refusal(loaded + "[position]\nyaw = 0.11"), HasSubstr("(out of range)"));
  EXPECT_THAT(refusal(loaded + "[position]\nvertical = 0.1"), HasSubstr("exactly one of"));
  for (const char* rate : {"pitch_rate", "lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate"}) {
    const std::string line = std::string(rate) + " = 0.1\n";
    EXPECT_THAT(refusal(loaded + "[motion]\n" + line),
                AllOf(HasSubstr(rate), HasSubstr("motion.speed is not given")));
    EXPECT_THAT(refusal(loaded + "[motion]\nspeed = 1e4\nkind = \"shift\"\n" + line),
                AllOf(HasSubstr(rate), HasSubstr("a shift has no velocities")));
  }
  EXPECT_THAT(refusal(loaded + "[motion]\nspeed = 1e4\npitch_rate = 20\nrolling_radius = 460"),
              HasSubstr("either the rolling radius or both"));
  EXPECT_THAT(refusal(loaded + "[position]\nside = \"lft\""), HasSubstr("left"));
  EXPECT_THAT(refusal(loaded + "[grid]\ns_from = -20\ns_to = -40"),
              HasSubstr("Give s_to greater than s_from"));
  EXPECT_THAT(refusal(loaded + "[position]\nlateral = nan"), HasSubstr("(the value must be finite)"));
}

TEST(SceneFile, fem_needs_an_influence_file) {
  EXPECT_THAT(refusal(patch + "[solver]\nmodel = 'fem'"),
              AllOf(HasSubstr("no influence file is given"), HasSubstr("model = \"halfspace\"")));
  EXPECT_THAT(refusal(patch + "[solver]\nmodel = 'half-space'"), HasSubstr("Did you mean \"halfspace\"?"));
}

TEST(SceneFile, nested_tables_are_known) {
  EXPECT_THAT(refusal("[rail.materiel]\npoisson = 0.3"), HasSubstr("Did you mean rail.material"));
  EXPECT_THAT(refusal("[rail.material]\npoison = 0.3"), HasSubstr("Did you mean rail.material.poisson"));
}

TEST(SceneFile, a_missing_file_is_named) {
  EXPECT_THAT(message_of([] { read_scene_file("no/such.toml"); }),
              StartsWith("scene file 'no/such.toml' cannot be read (there is no such file)"));
}

} // namespace
TEST(SceneFile, ListsOfNumbers) {
  const std::string patch = "kind = \"patch\"\nload.force = 1\n[grid]\nmx = 2\nms = 2\n[stresses]\n";
  EXPECT_THAT(parse_scene_file(patch + "depths = [0.5, 1]").stresses.depths, testing::ElementsAre(0.5, 1));
  EXPECT_THAT(parse_scene_file(patch + "x = []").stresses.x, testing::IsEmpty());
  const auto refusal = [&](const std::string& line) {
    try {
      parse_scene_file({patch + line, "scene.toml"});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  for (const char* key : {"x", "s"})
    EXPECT_THAT(refusal(std::string("depths = [1.0]\n") + key + " = []"),
                testing::HasSubstr(std::string("scene.toml:8: stresses.") + key +
                                   " = [] (stresses.depths are given"));
  EXPECT_THAT(refusal("depths = 2"),
              testing::HasSubstr("scene.toml:7: stresses.depths is a whole number (it must be of "
                                 "type: list of numbers)"));
  EXPECT_THAT(refusal("depths = [1, \"2\"]"), testing::HasSubstr("must be of type: list of numbers"));
  EXPECT_THAT(refusal("depths = [1, -2]"),
              testing::HasSubstr("[1.0, -2.0] (out of range) Give a value >= 1e-06"));
}

TEST(SceneFile, TheAccuracyIsOfTheQuantitiesNamed) {
  const std::string wheel = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n";
  EXPECT_THAT(parse_scene_file(wheel).grid.accuracy_of,
              ElementsAre(ErrorQuantity::forces, ErrorQuantity::pmax));
  EXPECT_THAT(parse_scene_file(wheel + "grid.accuracy = 0.01\ngrid.accuracy_of = 'area,  creepages'")
                  .grid.accuracy_of,
              ElementsAre(ErrorQuantity::area, ErrorQuantity::creepages));
  EXPECT_THROW(parse_scene_file(wheel + "grid.accuracy = 0.01\ngrid.accuracy_of = 'pressure'"), InputError);
  EXPECT_THROW(parse_scene_file(wheel + "grid.accuracy = 0.01\ngrid.accuracy_of = ''"), InputError);
  EXPECT_THAT(
      parse_scene_file(wheel + "solver.model_tolerance_of = 'pmax,friction_power'").solver.model_tolerance_of,
      ElementsAre(ErrorQuantity::pmax, ErrorQuantity::friction_power));
  EXPECT_THAT(refusal(wheel + "solver.model_tolerance_of = 'forces, pmx'"),
              AllOf(HasSubstr(":4: solver.model_tolerance_of = "), HasSubstr("'pmx' is unknown"),
                    HasSubstr("Did you mean \"pmax\"?")));
}

/// No scene depends on them, and what depends on one of them does not on the others.
TEST(SceneFile, TablesOfCommandsArePassedOver) {
  const std::string wheel = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n";
  const SceneFile plain = parse_scene_file(wheel);
  const std::string tables = "[conicity]\nto = 3 # mm\n[creep_curves]\nxi = 'auto'\n[wear]\ndepth = 0.2\n"
                             "speeds = [200]\npressures = [2000]\ncoefficients = [1e-4, 2e-4, 3e-4, 4e-4]\n";
  SceneFile with = parse_scene_file(wheel + tables);
  EXPECT_THAT(with.unused, IsEmpty());
  EXPECT_THAT(with.wear.speeds, ElementsAre(200));
  with.wear = {};
  EXPECT_EQ(scene_with_defaults(with), scene_with_defaults(plain));
  EXPECT_THAT(refusal(wheel + "[conicty]\nto = 3\n"), HasSubstr("Did you mean conicity"));

  const auto text = [&](const std::string& more) { return text_for({wheel + more}, {"conicity"}); };
  EXPECT_EQ(text(tables), text("conicity.to = 3"));
  EXPECT_NE(text(tables), text("conicity.to = 4"));
  EXPECT_NE(text(tables), text("conicity.to = 3\nmotion.xi = 1e-3"));
  EXPECT_EQ(text_for({wheel + "wear.depth = 1"}, {"wear"}, {"wear.depth"}),
            text_for({wheel + "wear.depth = 2"}, {"wear"}, {"wear.depth"}));
}

} // namespace bem_contact
