#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/material.hpp"

#include <gtest/gtest.h>

namespace bem_contact {
namespace {

TEST(Conventions, on_top_of_the_rail_the_contact_frame_is_the_track_frame) {
  EXPECT_EQ(tangent_of(0).y, 1);
  EXPECT_EQ(tangent_of(0).z, 0);
  EXPECT_EQ(normal_of(0).y, 0);
  EXPECT_EQ(normal_of(0).z, 1); // down, into the rail
}

TEST(Conventions, at_the_gauge_corner_the_normal_points_down_and_to_the_field_side) {
  const Point2 n = normal_of(-0.7); // of a right-hand rail: the corner lies at y < 0
  EXPECT_GT(n.y, 0);
  EXPECT_GT(n.z, 0);
}

TEST(Conventions, the_frame_is_orthonormal_and_right_handed) {
  for (double delta = -4; delta < 4; delta += 0.37) {
    const Point2 s = tangent_of(delta), n = normal_of(delta);
    EXPECT_NEAR(dot(s, n), 0, 1e-15);
    EXPECT_NEAR(s.y * n.z - s.z * n.y, 1, 1e-15); // e_s x e_n = e_x
  }
}

TEST(Conventions, parity_is_odd_where_one_component_is_longitudinal) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(parity(i, j), ((i == component_x) + (j == component_x)) == 1 ? -1 : 1);
      EXPECT_EQ(parity(i, j), parity(j, i));
    }
}

TEST(Material, youngs_modulus) {
  EXPECT_DOUBLE_EQ((Material{82000, 0.28}.young()), 209920);
}

} // namespace
} // namespace bem_contact
