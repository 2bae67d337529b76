#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "meshes/section_mesh.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

/// 60E1 is 172 mm high.
TEST(Refusals, RollerWhoseAxisLiesInItsSection) {
  BodyFile body = body_of(BodyKind::rail);
  body.body.roller_radius = 150;
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("reaches the axis of its roller"), HasSubstr("z = 172 mm"),
                                   HasSubstr("body.roller_radius is 150 mm")));
  body.body.roller_radius = 200;
  EXPECT_EQ(refusal(body), "no error");
}

TEST(Refusals, OddStripUpToACorner) {
  BodyFile body = body_of(BodyKind::block);
  body.body.size = 5;
  body.strip.station_width = 2;
  body.mesh.elements_per_station = 1;
  EXPECT_THAT(refusal(body), AllOf(HasSubstr("The strip of block 5 ends at a corner after 5 element edges"),
                                   HasSubstr("Make [mesh] elements_per_station even")));
}

} // namespace
} // namespace bem_contact::meshes
