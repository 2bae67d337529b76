#include "bem_contact/halfspace/near_field.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/halfspace/plane_strain.hpp"
#include "bem_contact/halfspace/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bem_contact::halfspace {

BEM_CONTACT_WIDE void add_mix(const LineMix& mix, std::size_t shift, double factor, double* __restrict line,
                              std::size_t offsets) {
  if (mix.count == 0)
    std::transform(line, line + offsets, line, [factor](double v) { return factor * v; });
  for (std::size_t first = 0; first < mix.count; first += 4) { // one pass over the line for four
    const auto from = [&](std::size_t b) {
      return mix.block[first + b < mix.count ? first + b : first] + shift;
    };
    const auto weight = [&](std::size_t b) { return first + b < mix.count ? mix.weight[first + b] : 0.0; };
    const double* const __restrict p0 = from(0), * const __restrict p1 = from(1);
    const double* const __restrict p2 = from(2), * const __restrict p3 = from(3);
    const double own = first == 0 ? factor : 1, w0 = weight(0), w1 = weight(1), w2 = weight(2),
                 w3 = weight(3);
    for (std::size_t m = 0; m < offsets; ++m)
      line[m] = own * line[m] + w0 * p0[m] + w1 * p1[m] + w2 * p2[m] + w3 * p3[m];
  }
}

namespace {

/// How many lines serve the distances from .. to (absolute values) of rows ds wide; more than `most`: no
/// polynomial does.
int lines_for(double from, double to, double ds, int most) {
  const double half = 0.5 * (to - from);
  if (half <= same_distance * ds)
    return 1;
  const double apart = from - ds + half;
  if (!(from > ds))
    return most + 1;
  const double ratio = half / (2 * apart);
  int count = 1;
  for (double error = 4 * ratio; count <= most && error > near_field_accuracy; error *= ratio)
    ++count;
  return std::max(count, 2);
}

/// Ends of a range of distances that other strips have too.
std::pair<double, double> rounded_outwards(double from, double to, double ds) {
  const double width = to - from;
  if (width <= same_distance * ds) {
    const double whole = ds * std::round(from / ds); // of equal rows
    return std::abs(from - whole) <= same_distance * ds ? std::pair(whole, whole) : std::pair(from, to);
  }
  const double step = std::exp2(std::floor(std::log2(width)) - 1);
  return {step * std::floor(from / step), step * std::ceil(to / step)};
}

} // namespace

NearField::NearField(const Material& material, const ExpandOptions& options, std::span<const double> row_s,
                     double ds, LineStore& known)
    : NearField(
          material, options, row_s.size(),
          [&](std::size_t apart, std::size_t row_j) { return row_s[row_j + apart] - row_s[row_j]; }, ds,
          known) {}

NearField::NearField(const Material& material, const ExpandOptions& options, std::size_t rows,
                     const Distances& distance, double ds, LineStore& known) {
  std::vector<double> at; // distances of the lines
  mixes_.reserve(rows * (rows + 1) / 2);
  for (std::size_t d = 0; d < rows; ++d) {
    first_of_.push_back(mixes_.size());
    std::vector<double> distances;
    for (std::size_t j = 0; j + d < rows; ++j)
      distances.push_back(distance(d, j));
    add_mixes(distances, ds, at);
  }
  fill(material, options, at, ds, known);
}

void NearField::add_mixes(std::span<const double> distances, double ds, std::vector<double>& at) {
  const auto [least, greatest] = std::minmax_element(distances.begin(), distances.end());
  const auto [low, high] = rounded_outwards(*least, *greatest, ds);
  const int count =
      lines_for(std::min(std::abs(low), std::abs(high)), std::max(std::abs(low), std::abs(high)), ds, most);
  if (count > most || count >= static_cast<int>(distances.size())) { // one line each, but for equal distances
    for (std::size_t j = 0; j < distances.size(); ++j) {
      if (j == 0 || std::abs(distances[j] - at.back()) > same_distance * ds)
        at.push_back(low == high ? low : distances[j]);
      mixes_.push_back({at.size() - 1, 1, {1}});
    }
    return;
  }
  const std::size_t first = at.size();
  for (int p = 0; p < count; ++p)
    at.push_back(0.5 * (low + high) - 0.5 * (high - low) * std::cos((p + 0.5) * std::numbers::pi / count));
  const std::span<const double> nodes = std::span(at).subspan(first);
  for (const double s : distances) {
    Mix mix{first, count, {}};
    for (std::size_t p = 0; p < nodes.size(); ++p) {
      double weight = 1;
      for (std::size_t q = 0; q < nodes.size(); ++q)
        if (q != p)
          weight *= (s - nodes[q]) / (nodes[p] - nodes[q]);
      mix.weight[p] = weight;
    }
    mixes_.push_back(mix);
  }
}

void NearField::fill(const Material& material, const ExpandOptions& options, std::span<const double> at,
                     double ds, LineStore& known) {
  lines_ = at.size();
  offsets_ = static_cast<std::size_t>(options.dx == 0 ? 1 : options.offsets);
  values_.resize(lines_ * 9 * offsets_);
  for (std::size_t l = 0; l < lines_; ++l) {
    double* const to = &values_[l * 9 * offsets_];
    if (options.dx == 0) {
      // Any reference distance will do: resample() takes away what it adds.
      const Matrix3 number = averaged_plane_strain(material, at[l], ds, plane_strain_reference);
      for (std::size_t e = 0; e < 9; ++e)
        to[e] = number[e / 3][e % 3];
      continue;
    }
    const LineStore::Line line = known.get(material, at[l], options.dx, ds, offsets_);
    for (std::size_t e = 0; e < 9; ++e)
      std::copy_n(line.values + e * line.offsets, offsets_, to + e * offsets_);
  }
}

} // namespace bem_contact::halfspace
