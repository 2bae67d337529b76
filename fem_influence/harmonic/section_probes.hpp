#pragma once

#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/inside/section.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/harmonic/harmonic_system.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Amplitudes of one wave: of xx, ss, nn and sn with cos kx, of xs and xn with sin kx.
struct WaveStress {
  halfspace::Stress even, odd;
};

/// Points of a section at which stresses follow from a solution.
class SectionProbes {
public:
  /// `radius`: R_ref of a body of revolution, else 0. Points have an arc length on the curve.
  SectionProbes(const Section& section, const ProfileCurve& curve, double radius,
                std::span<const inside::BelowSurface> points);

  std::size_t count() const { return probes_.size(); }
  bool is_there(std::size_t probe) const { return !probes_[probe].shapes.nodes.empty(); }
  /// Of a solution for the wavenumber k (THEORY.md, section 2), in the frame of the surface above the point,
  /// which must be there.
  WaveStress stress(const HarmonicSystem& system, std::size_t probe, double k,
                    std::span<const double> solution) const;
  /// use(unknown, stress) for each unknown of the cell that it lies in: what 1 mm of it makes there.
  void for_each_unknown(const HarmonicSystem& system, std::size_t probe, double k,
                        const std::function<void(int, const WaveStress&)>& use) const;

private:
  /// Displacements and their derivatives along y and z, by component.
  struct Field {
    std::array<double, 3> u{}, uy{}, uz{};
  };
  WaveStress stress_of(const HarmonicSystem& system, std::size_t probe, double k, const Field& field) const;
  struct Probe {
    PointShapes shapes; ///< of the cell that it lies in
    Point2 position;
    double delta = 0; ///< of the surface above it
  };
  double radius_;
  std::vector<Probe> probes_;
};

} // namespace bem_contact::fem
