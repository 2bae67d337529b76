// Finite elements on a rail of sections: influence files of some of them, blended between.
#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/halfspace/strip_kernel.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

namespace section_influence_tests {

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string files = CONFORMAL_SOURCE_DIR "/data/influence/";
const std::string rail_file = files + "small_rail.h5";

/// S1002 at the gauge corner, by finite elements unless `more` names another model.
SceneFile scene_of(const std::string& rail, const std::string& more = "motion.frictionless = true\n") {
  return parse_scene_file(fmt::format(
      "wheel = {{ profile = 'S1002', influence = '{}small_wheel.h5' }}\nload.force = 1e5\n"
      "grid = {{ dx = 1.0, ds = 0.5 }}\n{}{}{}",
      files, more.find("solver") == std::string::npos ? "solver.model = 'fem'\n" : "", more, rail));
}

SceneResult solved(const SceneFile& scene) {
  SceneResult out = Sequence().solve(scene);
  EXPECT_TRUE(certified(out));
  return out;
}

/// 60E1 at 0, 100 and 400 mm, each with a file; the wheel stands at `along`.
std::string three_sections(double along, const std::string& first = rail_file,
                           const std::string& second = rail_file, const std::string& third = rail_file) {
  return fmt::format("position = {{ lateral = 6.6, along = {} }}\n"
                     "rail.sections = [ {{ at = 0, profile = '60E1', influence = '{}' }},\n"
                     "{{ at = 100, profile = '60E1', influence = '{}' }},\n"
                     "{{ at = 400, profile = '60E1', influence = '{}' }} ]\n",
                     along, first, second, third);
}

const std::string prismatic =
    fmt::format("position.lateral = 6.6\nrail = {{ profile = '60E1', influence = '{}' }}\n", rail_file);

double number(const SceneResult& r, const char* name) {
  return quantity(name).value(r);
}

/// The same rail as if it were thin: its strip yields to pressure as a whole, over 60 mm, by `factor` of what
/// the middle of it yields to its own.
std::string softer(const TemporaryFolder& folder, const char* name, double factor) {
  InfluenceFunction f = read_influence_file(rail_file);
  const std::size_t stations = f.station_count(), n = 3 * (stations / 2) + 2;
  for (std::size_t k = 0; k < f.wavenumber_count(); ++k) {
    const double share = factor * std::exp(-std::pow(60 * f.wavenumber[k], 2));
    const double more = share * f.kernel[f.kernel_index(0, n, n)];
    for (std::size_t row = 0; row < stations; ++row)
      for (std::size_t column = 0; column <= row; ++column)
        f.kernel[f.kernel_index(k, 3 * row + 2, 3 * column + 2)] += more;
  }
  const std::string out = folder / name;
  write_influence_file(out, f);
  return out;
}

/// Files that are all equal are the rail that is the same all along. The surface through the sections is
/// within 1e-9 mm of the profile, which the pressure of so conformal a contact feels by 6e-9.
TEST(SectionInfluence, OfEqualFilesIsThatOfThePrismaticRail) {
  for (const auto& [motion, tolerance] : {std::pair{"motion.frictionless = true\n", 1e-8},
                                          {"motion = { friction = 0.3, xi = 5e-4 }\n", 1e-7}}) {
    const SceneResult one = solved(scene_of(prismatic, motion));
    for (const double along : {0.0, 30.0, 250.0}) {
      const SceneResult blended = solved(scene_of(three_sections(along), motion));
      EXPECT_EQ(blended.choice.model, Model::fem);
      for (const char* name : {"pmax", "area", "Fx", "Fy", "Fz", "approach"})
        EXPECT_NEAR(number(blended, name), number(one, name), tolerance * (1 + std::abs(number(one, name))))
            << name << " at " << along;
      // Nothing changes along the track, so that blending adds nothing to the stated errors.
      EXPECT_NEAR(blended.result.totals.pmax.error, one.result.totals.pmax.error,
                  1e-6 * one.result.totals.pmax.error);
    }
  }
}

/// Half way between two bodies lies what is between their answers, and the stated errors know how far apart
/// these are.
TEST(SectionInfluence, HalfWayBetweenTwoBodiesLiesBetweenTheirAnswers) {
  const TemporaryFolder folder;
  const std::string soft = softer(folder, "soft.h5", 0.03);
  const auto at = [&](double along) {
    return solved(scene_of(three_sections(along, rail_file, soft, soft)));
  };
  const SceneResult hard = at(0), middle = at(50), yielding = at(100);
  const double change = number(yielding, "approach") - number(hard, "approach");
  EXPECT_GT(change, 0.02 * number(hard, "approach"));
  const double share = (number(middle, "approach") - number(hard, "approach")) / change;
  EXPECT_NEAR(share, 0.5, 0.05);
  const double quarter = number(at(25), "approach");
  EXPECT_NEAR((quarter - number(hard, "approach")) / change, 0.25, 0.05);
  // Half of the contact's length over 100 mm, and w (1 - w).
  const double length = 18, bend = 0.25;
  EXPECT_NEAR(middle.result.totals.approach.error - hard.result.totals.approach.error, bend * change,
              0.1 * change);
  EXPECT_GT(hard.result.totals.approach.error,
            solved(scene_of(prismatic)).result.totals.approach.error + 0.4 * length / 100 * change);
  for (const PatchSummary& patch : middle.result.patches)
    EXPECT_TRUE(patch.pmax.error > 0);
}

/// A rail that is much softer 20 mm further on is no prism over a contact that is as long.
TEST(SectionInfluence, RefusesASectionThatChangesTooMuchWithinTheContact) {
  const TemporaryFolder folder;
  const std::string soft = softer(folder, "soft.h5", 2);
  std::string near = three_sections(10, rail_file, soft, soft);
  near.replace(near.find("at = 100"), 8, "at = 20");
  const std::string why = message_of([&] { Sequence().solve(scene_of(near)); });
  EXPECT_THAT(why, AllOf(HasSubstr("changes too much within the contact"), HasSubstr("would change by"),
                         HasSubstr("10 % are allowed")));
}

TEST(SectionInfluence, BeyondTheLastFileIsRefusedAndAutoTakesAnotherModel) {
  std::string beyond = three_sections(200);
  beyond.replace(beyond.find(fmt::format("60E1', influence = '{}' }} ]", rail_file)),
                 fmt::format("60E1', influence = '{}' }} ]", rail_file).size(), "60E1' } ]");
  EXPECT_THAT(message_of([&] { Sequence().solve(scene_of(beyond)); }),
              AllOf(HasSubstr("not between sections of the rail that have influence files"),
                    HasSubstr("at 200 mm along the track"), HasSubstr("from 0 to 100 mm")));
  const std::string by_choice = "motion.frictionless = true\nsolver.model_tolerance = 1e-6\n"
                                "solver.model_tolerance_of = ['pmax']\n";
  const SceneResult other = solved(scene_of(beyond, by_choice));
  EXPECT_NE(other.choice.model, Model::fem);
  EXPECT_THAT(other.choice.why_this_model, HasSubstr("the influence files do not cover this contact"));
  EXPECT_EQ(solved(scene_of(three_sections(200), by_choice)).choice.model, Model::fem);
}

TEST(SectionInfluence, AStripThatDoesNotCoverTheContactIsRefusedWithThePlace) {
  const TemporaryFolder folder;
  InfluenceFile whole(rail_file);
  const int stations = static_cast<int>(whole.strip().station_count());
  const InfluenceFunction part = whole.around({0, stations / 3});
  const std::string cut = folder / "short.h5";
  write_influence_file(cut, part);
  EXPECT_THAT(message_of([&] { Sequence().solve(scene_of(three_sections(50, rail_file, cut, rail_file))); }),
              AllOf(HasSubstr("the section at 100 mm along the track"), HasSubstr("strip")));
}

/// Bodies beside each other have files of their own: a rail that is cut beside the contact is the rail.
TEST(SectionInfluence, OfBodiesBesideEachOtherIsThatOfEach) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, double from, double to) {
    std::ofstream out(folder.path() / fmt::format("{}.txt", name));
    for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.25))
      if (p.position.y >= from && p.position.y <= to)
        out << fmt::format("{:.12f} {:.12f}\n", p.position.y, p.position.z);
    out.close();
    ProfileReading reading;
    reading.keep_origin = true;
    reading.unit = ProfileUnit::mm;
    reading.profile_z = ProfileZ::down;
    const ProfileCurve curve =
        named_profile(fmt::format("{}.txt", name), ProfileKind::rail, folder.path(), reading);
    InfluenceFunction f = read_influence_file(rail_file);
    f.profile = curve.name();
    f.profile_digest = curve.digest();
    write_influence_file(folder / fmt::format("{}.h5", name), f);
  };
  write("whole", -100, 100);
  write("gauge", -100, 18);
  write("field", 20, 100);
  const auto on = [&](const std::string& rail) {
    SceneFile scene = scene_of("rail.profile_z = 'down'\nrail.unit = 'mm'\nrail.place = 'absolute'\n"
                               "rail.y = 753.5\nposition.lateral = 6.55\n" +
                               rail);
    scene.folder = folder.path();
    return solved(scene);
  };
  const SceneResult whole = on("rail.profile = 'whole.txt'\nrail.influence = 'whole.h5'\n"),
                    cut = on("rail.sections = [ { at = 0, profile = 'field.txt', body = 'field', influence = "
                             "'field.h5' }, { at = 0, profile = 'gauge.txt', body = 'gauge', influence = "
                             "'gauge.h5' } ]\n");
  for (const char* name : {"pmax", "area", "Fy", "Fz", "approach"})
    EXPECT_NEAR(number(cut, name), number(whole, name), 1e-6 * (1 + std::abs(number(whole, name)))) << name;
  EXPECT_EQ(cut.patch_places.at(0).body, 2);
}

/// Two heads that both bear the wheel, with the influence functions of half-spaces in their files: as by
/// half-space theory, but for what the two rails would feel of each other if they were one.
TEST(SectionInfluence, OfTwoBodiesThatBothBearTheWheelIsTheirs) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, ProfileKind kind, const ProfileCurve& curve, double middle,
                         int stations) {
    InfluenceFunction f = halfspace_function(Material{}, stations, 1.0, 0.8, 300, 3);
    f.profile = curve.name();
    f.profile_digest = curve.digest();
    for (Station& station : f.stations) {
      const CurvePoint p = curve.at(station.s + middle);
      station = {p.s, p.position, p.delta};
    }
    f.body = name_of(kind);
    write_influence_file(folder / fmt::format("{}.h5", name), f);
  };
  const auto write_head = [&](const char* name, double middle, double s) {
    std::ofstream out(folder.path() / fmt::format("{}.txt", name));
    for (int i = -48; i <= 48; ++i)
      out << fmt::format("{:.12f} {:.12f}\n", middle + 0.25 * i, 60 - std::sqrt(60 * 60 - 0.0625 * i * i));
    out.close();
    ProfileReading reading;
    reading.keep_origin = true;
    reading.unit = ProfileUnit::mm;
    reading.profile_z = ProfileZ::down;
    write(name, ProfileKind::rail,
          named_profile(fmt::format("{}.txt", name), ProfileKind::rail, folder.path(), reading), s, 24);
  };
  write_head("inner", -3, -2.75);
  write_head("outer", 32, 12.2);
  write("wheel", ProfileKind::wheel, named_profile("S1002", ProfileKind::wheel), -18, 68);
  const auto by = [&](const std::string& model, double inner, double outer, bool files_too = false) {
    const auto file = [&](const char* name) {
      return files_too ? fmt::format(", influence = '{}.h5'", name) : "";
    };
    SceneFile scene = parse_scene_file(fmt::format(
        "wheel.profile = 'S1002'\nrail.profile_z = 'down'\nrail.unit = 'mm'\nrail.place = 'absolute'\n"
        "rail.y = 753\nload.force = 20000\nmotion.frictionless = true\ngrid = {{ dx = 0.8, ds = 0.5 }}\n"
        "solver.model = '{}'\n{}rail.bodies = [ {{ name = 'inner', lowered = {} }}, {{ name = 'outer', "
        "lowered = {} }} ]\n"
        "rail.sections = [ {{ at = 0, profile = 'inner.txt', body = 'inner'{} }}, "
        "{{ at = 0, profile = 'outer.txt', body = 'outer'{} }} ]\n",
        model, files_too ? "wheel.influence = 'wheel.h5'\n" : "", inner, outer, file("inner"),
        file("outer")));
    scene.folder = folder.path();
    return solved(scene);
  };
  // Lowered by this the inner one bears about half.
  const double gap = number(by("halfspace", 30, 0), "vertical") - number(by("halfspace", 0, 30), "vertical");
  const SceneResult half = by("halfspace", gap, 0), own = by("fem", gap, 0, true);
  ASSERT_EQ(half.result.patches.size(), 2u);
  ASSERT_EQ(own.result.patches.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(own.patch_places[k].body, half.patch_places[k].body);
    EXPECT_NEAR(own.result.patches[k].fn, half.result.patches[k].fn, 0.02 * half.result.patches[k].fn);
    EXPECT_NEAR(own.result.patches[k].pmax, half.result.patches[k].pmax, 0.02 * half.result.patches[k].pmax);
  }
}

TEST(SectionInfluence, RefusesWhatDoesNotFit) {
  const auto why = [](const std::string& rail) {
    return message_of([&] { Sequence().solve(scene_of(rail)); });
  };
  const std::string good = three_sections(50);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string out = good;
    out.replace(out.find(from), from.size(), to);
    return out;
  };
  EXPECT_THAT(why(good + fmt::format("rail.influence = '{}'\n", rail_file)),
              AllOf(HasSubstr("rail.influence"), HasSubstr("the same all along the track")));
  EXPECT_THAT(why(good + "rail.structural = 'included'\n"), HasSubstr("rail.structural"));
  EXPECT_THAT(why(changed("at = 100, profile = '60E1'", "at = 100, profile = '54E1'")),
              AllOf(HasSubstr("the section at 100 mm along the track"), HasSubstr("54E1"),
                    HasSubstr("do not belong to the profile")));
  EXPECT_THAT(why("position = { lateral = 6.6, along = 50 }\nrail.sections = [ { at = 0, profile = '60E1', "
                  "influence = '" +
                  rail_file + "' }, { at = 100, profile = '60E1' } ]\n"),
              HasSubstr("1 of the 2 sections of the rail have influence files"));
  EXPECT_THAT(message_of([&] { parse_scene_file("wheel.profile = 'S1002'\nload.force = 1e5\n" + good); }),
              HasSubstr("the wheel has none"));
  EXPECT_THAT(why("position = { lateral = 6.6, along = 50 }\nrail.sections = [ { at = 0, profile = '60E1' }, "
                  "{ at = 100, profile = '60E1' } ]\n"),
              HasSubstr("no section has an influence file"));
}

/// What check says of a place.
TEST(SectionInfluence, CheckNamesTheSectionsOfTheFiles) {
  std::string all;
  for (const std::string& line : Sequence().check(scene_of(three_sections(150))).lines)
    all += line + "\n";
  EXPECT_THAT(all, AllOf(HasSubstr("the section at 100 mm along the track, strip"),
                         HasSubstr("the section at 400 mm along the track, strip"), HasSubstr("covered")));
}

} // namespace

} // namespace section_influence_tests
