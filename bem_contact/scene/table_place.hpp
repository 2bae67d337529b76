#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace bem_contact {

/// Where an arc length or an inclination lies in a table whose rows have a rising member `at`: a value there
/// is (1 - share) times that of `before` plus share times that of `after`. Beyond the ends both are the last
/// row.
template <class Row> struct TablePlace {
  const Row *before, *after;
  double share = 0;
};

/// The table must not be empty.
template <class Row> TablePlace<Row> place_in(const std::vector<Row>& table, double at) {
  const auto after = std::ranges::find_if(table, [at](const Row& row) { return row.at > at; });
  if (after == table.begin() || after == table.end()) {
    const Row* const end = after == table.begin() ? &table.front() : &table.back();
    return {end, end};
  }
  const auto before = std::prev(after);
  return {&*before, &*after, (at - before->at) / (after->at - before->at)};
}

} // namespace bem_contact
