#include "bem_contact/inside/waves.hpp"

#include "bem_contact/inside/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::inside {

namespace {

/// rad. By so much the phase turns at most within a panel of the integral over wavenumbers, of four Gauss
/// points: that costs a ten-thousandth.
constexpr double phase_of_panel = 3.5;

} // namespace

std::vector<Wavenumber> waves_of_series(double half_period, double last, double reach) {
  const double unit = std::numbers::pi / half_period, widest = phase_of_panel / reach;
  std::vector<Wavenumber> out{{0, 0.5 / half_period}};
  for (int n = 1; n <= lowest_waves; ++n)
    out.push_back({n * unit, 1 / half_period});
  constexpr std::array<double, 4> point{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                        0.8611363115940526},
      weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  for (double from = (lowest_waves + 0.5) * unit; from < last;) {
    const double width = std::min(from, widest);
    for (std::size_t i = 0; i < point.size(); ++i)
      out.push_back({from + 0.5 * width * (1 + point[i]), 0.5 * width * weight[i] / std::numbers::pi});
    from += width;
  }
  return out;
}

double reach_of(const SurfaceTractions& t) {
  return std::max(std::abs(t.x(0)), std::abs(t.x(t.columns - 1))) + t.dx / 2;
}

WaveOfRow::WaveOfRow(const SurfaceTractions& t, std::size_t row, double k) {
  const double half = 0.5 * k * t.dx, length = t.dx * (half < 1e-6 ? 1 : std::sin(half) / half);
  for (int column = 0; column < t.columns; ++column) {
    const std::array<double, 3> p =
        t.at(row * static_cast<std::size_t>(t.columns) + static_cast<std::size_t>(column));
    if (p == std::array<double, 3>{})
      continue;
    const double c = length * std::cos(k * t.x(column)), s = length * std::sin(k * t.x(column));
    for (std::size_t i = 0; i < 3; ++i) {
      cosine[i] += c * p[i];
      sine[i] += s * p[i];
    }
  }
}

WaveAt::WaveAt(double phase, bool second) {
  const double turned = phase - (second ? std::numbers::pi / 2 : 0);
  even = std::cos(turned);
  odd = std::sin(turned);
}

} // namespace bem_contact::inside
