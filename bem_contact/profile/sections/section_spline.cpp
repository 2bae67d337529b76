#include "bem_contact/profile/sections/section_spline.hpp"

namespace bem_contact {

SectionSpline::SectionSpline(const std::vector<double>& places) {
  const std::size_t n = places.size();
  for (std::size_t i = 0; i + 1 < n; ++i)
    length_.push_back(places[i + 1] - places[i]);
  if (n == 2)
    return;
  rows_.resize(n);
  const std::vector<double>& h = length_;
  if (n == 3) { // the parabola
    const double sum = h[0] + h[1];
    rows_ = {{.first = 1 + h[0] / sum, .second = -h[0] / sum},
             {.first = h[1] / sum, .second = h[0] / sum},
             {.first = -h[1] / sum, .second = 1 + h[1] / sum}};
    return;
  }
  std::vector<double> middle(n), behind(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    rows_[i] = {.before = h[i], .first = 3 * h[i], .second = 3 * h[i - 1]};
    middle[i] = 2 * (h[i - 1] + h[i]);
    behind[i] = h[i - 1];
  }
  const double begin = h[0] + h[1], end = h[n - 2] + h[n - 3];
  rows_[0] = {.first = (h[0] + 2 * begin) * h[1] / begin, .second = h[0] * h[0] / begin};
  middle[0] = h[1], behind[0] = begin;
  rows_[n - 1] = {
      .before = end, .first = h[n - 2] * h[n - 2] / end, .second = (h[n - 2] + 2 * end) * h[n - 3] / end};
  middle[n - 1] = h[n - 3];
  for (std::size_t i = 0; i < n; ++i) { // no pivots are needed: places rise
    const double left = i == 0 ? 0 : rows_[i].before * rows_[i - 1].after;
    rows_[i].scale = 1 / (middle[i] - left);
    rows_[i].after = behind[i] * rows_[i].scale;
  }
}

} // namespace bem_contact
