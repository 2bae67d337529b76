#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/nominal_place.hpp"
#include "tests/app/run_program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

class ProfileCommand : public ProgramTest {};

/// The depth is that along the normal, on the flank too, where a difference of heights would be ten times it.
TEST_F(ProfileCommand, LaysAStandardOnTheUnwornPartOfAFile) {
  const ProfileCurve upright = standard_profile("60E1");
  const NominalPlace in_track{{-7, 0.2}, -0.025};
  const auto worn = [](double s) { return 0.5 * std::exp(-std::pow((s + 42) / 5, 2)); };
  std::string points;
  for (double s = upright.s_begin(); s <= upright.s_end(); s += 0.25) {
    const CurvePoint p = upright.at(s);
    const Point2 q = in_track.to_measured(p.position + worn(s) * normal_of(p.delta));
    points += fmt::format("{:.6f} {:.6f}\n", q.y, q.z);
  }
  const std::string file = write("rail.txt", points).string(), table = (folder_ / "p.csv").string();
  const Outcome r = run("profile 60E1 --on '" + file + "' --csv '" + table + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("turned by -1.43"));
  std::ifstream in(table);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "s_mm,y_mm,z_mm,inclination_rad,curvature_per_mm,depth_mm");
  int rows = 0;
  while (std::getline(in, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    double s = 0, y = 0, z = 0, delta = 0, curvature = 0, depth = 0;
    words >> s >> y >> z >> delta >> curvature >> depth;
    if (!words || s < upright.s_begin() + 1 || s > upright.s_end() - 1)
      continue;
    ++rows;
    EXPECT_LT(norm(Point2{y, z} - in_track.to_measured(upright.at(s).position)), 5e-3) << s;
    EXPECT_NEAR(depth, worn(s), 5e-3) << s;
  }
  EXPECT_GT(rows, 1000);
  const Outcome other = run("profile '" + file + "' --kind rail --on '" + file + "'");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("only a standard profile is laid on a measured one"));
}

TEST_F(ProfileCommand, ListsTheStandards) {
  const Outcome all = run("profile --list");
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("60E1            rail   EN 13674-1:2017; also UIC60\n"));
  EXPECT_EQ(std::ranges::count(all.out, '\n'), static_cast<long>(standard_entries().size()));
  EXPECT_EQ(run("profile --list 'uic 60'").out, "60E1\n");
  const Outcome unknown = run("profile --list UIC61");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("Did you mean UIC60"));
  EXPECT_THAT(run("profile 'S1002 h28 e30.5 10%'").out, HasSubstr("Profile of a wheel: S1002 h28 e30.5 10%"));
  const Outcome none = run("profile");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("give --list"));
}

/// EN 15313's numbers, in the text and for programs; and a mirrored rail that leans outwards.
TEST_F(ProfileCommand, GaugesWheelsAndRails) {
  EXPECT_THAT(run("profile S1002").out, HasSubstr("flange: Sh 28.00 mm, Sd 32.50 mm, qR 10.79 mm"));
  const auto j = nlohmann::json::parse(run("profile S1002 --json --step 5").out);
  EXPECT_NEAR(j["flange"]["Sd"].get<double>(), 32.5, 1e-3);
  EXPECT_TRUE(j["wear"].is_null());
  const ProfileCurve upright = standard_profile("60E1");
  const NominalPlace in_track{{0, 0}, -0.025};
  std::string points;
  for (double s = upright.s_begin(); s <= upright.s_end(); s += 0.25) {
    const CurvePoint p = upright.at(s);
    const Point2 q = in_track.to_measured(p.position + std::exp(-std::pow(s / 12, 2)) * normal_of(p.delta));
    points += fmt::format("{:.6f} {:.6f}\n", q.y, q.z);
  }
  const std::string file = write("rail.ban", points).string();
  EXPECT_THAT(run("profile '" + file + "'").out, HasSubstr("wear: W1 1.00 mm, W2 0.00 mm"));
  EXPECT_THAT(run("profile '" + file + "' --mirror").out, HasSubstr("leans away from the track's centre"));
  const std::string old = "MINIPROF 101 148\nown.prd\n 32.50 28.00 10.80  (Sd/Sh/qR)\n\n" + points;
  EXPECT_EQ(run("profile '" + write("old.ban", old).string() + "'").code, 0);
}

/// Worn on top and inclined.
TEST_F(ProfileCommand, SaysThatAWornRailIsInclined) {
  const ProfileCurve upright = standard_profile("54E1");
  const NominalPlace in_track{{-5, 0}, -0.05};
  std::string points;
  for (double s = upright.s_begin(); s <= upright.s_end(); s += 0.25) {
    const CurvePoint p = upright.at(s);
    const Point2 q =
        in_track.to_measured(p.position + 0.3 * std::exp(-std::pow(s / 10, 2)) * normal_of(p.delta));
    points += fmt::format("{:.6f} {:.6f}\n", q.y, q.z);
  }
  const Outcome r = run("profile '" + write("rail.txt", points).string() + "' --kind rail");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("inclined: turned by -2.8"));
  EXPECT_THAT(
      r.out,
      HasSubstr("(about 1:20): the file is already inclined; give position.rail_inclination = 0 with it"));
}

/// A body file says whether it is a rail or a wheel.
TEST_F(ProfileCommand, TakesTheKindOfABody) {
  for (const char* kind : {"rail", "wheel"}) {
    const std::string body =
        write(std::string(kind) + ".toml", "[body]\nkind = \"" + std::string(kind) + "\"\nprofile = \"" +
                                               (kind[0] == 'r' ? "60E1" : "S1002") +
                                               "\"\n[strip]\nfrom = -5\nto = 5\nstation_width = 0.5\n")
            .string();
    const Outcome r = run("profile '" + body + "'");
    EXPECT_EQ(r.code, 0) << r.err;
  }
}

/// A scene names its sections in a list or by a slices file; the words in it decide nothing.
TEST_F(ProfileCommand, SaysAlongWhichLinesSectionsAreJoined) {
  const std::string slices = " 0 1 S_OFFSET, S_SCALE\n 2 NSLC\n 0 0 0 NFEAT\n 1\n 0 '60E1'\n 100 '60E1'\n",
                    load = "wheel.profile = 'S1002'\nload.force = 1e5\n";
  write("even.SLCS", slices);
  const std::string by_file = write("a.toml", "rail.profile = 'even.SLCS'\n" + load).string(),
                    by_list = write("b.toml", "[[rail.sections]]\nat = 0\nprofile = '60E1'\n"
                                              "[[rail.sections]]\nat = 100\nprofile = '60E1'\n"
                                              "[wheel]\nprofile = 'S1002'\n[load]\nforce = 1e5\n")
                                  .string();
  const std::string table = (folder_ / "lines.csv").string();
  for (const std::string& file : {by_file, by_list, (folder_ / "even.SLCS").string()}) {
    const Outcome r = run("profile '" + file + "' --csv '" + table + "'");
    ASSERT_EQ(r.code, 0) << file << r.err;
    EXPECT_THAT(r.out, HasSubstr("the sections of a rail")) << file;
    std::ostringstream lines;
    lines << std::ifstream(table).rdbuf();
    EXPECT_THAT(lines.str(), HasSubstr("body,t,line,section,u,y,z\n1,0,1,1,0,")) << file;
    EXPECT_EQ(run("profile '" + file + "' --json").code, 2) << file;
    EXPECT_THAT(run("profile '" + file + "' --csv /dev/stdout").out,
                HasSubstr("body,t,line,section,u,y,z\n"));
  }
  write("own.slcs", " 0 1\n 2\n 0\n 1\n 0 'lines.csv'\n 100 '60E1'\n"); // what it names is no output
  const std::string by_own = write("d.toml", "rail.profile = 'own.slcs'\n" + load).string();
  EXPECT_THAT(run("profile '" + by_own + "' --csv '" + table + "'").err, HasSubstr("would overwrite"));
  const std::string page = (folder_ / "lines.html").string();
  ASSERT_EQ(run("profile '" + by_list + "' --plot '" + page + "'").code, 0);
  std::ostringstream drawn;
  drawn << std::ifstream(page).rdbuf();
  EXPECT_THAT(drawn.str(), HasSubstr("\"section_lines\""));
  EXPECT_THAT(run("check '" + by_list + "'").out, HasSubstr("line at t ="));
  const Outcome other =
      run("profile '" + write("c.toml", "# no sections\nrail.profile = '60E1'\n" + load).string() + "'");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("if it is a scene, solve it first"));
}

} // namespace
