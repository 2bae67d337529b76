#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/wheel_datum.hpp"
#include "sampled.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace bem_contact {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Points = std::vector<Point2>;

/// A wheel as MiniProf has it: x from the flange's back to the field side, y down.
std::string miniprof_columns(double step = 0.5, double z = 0) {
  std::string text;
  Points points = sampled_curve(standard_profile("S1002"), step);
  for (auto p = points.rbegin(); p != points.rend(); ++p)
    text += fmt::format("{:.6f} {:.6f}\n", p->y + 70, p->z + z);
  return text;
}

double tip_of(const std::string& text, const ProfileReading& reading = {}, int part = 0) {
  const SaidWarnings warnings;
  const MeasuredProfile profile = parse_measured_profile(text, "p.whl", ProfileKind::wheel, reading, part);
  return flange_tip(sampled_curve(profile.curve, 0.05))->y;
}

TEST(OldMiniProf, TheHeaderEndsAtTheFirstEmptyLineAndItsNumbersAreNoPoints) {
  const std::string header =
      "#MINIWHEELPROF\nCar1_T(R).whl\nMINIPROF 2020\nStock.......:\n\" 32.58 37.11 14.71\n"
      "(Sd/Sh/qR)\n\n";
  EXPECT_NEAR(tip_of(header + miniprof_columns()), -55, 0.1);
}

TEST(OldMiniProf, MayBeginWithoutAHash) {
  const std::string header =
      "MINIPROF 101 148 1994 3 24\nown.prd\nStock.......: \nWheel ID....:\n 32.50 28.00 10.80  "
      "(Sd/Sh/qR)\n\n";
  EXPECT_NEAR(tip_of(header + miniprof_columns()), -55, 0.1);
}

TEST(MiniProfParts, OneOfTwoProfilesIsChosenByItsNumber) {
  const std::string columns = miniprof_columns(), lower = miniprof_columns(0.5, 3);
  const std::string two = "[FileInfo]\nProgramName=x\n\n[Profile1Info]\nColumnDef=X,Y\n[Profile1Points]\n" +
                          columns + "\n[Profile2Info]\nColumnDef=X,Y\n[Profile2Points]\n" + lower;
  const SaidWarnings warnings;
  EXPECT_THAT(message_of([&] { parse_measured_profile(two, "p.mpt", ProfileKind::wheel); }),
              testing::AllOf(HasSubstr("p.mpt holds 2 profiles"), HasSubstr("#1 for the first")));
  EXPECT_THAT(message_of([&] { parse_measured_profile(two, "p.mpt", ProfileKind::wheel, {}, 3); }),
              HasSubstr("p.mpt has no profile 3 (it holds 2)"));
  const auto height = [&](int part) {
    return parse_measured_profile(two, "p.mpt", ProfileKind::wheel, {}, part).curve.at(0).position.z;
  };
  EXPECT_NEAR(height(2) - height(1), 3, 1e-6);
}

TEST(MiniProfParts, AHeaderAfterPointsBeginsAnotherProfile) {
  const auto part = [](double z) {
    const std::string columns = miniprof_columns(0.5, z);
    const auto points = std::ranges::count(columns, '\n');
    return fmt::format("Stock=wheel\nColumnDef=X,Y\nXYPoints={}\n\n{}\n", points, columns);
  };
  const std::string two = part(0) + part(3);
  const SaidWarnings warnings;
  const auto height = [&](int number) {
    return parse_measured_profile(two, "p.mpt", ProfileKind::wheel, {}, number).curve.at(0).position.z;
  };
  EXPECT_NEAR(height(2) - height(1), 3, 1e-6);
  // Keys at the end of a file describe no profile.
  EXPECT_NEAR(tip_of(part(0) + "Remark=end\n"), -55, 0.1);
}

TEST(MiniProfParts, TheNumberStandsBehindTheFilesName) {
  const TemporaryFolder files;
  const std::filesystem::path folder = files.path();
  std::ofstream(folder / "two.mpt") << "[Profile1Info]\nColumnDef=X,Y\n[Profile1Points]\n"
                                    << miniprof_columns()
                                    << "[Profile2Info]\nColumnDef=X,Y\n[Profile2Points]\n"
                                    << miniprof_columns(0.5, 3);
  const SaidWarnings warnings;
  EXPECT_NEAR(named_profile("two.mpt#2", ProfileKind::wheel, folder).at(0).position.z, 3, 1e-5);
  EXPECT_THAT(message_of([&] { named_profile("three.mpt#2", ProfileKind::wheel, folder); }),
              HasSubstr("there is no file"));
}

TEST(PlainProfile, CommentsAndQuotesMayEndALine) {
  const SaidWarnings warnings;
  const std::string text = "-20 1 ! first\n-10 0.25 % here\n% a line\n\"0 0\"\n10 0.25 # x\n20 1 \"last\"\n";
  EXPECT_NEAR(parse_profile(text, "p.txt", ProfileKind::rail).nearest({10, 0.25}).position.z, 0.25, 1e-12);
  const std::string miniprof =
      "Stock=%T\nColumnDef=X,Y\nXYPoints=5\n\n-20 1 ! a\n-10 0.25 % b\n% c\n\"0 0\n10 0.25\"\n20 1\n";
  EXPECT_NEAR(parse_profile(miniprof, "p.ban", ProfileKind::rail).nearest({10, 0.25}).position.z, 0.25,
              1e-12);
}

/// Both wheels of a wheelset, or both rails of a track, about the track's centre.
std::string vampire(const char* first_line, const std::string& header, const Points& right, double z_sign) {
  std::string text = std::string(first_line) + "\na title 1 2 3\n" + header;
  for (const Point2 p : right)
    text += fmt::format("{:.6f}, {:.6f}, {:.6f}, {:.6f}\n", -p.y, z_sign * p.z, p.y, z_sign * p.z);
  return text;
}

TEST(Vampire, AWheelStandsByTheBackOfItsFlange) {
  Points points = sampled_curve(standard_profile("S1002"), 0.25);
  for (Point2& p : points)
    p.y += 680 + 70;
  const std::string text = vampire("WHEELPROFILE", "TREADDATUM EUROPEAN\nFLANGEBACK 1360\n", points, 1);
  EXPECT_NEAR(tip_of(text), -55, 0.1);
  EXPECT_NEAR(tip_of(text, {.mirror = true}), -55, 0.1);
  const SaidWarnings warnings;
  const ProfileCurve curve = parse_profile(text, "p.whe", ProfileKind::wheel);
  EXPECT_NEAR(curve.nearest({20, -1}).position.z, standard_profile("S1002").nearest({20, -1}).position.z,
              1e-3);
  EXPECT_THAT(warnings.text(), IsEmpty());
  EXPECT_THAT(message_of([&] { parse_profile(text, "p.whe", ProfileKind::rail); }),
              HasSubstr("no profile of a rail"));
  EXPECT_THAT(
      message_of([&] { parse_profile(vampire("WHEELPROFILE", "", points, 1), "p.whe", ProfileKind::wheel); }),
      HasSubstr("p.whe has no FLANGEBACK"));
}

TEST(Vampire, ARailHasZUpAndItsMiddleAtZero) {
  Points points = sampled_curve(standard_profile("60E1"), 0.5);
  for (Point2& p : points)
    p.y += 753.5;
  const SaidWarnings warnings;
  const ProfileCurve curve = parse_profile(
      vampire("RAILPROFILE", "GAUGEPOINT EUROPEAN\nGAUGE 1435\n", points, -1), "p.rai", ProfileKind::rail);
  EXPECT_THAT(warnings.text(), IsEmpty());
  EXPECT_NEAR(norm(curve.at(0).position), 0, 1e-3);
  EXPECT_GT(curve.at(0).curvature, 0);
  EXPECT_THAT(message_of([&] {
                parse_profile("RAILPROFILE\ntitle\nGAUGE 1435\n1 2 3\n", "p.rai", ProfileKind::rail);
              }),
              HasSubstr("p.rai:4: '1 2 3' is not a pair of points"));
}

} // namespace
} // namespace bem_contact
