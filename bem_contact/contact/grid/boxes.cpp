#include "bem_contact/contact/grid/boxes.hpp"

#include "bem_contact/contact/settings.hpp"

namespace bem_contact::contact {
namespace {

/// From the first to the last element on the rows from .. to.
struct Span {
  int low_x = 0, high_x = 0, low_s = 0, high_s = 0;
};

/// One for each group of rows. Between groups there are at least `apart` empty rows.
std::vector<Span> groups(std::span<const int> elements, const ContactGrid& grid, int apart) {
  std::vector<int> low(grid.ms, grid.mx), high(grid.ms, -1);
  for (const int i : elements) {
    low[i / grid.mx] = std::min(low[i / grid.mx], i % grid.mx);
    high[i / grid.mx] = std::max(high[i / grid.mx], i % grid.mx);
  }
  std::vector<Span> found;
  for (int is = 0; is < grid.ms; ++is) {
    if (high[is] < 0)
      continue;
    if (found.empty() || is - found.back().high_s > apart)
      found.push_back({low[is], high[is], is, is});
    Span& last = found.back();
    last = {std::min(last.low_x, low[is]), std::max(last.high_x, high[is]), last.low_s, is};
  }
  return found;
}

/// One box around each span, all of the size of the largest and inside the grid.
std::vector<Box> boxes_of(const std::vector<Span>& spans, const ContactGrid& grid, int margin) {
  int mx = 1, ms = 1;
  for (const Span& s : spans) {
    mx = std::max(mx, std::min(s.high_x + margin, grid.mx - 1) - std::max(s.low_x - margin, 0) + 1);
    ms = std::max(ms, std::min(s.high_s + margin, grid.ms - 1) - std::max(s.low_s - margin, 0) + 1);
  }
  std::vector<Box> boxes;
  for (const Span& s : spans)
    boxes.push_back({std::clamp(s.low_x - margin, 0, grid.mx - mx),
                     std::clamp(s.low_s - margin, 0, grid.ms - ms), mx, ms});
  return boxes;
}

} // namespace

int Boxes::local(int element, int grid_mx) const {
  const int x = element % grid_mx, s = element / grid_mx;
  for (int k = 0; k < count(); ++k)
    if (boxes[k].contains(x, s))
      return (k * ms() + s - boxes[k].first_s) * mx() + x - boxes[k].first_x;
  return -1;
}

std::vector<int> Boxes::local(std::span<const int> elements, int grid_mx) const {
  std::vector<int> places(elements.size());
  std::ranges::transform(elements, places.begin(), [&](int element) { return local(element, grid_mx); });
  return places;
}

bool Boxes::cover(std::span<const int> elements, int grid_mx) const {
  return std::ranges::all_of(elements, [&](int element) { return local(element, grid_mx) >= 0; });
}

Boxes boxes_around(std::span<const int> elements, const ContactGrid& grid, int margin, bool same_columns) {
  std::vector<Span> spans = groups(elements, grid, rows_between_boxes);
  Span all = spans.front();
  for (const Span& s : spans)
    all = {std::min(all.low_x, s.low_x), std::max(all.high_x, s.high_x), all.low_s, s.high_s};
  const Boxes one{boxes_of({all}, grid, margin)};
  if (spans.size() == 1 || spans.size() > std::size_t(most_boxes))
    return one;
  if (same_columns)
    for (Span& s : spans)
      s.low_x = all.low_x, s.high_x = all.high_x;
  const Boxes several{boxes_of(spans, grid, margin)};
  for (int k = 1; k < several.count(); ++k)
    if (several.boxes[k - 1].first_s + several.ms() > several.boxes[k].first_s)
      return one;
  return several.size() < several_boxes_share * one.size() ? several : one;
}

bool serve(const Boxes& earlier, const Boxes& needed, std::span<const int> elements, int grid_mx) {
  return earlier.size() <= box_reuse_factor * needed.size() && earlier.cover(elements, grid_mx);
}

} // namespace bem_contact::contact
