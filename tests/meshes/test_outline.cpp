#include "bem_contact/base/error.hpp"
#include "meshes/outline.hpp"
#include "meshes/sampled_span.hpp"
#include "meshes/wheel_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bem_contact::meshes {
namespace {

using std::numbers::pi;

TEST(SizeField, GrowsFromItsSourcesUpToTheLargest) {
  SizeField size(5, 0.5);
  EXPECT_EQ(size({100, 0}), 5);
  size.add(1, {{0, 0}, {10, 0}});
  size.add(2, {{20, 0}});
  EXPECT_NEAR(size({0, 0}), 1, 1e-12);
  EXPECT_NEAR(size({0, 3}), 2.5, 1e-12);
  EXPECT_NEAR(size({9, 0}), 1.5, 1e-12);
  EXPECT_LE(size({20, 0}), 2);
  EXPECT_GT(size({20, 0}), 2 / 1.05);
  EXPECT_EQ(size({0, 100}), 5);
}

TEST(Spans, EndAtCornersAndWhereTheGroupChanges) {
  // A stadium: smooth all round, its lower side held.
  const Loop stadium{line({-1, 0}, {1, 0}, Group::held), arc({1, 1}, 1, -pi / 2, pi / 2),
                     line({1, 2}, {-1, 2}), arc({-1, 1}, 1, pi / 2, 3 * pi / 2)};
  const auto smooth_spans = sample_spans(stadium);
  ASSERT_EQ(smooth_spans.size(), 2u);
  EXPECT_EQ(smooth_spans[1].pieces.size(), 3u);
  EXPECT_NEAR(smooth_spans[1].samples.back().turn, 2 * pi, 0.1);
  EXPECT_NEAR(smooth_spans[1].samples.back().length, 2 + 2 * pi, 1e-2);

  const Loop square{line({0, 0}, {1, 0}), line({1, 0}, {1, 1}), line({1, 1}, {0, 1}), line({0, 1}, {0, 0})};
  EXPECT_EQ(sample_spans(square).size(), 4u);

  const Loop circle{arc({0, 0}, 3, 0, 2 * pi)};
  const auto closed = sample_spans(circle);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(closed[0].closed);
  EXPECT_NEAR(curvature_at(closed[0], closed[0].samples.size() / 2), 1.0 / 3, 1e-3);
}

Section square_with_strip(std::vector<Piece> rest) {
  Loop loop{line({-1, 0}, {1, 0}, Group::contact)};
  loop.insert(loop.end(), rest.begin(), rest.end());
  return {"shape", {loop}};
}

TEST(Divide, KeepsCornersAtEvenPlacesAndAnEvenNumber) {
  // The strip ends on the flat top, so that an odd number of edges is allowed.
  const Section section =
      square_with_strip({line({1, 0}, {2, 0}), line({2, 0}, {2, 4}), line({2, 4}, {-2, 4}),
                         line({-2, 4}, {-2, 0}), line({-2, 0}, {-1, 0})});
  for (const int edges : {1, 2, 5, 8}) {
    const Outline outline = divide(section, edges, {.grading = 0.3, .largest = 1});
    ASSERT_EQ(outline.loops.size(), 1u);
    const auto& loop = outline.loops[0];
    EXPECT_EQ(loop.size() % 2, 0u) << edges;
    int contact = 0, corners = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      contact += loop[i].group == Group::contact;
      const Point2 p = loop[i].position;
      if (std::abs(std::abs(p.y) - 2) < 1e-12 && std::abs(std::abs(p.z - 2) - 2) < 1e-12) {
        ++corners;
        EXPECT_EQ(i % 2, 0u) << edges;
      }
    }
    EXPECT_EQ(corners, 4) << edges;
    EXPECT_EQ(contact, edges);
  }
}

TEST(Divide, MakesElementsSmallWhereTheBodyIsThin) {
  // A plate 1 mm thick: half of it, up to the places where the thickness was measured; 10 without it.
  const Section plate{"plate",
                      {{line({-20, 0}, {-19, 0}, Group::contact), line({-19, 0}, {20, 0}),
                        line({20, 0}, {20, 1}), line({20, 1}, {-20, 1}), line({-20, 1}, {-20, 0})}}};
  const Outline outline = divide(plate, 4, {.grading = 0.5, .largest = 10});
  const auto& loop = outline.loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_LE(norm(loop[(i + 1) % loop.size()].position - loop[i].position), 0.75);
}

TEST(Crossings, AreRefused) {
  const Section bow =
      square_with_strip({line({1, 0}, {-1, 2}), line({-1, 2}, {1, 2}), line({1, 2}, {-1, 0})});
  const Outline outline = divide(bow, 8, {.grading = 0.3, .largest = 1});
  try {
    refuse_crossings(outline, "the bow");
    FAIL() << "the bow was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("The outline of the bow crosses itself"));
    EXPECT_THAT(error.what(), testing::HasSubstr("near y = "));
    EXPECT_THAT(error.what(), testing::HasSubstr("Check the profile"));
  }
  const Section fair =
      square_with_strip({line({1, 0}, {1, 2}), line({1, 2}, {-1, 2}), line({-1, 2}, {-1, 0})});
  EXPECT_NO_THROW(refuse_crossings(divide(fair, 8, {.grading = 0.3, .largest = 1}), "the square"));
}

TEST(Crossings, OfAHoleThatCutsTheOuterBoundaryAreRefused) {
  Section section = square_with_strip({line({1, 0}, {1, 2}), line({1, 2}, {-1, 2}), line({-1, 2}, {-1, 0})});
  section.loops.push_back({arc({0.8, 1}, 0.5, 0, -2 * pi)});
  EXPECT_THROW(refuse_crossings(divide(section, 8, {.grading = 0.3, .largest = 1}), "x"), InputError);
}

TEST(WheelBody, IsAClosedChainFromFlangeBackToFieldSide) {
  const Point2 end{-70, 9.5}, begin{60, -2.6};
  const auto pieces = wheel_body(end, begin);
  EXPECT_LT(norm(pieces.front().begin() - end), 1e-12);
  EXPECT_LT(norm(pieces.back().end() - begin), 1e-12);
  double held = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(norm(pieces[i].begin() - pieces[i - 1].end()), 1e-12) << i;
    }
    if (pieces[i].group == Group::held) {
      held += norm(pieces[i].end() - pieces[i].begin());
      EXPECT_NEAR(pieces[i].begin().z, 92.5 - 460, 1e-12);
    }
  }
  EXPECT_NEAR(held, 180, 1e-12); // the hub's length
}

TEST(WheelBody, RefusesAProfileThatDoesNotFitTheRim) {
  try {
    wheel_body({60, -2.6}, {-70, 9.5}); // walked the wrong way
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("does not fit the rim"));
    EXPECT_THAT(error.what(), testing::HasSubstr("Check the profile's frame, unit and walking order."));
  }
  EXPECT_THROW(wheel_body({-0.07, 0.0095}, {0.06, -0.0026}), InputError); // metres
}

} // namespace
} // namespace bem_contact::meshes
