#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Kernel of the half-space on strips `width` wide, distance s = s_I - s_J between centres: load and mean.
/// Transforms in x of Boussinesq-Cerruti (Gradshteyn and Ryzhik 3.754, 3.723): 1/r -> 2 K0, s^2/r^3 -> 2 k|s|
/// K1, x s/r^3 -> 2 k s K0 (sine), x/r^2 -> pi e^(-k|s|) (sine), s/r^2 -> pi sign(s) e^(-k|s|). At k = 0 the
/// constant with which a series of half period L has 1/r + O(x^2/L^3) as its sum: 1/r -> 2 (ln(4 L/|s|) -
/// gamma).
inline std::array<std::array<double, 3>, 3>
strip_kernel(const bem_contact::Material& material, double half_period, double k, double s, double width) {
  const double nu = material.poisson, pi = std::numbers::pi;
  std::array<double, 5> sum{}; // 1/r, s^2/r^3, x s/r^3, x/r^2, s/r^2
  for (const int half : {-1, 1})
    for (std::size_t f = 0; f < sum.size(); ++f)
      sum[f] +=
          width * integrate(0, 1, 48, [&](double t) {
            const double d = s + half * t * width, r = std::max(std::abs(d), 1e-300), kr = k * r;
            const double k0 = k == 0 ? std::log(4 * half_period / r) - std::numbers::egamma
                                     : (kr < 600 ? std::cyl_bessel_k(0.0, kr) : 0);
            const double kk1 = k == 0 ? 1 : (kr < 600 ? kr * std::cyl_bessel_k(1.0, kr) : 0);
            const double sign = d < 0 ? -1 : 1;
            const std::array<double, 5> value = {2 * k0, 2 * kk1, k == 0 ? 0 : 2 * k * d * k0,
                                                 k == 0 ? 0 : pi * std::exp(-kr), sign * pi * std::exp(-kr)};
            return (1 - t) * value[f];
          });
  const double c = 1 / (2 * pi * material.shear_modulus), coupling = (1 - 2 * nu) / 2;
  std::array<std::array<double, 3>, 3> g{};
  g[0][0] = c * ((1 - nu) * sum[0] + nu * (sum[0] - sum[1]));
  g[1][1] = c * ((1 - nu) * sum[0] + nu * sum[1]);
  g[2][2] = c * (1 - nu) * sum[0];
  g[0][1] = c * nu * sum[2];        // u_x = g sin kx under p_s cos kx
  g[1][0] = -c * nu * sum[2];       // u_s = -g sin kx under p_x cos kx
  g[0][2] = -c * coupling * sum[3]; // a pressure pulls towards the load
  g[2][0] = -c * coupling * sum[3];
  g[1][2] = -c * coupling * sum[4];
  g[2][1] = c * coupling * sum[4];
  return g;
}

/// Harmonics 0 .. 8, then seven a decade in log k up to 10 / shortest_dx.
inline std::vector<double> sampled_wavenumbers(double half_period, double shortest_dx, int per_decade = 7) {
  std::vector<double> k;
  for (int n = 0; n <= 8; ++n)
    k.push_back(n * std::numbers::pi / half_period);
  const double from = k.back(), to = 10 / shortest_dx;
  const int steps = static_cast<int>(std::ceil(std::log10(to / from) * per_decade));
  for (int i = 1; i <= steps; ++i)
    k.push_back(from * std::pow(to / from, i / static_cast<double>(steps)));
  return k;
}

/// A flat half-space as an influence function; its remote section is made up (a body that does not move).
inline bem_contact::InfluenceFunction halfspace_function(const bem_contact::Material& material, int stations,
                                                         double width, double shortest_dx,
                                                         double half_period = 600, int per_decade = 7) {
  bem_contact::InfluenceFunction f;
  f.body = "half-space";
  f.profile = "plane";
  f.profile_digest = 42;
  f.material = material;
  f.held = "not at all";
  f.method = "closed form";
  f.half_period = half_period;
  f.station_width = width;
  for (int i = 0; i < stations; ++i)
    f.stations.push_back({(i - 0.5 * (stations - 1)) * width, {(i - 0.5 * (stations - 1)) * width, 0}, 0});
  f.wavenumber = sampled_wavenumbers(half_period, shortest_dx, per_decade);
  const std::size_t n = 3 * static_cast<std::size_t>(stations), nk = f.wavenumber.size();
  f.kernel.resize(nk * f.kernel_size());
  f.remote.assign(nk * 6 * n, 0);
  f.remote_self.assign(nk * 36, 0);
  for (std::size_t k = 0; k < nk; ++k) {
    for (std::size_t d = 0; d < 6; ++d)
      f.remote_self[k * 36 + 7 * d] = 1;
    for (std::size_t distance = 0; 3 * distance < n; ++distance) {
      const auto g =
          strip_kernel(material, half_period, f.wavenumber[k], static_cast<double>(distance) * width, width);
      for (std::size_t row = 0; 3 * (row + distance) < n; ++row)
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = 3 * (row + distance) + i, b = 3 * row + j;
            const double value = distance > 0 || i == j || (i != 1 && j != 1) ? g[i][j] : 0;
            f.kernel[f.kernel_index(k, a, b)] = value;
          }
    }
  }
  return f;
}
