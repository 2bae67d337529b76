#include "bem_contact/sequence/numbers/numbers_store.hpp"

#include "bem_contact/sequence/numbers/keep_newest.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

/// Numbers of `count` rows from `first` on, of fewer offsets.
InfluenceNumbers part_of(const InfluenceNumbers& all, int first, int count, int offsets) {
  InfluenceNumbers part{offsets, count, all.dx, all.ds, {}};
  part.values.reserve(part.expected_values());
  for (int m = 0; m < offsets; ++m)
    for (int row = first; row < first + count; ++row)
      for (int i = 0; i < 3; ++i) {
        const double* from = &all.values[all.index(m, row, i, first, 0)];
        part.values.insert(part.values.end(), from, from + 3 * static_cast<std::ptrdiff_t>(count));
      }
  return part;
}

double megabytes_of(const InfluenceNumbers& numbers) {
  return 1e-6 * sizeof(double) * static_cast<double>(numbers.values.size());
}

} // namespace

InfluenceNumbers RailNumbersStore::get(const BodyNumbersSource& source, const std::vector<double>& row_s,
                                       int offsets, const std::function<InfluenceNumbers()>& compute) {
  for (const Kept& kept : kept_) {
    const auto found = std::ranges::search(kept.row_s, row_s);
    if (kept.source == source && !found.empty() && kept.numbers.offsets >= offsets)
      return part_of(kept.numbers, static_cast<int>(found.begin() - kept.row_s.begin()),
                     static_cast<int>(row_s.size()), offsets);
  }
  InfluenceNumbers numbers = compute();
  if (megabytes_of(numbers) <= largest_kept_numbers) {
    kept_.push_front({source, row_s, numbers});
    keep_newest(
        kept_, [](const Kept& kept) { return megabytes_of(kept.numbers); }, largest_kept_numbers,
        numbers_kept);
  }
  return numbers;
}

InfluenceNumbers NumbersStore::take(const NumbersSource& source,
                                    const std::function<InfluenceNumbers()>& compute) {
  const auto found = std::ranges::find(
      kept_, source, [](const auto& kept) -> const auto& { return kept.first; });
  if (found == kept_.end())
    return compute();
  ++found_;
  InfluenceNumbers numbers = std::move(found->second);
  kept_.erase(found);
  return numbers;
}

void NumbersStore::keep(const NumbersSource& source, InfluenceNumbers numbers) {
  kept_.emplace_front(source, std::move(numbers));
  keep_newest(
      kept_, [](const auto& kept) { return megabytes_of(kept.second); }, largest_kept_numbers, numbers_kept);
}

} // namespace bem_contact
