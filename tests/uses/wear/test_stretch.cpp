#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/sectioned_surface.hpp"
#include "bem_contact/uses/wear/evolution.hpp"
#include "bem_contact/uses/wear/study.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace {

using namespace bem_contact;
using namespace bem_contact::wear;
using ::testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

SweepFile sweep_on(const std::string& rail, const std::string& passage,
                   const std::filesystem::path& folder = {}) {
  return parse_sweep_file({"wheel.profile = 'S1002'\nsolver.model = 'halfspace'\nload.force = 8e4\n"
                           "position.rail_inclination = 0.025\ngrid = { dx = 1, ds = 0.5 }\n"
                           "motion = { xi = 2e-3, rolling_radius = 460, free_rolling = false }\n" +
                               rail + passage,
                           "stretch.toml", folder});
}

/// One step on these rails.
WornPair worn_by(const SweepFile& sweep, const EvolutionOptions& options = {}) {
  const TemporaryFolder folder;
  const std::vector<CollectiveCase> cases = collective_of(sweep, sweep.all(), "");
  validate(cases, options, 1);
  return wear_step(unworn(cases.front().scene), cases, options, 1, folder.path());
}

/// 1. By how much two lists differ, over the largest number of the first one.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, off = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::abs(a[i]));
    off = std::max(off, std::abs(a[i] - b[i]));
  }
  return off / largest;
}

/// Equal sections under an equal passage wear as the profile does, wherever the sections and the places lie.
TEST(Stretch, OfEqualSectionsWearsAsTheProfile) {
  const std::string three = "rail.sections = [ { at = 0, profile = '60E1' }, { at = 30, profile = '60E1' }, "
                            "{ at = 100, profile = '60E1' } ]\n";
  const WornPair one = worn_by(sweep_on("rail.profile = '60E1'\n", "[sweep]\nposition.lateral = [1]\n")),
                 many = worn_by(sweep_on(three, "[passage]\nfrom = 0\nto = 100\ncount = 6\n"
                                                "[sweep]\nposition.lateral = [1]\n"));
  ASSERT_EQ(many.sections.size(), 3u);
  EXPECT_NEAR(many.revolutions, one.revolutions, 1e-4 * one.revolutions);
  EXPECT_NEAR(many.rail.area, one.rail.area, 1e-4 * one.rail.area);
  EXPECT_LT(difference(one.wheel.depth, many.wheel.depth), 1e-4);
  for (const WornSection& section : many.sections)
    EXPECT_LT(difference(one.rail.depth, section.worn.depth), 1e-3) << section.at;
}

/// Head of 60E1, lower by `z`.
void write_head(const std::filesystem::path& file, double z) {
  std::ofstream out(file);
  for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.25))
    out << fmt::format("{:.12f} {:.12f}\n", p.position.y, p.position.z + z);
}

/// Half the distances to both neighbours, mm.
std::vector<double> lengths(const std::vector<WornSection>& sections) {
  std::vector<double> out(sections.size(), 0.0);
  for (std::size_t i = 0; i + 1 < sections.size(); ++i)
    for (const std::size_t k : {i, i + 1})
      out[k] += 0.5 * (sections[i + 1].at - sections[i].at);
  return out;
}

/// What leaves the sections, each for its length, is what the contacts take, each for its own; and a hump
/// wears where it is.
TEST(Stretch, KeepsTheVolume) {
  const TemporaryFolder folder;
  std::string rail = "rail.profile_z = 'down'\nrail.unit = 'mm'\nrail.place = 'absolute'\nrail.y = 753\n"
                     "rail.sections = [ ";
  for (const auto& [at, z] : {std::pair{0, 0.0}, {40, 0.05}, {90, 0.0}, {130, 0.02}, {200, 0.0}}) {
    write_head(folder.path() / fmt::format("{}.txt", at), z);
    rail += fmt::format("{}{{ at = {}, profile = '{}.txt' }}", at ? ", " : "", at, at);
  }
  const SweepFile sweep = sweep_on(rail + " ]\n",
                                   "[passage]\nfrom = 0\nto = 200\nstep = 25\n"
                                   "[sweep]\nload.force = [ 5e4, 8e4 ]\n",
                                   folder.path());
  const WornPair worn = worn_by(sweep, {.passages = 3});
  ASSERT_EQ(worn.sections.size(), 5u);
  const std::vector<double> length = lengths(worn.sections);
  double volume = 0;
  for (std::size_t i = 0; i < length.size(); ++i)
    volume += worn.sections[i].worn.area * length[i];
  EXPECT_NEAR(volume / 200, worn.rail.area, 1e-9 * worn.rail.area);
  EXPECT_NEAR(worn.rail.area, 3 * worn.wheel.area, 1e-9 * worn.rail.area);
  for (const WornSection& section : worn.sections)
    EXPECT_GT(section.worn.area, 0.5 * worn.rail.area) << section.at;
}

/// Where a part of the rail begins within the stretch, the sections that have it get all that wears there,
/// for the length over which it is there.
TEST(Stretch, KeepsTheVolumeWhereANoseBegins) {
  const ProfileCurve head = named_profile("60E1", ProfileKind::rail);
  const double a = head.s_begin(), c = head.s_end(), b = 0.5 * (a + c);
  std::vector<WornSection> sections;
  std::vector<BodySection> of_surface;
  for (const double at : {0.0, 50.0, 120.0}) {
    of_surface.push_back({at, head, {at == 0 ? none : a, b, c}});
    WornSection& section = sections.emplace_back();
    section.at = at;
    section.worn.points = points_of(head);
    section.worn.depth.assign(section.worn.points.size(), 0.0);
  }
  const auto surface = std::make_shared<const SectionedSurface>(of_surface);
  SectionDepths depths(sections, {surface});
  const double t = 0.5 * surface->lines()[1]; // on what begins at 50 mm
  const DepthOverS row{{0}, {0.01}, 0.5};
  depths.add(row, {{60}, {0}, {t}}, {35, 60, 90, 1, 1}, 2, 1);
  const double taken = 2 * row.area() * 0.5 * (90 - 35); // mm^3
  const std::vector<Depths>& of = depths.of_sections();
  EXPECT_EQ(of[0].area(), 0);
  EXPECT_GT(of[1].area(), of[2].area());
  EXPECT_NEAR((of[1].area() + of[2].area()) * 35, taken, 1e-9 * taken);
  // Beyond its end as well: the wheel touches 5 mm before it is there.
  depths.add(row, {{45}, {0}, {t}}, {40, 45, 49, 1, 1}, 1, 1);
  EXPECT_EQ(of[0].area(), 0);
  const double more = taken + row.area() * 0.5 * (49 - 40);
  EXPECT_NEAR((of[1].area() + of[2].area()) * 35, more, 1e-9 * more);
}

/// Feature lines stay on their material, and what a section does not have stays away.
TEST(Stretch, KeepsItsFeatureLines) {
  const ProfileCurve head = named_profile("60E1", ProfileKind::rail);
  const double s = head.s_begin() + 20.03;
  const std::string two = fmt::format(
      "rail.sections = [ {{ at = 0, profile = '60E1', features = [{0}, {1}, {2}] }}, {{ at = 100, "
      "profile = '60E1', features = [{0}, {1}], without = [3], kink = true }} ]\n",
      head.s_begin(), s, head.s_end());
  std::vector<WornSection> sections = unworn_sections(
      parse_scene_file({"wheel.profile = 'S1002'\nload.force = 1e4\n" + two, "features.toml"}));
  ASSERT_EQ(sections.size(), 2u);
  const SceneFile::Section before = section_in_scene(sections[1], "b.txt");
  EXPECT_EQ(before.without, std::vector{3.0});
  EXPECT_TRUE(before.kink);
  ASSERT_EQ(before.features.size(), 2u);
  EXPECT_NEAR(before.features[1] - before.features[0], 20.03, 1e-3);
  for (Point2& p : sections[1].worn.points)
    p = 1.01 * p;
  const SceneFile::Section after = section_in_scene(sections[1], "b.txt");
  EXPECT_NEAR(after.features[1] - after.features[0], 1.01 * 20.03, 1e-3);
}

TEST(Stretch, SaysWhatItCannotWear) {
  const std::string two =
      "rail.sections = [ { at = 0, profile = '60E1' }, { at = 100, profile = '60E1' } ]\n";
  const auto message = [](const std::string& rail, const std::string& passage) {
    return message_of([&] { study_of(sweep_on(rail, passage), "", {}); });
  };
  EXPECT_THAT(message(two, "[sweep]\nposition.lateral = [0, 1]\n"), HasSubstr("no passage along the track"));
  EXPECT_THAT(message(two, "[sweep]\nmode = 'zip'\nposition.along = [0, 50, 100]\nweight = [1, 2, 1]\n"),
              HasSubstr("several weights"));
  EXPECT_THAT(message(two, "[sweep]\nposition.along = [0, 50, 50]\n"), HasSubstr("twice at 50 mm"));
  EXPECT_THAT(message_of([&] {
                unworn_sections(parse_scene_file(
                    {"wheel.profile = 'S1002'\nload.force = 1e4\nrail.sections = [ { at = 0, profile = "
                     "'60E1', body = 'a' }, { at "
                     "= 0, profile = '60E1', body = 'b' }, { at = 100, profile = '60E1', body = 'b' } ]\n",
                     "bodies.toml"}));
              }),
              HasSubstr("Body 'a' of the rail cannot wear place by place"));
}

} // namespace
