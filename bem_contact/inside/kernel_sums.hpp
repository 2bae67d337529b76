#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/stress_kernel.hpp"
#include "bem_contact/inside/remainder.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact::inside {

/// The surface there: between two places as on a line, beside the first and the last as if the profile went
/// on straight.
ContactRow surface_at(const StressKernel& kernel, double s);

/// A point between places and depths of a stress kernel: Lagrange's weights of up to four of each. No
/// weights: the kernel has nothing there.
struct KernelPoint {
  std::size_t place = 0, depth = 0; ///< the first ones
  std::vector<double> of_place, of_depth;

  /// `s` and `log_depths`: of the kernel's places and depths.
  KernelPoint(const StressKernel& kernel, std::span<const double> s, std::span<const double> log_depths,
              const BelowSurface& at);
  bool is_there() const { return !of_place.empty(); }
};

/// Stresses of a stress kernel under given tractions.
class KernelSums {
public:
  /// `tractions` have a row for each station of the strip.
  KernelSums(const InfluenceStrip& strip, const StressKernel& kernel, const SurfaceTractions& tractions);

  /// At these points and places along x; nan where the kernel has nothing. Errors are those of the mesh.
  ProbedRemainder at(std::span<const BelowSurface> points, std::span<const double> x) const;

private:
  std::vector<Passage> sums(const StressForm& form, std::span<const KernelPoint> points,
                            std::span<const double> x, double rho) const;

  const InfluenceStrip& strip_;
  const StressKernel& kernel_;
  const SurfaceTractions& tractions_;
  StationRange loaded_;
};

} // namespace bem_contact::inside
