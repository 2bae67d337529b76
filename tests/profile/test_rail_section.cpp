#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/rail_section.hpp"

#include <gmock/gmock.h>

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
  for (const char* name : {"60E1", "60E2"}) {
    const auto pieces = rail_section(name);
    EXPECT_EQ(norm(pieces.front().from), 0);
    EXPECT_EQ(pieces.back().to.y, 0);
    EXPECT_EQ(pieces.back().to.z, 172);
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

TEST(RailSection, says_what_it_does_not_know) {
  try {
    rail_section("54E1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the whole section of rail 54E1 is not known"));
  }
  try {
    rail_section("60E3");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("unknown rail '60E3' (known are 60E1, 60E2 and 54E1)"));
  }
}

} // namespace
} // namespace bem_contact
