#include "fem_influence/harmonic/wavenumbers.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <cmath>
#include <numbers>

namespace bem_contact::fem {

std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade) {
  if (!(half_period > 0) || !(shortest_dx > 0) || samples_per_decade < 1)
    throw InputError("The wavenumbers cannot be chosen",
                     "half_period, shortest_dx and samples_per_decade must be positive",
                     "Correct [harmonic] of the body file.");
  const double unit = std::numbers::pi / half_period,
               largest = settings::largest_wavenumber_times_dx / shortest_dx;
  std::vector<double> k{0};
  for (int n = 1; n <= settings::exact_harmonics; ++n)
    k.push_back(n * unit);
  if (largest <= k.back())
    throw InputError("The largest wavenumber 10 / shortest_dx does not exceed that of harmonic 8",
                     "the half period is too short for elements that long",
                     "Lower harmonic.shortest_dx or raise harmonic.half_period.");
  const double from = std::log(k.back()), length = std::log(largest) - from;
  // An even number, so that every second sample can be left out.
  const int steps = 2 * static_cast<int>(std::ceil(length / std::numbers::ln10 * samples_per_decade / 2));
  for (int i = 1; i < steps; ++i)
    k.push_back(std::exp(from + length * i / steps));
  k.push_back(largest);
  return k;
}

} // namespace bem_contact::fem
