#include "bem_contact/base/error.hpp"
#include "bem_contact/inside/surface_tractions.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using namespace bem_contact::inside;
using ::testing::HasSubstr;

/// A result of 2 rows and 3 columns. On the wheel the rows lie the other way round.
record::Record result(bool certified = true) {
  using record::field;
  using record::Number;
  const std::vector<std::size_t> shape{2, 3};
  return {{"format", record::Text{result_format}},
          {"certified", certified},
          {"geometry", record::Record{{"rail", record::Text{"00000000000000ab"}},
                                      {"wheel", record::Text{"00000000000000cd"}}}},
          {"materials", record::Record{{"rail_poisson", Number{0.28}}, {"wheel_poisson", Number{0.3}}}},
          {"quantities",
           record::Record{{"dx", Number{0.5}}, {"ds", Number{0.4}}, {"pmax", Number{9, "MPa", "", 0.9}}}},
          {"x", field({-0.5, 0, 0.5}, "mm", "")},
          {"s", field({-30.2, -29.8}, "mm", "")},
          {"wheel_s", field({34.41, 34.0}, "mm", "")},
          {"p_x", field({1, 2, 3, 4, 5, 6}, "MPa", "", shape)},
          {"p_s", field({-1, -2, -3, -4, -5, -6}, "MPa", "", shape)},
          {"p_n", field({7, 8, 9, 0, 5, 4}, "MPa", "", shape)}};
}

TEST(SurfaceTractions, OfTheRailAreThoseOfTheFile) {
  const SurfaceTractions t = read_tractions(result(), Side::rail);
  EXPECT_EQ(t.columns, 3);
  EXPECT_EQ(t.x(2), 0.5);
  EXPECT_EQ(t.s, (std::vector<double>{-30.2, -29.8}));
  EXPECT_EQ(t.at(3), (std::array<double, 3>{4, -4, 0}));
  EXPECT_EQ(t.poisson, 0.28);
  EXPECT_NEAR(t.force()[component_n], 33 * 0.2, 1e-12);
}

/// A patch given directly has its own s; where it lies on the body, its rows say apart.
TEST(SurfaceTractions, OfAPatchLieWhereItsStripDoes) {
  record::Record patch = result();
  patch.add("rail_s", record::field({11.8, 12.2}, "mm", ""));
  EXPECT_EQ(read_tractions(patch, Side::rail).s, (std::vector<double>{11.8, 12.2}));
  EXPECT_NEAR(read_tractions(patch, Side::wheel).s[0], 34.005, 1e-12);
}

/// Turned by pi about x, and with the other sign: pressure stays pressure. Rows are as wide as on the rail.
TEST(SurfaceTractions, OfTheWheelAreTurned) {
  const SurfaceTractions t = read_tractions(result(), Side::wheel);
  ASSERT_EQ(t.rows(), 2);
  EXPECT_NEAR(t.s[0], 34.005, 1e-12);
  EXPECT_NEAR(t.s[1], 34.405, 1e-12);
  EXPECT_EQ(t.at(0), (std::array<double, 3>{-4, -4, 0}));
  EXPECT_EQ(t.at(5), (std::array<double, 3>{-3, -3, 9}));
  EXPECT_EQ(t.poisson, 0.3);
}

TEST(SurfaceTractions, KnowTheirBody) {
  EXPECT_EQ(side_of(result(), 0xab), Side::rail);
  EXPECT_EQ(side_of(result(), 0xcd), Side::wheel);
  EXPECT_THAT(message_of([] { side_of(result(), 0xef); }), HasSubstr("does not belong to this result"));
  EXPECT_NEAR(traction_error(result()), 0.1, 1e-12);
}

TEST(SurfaceTractions, RefuseWhatIsNoSolution) {
  EXPECT_THAT(message_of([] { read_tractions(result(false), Side::rail); }), HasSubstr("not certified"));
  EXPECT_THAT(message_of([] { read_tractions({}, Side::rail); }), HasSubstr("no result of one scene"));
  record::Record other{{"format", record::Text{result_format}}, {"certified", true}};
  EXPECT_THAT(message_of([&] { read_tractions(other, Side::rail); }), HasSubstr("of its elements"));
}

TEST(SurfaceTractions, PatchesAreOrderedByTheirForce) {
  SurfaceTractions t{.dx = 1,
                     .ds = 1,
                     .x0 = 0,
                     .columns = 4,
                     .s = {0, 1},
                     .px = {},
                     .ps = {},
                     .pn = {1, 0, 0, 2, 0, 0, 0, 3}};
  t.px.assign(8, 0), t.ps = t.px;
  EXPECT_EQ(loaded_patches(t), (std::vector<std::vector<int>>{{3, 7}, {0}}));
}

} // namespace
