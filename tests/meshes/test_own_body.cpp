#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "mesh_checks.hpp"
#include "meshes/section_mesh.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace bem_contact::meshes {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using std::numbers::pi;

/// A block 40 wide and 20 high, its top the contact surface, with holes.
BodyFile block(std::vector<BodyFile::Hole> holes) {
  BodyFile file;
  file.body.kind = BodyKind::outline;
  file.body.name = "plate";
  file.body.outline = {
      {{-20, 0}}, {{20, 0}, 0, PieceGroup::contact}, {{20, 20}}, {{-20, 20}, 0, PieceGroup::held}};
  file.body.holes = std::move(holes);
  file.strip = {-5, 5, 0.5};
  return file;
}

std::string own_refusal(const BodyFile& body) {
  return message_of([&] { mesh_section(body); });
}

TEST(OwnBody, HolesAreLeftOut) {
  const QuadMesh mesh = mesh_section(block({{{-8, 12}, 3}, {{9, 11}, 4, HoleGroup::held}}));
  EXPECT_NEAR(mesh.section_area, 800 - 25 * pi, 1e-4);
  EXPECT_GE(quality(mesh).smallest, poor_quality);
  int on_hole = 0;
  for (const auto& edge : edges_of(mesh, Group::held))
    on_hole += std::abs(norm(point(mesh, edge.vertices[0]) - Point2{9, 11}) - 4) < 1e-12;
  EXPECT_GE(on_hole, 48); // 7.5 degrees an edge
}

TEST(OwnBody, HolesThatAreNotWithinTheBodyAreRefused) {
  EXPECT_THAT(own_refusal(block({{{50, 10}, 3}})),
              AllOf(HasSubstr("A hole of plate lies outside the body"), HasSubstr("Move or remove it.")));
  EXPECT_THAT(own_refusal(block({{{0, 10}, 5}, {{0, 10}, 2}})),
              HasSubstr("A hole of plate lies in another hole"));
  EXPECT_THAT(own_refusal(block({{{0, 18}, 5}})), HasSubstr("The outline of plate crosses itself"));
  EXPECT_THAT(own_refusal(block({{{0, 10}, 4}, {{3, 10}, 4}})),
              HasSubstr("The outline of plate crosses itself"));
}

TEST(OwnBody, ASelfCrossingOutlineIsRefused) {
  BodyFile file = block({});
  file.body.outline = {{{-20, 0}},
                       {{20, 0}, 0, PieceGroup::contact},
                       {{20, 20}},
                       {{-5, -5}},
                       {{-20, 30}, 0, PieceGroup::held}};
  EXPECT_THAT(own_refusal(file),
              AllOf(HasSubstr("The outline of plate crosses itself"), HasSubstr("near y = ")));
}

TEST(OwnBody, AStripOffTheContactSurfaceIsRefused) {
  BodyFile file = block({});
  file.strip = {-25, 5, 0.5};
  EXPECT_THAT(own_refusal(file),
              AllOf(HasSubstr("is not on profile plate"), HasSubstr("from -20.000 to 20.000 mm")));
}

} // namespace
} // namespace bem_contact::meshes
