#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/hard_cases/scene_outcome.hpp"
#include "tests/profile/warnings.hpp"

#include <fstream>
#include <map>
#include <unistd.h>

/// Scene files that a user should not have written: refused with the reason, or certified all the same.
namespace bem_contact {
namespace {

using Keys = std::map<std::string, std::string>;

/// `changes` over the keys of a small sound scene; an empty value takes the key out.
std::string scene(Keys keys, const Keys& changes) {
  for (const auto& [key, value] : changes)
    keys[key] = value;
  std::string text;
  for (const auto& [key, value] : keys)
    if (!value.empty())
      text += key + " = " + value + "\n";
  return text;
}

std::string patch(const Keys& changes) {
  return scene({{"kind", "\"patch\""},
                {"load.force", "1e3"},
                {"motion.xi", "1e-3"},
                {"grid.dx", "0.5"},
                {"grid.ds", "0.5"},
                {"grid.mx", "8"},
                {"grid.ms", "8"},
                {"gap.a", "1e-3"},
                {"gap.b", "1e-3"}},
               changes);
}

std::string wheel_rail(const Keys& changes) {
  return scene({{"rail.profile", "\"60E1\""},
                {"wheel.profile", "\"S1002\""},
                {"load.force", "1e5"},
                {"grid.dx", "1.0"},
                {"grid.ds", "0.5"}},
               changes);
}

struct Case {
  std::string name, text, expected; ///< part of the outcome; "certified"; "": either
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.text;
}

struct BadScenes : testing::TestWithParam<Case> {};

TEST_P(BadScenes, AreRefusedOrCertified) {
  EXPECT_THAT(hard::outcome(GetParam().text), testing::HasSubstr(GetParam().expected));
}

const Case cases[] = {
    {"huge_creepage", patch({{"motion.xi", "1e9"}}), "certified"},
    {"huge_spin", patch({{"motion.phi", "-1e9"}}), "certified"},
    {"creepage_at_the_end_of_doubles", patch({{"motion.eta", "1e300"}}), ""},
    {"huge_friction", patch({{"motion.friction", "1e300"}}), "certified"},
    {"tiny_friction", patch({{"motion.friction", "1e-30"}}), "certified"},
    {"huge_force", patch({{"load.force", "1e30"}}), "far beyond elastic contact"},
    {"force_at_the_end_of_doubles", patch({{"load.force", "1e300"}}), "far beyond elastic contact"},
    {"force_below_rounding_of_the_gap", patch({{"load.force", "1e-30"}}), "not converged: digits were lost"},
    {"huge_force_on_a_rail", wheel_rail({{"load.force", "1e30"}}), "far beyond elastic contact"},
    {"shear_force_beyond_friction", patch({{"load.force_x", "1e30"}}), "cannot be carried"},
    {"creepage_taken_back_by_no_force", patch({{"load.force_x", "0"}}), "certified"},
    {"elements_of_no_size", patch({{"grid.ds", "0"}}), "grid.ds = 0.0 (out of range)"},
    {"elements_of_negative_size", patch({{"grid.dx", "-1"}}), "grid.dx = -1.0 (out of range)"},
    {"tiny_elements", patch({{"grid.dx", "1e-300"}}), "out of range"},
    {"endless_elements", patch({{"grid.ds", "1e300"}}), "out of range"},
    {"slivers", patch({{"grid.dx", "1e-6"}}), ""},
    {"huge_grid", patch({{"grid.mx", "4096"}, {"grid.ms", "4096"}}), "is too large"},
    {"more_than_huge_grid", patch({{"grid.ms", "100000000"}}), "out of range"},
    {"tiny_elements_on_a_rail", wheel_rail({{"grid.dx", "1e-4"}}), "elements are too small"},
    {"rows_without_end", wheel_rail({{"grid.s_from", "-1e300"}, {"grid.s_to", "1e300"}}), "too small"},
    {"rows_beside_the_contact", wheel_rail({{"grid.s_from", "20"}, {"grid.s_to", "21"}}), "does not fit"},
    {"not_a_number", patch({{"motion.xi", "nan"}}), "must be finite"},
    {"infinite_force", patch({{"load.force", "inf"}}), "must be finite"},
    {"gap_without_bound", patch({{"gap.a", "-1e300"}}), "not converged"},
    {"bodies_that_overlap_everywhere", patch({{"gap.a", "-1e3"}, {"gap.b", "-1e3"}}), ""},
    {"tiny_radius", patch({{"strip.radius", "1e-9"}, {"strip.upper_radius", "1e-9"}}),
     "too long for its radius"},
    {"negative_radii", patch({{"strip.radius", "-10"}, {"strip.upper_radius", "-10"}}), ""},
    {"yaw_of_the_strip_beyond_a_quarter_turn", patch({{"strip.radius", "1"}}), "too long for its radius"},
    {"wheel_radius_1e-9", wheel_rail({{"position.wheel_radius", "1e-9"}}), "reaches beyond its axle"},
    {"wheel_radius_in_metres", wheel_rail({{"position.wheel_radius", "0.46"}}), "reaches beyond its axle"},
    {"yaw_of_90_degrees", wheel_rail({{"position.yaw", "1.5708"}}), "out of range"},
    {"bodies_that_overlap_by_5_mm", wheel_rail({{"load.force", ""}, {"position.vertical", "5.0"}}),
     "far beyond elastic contact"},
    {"bodies_that_overlap_by_a_tenth", wheel_rail({{"load.force", ""}, {"position.vertical", "0.1"}}),
     "certified"},
    {"flange_back_outside_the_rails", wheel_rail({{"position.back_to_back", "1600"}}), "the gauge is only"},
    {"flange_inside_the_rail", wheel_rail({{"position.lateral", "9.0"}}), "certified"},
    {"wheel_beside_its_tread", wheel_rail({{"position.lateral", "-70.0"}}), "touches the rail at the end"},
    {"upper_radius_on_a_flat_strip", patch({{"strip.upper_radius", "300"}}), "strip.radius is not given"},
    {"a_file_name_of_NUL", patch({{"gap.table", "\"\\u0000\""}}), "holds the character NUL"},
    {"wheel_radius_1e300", wheel_rail({{"position.wheel_radius", "1e300"}}), "("},
    {"wheel_beside_the_rail", wheel_rail({{"position.lateral", "1e300"}}), "never meets the rail"},
    {"wheel_at_the_end_of_its_profile", wheel_rail({{"position.roll", "0.1"}}),
     "touches the rail at the end"},
    {"roll_of_90_degrees", wheel_rail({{"position.roll", "1.5708"}}), "out of range"},
    {"soft_as_nothing", patch({{"rail.material.shear_modulus", "1e-300"}}), ""},
    {"incompressible", patch({{"rail.material.poisson", "0.5"}}), "out of range"},
    {"as_good_as_incompressible", patch({{"rail.material.poisson", "0.4999999999"}}), "certified"},
    {"bodies_apart", patch({{"load.force", ""}, {"load.approach", "-1"}}), "certified"},
    {"approach_through_the_wheel", wheel_rail({{"load.force", ""}, {"load.approach", "1e300"}}),
     "far beyond"},
    {"stresses_at_a_billion_points",
     patch({{"stresses.depths", "[1]"}, {"stresses.x", "[" + std::string(2'000'002, '1') + "]"}}), "("},
    {"stresses_far_away", patch({{"stresses.depths", "[1e300, 1e-300]"}, {"stresses.s", "[1e300]"}}),
     "out of range"},
    {"no_iterations", patch({{"solver.max_outer", "0"}}), "out of range"},
    {"unreachable_tolerance", patch({{"solver.tolerance", "1e-300"}}), "out of range"},
    {"hardest_tolerance", patch({{"solver.tolerance", "1e-13"}}), "certified"},
    {"history_beyond_memory",
     patch({{"motion.kind", "\"transient\""},
            {"motion.steps", "100000"},
            {"grid.mx", "50"},
            {"grid.ms", "50"}}),
     "the fields of all steps need about 12 GB"},
    {"text_for_a_number", patch({{"load.force", "\"much\""}}), "must be of type"},
    {"a_misspelt_key", patch({{"motion.frction", "0.3"}}), "motion.friction"},
};

INSTANTIATE_TEST_SUITE_P(HardCases, BadScenes, testing::ValuesIn(cases), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

struct BadTables : testing::Test {
  BadTables() { std::filesystem::create_directories(folder); }
  ~BadTables() override { std::filesystem::remove_all(folder); }
  std::string with_table(const std::string& key, const std::string& rows) const {
    std::ofstream(folder / "table.csv") << rows;
    return hard::outcome(patch({{key, "\"table.csv\""},
                                {"gap.a", key == "gap.table" ? "" : "1e-3"},
                                {"gap.b", key == "gap.table" ? "" : "1e-3"},
                                {"motion.xi", key == "motion.slip_table" ? "" : "1e-3"},
                                {"grid.mx", "3"},
                                {"grid.ms", "2"}}),
                         folder);
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("conformal_bad_tables_" + std::to_string(getpid()));
};

TEST_F(BadTables, OfGaps) {
  const std::string sound = "ix,is,h\n0,0,1e-3\n1,0,0\n2,0,1e-3\n0,1,1e-3\n1,1,0\n";
  EXPECT_EQ(with_table("gap.table", sound + "2,1,1e-3\n"), "certified");
  EXPECT_THAT(with_table("gap.table", sound), testing::HasSubstr("element (2, 1) is missing"));
  EXPECT_THAT(with_table("gap.table", sound + "2,1,nan\n"), testing::HasSubstr("not a finite number"));
  EXPECT_THAT(with_table("gap.table", sound + "2,1,1e999\n"), testing::HasSubstr("not a finite number"));
  EXPECT_THAT(with_table("gap.table", sound + "2,1\n"),
              testing::HasSubstr("it has 2 cells, and 3 columns have names"));
  EXPECT_THAT(with_table("gap.table", sound + "0,0,1\n"), testing::HasSubstr("given twice"));
  EXPECT_THAT(with_table("gap.table", sound + "1e300,1,1\n"), testing::HasSubstr("not one of it"));
  EXPECT_THAT(with_table("gap.table", sound + "2.5,1,1\n"), testing::HasSubstr("not one of it"));
  EXPECT_THAT(with_table("gap.table", "h,ix,is\n"), testing::HasSubstr("has other columns"));
  EXPECT_THAT(with_table("gap.table", ""), testing::HasSubstr("is empty"));
  EXPECT_EQ(with_table("gap.table", sound + "2,1,1e300\n"), "certified") << "a wall that is never reached";
  EXPECT_THAT(with_table("gap.table", sound + "2,1,-1e300\n"), testing::HasSubstr("not converged"));
}

/// A rail's profile with points missing: said, and solved where the curve through the others is the same.
TEST_F(BadTables, ProfilesWithHoles) {
  const auto with_hole = [&](double from, double to) {
    std::ofstream file(folder / "rail.txt");
    const ProfileCurve curve = standard_profile("60E1");
    for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.2)
      if (const Point2 p = curve.at(s).position; p.y < from || p.y > to)
        file << p.y << ' ' << p.z << '\n';
    file.close();
    const SaidWarnings warnings;
    EXPECT_EQ(hard::outcome(wheel_rail({{"rail.profile", "\"rail.txt\""}}), folder), "certified");
    return warnings.text();
  };
  EXPECT_EQ(with_hole(0, 0), "");
  EXPECT_EQ(with_hole(-2, 2), "") << "on the top, of radius 300 mm, nothing is lost";
  EXPECT_THAT(with_hole(-34, -20), testing::HasSubstr("its shape there is a guess"));
}

TEST_F(BadTables, OfInclinationsAndSlip) {
  EXPECT_EQ(with_table("strip.inclination", "is,delta\n0,-0.2\n1,0.2\n"), "certified");
  EXPECT_THAT(with_table("strip.inclination", "is,delta\n0,-0.2\n"), testing::HasSubstr("row 1 is missing"));
  with_table("strip.inclination", "is,delta\n0,-1e300\n1,1e300\n");
  with_table("strip.inclination", "is,delta\n0,3.2\n1,3.2\n"); // upside down: no force can press it down
  EXPECT_THAT(with_table("motion.slip_table", "ix,is,wx,ws\n0,0,1,1\n"), testing::HasSubstr("is missing"));
}

} // namespace
} // namespace bem_contact
