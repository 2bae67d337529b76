#include "bem_contact/contact/grid/box.hpp"

namespace bem_contact::contact {
namespace {

/// From the first to the last element on the rows from .. to.
struct Span {
  int low_x = 0, high_x = 0, low_s = 0, high_s = 0;
};

/// One for each group of rows that at least `apart` empty ones part.
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

/// Boxes of the size of the largest, inside the grid.
std::vector<Box> boxes_around(const std::vector<Span>& spans, const ContactGrid& grid, int margin) {
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

Parts parts_around(std::span<const int> elements, const ContactGrid& grid, int margin, bool columns) {
  constexpr int apart = 8, most = 3;
  constexpr double saves = 0.6; // else one box is as good
  std::vector<Span> spans = groups(elements, grid, apart);
  Span all = spans.front();
  for (const Span& s : spans)
    all = {std::min(all.low_x, s.low_x), std::max(all.high_x, s.high_x), all.low_s, s.high_s};
  const Parts one{boxes_around({all}, grid, margin)};
  if (spans.size() == 1 || spans.size() > most)
    return one;
  if (columns)
    for (Span& s : spans)
      s.low_x = all.low_x, s.high_x = all.high_x;
  const Parts several{boxes_around(spans, grid, margin)};
  for (int k = 1; k < several.count(); ++k)
    if (several.boxes[k - 1].first_s + several.ms() > several.boxes[k].first_s)
      return one;
  return several.size() < saves * one.size() ? several : one;
}

} // namespace bem_contact::contact
