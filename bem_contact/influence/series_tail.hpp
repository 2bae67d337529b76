#pragma once

#include <complex>
#include <vector>

namespace bem_contact {

struct TailSums {
  std::complex<double> cubes = 0, fourths = 0;
};

/// Sums over n = first .. last of e^(i n angle) / (n step)^3 and / (n step)^4, for 0 <= angle <= pi.
///
/// From n angle >= expansion_phase (settings.hpp) on they are the difference of two infinite sums, each from
/// its expansion in 1/n (Euler-Maclaurin where angle = 0): the cost does not grow with `last`. Before that,
/// an octave of harmonics has few waves, so that few points stand for it (harmonic_points()). Small angles
/// that need more than tail_octaves of them have the next terms added one by one.
class TailSeries {
public:
  TailSeries(long first, long last, double step);

  long last() const { return last_; }
  /// Exact to 1e-13 of the sum for angle = 0.
  TailSums at(double angle) const;

private:
  struct Octave {
    long end;                                   ///< first harmonic beyond
    std::vector<double> position, cube, fourth; ///< of its points; weight / position^3 and / position^4
  };

  long first_, last_;
  double step_;
  std::vector<Octave> octaves_;
};

} // namespace bem_contact
