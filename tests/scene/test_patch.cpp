#include "bem_contact/scene/patch_geometry.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/scene/patch_on_grid.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

SceneFile patch(int mx, int ms) {
  SceneFile scene;
  scene.kind = SceneKind::patch;
  scene.grid.mx = mx;
  scene.grid.ms = ms;
  return scene;
}

class Tables : public ::testing::Test {
protected:
  SceneFile with_gap(const std::string& table) {
    std::ofstream(folder_ / "gap.csv") << table;
    SceneFile scene = patch(2, 1);
    scene.folder = folder_.path();
    scene.gap.table = "gap.csv";
    return scene;
  }
  std::string refusal(const SceneFile& scene) {
    return message_of([&] { patch_on_grid(scene); });
  }
  TemporaryFolder folder_;
};

TEST(CircularGap, OfConcentricCirclesIsTheirClearance) {
  // Bore R 10 below, disc r 9.8: along the bore's normal from a point at angle t the disc's circle is at
  // R - (dR cos t + sqrt(r^2 - dR^2 sin^2 t)).
  for (const double t : {-0.5, -0.1, 0.0, 0.3, 1.2}) {
    const double exact = 10 - 0.2 * std::cos(t) - std::sqrt(9.8 * 9.8 - std::pow(0.2 * std::sin(t), 2));
    EXPECT_NEAR(circular_gap(-10, 9.8, 10 * t), exact, 1e-13) << t;
    // The other way round: disc below, bore above.
    const double other = 0.2 * -std::cos(t) - 9.8 + std::sqrt(100 - std::pow(0.2 * std::sin(t), 2));
    EXPECT_NEAR(circular_gap(9.8, -10, 9.8 * t), other, 1e-13) << t;
  }
}

TEST(CircularGap, IsQuadraticNearTheContact) {
  EXPECT_NEAR(circular_gap(300, 20, 0.01), 0.5e-4 * (1 / 300.0 + 1 / 20.0), 1e-10);
}

TEST(CircularGap, IsExcludedWhereTheNormalMisses) {
  EXPECT_EQ(circular_gap(80, 5, 60), excluded_gap);
}

TEST(Patch, HasItsRowsAndColumnsAboutTheOrigin) {
  SceneFile scene = patch(4, 3);
  scene.grid.dx = 0.5;
  scene.grid.ds = 2;
  scene.gap.a = 1;
  scene.gap.b = 10;
  scene.gap.c = 100;
  const ContactOnGrid contact = patch_on_grid(scene);
  EXPECT_DOUBLE_EQ(contact.problem.grid.x0, -0.75);
  EXPECT_DOUBLE_EQ(contact.problem.rows[2].s, 2);
  EXPECT_DOUBLE_EQ(contact.problem.gap[8], 0.75 * 0.75 + 10 * 4 - 100 * 0.75 * 2);
}

TEST(Patch, OnACurvedStripTurnsItsRows) {
  SceneFile scene = patch(1, 3);
  scene.grid.ds = 1;
  scene.strip = {-10, 9.8, 4, 7, ""};
  const ContactOnGrid contact = patch_on_grid(scene);
  const ContactRow& row = contact.problem.rows[2];
  EXPECT_NEAR(row.delta, -0.1, 1e-15);
  EXPECT_NEAR(row.position.y, 10 * std::sin(0.1), 1e-14);
  EXPECT_NEAR(row.position.z, -10 * (1 - std::cos(0.1)), 1e-14); // the bore rises beside its lowest point
  EXPECT_DOUBLE_EQ(contact.rail_s[2], 5);
  // Seen from the disc's centre (0, -9.8).
  EXPECT_NEAR(contact.wheel_s[2], 7 - 9.8 * std::atan2(row.position.y, row.position.z + 9.8), 1e-13);
  EXPECT_NEAR(contact.problem.gap[2], circular_gap(-10, 9.8, 1), 1e-15);
}

TEST(Patch, RefusesAStripBeyondAQuarterTurn) {
  SceneFile scene = patch(1, 100);
  scene.grid.ds = 1;
  scene.strip.radius = 10;
  EXPECT_THROW(patch_on_grid(scene), InputError);
}

TEST_F(Tables, GiveTheGap) {
  for (const char* table :
       {"# mm\nix, is, h\n1, 0, 0.25\n0, 0, 0.5\n",
        "\"ix\",\"is\",\"h\" # quotes, and a comma at the end\n1, 0, 0.25,\n0, 0, \"0.5\"\n"})
    EXPECT_THAT(patch_on_grid(with_gap(table)).problem.gap, ::testing::ElementsAre(0.5, 0.25));
}

TEST_F(Tables, AreRefusedWithTheirFault) {
  EXPECT_THAT(refusal(with_gap("x, y, h\n0, 0, 0\n")), HasSubstr("has other columns"));
  EXPECT_THAT(refusal(with_gap("ix, is, h\n0, 0, nan\n1, 0, 0\n")), HasSubstr("is not a finite number"));
  EXPECT_THAT(refusal(with_gap("ix, is, h\n0, 0, +-1\n1, 0, 0\n")), HasSubstr("is not a finite number"));
  EXPECT_EQ(refusal(with_gap("ix, is, h\n0, 0, +0.1\n+1, 0, 1e-3\n")), "no error");
  EXPECT_THAT(refusal(with_gap("ix, is, h\n0, 0, 1\n")), HasSubstr("element (1, 0) is missing"));
  EXPECT_THAT(refusal(with_gap("ix, is, h\n0, 0, 1\n0, 0, 1\n")), HasSubstr("given twice"));
  EXPECT_THAT(refusal(with_gap("ix, is, h\n5, 0, 1\n")), HasSubstr("is not one of it"));
  EXPECT_THAT(refusal(with_gap("ix, is, h\n0, 0\n")), HasSubstr("it has 2 cells, and 3 columns have names"));
  EXPECT_THAT(refusal(with_gap("")), HasSubstr("is empty"));
  SceneFile scene = patch(1, 1);
  scene.gap.table = "nowhere.csv";
  EXPECT_THAT(refusal(scene), HasSubstr("there is no such file"));
}

TEST_F(Tables, OfRowsHaveEachRowOnce) {
  SceneFile scene = patch(1, 2);
  scene.folder = folder_.path();
  scene.strip.inclination = "delta.csv";
  const auto refusal_of = [&](const std::string& rows) {
    folder_.write("delta.csv", "is, delta\n" + rows);
    return refusal(scene);
  };
  EXPECT_EQ(refusal_of("0, 0\n1, 0.1\n"), "no error");
  EXPECT_THAT(refusal_of("0, 0\n1, 0.1\n0, 0.2\n"), HasSubstr("row 0 is given twice"));
  EXPECT_THAT(refusal_of("0, 0\n2, 0.1\n"), HasSubstr("row 2 is not one of it"));
  EXPECT_THAT(refusal_of("0, 0\n"), HasSubstr("row 1 is missing"));
}

TEST_F(Tables, InclineTheRows) {
  std::ofstream(folder_ / "delta.csv") << "is, delta\n0, -0.2\n1, 0\n2, 0.2\n";
  SceneFile scene = patch(1, 3);
  scene.grid.ds = 2;
  scene.folder = folder_.path();
  scene.strip.inclination = "delta.csv";
  const ContactOnGrid contact = patch_on_grid(scene);
  EXPECT_DOUBLE_EQ(contact.problem.rows[0].delta, -0.2);
  EXPECT_NEAR(contact.problem.rows[2].position.y, 2 * std::cos(0.1), 1e-15);
  EXPECT_NEAR(contact.problem.rows[2].position.z, 2 * std::sin(0.1), 1e-15);
  EXPECT_NEAR(contact.problem.rows[0].position.z, 2 * std::sin(0.1), 1e-15);
}

} // namespace
