#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/own_outline.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <numbers>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using std::numbers::pi;

/// A body file of kind outline, strip and all, from its pieces and further lines of [body].
std::string toml(const std::string& pieces, const std::string& more = "") {
  return "[body]\nkind = 'outline'\nname = 'part'\n" + more + "outline = [\n" + pieces +
         "]\n[strip]\nfrom = 0\nto = 1\nstation_width = 0.5\n";
}

const std::string corner = "{to = [-10, 10]},\n{to = [0, 0], radius = 10, group = 'contact'},\n"
                           "{to = [90, 0]},\n{to = [90, 100]},\n{to = [-10, 100], group = 'held'},\n";

ProfileCurve profile(const std::string& text) {
  return body_profile(parse_body_file(text, "body.toml"));
}

std::string outline_refusal(const std::string& text) {
  return message_of([&] { profile(text); });
}

TEST(OwnOutline, the_contact_pieces_are_the_profile) {
  const ProfileCurve curve = profile(toml(corner));
  EXPECT_EQ(curve.name(), "part");
  EXPECT_NEAR(curve.s_begin(), -5 * pi, 1e-12);
  EXPECT_NEAR(curve.s_end(), 0, 1e-12);
  for (const double part : {0.0, 0.3, 0.5, 1.0}) {
    const CurvePoint p = curve.at(curve.s_begin() * part);
    EXPECT_NEAR(p.delta, -pi / 2 * part, 1e-12);
    EXPECT_NEAR(p.curvature, 0.1, 1e-15);
    EXPECT_NEAR(norm(p.position - Point2{0, 10}), 10, 1e-12);
  }
}

TEST(OwnOutline, a_run_over_the_end_of_the_list_is_one_run) {
  // The same corner, the list begun in the middle of a contact surface of flank, arc and top.
  const ProfileCurve curve = profile(
      toml("{to = [0, 0], radius = 10, group = 'contact'},\n{to = [90, 0], group = 'contact'},\n"
           "{to = [90, 100]},\n{to = [-10, 100], group = 'held'},\n{to = [-10, 10], group = 'contact'},\n"));
  EXPECT_NEAR(curve.s_begin(), -5 * pi - 90, 1e-12);
  EXPECT_NEAR(curve.s_end(), 90, 1e-12);
}

TEST(OwnOutline, mirrored_pieces_give_the_mirrored_curve) {
  const ProfileCurve left = profile(toml(corner));
  const ProfileCurve right =
      profile(toml("{to = [0, 0]},\n{to = [10, 10], radius = 10, group = 'contact'},\n"
                   "{to = [10, 100]},\n{to = [-90, 100], group = 'held'},\n{to = [-90, 0]},\n"));
  for (double s = 0; s < 15.7; s += 0.7) {
    const CurvePoint a = left.at(-s), b = right.at(s);
    EXPECT_LT(norm(a.position - Point2{-b.position.y, b.position.z}), 1e-12);
    EXPECT_NEAR(a.delta, -b.delta, 1e-12);
  }
}

TEST(OwnOutline, a_half_circle_is_the_disc_and_the_bore) {
  const auto same = [](const ProfileCurve& a, const ProfileCurve& b) {
    EXPECT_NEAR(a.s_begin(), b.s_begin(), 1e-9);
    EXPECT_NEAR(a.s_end(), b.s_end(), 1e-9);
    for (double s = -15; s < 15; s += 0.9) {
      EXPECT_LT(norm(a.at(s).position - b.at(s).position), 1e-9);
      EXPECT_NEAR(a.at(s).delta, b.at(s).delta, 1e-9);
      EXPECT_NEAR(a.at(s).curvature, b.at(s).curvature, 1e-12);
    }
  };
  same(profile(toml("{to = [-10, 0], radius = 10, group = 'contact'},\n{to = [10, 0], radius = 10, group = "
                    "'held'},\n")),
       profile("body.kind = 'disc'\nstrip.from = -1\nstrip.to = 1"));
  same(profile(toml("{to = [-10, 0]},\n{to = [10, 0], radius = -10, group = 'contact'},\n{to = [50, 0]},\n"
                    "{to = [50, 50], group = 'held'},\n{to = [-50, 50]},\n{to = [-50, 0]},\n")),
       profile("body.kind = 'bore'\nstrip.from = -1\nstrip.to = 1"));
}

TEST(OwnOutline, what_is_no_closed_smooth_outline_is_refused) {
  EXPECT_THAT(outline_refusal(toml("")),
              AllOf(HasSubstr("The outline of part has 0 pieces"), HasSubstr("{ to = [y, z] }")));
  EXPECT_THAT(outline_refusal(toml("{to = [0, 0], group = 'contact'},\n{to = [9, 0], group = 'held'},\n")),
              HasSubstr("The outline of part has 2 pieces"));
  EXPECT_THAT(outline_refusal(toml("{to = [-10, 10]},\n" + corner)),
              AllOf(HasSubstr("Piece 2 of the outline of part from (-10, 10) to (-10, 10) mm has no length"),
                    HasSubstr("the loop is closed")));
  EXPECT_THAT(outline_refusal(
                  toml("{to = [0, 0]},\n{to = [20, 0], radius = -9.9, group = 'contact'},\n{to = [20, 50], "
                       "group = 'held'},\n{to = [0, 50]},\n")),
              AllOf(HasSubstr("Piece 2"), HasSubstr("is no arc"),
                    HasSubstr("its ends are 20 mm apart, more than twice its radius of 9.9 mm")));
  const std::string head = "{to = [0, 0]},\n{to = [20, 0], group = 'contact'},\n";
  EXPECT_THAT(outline_refusal(toml(head + "{to = [20, 50]},\n{to = [0, 50]},\n")),
              AllOf(HasSubstr("Nothing holds part"), HasSubstr("group = \"held\"")));
  EXPECT_THAT(
      outline_refusal(toml(head + "{to = [40, 2], group = 'contact'},\n{to = [0, 50], group = 'held'},\n")),
      AllOf(HasSubstr("The contact surface of part has a corner at (20, 0) mm"),
            HasSubstr("meet at 0.09967 rad, at most 0.01")));
  EXPECT_THAT(outline_refusal(toml(head + "{to = [20, 50]},\n{to = [0, 50], group = 'contact'},\n")),
              HasSubstr("form 2 separate runs"));
  EXPECT_THAT(outline_refusal(toml("{to = [0, 0]},\n{to = [9, 0]},\n{to = [9, 9], group = 'held'},\n")),
              HasSubstr("has no contact piece"));
  EXPECT_THAT(
      outline_refusal(toml("{to = [0, 0], group = 'contact'},\n{to = [9, 0], group = 'contact'},\n{to = [9, "
                           "9], group = 'contact'},\n")),
      HasSubstr("has only contact piece"));
  EXPECT_THAT(outline_refusal(
                  toml("{to = [20, 0]},\n{to = [0, 0], group = 'contact'},\n{to = [0, 50], group = 'held'},\n"
                       "{to = [20, 50]},\n")),
              AllOf(HasSubstr("is walked the wrong way round"), HasSubstr("Reverse the order")));
}

TEST(OwnOutline, a_body_of_revolution_keeps_off_its_axle) {
  const auto roller = [](const std::string& radius) {
    return toml("{to = [9, 0]},\n{to = [-9, 0], group = 'contact'},\n{to = [-9, -20]},\n"
                "{to = [9, -20], radius = 15, group = 'held'},\n",
                "reference_radius = " + radius + "\n");
  };
  EXPECT_EQ(outline_refusal(roller("30")), "no error");
  EXPECT_THAT(outline_refusal(roller("23")),
              AllOf(HasSubstr("part reaches its axle"), // the arc's top is 3 mm higher
                    HasSubstr("Raise [body] reference_radius")));
  // Turned by half a turn: the axle below.
  const auto below = [](const std::string& radius) {
    return toml("{to = [-9, 0]},\n{to = [9, 0], group = 'contact'},\n{to = [9, 20]},\n"
                "{to = [-9, 20], radius = 15, group = 'held'},\n",
                "reference_radius = " + radius + "\n");
  };
  EXPECT_EQ(outline_refusal(below("-30")), "no error");
  EXPECT_THAT(outline_refusal(below("-23")),
              AllOf(HasSubstr("part reaches its axle"), HasSubstr("Lower [body] reference_radius")));
}

TEST(OwnOutline, wrong_keys_name_their_line) {
  EXPECT_THAT(outline_refusal(toml("{to = [0, 0]},\n{to = [9, 0], raduis = 3},\n")),
              AllOf(HasSubstr("body.toml:6: unknown key 'body.outline.raduis'"),
                    HasSubstr("Did you mean body.outline.radius?")));
  EXPECT_THAT(outline_refusal(toml("{radius = 3},\n")), HasSubstr("body.toml:5: body.outline.to is missing"));
  EXPECT_THAT(outline_refusal(toml("{to = [0, 0, 0]},\n")),
              AllOf(HasSubstr("body.outline.to is a list (it must be of type: two numbers)")));
  EXPECT_THAT(outline_refusal(toml("{to = [0, nan]},\n")), HasSubstr("the value must be finite"));
  EXPECT_THAT(outline_refusal(toml("{to = [0, 0], group = 'strip'},\n")),
              HasSubstr("known are contact, held, free"));
  EXPECT_THAT(outline_refusal(toml("[0, 0],\n")), HasSubstr("it must be of type: list of tables"));
  EXPECT_THAT(outline_refusal(toml(corner, "holes = [{centre = [0, 50], radius = 0}]\n")),
              HasSubstr("body.toml:4: body.holes.radius = 0.0 (out of range)"));
  EXPECT_THAT(outline_refusal(toml(corner, "radius = 3\n")), HasSubstr("only where it is disc or bore"));
}

TEST(NamedProfile, of_a_body_file_is_its_contact_curve) {
  const std::filesystem::path folder = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data" / "bodies";
  const ProfileCurve corner_curve = named_profile("convex_corner.toml", ProfileKind::rail, folder);
  EXPECT_EQ(corner_curve.name(), "convex corner R 10");
  EXPECT_EQ(corner_curve.digest(), body_profile(read_body_file(folder / "convex_corner.toml")).digest());
  EXPECT_EQ(named_profile("roller.toml", ProfileKind::wheel, folder).name(), "roller R 50 crown 28");
  const auto refused = [&](const char* file, ProfileKind kind) -> std::string {
    return message_of([&] { named_profile(file, kind, folder); });
  };
  EXPECT_THAT(refused("convex_corner.toml", ProfileKind::wheel),
              AllOf(HasSubstr("is a lower body (a wheel is asked for)")));
  EXPECT_THAT(refused("roller.toml", ProfileKind::rail), HasSubstr("is an upper body (a rail is asked for)"));
  EXPECT_THAT(refused("ring.toml", ProfileKind::rail),
              AllOf(HasSubstr("is no rail: it is curved along x, about an axle 80 mm above"),
                    HasSubstr("Use kind = \"patch\"")));
}

TEST(NamedProfile, a_body_file_that_names_itself_is_refused) {
  const TemporaryFolder folder;
  const auto file = folder / "names_itself.toml";
  std::ofstream(file) << "[body]\nprofile = 'names_itself.toml'\n";
  EXPECT_THAT(message_of([&] { named_profile(file.string(), ProfileKind::rail); }),
              HasSubstr("names the body file names_itself.toml as its profile"));
}

} // namespace
} // namespace bem_contact
