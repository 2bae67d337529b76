#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "mesh_checks.hpp"
#include "meshes/graft.hpp"
#include "meshes/graft_fit.hpp"
#include "meshes/section_mesh.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "worn_profiles.hpp"

#include <gmock/gmock.h>

namespace bem_contact::meshes {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Graft : public testing::Test {
protected:
  /// A rail (or wheel) with a worn profile from a file.
  BodyFile worn(BodyKind kind, const char* standard, const Wear& wear, BodyFile::Strip strip) {
    write_worn(folder / "worn.txt", standard, wear);
    BodyFile body;
    body.folder = folder.path();
    body.body.kind = kind;
    body.body.profile = "worn.txt";
    body.strip = strip;
    return body;
  }
  std::string refusal(const BodyFile& body) {
    return message_of([&] { mesh_section(body); });
  }

  TemporaryFolder folder;
};

void expect_on_curve(const BodyFile& body, const QuadMesh& mesh) {
  const ProfileCurve curve = body_profile(body);
  for (const Point2 p : strip_vertices(mesh))
    EXPECT_LT(norm(curve.nearest(p).position - p), 1e-9);
}

double area_of(const BodyFile& body) {
  return area(make_section(body));
}

BodyFile standard_body(BodyKind kind, const char* profile, BodyFile::Strip strip) {
  BodyFile body;
  body.body.kind = kind;
  body.body.profile = profile;
  body.strip = strip;
  return body;
}

TEST_F(Graft, AnUnwornProfileGivesTheStandardBody) {
  const Wear none{.depth = 0, .noise = 0};
  EXPECT_NEAR(area_of(worn(BodyKind::rail, "60E1", none, {-45, -17, 0.25})),
              area_of(standard_body(BodyKind::rail, "60E1", {-45, -17, 0.25})),
              0.5); // rounder under the head
  EXPECT_NEAR(area_of(worn(BodyKind::wheel, "S1002", none, {20, 50, 0.25})),
              area_of(standard_body(BodyKind::wheel, "S1002", {20, 50, 0.25})), 2);
}

TEST_F(Graft, AWornGaugeCornerLacksWhatWasTaken) {
  const Wear wear{.depth = 1.2};
  BodyFile body = worn(BodyKind::rail, "60E1", wear, {-45, -17, 0.25});
  body.body.graft_at = Point2{};                             // where it lies is known
  const double taken = 1.2 * 8 * std::sqrt(std::acos(-1.0)); // and less of it where the surface is convex
  EXPECT_NEAR(area_of(body), area_of(standard_body(BodyKind::rail, "60E1", {-45, -17, 0.25})) - taken,
              0.08 * taken);
  const QuadMesh mesh = mesh_section(body);
  EXPECT_EQ(mesh.name, "rail worn.txt on 60E1");
  EXPECT_GE(quality(mesh).smallest, poor_quality);
  expect_on_curve(body, mesh);
  for (const auto& edge : edges_of(mesh, Group::held))
    EXPECT_NEAR(point(mesh, edge.vertices[0]).z, 172, 1e-9);
}

TEST_F(Graft, AWornFlangeOnTheWheel) {
  const BodyFile body = worn(BodyKind::wheel, "S1002", {.middle = 44, .depth = 1.5}, {25, 50, 0.25});
  const QuadMesh mesh = mesh_section(body);
  EXPECT_EQ(mesh.name, "wheel worn.txt on S1002 (representative rim, web and hub)");
  EXPECT_GE(quality(mesh).smallest, poor_quality);
  expect_on_curve(body, mesh);
}

TEST_F(Graft, AProfileThatEndsEarlyIsContinuedByTheStandard) {
  const BodyFile body =
      worn(BodyKind::rail, "54E1", {.depth = 0, .noise = 0, .cut_begin = 9, .cut_end = 4}, {-20, 20, 0.5});
  BodyFile on_54 = body;
  on_54.body.graft_onto = "54E1";
  EXPECT_NEAR(area_of(on_54), area_of(standard_body(BodyKind::rail, "54E1", {-20, 20, 0.5})), 0.3);
  EXPECT_EQ(make_section(on_54).name, "rail worn.txt on 54E1");
}

TEST_F(Graft, AStepAtTheJointIsBlendedSmoothly) {
  // The gauge side of the head is 1 mm narrower all the way down to where the measurement ends.
  const BodyFile body =
      worn(BodyKind::rail, "60E1", {.middle = -52, .width = 9, .depth = 1}, {-45, -17, 0.25});
  const Section section = make_section(body);
  const Loop& loop = section.loops.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Piece &a = loop[i], &b = loop[(i + 1) % loop.size()];
    EXPECT_LT(norm(b.begin() - a.end()), 1e-9) << i;
  }
  EXPECT_GE(quality(mesh_section(body)).smallest, poor_quality);
}

TEST_F(Graft, WhatDoesNotFitIsRefusedWithBothFigures) {
  BodyFile body = worn(BodyKind::rail, "60E1", {.depth = 0, .noise = 0, .cut_end = 20}, {-45, -17, 0.25});
  body.body.graft_at = {3, 0};
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("The profile worn.txt does not fit the body of 60E1"),
                                   HasSubstr("mm off it, inclined by"), HasSubstr("up to 2 mm and 0.7 rad"),
                                   HasSubstr("graft_at and graft_angle")));
  body.body.graft_at.reset();
  body.body.graft_angle = 0.3;
  EXPECT_THAT(refusal(body), HasSubstr("does not fit the body of 60E1"));
  body.body.graft_angle.reset();
  body.body.graft_onto = "46E3"; // 30 mm lower and narrower
  EXPECT_NE(refusal(body), "no error");
  body.body.graft_onto = "S1002";
  EXPECT_THAT(refusal(body), HasSubstr("A rail cannot be grafted onto 'S1002'"));
  body.body.graft_onto = "60E3";
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("cannot be grafted onto '60E3'"), HasSubstr("Use 60E1")));
}

TEST_F(Graft, AnInclinedMeasurementNeedsAnInclinedBody) {
  BodyFile body =
      worn(BodyKind::rail, "60E1", {.depth = 0.8, .angle = -0.025, .shift_z = 0.4}, {-45, -17, 0.25});
  body.body.graft_angle = -0.025;
  body.body.graft_at = {0, 0.4};
  BodyFile straight = worn(BodyKind::rail, "60E1", {.depth = 0.8}, {-45, -17, 0.25});
  straight.body.graft_at = Point2{}; // where it lies is known
  const double there = area_of(straight);
  write_worn(folder / "worn.txt", "60E1", {.depth = 0.8, .angle = -0.025, .shift_z = 0.4});
  EXPECT_NEAR(area_of(body), there, 1e-2);
}

/// Where the body of `base` is found on body's profile.
GraftPlace found(const BodyFile& body, const char* base) {
  return find_graft(body_profile(body), base);
}

TEST_F(Graft, TheBodyIsFoundOnTheUnwornPart) {
  for (const double angle : {0.0, 0.025, -0.05})
    for (const double depth : {0.0, 1.5, 4.0}) {
      const Wear wear{.depth = depth, .angle = angle, .shift_z = -6};
      const GraftPlace rail = found(worn(BodyKind::rail, "60E1", wear, {-45, -17, 0.25}), "60E1");
      EXPECT_NEAR(rail.place.angle, angle, 1e-4) << depth;
      EXPECT_LT(norm(rail.place.shift - Point2{0, -6}), 0.005)
          << depth; // noise of 3 um, wear that ends slowly
      EXPECT_GT(rail.share, 0.6);
      const Wear flange{.middle = 44, .depth = depth, .angle = angle, .shift_z = 3};
      const GraftPlace wheel = found(worn(BodyKind::wheel, "S1002", flange, {25, 50, 0.25}), "S1002");
      EXPECT_NEAR(wheel.place.angle, angle, 1e-4) << depth;
      EXPECT_LT(norm(wheel.place.shift - Point2{0, 3}), 0.005) << depth;
    }
}

TEST_F(Graft, AFoundPlaceIsSaidAndOneThatIsGivenStays) {
  BodyFile body =
      worn(BodyKind::rail, "60E1", {.depth = 0.8, .angle = -0.025, .shift_z = 4}, {-45, -17, 0.25});
  const Section automatic = make_section(body);
  EXPECT_THAT(automatic.note, AllOf(HasSubstr("body of 60E1 found at graft_at ="), HasSubstr("% of the")));
  body.body.graft_at = {0, 4};
  body.body.graft_angle = -0.025;
  const Section given = make_section(body);
  EXPECT_EQ(given.note, "");
  EXPECT_NEAR(area(automatic), area(given), 0.2);
  body.body.graft_at = Point2{};
  body.body.graft_angle = 0; // the keys are there, and zero
  EXPECT_THAT(refusal(body), HasSubstr("does not fit the body of 60E1"));
}

TEST_F(Graft, APlaceThatCannotBeToldIsRefused) {
  // The top alone, 24 mm of two arcs that meet smoothly: it slides.
  EXPECT_THAT(refusal(worn(BodyKind::rail, "60E1", {.depth = 0, .noise = 0, .cut_begin = 55, .cut_end = 55},
                           {-5, 5, 0.25})),
              AllOf(HasSubstr("no place for the body of 60E1 can be found"), HasSubstr("slides"),
                    HasSubstr("graft_at and graft_angle")));
  // Everything is worn.
  EXPECT_THAT(
      refusal(worn(BodyKind::rail, "60E1", {.middle = 0, .width = 25, .depth = 15}, {-45, -17, 0.25})),
      HasSubstr("% of it lie within 0.1 mm"));
}

TEST_F(Graft, AMissingProfileIsNamed) {
  BodyFile body;
  body.folder = folder.path();
  body.body.profile = "missing.ban";
  EXPECT_THAT(refusal(body),
              AllOf(HasSubstr("Unknown profile 'missing.ban'"), HasSubstr("there is no file")));
}

TEST_F(Graft, PublishedSampleFilesFit) {
  const auto sample = [](const char* name) {
    return std::filesystem::path(CONFORMAL_SOURCE_DIR) / ".." / "shared" / "data" / "profiles" / name;
  };
  if (!std::filesystem::exists(sample("MBench_S1002_v3.prw")))
    GTEST_SKIP() << "the sample files are not at hand";
  BodyFile wheel = standard_body(BodyKind::wheel, "S1002", {20, 50, 0.25});
  wheel.body.profile = sample("MBench_S1002_v3.prw").string();
  EXPECT_GE(quality(mesh_section(wheel)).smallest, poor_quality);
  BodyFile rail = standard_body(BodyKind::rail, "60E1", {-45, -17, 0.25});
  rail.body.profile = sample("MBench_UIC60_v3.ban").string();
  rail.strip = {-40, -12, 0.25};
  const NominalPlace place = found(rail, "60E1").place;
  EXPECT_NEAR(place.angle, -std::atan(1 / 40.0), 2e-3);
  EXPECT_GE(quality(mesh_section(rail)).smallest, poor_quality);
  rail.body.graft_at = Point2{};
  EXPECT_THAT(refusal(rail), HasSubstr("a measured rail is often inclined"));
  const double angle = -std::atan(1 / 40.0);
  rail.body.graft_angle = angle;
  rail.body.graft_at = -7.4917 * tangent_of(angle) - 0.0937 * normal_of(angle);
  EXPECT_LT(norm(place.shift - *rail.body.graft_at), 0.2);
  EXPECT_GE(quality(mesh_section(rail)).smallest, poor_quality);
}

} // namespace
} // namespace bem_contact::meshes
