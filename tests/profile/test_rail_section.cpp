#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/rail_section.hpp"
#include "bem_contact/profile/curve_piece.hpp"
#include "tests/base/message.hpp"
#include "tests/profile/section_properties.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {
namespace {

TEST(SectionProperties, of_a_rectangle) {
  // 20 wide, 30 high: right half from the top centre to the base centre.
  const SectionProperties p =
      section_properties({{{0, 0}, {10, 0}}, {{10, 0}, {10, 30}}, {{10, 30}, {0, 30}}});
  EXPECT_NEAR(p.area, 600, 1e-10);
  EXPECT_NEAR(p.centroid, 15, 1e-12);
  EXPECT_NEAR(p.Ix, 20 * 27000 / 12.0, 1e-8);
  EXPECT_NEAR(p.Iy, 30 * 8000 / 12.0, 1e-8);
}

TEST(SectionProperties, of_a_circle) {
  const SectionProperties p = section_properties({{{0, 0}, {7, 7}, 7}, {{7, 7}, {0, 14}, 7}});
  EXPECT_NEAR(p.area, std::numbers::pi * 49, 1e-9);
  EXPECT_NEAR(p.centroid, 7, 1e-10);
  EXPECT_NEAR(p.Ix, std::numbers::pi / 4 * std::pow(7, 4), 1e-7);
  EXPECT_NEAR(p.Iy, std::numbers::pi / 4 * std::pow(7, 4), 1e-7);
}

TEST(RailSection, properties_of_60E1_to_the_printed_figures) {
  const SectionProperties p = section_properties(rail_section("60E1"));
  EXPECT_NEAR(p.area / 1e2, 76.7000, 1e-4);
  EXPECT_NEAR(p.centroid, 80.92, 5e-3);
  EXPECT_NEAR(p.Ix / 1e4, 3038.31, 5e-3);
  EXPECT_NEAR(p.Iy / 1e4, 512.30, 1e-2);
}

TEST(RailSection, properties_of_60E2_to_the_printed_figures) {
  const SectionProperties p = section_properties(rail_section("60E2"));
  EXPECT_NEAR(p.area / 1e2, 76.476, 5e-4);
  EXPECT_NEAR(p.Ix / 1e4, 3021.5, 5e-2);
  EXPECT_NEAR(p.Iy / 1e4, 510.5, 5e-2);
}

TEST(RailSection, is_a_chain_from_the_top_centre_to_the_base_centre) {
  for (const char* name : {"60E1", "60E2", "54E1", "46E3"}) {
    const auto pieces = rail_section(name);
    EXPECT_EQ(norm(pieces.front().from), 0);
    EXPECT_EQ(pieces.back().to.y, 0);
    for (std::size_t i = 1; i < pieces.size(); ++i)
      EXPECT_EQ(norm(pieces[i].from - pieces[i - 1].to), 0);
    for (const SectionPiece& piece : pieces)
      if (piece.radius != 0) {
        EXPECT_LT(norm(piece.to - piece.from), 2 * std::abs(piece.radius));
      }
  }
}

TEST(RailHead, meets_the_printed_joints_of_60E1) {
  const auto pieces = rail_head("60E1");
  ASSERT_EQ(pieces.size(), 4u);
  const Point2 printed[] = {{10.228, 0.1744}, {26.0265, 2.3025}, {35.9998, 14.3000}, {37.0486, 35.2753}};
  for (int i = 0; i < 4; ++i)
    EXPECT_LT(norm(pieces[i].to - printed[i]), 8e-5) << i;
}

TEST(RailHead, of_54E1_is_70_wide_14_1_mm_below_the_top) {
  const auto pieces = rail_head("54E1");
  const SectionPiece& flank = pieces.back();
  EXPECT_NEAR(flank.from.y + (14.1 - flank.from.z) / 20, 35, 2e-4);
}

/// EN 13674-1's figures.
struct Printed {
  const char* name;
  double area, Ix, Iy;      // cm^2, cm^4
  double height, foot, web; // mm
};

TEST(RailSection, properties_of_54E1_and_46E3_to_a_thousandth) {
  for (const Printed& rail : {Printed{"54E1", 69.77, 2337.9, 419.2, 159, 140, 16},
                              Printed{"46E3", 59.44, 1605.9, 307.5, 142, 120, 14}}) {
    const auto pieces = rail_section(rail.name);
    const SectionProperties p = section_properties(pieces);
    EXPECT_NEAR(p.area / 1e2, rail.area, 1e-3 * rail.area) << rail.name;
    EXPECT_NEAR(p.Ix / 1e4, rail.Ix, 1e-3 * rail.Ix) << rail.name;
    EXPECT_NEAR(p.Iy / 1e4, rail.Iy, 1e-3 * rail.Iy) << rail.name;
    double height = 0, foot = 0, web = 1e9;
    for (const SectionPiece& piece : pieces) {
      height = std::max(height, piece.to.z);
      foot = std::max(foot, 2 * piece.to.y);
      const CurvePiece curve = arc_piece(piece.from, piece.to, piece.radius == 0 ? 0 : 1 / piece.radius);
      for (double s = 0; s < curve.length; s += 0.1)
        if (const Point2 at = point_on(curve, s).position; at.z > 60 && at.z < 100)
          web = std::min(web, 2 * at.y);
    }
    EXPECT_EQ(height, rail.height) << rail.name;
    EXPECT_EQ(foot, rail.foot) << rail.name;
    EXPECT_NEAR(web, rail.web, 1e-3) << rail.name;
  }
  EXPECT_NEAR(section_properties(rail_section("54E1")).centroid, 75.1, 0.05);
}

TEST(RailSection, of_54E1_and_46E3_is_smooth_but_for_the_foot) {
  for (const char* name : {"54E1", "46E3"}) {
    const auto pieces = rail_section(name);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const auto curve = [&](std::size_t k) {
        return arc_piece(pieces[k].from, pieces[k].to, pieces[k].radius == 0 ? 0 : 1 / pieces[k].radius);
      };
      const CurvePiece before = curve(i - 1);
      const double turn = curve(i).delta0 - point_on(before, before.length).delta;
      EXPECT_LT(std::abs(std::remainder(turn, 2 * std::numbers::pi)), 2e-4) << name << " " << i;
    }
  }
}

TEST(RailHead, of_46E3_is_73_72_wide_where_its_corner_ends) {
  EXPECT_NEAR(rail_head("46E3").back().from.y, 73.72 / 2, 2e-4);
}

TEST(RailSection, says_what_it_does_not_know) {
  EXPECT_THAT(
      message_of([&] { rail_section("60E3"); }),
      testing::HasSubstr("Unknown rail '60E3' (no table of a standard has it) Did you mean 50E3 or 60E1"));
  EXPECT_THAT(message_of([&] { rail_section("60N"); }),
              testing::HasSubstr("The web and the foot of rail 60N are not known"));
}

} // namespace
} // namespace bem_contact
