#include "bem_contact/sequence/numbers/numbers_store.hpp"

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

/// Those kept last are in front; the first of them stays whatever its size.
template <class Kept, class NumbersOf> void discard_old(std::deque<Kept>& kept, const NumbersOf& numbers_of) {
  double megabytes = 0;
  std::size_t count = 0;
  while (count < std::min<std::size_t>(kept.size(), numbers_kept)) {
    megabytes += megabytes_of(numbers_of(kept[count]));
    if (count > 0 && megabytes > largest_kept_numbers)
      break;
    ++count;
  }
  kept.resize(count);
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
    discard_old(kept_, [](const Kept& kept) -> const InfluenceNumbers& { return kept.numbers; });
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
  discard_old(kept_, [](const auto& kept) -> const InfluenceNumbers& { return kept.second; });
}

} // namespace bem_contact
