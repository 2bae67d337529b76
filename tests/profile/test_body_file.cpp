#include "bem_contact/profile/bodies/body_file.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string body_refusal(const std::string& toml) {
  return message_of([&] { parse_body_file(toml, "body.toml"); });
}

TEST(BodyFile, an_empty_file_is_the_default_one) {
  const BodyFile empty = parse_body_file(""), defaults;
  EXPECT_EQ(empty.body.kind, BodyKind::rail);
  EXPECT_EQ(empty.body.profile, defaults.body.profile);
  EXPECT_EQ(empty.material, defaults.material);
  EXPECT_EQ(empty.strip.from, defaults.strip.from);
  EXPECT_EQ(empty.harmonic.degree, defaults.harmonic.degree);
}

TEST(BodyFile, a_wheel_has_the_strip_of_a_wheel) {
  const BodyFile wheel = parse_body_file("[body]\nkind = \"wheel\"");
  EXPECT_EQ(wheel.strip.from, 20);
  EXPECT_EQ(wheel.strip.to, 50);
  EXPECT_EQ(parse_body_file("[body]\nkind = \"wheel\"\n[strip]\nto = 48").strip.to, 48);
}

TEST(BodyFile, a_strip_on_the_field_side_is_warned_of) {
  const auto warnings = [](const char* toml) { return body_warnings(parse_body_file(toml)); };
  EXPECT_TRUE(warnings("").empty());
  EXPECT_TRUE(warnings("[body]\nkind = \"wheel\"").empty());
  EXPECT_TRUE(warnings("[strip]\nfrom = -10\nto = 10").empty()) << "the top of the rail";
  const std::vector<std::string> rail = warnings("[strip]\nfrom = 20\nto = 45");
  ASSERT_EQ(rail.size(), 1u);
  EXPECT_THAT(rail[0], AllOf(HasSubstr("strip of this rail (20 .. 45 mm)"), HasSubstr("-45 .. -20 mm")));
  EXPECT_EQ(warnings("[body]\nkind = \"wheel\"\n[strip]\nfrom = -45\nto = -20").size(), 1u);
}

TEST(BodyFile, the_tolerance_chooses_what_is_not_given) {
  const BodyFile defaults, usual = parse_body_file("tolerance = 1e-3");
  EXPECT_EQ(usual.harmonic.degree, defaults.harmonic.degree);
  EXPECT_EQ(usual.harmonic.border_levels, defaults.harmonic.border_levels);
  EXPECT_EQ(usual.harmonic.samples_per_decade, defaults.harmonic.samples_per_decade);
  EXPECT_EQ(usual.mesh.elements_per_station, defaults.mesh.elements_per_station);
  const BodyFile coarse = parse_body_file("tolerance = 1e-2"), fine = parse_body_file("tolerance = 1e-4");
  EXPECT_LT(coarse.harmonic.border_levels, usual.harmonic.border_levels);
  EXPECT_LT(coarse.harmonic.samples_per_decade, usual.harmonic.samples_per_decade);
  EXPECT_GT(fine.harmonic.border_levels, usual.harmonic.border_levels);
  EXPECT_GT(fine.harmonic.samples_per_decade, usual.harmonic.samples_per_decade);
  EXPECT_GT(fine.harmonic.degree, usual.harmonic.degree);
  // What is given stays, and the rest makes up for it.
  const BodyFile given = parse_body_file("tolerance = 1e-3\n[mesh]\nelements_per_station = 4\n"
                                         "[harmonic]\ndegree = 2\nsamples_per_decade = 9");
  EXPECT_EQ(given.harmonic.degree, 2);
  EXPECT_EQ(given.harmonic.samples_per_decade, 9);
  EXPECT_EQ(given.mesh.elements_per_station, 4);
  EXPECT_EQ(given.harmonic.border_levels, 4); // 16 times less by the elements, 5 times more by the degree
  EXPECT_THAT(body_refusal("tolerance = 0.1"), HasSubstr("tolerance"));
}

TEST(BodyFile, the_digest_of_a_mesh_sees_what_the_mesh_depends_on) {
  const auto digest = [](const char* toml, std::uint64_t profile = 1) {
    return mesh_digest(parse_body_file(toml), profile);
  };
  const std::string usual = digest("");
  EXPECT_EQ(usual.size(), 16u);
  EXPECT_EQ(digest("[material]\npoisson = 0.3\n[harmonic]\ndegree = 2"), usual);
  EXPECT_NE(digest("", 2), usual);
  EXPECT_NE(digest("[body]\nprofile = \"60E2\""), usual);
  EXPECT_NE(digest("[strip]\nto = -25"), usual);
  EXPECT_NE(digest("[mesh]\ngrading = 0.2"), usual);
}

TEST(BodyFile, the_printed_schema_is_a_valid_file_with_the_defaults) {
  const BodyFile printed = parse_body_file(default_body_file()), defaults;
  EXPECT_EQ(printed.strip.to, defaults.strip.to);
  EXPECT_EQ(printed.strip.station_width, defaults.strip.station_width);
  EXPECT_EQ(printed.harmonic.half_period, defaults.harmonic.half_period);
  EXPECT_EQ(printed.mesh.largest, defaults.mesh.largest);
}

TEST(BodyFile, the_printed_schema_says_type_unit_range_and_default) {
  EXPECT_THAT(default_body_file(),
              HasSubstr("# Width of a station; it must divide the strip (number; mm; > 0; default 0.2)\n"
                        "station_width = 0.2\n"));
  EXPECT_THAT(default_body_file(), HasSubstr("(number; >= 0 and < 0.5; default 0.28)"));
}

TEST(BodyFile, every_key_is_read) {
  const BodyFile f = parse_body_file(R"(
    [body]
    kind = "bore"
    radius = 12
    size = 80.5
    [material]
    shear_modulus = 70000
    poisson = 0.3
    [strip]
    from = -6
    to = 6
    station_width = 0.25
    [mesh]
    elements_per_station = 3
    grading = 0.2
    largest = 9
    [harmonic]
    degree = 2
    half_period = 400
    shortest_dx = 0.3
    samples_per_decade = 9
    remote_distance = 30)");
  EXPECT_EQ(f.body.kind, BodyKind::bore);
  EXPECT_EQ(f.body.radius, 12);
  EXPECT_EQ(f.body.size, 80.5);
  EXPECT_EQ(f.material, (Material{70000, 0.3}));
  EXPECT_EQ(f.strip.from, -6);
  EXPECT_EQ(f.strip.to, 6);
  EXPECT_EQ(f.strip.station_width, 0.25);
  EXPECT_EQ(f.mesh.elements_per_station, 3);
  EXPECT_EQ(f.mesh.grading, 0.2);
  EXPECT_EQ(f.mesh.largest, 9);
  EXPECT_EQ(f.harmonic.degree, 2);
  EXPECT_EQ(f.harmonic.half_period, 400);
  EXPECT_EQ(f.harmonic.shortest_dx, 0.3);
  EXPECT_EQ(f.harmonic.samples_per_decade, 9);
  EXPECT_EQ(f.harmonic.remote_distance, 30);
}

TEST(BodyFile, a_wheel_is_an_S1002_unless_said) {
  EXPECT_EQ(parse_body_file("body.kind = 'wheel'").body.profile, "S1002");
  EXPECT_EQ(parse_body_file("body.kind = 'wheel'\nbody.profile = 'worn.prw'").body.profile, "worn.prw");
}

TEST(BodyFile, every_misspelt_key_is_answered_with_the_right_one) {
  std::istringstream lines(default_body_file());
  std::string line, table;
  int tried = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with("["))
      table = line.substr(1, line.find(']') - 1);
    const auto equals = line.find(" = ");
    if (line.starts_with("#") || equals == std::string::npos || equals < 3)
      continue;
    const std::string key = line.substr(0, equals);
    std::string wrong = key;
    std::swap(wrong[1], wrong[2]);
    if (wrong == key)
      wrong.erase(1, 1);
    const std::string header = table.empty() ? "\n" : "[" + table + "]\n",
                      path = table.empty() ? "" : table + ".";
    EXPECT_THAT(body_refusal(header + wrong + " = 1"),
                AllOf(StartsWith("body.toml:2: unknown key '" + path + wrong + "' ("),
                      HasSubstr("Did you mean " + path + key)));
    ++tried;
  }
  EXPECT_GE(tried, 12);
}

TEST(BodyFile, unknown_tables_and_misplaced_keys) {
  EXPECT_EQ(
      body_refusal("\n[strp]\nfrom = 1"),
      "body.toml:2: unknown table 'strp' (a body file has no such table) Did you mean strip or stress?");
  EXPECT_THAT(body_refusal("[mesh]\npoisson = 0.3"), HasSubstr("Did you mean material.poisson?"));
  EXPECT_THAT(body_refusal("qqqqqqqq = 1"), HasSubstr("See --print-default"));
  EXPECT_THAT(body_refusal("strip = 3"),
              StartsWith("body.toml:1: strip is a whole number (it is the name of a table)"));
  EXPECT_THAT(body_refusal("[strip.from]\nx = 1"),
              HasSubstr("strip.from is a table (it must be of type: number)"));
}

TEST(BodyFile, wrong_types_ranges_and_values_name_line_and_key) {
  EXPECT_EQ(body_refusal("[strip]\nfrom = 'a'"), "body.toml:2: strip.from is text (it must be of type: "
                                                 "number, in mm) Correct it, for instance from = -45.0.");
  EXPECT_THAT(body_refusal("[mesh]\nelements_per_station = 2.5"),
              HasSubstr("(it must be of type: whole number)"));
  EXPECT_THAT(body_refusal("[mesh]\nelements_per_station = 99999999999"), HasSubstr("(out of range)"));
  EXPECT_EQ(body_refusal("[strip]\nfrom = nan"),
            "body.toml:2: strip.from = nan (the value must be finite) Give a number.");
  EXPECT_THAT(body_refusal("[strip]\nto = inf"), HasSubstr("strip.to = inf (the value must be finite)"));
  EXPECT_EQ(body_refusal("[material]\npoisson = 0.5"),
            "body.toml:2: material.poisson = 0.5 (out of range) Give a value >= 0 and < 0.5. It is: "
            "Poisson's ratio.");
  EXPECT_EQ(body_refusal("[material]\nshear_modulus = 0"),
            "body.toml:2: material.shear_modulus = 0.0 (out of range) Give a value > 0 MPa. It is: G; give "
            "either this or young.");
  EXPECT_THAT(body_refusal("[body]\nkind = 'weel'"),
              AllOf(HasSubstr("(known are rail, wheel, block, disc, bore, outline)"),
                    HasSubstr("Did you mean \"wheel\"?")));
}

TEST(BodyFile, sizes_and_numbers_of_a_mesh_are_positive) {
  EXPECT_THAT(body_refusal("[body]\nkind = 'disc'\nradius = nan"),
              StartsWith("body.toml:3: body.radius = nan (the value must be finite)"));
  EXPECT_THAT(body_refusal("[body]\nkind = 'block'\nsize = -1"),
              StartsWith("body.toml:3: body.size = -1.0 (out of range) Give a value > 0 mm."));
  for (const char* line :
       {"strip.station_width = 0", "mesh.elements_per_station = 0", "mesh.grading = -0.1", "mesh.largest = 0",
        "harmonic.half_period = 0", "harmonic.shortest_dx = 0", "harmonic.samples_per_decade = 0"})
    EXPECT_THAT(body_refusal(line), AllOf(StartsWith(std::string("body.toml:1: ") + line),
                                          HasSubstr("(out of range) Give a value ")));
}

TEST(BodyFile, what_is_not_toml_names_the_line) {
  EXPECT_THAT(body_refusal("[strip]\nfrom = = 3"),
              AllOf(StartsWith("body.toml:2: "), HasSubstr("(the file is not valid TOML)")));
  EXPECT_THAT(body_refusal("[strip]\nfrom = 1\nfrom = 2"), StartsWith("body.toml:3: "));
}

TEST(BodyFile, the_station_width_divides_the_strip) {
  EXPECT_THAT(
      body_refusal("[strip]\nfrom = -10\nto = 0\nstation_width = 0.3"),
      AllOf(StartsWith("body.toml:4: strip.station_width = 0.3 (it does not divide the strip of 10 mm"),
            HasSubstr("Use 0.303030303 for 33 stations")));
  EXPECT_NO_THROW(parse_body_file("[strip]\nfrom = -10\nto = 0\nstation_width = 0.303030303"));
  EXPECT_THAT(body_refusal("[strip]\nstation_width = 0.001"), HasSubstr("25000 stations"));
  EXPECT_THAT(body_refusal("[strip]\nfrom = 10"), HasSubstr("Give strip.to greater than strip.from."));
  EXPECT_THAT(body_refusal("[strip]\nfrom = -5\nto = -5"),
              AllOf(StartsWith("body.toml:3: strip.to"), HasSubstr("the strip runs from -5 to -5 mm")));
  EXPECT_THAT(body_refusal("[strip]\nto = nan"), HasSubstr("strip.to = nan (the value must be finite)"));
}

TEST(BodyFile, the_strip_lies_on_the_body) {
  EXPECT_THAT(
      body_refusal("[body]\nkind='disc'\nradius=10\n[strip]\nfrom=-16\nto=10\nstation_width=1"),
      AllOf(StartsWith("body.toml:5: strip.from = -16.0"), HasSubstr("runs from -15.708 to 15.708 mm")));
  EXPECT_THAT(body_refusal("[body]\nkind='block'\nsize=5\n[strip]\nfrom=-4\nto=6\nstation_width=1"),
              StartsWith("body.toml:6: strip.to = 6.0"));
  EXPECT_THAT(body_refusal("[body]\nkind='bore'\nsize=5\nradius=6\n[strip]\nfrom=-4\nto=4"),
              HasSubstr("does not fit into the block"));
  EXPECT_THAT(body_refusal("[body]\nkind='bore'\nsize=10\nradius=10\n[strip]\nfrom=-5\nto=5"),
              StartsWith("body.toml:3: body.size = 10.0 (the bore of radius 10 mm does not fit into"));
}

TEST(BodyFile, a_roller_has_its_axle_below) {
  const BodyFile straight = parse_body_file("[body]\nkind='rail'"),
                 roller = parse_body_file("[body]\nkind='rail'\nroller_radius=500"),
                 outline = parse_body_file("[body]\nkind='outline'\nreference_radius=-50");
  EXPECT_EQ(reference_radius_of(straight), 0);
  EXPECT_EQ(reference_radius_of(roller), -500);
  EXPECT_EQ(reference_radius_of(outline), -50);
  EXPECT_NEAR(half_period_of(roller), std::numbers::pi * 500, 1e-9);
  EXPECT_NEAR(half_period_of(outline), std::numbers::pi * 50, 1e-9);
  EXPECT_NE(mesh_digest(straight, 1), mesh_digest(roller, 1));
  EXPECT_THAT(body_refusal("[body]\nkind='rail'\nroller_radius=-500"),
              StartsWith("body.toml:3: body.roller_radius = -500.0 (out of range)"));
  EXPECT_THAT(body_refusal("[body]\nkind='wheel'\nroller_radius=500"), HasSubstr("only where it is rail"));
}

TEST(BodyFile, a_key_of_another_kind_of_body_is_refused) {
  EXPECT_THAT(
      body_refusal("[body]\nkind = 'disc'\nprofile = '60E1'"),
      StartsWith("body.toml:3: body.profile = \"60E1\" (the key has no meaning where body.kind is \"disc\""));
}

TEST(BodyFile, the_material_is_given_by_G_or_by_E) {
  const Material by_E = parse_body_file("[material]\nyoung = 210000\npoisson = 0.3").material;
  EXPECT_NEAR(by_E.shear_modulus, 210000 / 2.6, 1e-9);
  EXPECT_EQ(by_E.poisson, 0.3);
  EXPECT_NEAR(parse_body_file("material.young = 209920").material.shear_modulus, 82000, 1e-9);
  EXPECT_EQ(
      body_refusal("[material]\nshear_modulus = 80000\nyoung = 210000"),
      "body.toml:3: material.young = 210000.0 (shear_modulus is given too) Give exactly one of the two.");
  EXPECT_THAT(body_refusal("[material]\nyoung = -1"), HasSubstr("(out of range)"));
  EXPECT_THAT(default_body_file(), HasSubstr("\n# young = 209920.0\n"));
}

TEST(BodyFile, a_body_is_held_where_its_kind_can_be) {
  EXPECT_EQ(parse_body_file("body.held = 'web'").body.held, "web");
  EXPECT_EQ(parse_body_file("body.kind = 'wheel'\nbody.held = 'rim'").body.held, "rim");
  EXPECT_EQ(
      body_refusal("[body]\nkind = 'rail'\nheld = 'bore'"),
      "body.toml:3: body.held = \"bore\" (a rail is held at its foot or its web) Use \"foot\" or \"web\".");
  EXPECT_THAT(body_refusal("[body]\nkind = 'block'\nheld = 'foot'"), HasSubstr("Use \"base\" or \"sides\"."));
  EXPECT_THAT(body_refusal("[body]\nkind = 'disc'\nheld = 'bore'"), HasSubstr("the key has no meaning"));
}

TEST(BodyFile, files_are_read_and_missing_ones_named) {
  const TemporaryFolder folder;
  const auto path = folder / "body.toml";
  std::ofstream(path) << "[strip]\nfrom = -30\n";
  const BodyFile file = read_body_file(path);
  EXPECT_EQ(file.strip.from, -30);
  EXPECT_EQ(file.folder, path.parent_path());
  std::filesystem::remove(path);
  EXPECT_THAT(message_of([&] { read_body_file(path); }), HasSubstr("(there is no such file)"));
  EXPECT_THAT(message_of([&] { read_body_file(testing::TempDir()); }), HasSubstr("(it is a folder)"));
}

} // namespace
} // namespace bem_contact
