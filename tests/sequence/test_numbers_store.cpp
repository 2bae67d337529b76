// What a sequence keeps of influence numbers.
#include "bem_contact/sequence/numbers/numbers_store.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"

#include <gtest/gtest.h>

using namespace bem_contact;

namespace {

/// Each number tells its place: rows by their arc length.
InfluenceNumbers numbers_at(const std::vector<double>& row_s, int offsets) {
  InfluenceNumbers a{offsets, static_cast<int>(row_s.size()), 0.5, 0.25, {}};
  a.values.resize(a.expected_values());
  for (int m = 0; m < offsets; ++m)
    for (const auto& [row_i, row_j] : a.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          a.at(m, row_i, i, row_j, j) = 1000 * row_s[static_cast<std::size_t>(row_i)] +
                                        row_s[static_cast<std::size_t>(row_j)] + 0.1 * m + 0.03 * i +
                                        0.01 * j;
  return a;
}

std::shared_ptr<const InfluenceFile> small_rail() {
  return std::make_shared<const InfluenceFile>(CONFORMAL_SOURCE_DIR "/data/influence/small_rail.h5");
}

/// Asks a store, and tells whether it had to compute.
struct Rail {
  RailNumbersStore store;
  BodyNumbersSource source{small_rail(), StructuralCompliance::removed, 0.5, 0.25};
  int computed = 0;

  InfluenceNumbers get(const std::vector<double>& row_s, int offsets) {
    return store.get(source, row_s, offsets, [&] {
      ++computed;
      return numbers_at(row_s, offsets);
    });
  }
};

} // namespace

TEST(RailNumbersStore, ServesRowsAmongThoseOfAnEarlierCase) {
  Rail rail;
  rail.get({1, 2, 3, 4, 5}, 7);
  const InfluenceNumbers part = rail.get({2, 3, 4}, 6), exact = numbers_at({2, 3, 4}, 6);
  EXPECT_EQ(rail.computed, 1);
  EXPECT_EQ(part.values, exact.values);
  EXPECT_EQ(part.rows, 3);
  EXPECT_EQ(part.offsets, 6);
  EXPECT_EQ(part.ds, exact.ds);
}

TEST(RailNumbersStore, ComputesWhatItDoesNotHave) {
  Rail rail;
  rail.get({1, 2, 3}, 7);
  rail.get({1, 2, 3}, 8);  // more offsets
  rail.get({3, 4}, 7);     // a row beyond
  rail.get({1.5, 2.5}, 7); // rows between
  rail.source.ds = 0.3;    // other elements
  EXPECT_EQ(rail.get({1, 2}, 7).values, numbers_at({1, 2}, 7).values);
  rail.source.file = small_rail(); // opened again: another one, for all the store knows
  rail.get({1, 2}, 7);
  rail.source.structural = StructuralCompliance::included;
  rail.get({1, 2}, 7);
  EXPECT_EQ(rail.computed, 7);
}

TEST(NumbersStore, GivesItsNumbersAway) {
  NumbersStore store;
  int computed = 0;
  const auto compute = [&] {
    ++computed;
    return numbers_at({1, 2}, 3);
  };
  NumbersSource source;
  for (int round = 0; round < 3; ++round) {
    InfluenceNumbers numbers = store.take(source, compute);
    EXPECT_EQ(numbers.values, numbers_at({1, 2}, 3).values);
    store.keep(source, std::move(numbers));
  }
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(store.found(), 2);
  store.take(source, compute); // and not given back
  store.take(source, compute);
  EXPECT_EQ(computed, 2);
}

TEST(NumbersStore, KeepsTheGridsMetLast) {
  NumbersStore store;
  const auto source_of = [](int columns) {
    NumbersSource source;
    source.columns = columns;
    return source;
  };
  for (int columns = 0; columns <= numbers_kept; ++columns)
    store.keep(source_of(columns), numbers_at({1, 2}, 3));
  int computed = 0;
  const auto compute = [&] {
    ++computed;
    return numbers_at({1, 2}, 3);
  };
  store.take(source_of(1), compute);
  EXPECT_EQ(computed, 0);
  store.take(source_of(0), compute);
  EXPECT_EQ(computed, 1);
}

TEST(NumbersStore, KeepsOneGridAtLeastHoweverLarge) {
  NumbersStore store;
  const auto large = [] {
    InfluenceNumbers a{1, 1, 0.5, 0.25, {}};
    a.values.resize(static_cast<std::size_t>(largest_kept_numbers * 1e6 / sizeof(double) * 0.6));
    return a;
  };
  NumbersSource first, second;
  second.columns = 1;
  store.keep(first, large());
  store.keep(second, large());
  int computed = 0;
  const auto compute = [&] {
    ++computed;
    return InfluenceNumbers();
  };
  store.take(second, compute);
  EXPECT_EQ(computed, 0);
  store.take(first, compute);
  EXPECT_EQ(computed, 1);
}
