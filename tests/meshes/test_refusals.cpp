#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "meshes/section_mesh.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace bem_contact::meshes {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const BodyFile& body) {
  return message_of([&] { mesh_section(body); });
}

BodyFile body_of(BodyKind kind) {
  BodyFile body;
  body.body.kind = kind;
  body.strip = {.from = -5, .to = 5, .station_width = 0.5};
  return body;
}

TEST(Refusals, UnknownKind) {
  EXPECT_THAT(message_of([] { parse_body_file("body.kind = 'sleeper'"); }),
              AllOf(HasSubstr("body.kind = \"sleeper\""), HasSubstr("bore")));
}

TEST(Refusals, UnknownProfile) {
  BodyFile body = body_of(BodyKind::rail);
  body.body.profile = "60E3";
  EXPECT_THAT(refusal(body), HasSubstr("60E3"));
}

TEST(Refusals, StripOffTheProfile) {
  BodyFile body = body_of(BodyKind::block);
  body.body.size = 4;
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("The strip from -5 to 5 mm is not on profile block"),
                                   HasSubstr("the profile runs from -4.000 to 4.000 mm"),
                                   HasSubstr("Change [strip] from and to.")));
  body = body_of(BodyKind::rail);
  body.strip.from = -80;
  EXPECT_THAT(refusal(body), HasSubstr("is not on profile 60E1"));
}

TEST(Refusals, EmptyStripAndNoNumbers) {
  BodyFile body = body_of(BodyKind::block);
  body.strip.to = -5;
  EXPECT_THAT(refusal(body), HasSubstr("is empty"));
  body.strip.to = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(body), HasSubstr("is empty"));
  body = body_of(BodyKind::disc);
  body.body.radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(body), HasSubstr("[body] radius = nan is no size of a body"));
  body = body_of(BodyKind::block);
  body.body.size = -1;
  EXPECT_THAT(refusal(body), HasSubstr("[body] size = -1 is no size of a body"));
}

TEST(Refusals, StationsThatDoNotFillTheStrip) {
  BodyFile body = body_of(BodyKind::block);
  body.strip.station_width = 0.3;
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("stations of 0.3 mm"), HasSubstr("their number must be whole")));
}

TEST(Refusals, MeshNumbersThatMakeNoMesh) {
  BodyFile body = body_of(BodyKind::block);
  body.mesh.elements_per_station = 0;
  EXPECT_THAT(refusal(body), HasSubstr("elements_per_station = 0"));
  body = body_of(BodyKind::block);
  body.mesh.grading = -0.1;
  EXPECT_THAT(refusal(body), HasSubstr("grading = -0.1"));
  body = body_of(BodyKind::block);
  body.mesh.largest = 0;
  EXPECT_THAT(refusal(body), HasSubstr("all three must be positive"));
}

TEST(Refusals, OddStripUpToACorner) {
  BodyFile body = body_of(BodyKind::block);
  body.body.size = 5;
  body.strip.station_width = 2;
  body.mesh.elements_per_station = 1;
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("The strip of block 5 ends at a corner after 5 element edges"),
                                   HasSubstr("Make [mesh] elements_per_station even")));
}

TEST(Refusals, BoreThatDoesNotFitItsBlock) {
  BodyFile body = body_of(BodyKind::bore);
  body.body.size = 10;
  EXPECT_THAT(refusal(body),
              HasSubstr("A bore of radius 10 mm does not fit into a block of half width 10 mm"));
}

} // namespace
} // namespace bem_contact::meshes
