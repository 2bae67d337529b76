#include "bem_contact/halfspace/wave_stress.hpp"
#include "tests/halfspace/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace bem_contact;
using namespace bem_contact::halfspace;

/// The sum of all waves of a unit traction on -a < x < a is the closed form of that rectangle. Tractions
/// along x are even there, a quarter of a wave ahead of those of strip_wave_stresses().
TEST(WaveStress, AllWavesAreTheRectangle) {
  constexpr double width = 0.5, a = 0.4, poisson = 0.28, pi = std::numbers::pi;
  constexpr std::size_t count = 6;
  const std::vector<double> depths{0.5, 3};
  const GaussRule rule(8);
  for (const double x : {0.0, 0.3, 2.0}) {
    std::vector<UnitStresses> sum(depths.size() * count);
    for (double from = 1e-4, to = 2e-4; from < 56; from = to, to = std::min(2 * from, from + 2))
      for (int p = 0; p < 8; ++p) {
        const double k = from + 0.5 * (to - from) * (1 + rule.point[p]);
        const double weight = 0.5 * (to - from) * rule.weight[p] / pi * 2 * std::sin(k * a) / k;
        const double c = weight * std::cos(k * x), s = weight * std::sin(k * x);
        const auto at = strip_wave_stresses(poisson, k, width, count, depths);
        for (std::size_t i = 0; i < at.size(); ++i)
          for (std::size_t load = 0; load < 3; ++load) {
            const Stress& t = at[i][load];
            const double even = load == 0 ? -s : c, odd = load == 0 ? c : s;
            sum[i][load].add(even, {t.xx, t.ss, t.nn, 0, 0, t.sn}).add(odd, {0, 0, 0, t.xs, t.xn, 0});
          }
      }
    for (std::size_t d = 0; d < depths.size(); ++d)
      for (std::size_t j = 0; j < count; ++j)
        for (const double side : {1.0, -1.0}) {
          const auto right =
              rectangle_stress(poisson, x, side * static_cast<double>(j) * width, depths[d], a, width / 2);
          const UnitStresses& there = sum[d * count + j];
          const UnitStresses found = side > 0 ? there : mirrored(there);
          for (std::size_t load = 0; load < 3; ++load) {
            Stress off = found[load];
            off.add(-1, right[load]);
            // what lies below the first wavenumber is left out: 1e-4 of stresses of a line
            EXPECT_LT(std::max({std::abs(off.xx), std::abs(off.ss), std::abs(off.nn), std::abs(off.xs),
                                std::abs(off.xn), std::abs(off.sn)}),
                      2e-5)
                << "x " << x << " s " << side * double(j) * width << " depth " << depths[d] << " load "
                << load;
          }
        }
  }
}

} // namespace
