#include "fem_influence/harmonic/section_probes.hpp"

#include <cmath>
#include <utility>

namespace bem_contact::fem {

SectionProbes::SectionProbes(const Section& section, const ProfileCurve& curve, double radius,
                             std::span<const inside::BelowSurface> points)
    : radius_(radius) {
  std::vector<Point2> positions;
  for (const inside::BelowSurface& p : points) {
    const CurvePoint above = curve.at(p.s);
    positions.push_back(above.position + p.depth * normal_of(above.delta));
    probes_.push_back({{}, positions.back(), above.delta});
  }
  std::vector<PointShapes> shapes = section.shapes_at(positions);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    probes_[i].shapes = std::move(shapes[i]);
}

WaveStress SectionProbes::stress(const HarmonicSystem& system, std::size_t probe, double k,
                                 std::span<const double> solution) const {
  Field field;
  const PointShapes& at = probes_[probe].shapes;
  for (std::size_t a = 0; a < at.nodes.size(); ++a)
    for (std::size_t c = 0; c < 3; ++c)
      if (const int row = system.unknown[3 * static_cast<std::size_t>(at.nodes[a]) + c]; row >= 0) {
        const double v = solution[static_cast<std::size_t>(row)];
        field.u[c] += at.value[a] * v;
        field.uy[c] += at.d_dy[a] * v;
        field.uz[c] += at.d_dz[a] * v;
      }
  return stress_of(system, probe, k, field);
}

void SectionProbes::for_each_unknown(const HarmonicSystem& system, std::size_t probe, double k,
                                     const std::function<void(int, const WaveStress&)>& use) const {
  const PointShapes& at = probes_[probe].shapes;
  for (std::size_t a = 0; a < at.nodes.size(); ++a)
    for (std::size_t c = 0; c < 3; ++c)
      if (const int row = system.unknown[3 * static_cast<std::size_t>(at.nodes[a]) + c]; row >= 0) {
        Field one;
        one.u[c] = at.value[a];
        one.uy[c] = at.d_dy[a];
        one.uz[c] = at.d_dz[a];
        use(row, stress_of(system, probe, k, one));
      }
}

WaveStress SectionProbes::stress_of(const HarmonicSystem& system, std::size_t probe, double k,
                                    const Field& field) const {
  const auto& [u, uy, uz] = field;
  const double mu = system.op.mu, lambda = system.op.lambda, z = probes_[probe].position.z,
               r = radius_ == 0 ? 1 : (radius_ + z) / radius_, over_r = radius_ == 0 ? 0 : 1 / (radius_ + z);
  const double e_xx = k / r * u[0] + over_r * u[2], e_yy = uy[1], e_zz = uz[2];
  const double trace = lambda * (e_xx + e_yy + e_zz);
  const double xx = trace + 2 * mu * e_xx, yy = trace + 2 * mu * e_yy, zz = trace + 2 * mu * e_zz,
               yz = mu * (uz[1] + uy[2]), xy = mu * (uy[0] - k / r * u[1]),
               xz = mu * (uz[0] - over_r * u[0] - k / r * u[2]);
  const double c = std::cos(probes_[probe].delta), s = std::sin(probes_[probe].delta);
  return {{xx, yy * c * c + zz * s * s + 2 * yz * c * s, yy * s * s + zz * c * c - 2 * yz * c * s, 0, 0,
           (zz - yy) * c * s + yz * (c * c - s * s)},
          {0, 0, 0, xy * c + xz * s, xz * c - xy * s, 0}};
}

} // namespace bem_contact::fem
