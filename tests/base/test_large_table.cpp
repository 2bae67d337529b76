#include "bem_contact/base/large_table.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace bem_contact;

/// Small ones lie on the heap, large ones in pages of their own; both are vectors like any other.
TEST(LargeTable, KeepsItsValuesAtEverySize) {
  for (const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(1000), std::size_t(3) << 20}) {
    LargeTable<double> table(n, 1.5);
    EXPECT_EQ(std::accumulate(table.begin(), table.end(), 0.0), 1.5 * static_cast<double>(n));
    table.resize(n + 1);
    table.back() = 2;
    const LargeTable<double> copy = table;
    table.assign(n, 0.0);
    EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), 0.0), 1.5 * static_cast<double>(n) + 2);
    EXPECT_EQ(std::accumulate(table.begin(), table.end(), 0.0), 0);
  }
}
