#include "fem_influence/harmonic/section_stresses.hpp"

#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/mumps_solver.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact::fem {

namespace {

using halfspace::Stress;

/// 1 (over the least depth). The largest wavenumber: what is above it has decayed at this depth to 4 % of an
/// amplitude that is a hundredth itself.
constexpr double largest_wavenumber = 5;
/// rad. By so much the phase turns at most within a panel of the integral over wavenumbers, of four Gauss
/// points: that costs a ten-thousandth.
constexpr double phase_of_panel = 3.5;

struct Wavenumber {
  double k = 0, weight = 0;
};

/// The series f(x) = 1/(2L) F(0) + 1/L sum F(n pi/L) cos(n pi x/L): its lowest terms as they are, and the
/// others as an integral up to `last`, in panels that are `widest` wide.
std::vector<Wavenumber> wavenumbers(double half_period, double last, double widest) {
  const double unit = std::numbers::pi / half_period;
  std::vector<Wavenumber> out{{0, 0.5 / half_period}};
  for (int n = 1; n <= settings::exact_harmonics; ++n)
    out.push_back({n * unit, 1 / half_period});
  constexpr std::array<double, 4> point{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                        0.8611363115940526},
      weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  for (double from = (settings::exact_harmonics + 0.5) * unit; from < last;) {
    const double width = std::min(from, widest);
    for (std::size_t i = 0; i < point.size(); ++i)
      out.push_back({from + 0.5 * width * (1 + point[i]), 0.5 * width * weight[i] / std::numbers::pi});
    from += width;
  }
  return out;
}

/// Integrals over x of a row's tractions times cos kx and sin kx; [component].
struct Transform {
  std::array<double, 3> cosine{}, sine{};

  Transform(const inside::SurfaceTractions& t, std::size_t row, double k) {
    const double half = 0.5 * k * t.dx, length = t.dx * (half < 1e-6 ? 1 : std::sin(half) / half);
    for (int column = 0; column < t.columns; ++column) {
      const std::array<double, 3> p =
          t.at(row * static_cast<std::size_t>(t.columns) + static_cast<std::size_t>(column));
      const double c = length * std::cos(k * t.x(column)), s = length * std::sin(k * t.x(column));
      for (std::size_t i = 0; i < 3; ++i) {
        cosine[i] += c * p[i];
        sine[i] += s * p[i];
      }
    }
  }
};

/// A point with the shapes of its cell.
struct Probe {
  PointShapes shapes;
  Point2 position;
  double delta = 0; ///< of the surface above it
};

/// Amplitudes of one wave: of xx, ss, nn and sn with cos kx, of xs and xn with sin kx.
struct Amplitudes {
  Stress even, odd;
};

class SectionRun {
public:
  explicit SectionRun(const SectionTask& task)
      : task_(task), stations_(make_stations(task.body.strip, task.curve)),
        radius_(reference_radius_of(task.body)) {
    Timing timing;
    MeshedSystem meshed(task.body, task.curve, task.mesh, {}, timing);
    find_probes(*meshed.section);
    AssembledSystem assembled = add_matrices(std::move(meshed), timing);
    system_ = std::move(assembled.system);
    renumber(system_, assembled.order);
  }

  SectionStresses compute(const std::function<void(std::size_t, std::size_t)>& progress) {
    double reach = 0;
    for (const AskedStresses& area : task_.areas)
      for (const double x : area.x)
        reach = std::max(reach, std::abs(x));
    double loaded = 0;
    for (const inside::SurfaceTractions& t : task_.tractions)
      loaded = std::max(loaded, std::max(std::abs(t.x(0)), std::abs(t.x(t.columns - 1))) + t.dx / 2);
    reach += loaded;
    const std::vector<Wavenumber> all = wavenumbers(
        half_period_of(task_.body), largest_wavenumber / task_.least_depth, phase_of_panel / reach);
    MumpsSolver solver(static_cast<int>(system_.unknowns()), unknowns_of_cells(system_));
    std::vector<double> matrix;
    for (std::size_t i = 0; i < all.size(); ++i) {
      evaluate(system_, all[i].k, matrix);
      solver.factorize(matrix);
      solver.solve(loads(all[i].k), [&](std::size_t column, std::span<const double> solution) {
        add(all[i], column / 2, column % 2 == 1, solution);
      });
      progress(i + 1, all.size());
    }
    out_.unknowns = system_.unknowns();
    out_.wavenumbers = all.size();
    return std::move(out_);
  }

private:
  double rho(double z) const { return radius_ == 0 ? 1 : (radius_ + z) / radius_; }

  void find_probes(const Section& section) {
    for (const AskedStresses& area : task_.areas) {
      std::vector<Probe> probes;
      std::vector<Point2> positions;
      double middle = 0;
      for (const inside::BelowSurface& p : area.points) {
        const CurvePoint above = task_.curve.at(p.s);
        positions.push_back(above.position + p.depth * normal_of(above.delta));
        probes.push_back({{}, positions.back(), above.delta});
        middle += rho(above.position.z) / static_cast<double>(area.points.size());
      }
      std::vector<PointShapes> shapes = section.shapes_at(positions);
      const Stress none{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0, 0};
      std::vector<inside::Passage> stresses;
      for (std::size_t i = 0; i < probes.size(); ++i) {
        probes[i].shapes = std::move(shapes[i]);
        stresses.emplace_back(area.x.size(), probes[i].shapes.nodes.empty() ? none : Stress{});
      }
      probes_.push_back(std::move(probes));
      place_.push_back(middle);
      out_.areas.push_back(std::move(stresses));
    }
  }

  /// Two columns a load: pressure and traction along s as cos kx with that along x as sin kx; then pressure
  /// and traction along s as sin kx = cos (kx - pi/2), with that along x as cos kx = -sin (kx - pi/2).
  SparseColumns loads(double k) const {
    SparseColumns out;
    for (const inside::SurfaceTractions& tractions : task_.tractions)
      add_load(tractions, k, out);
    return out;
  }

  void add_load(const inside::SurfaceTractions& tractions, double k, SparseColumns& out) const {
    std::array<std::vector<double>, 2> sums;
    for (std::vector<double>& sum : sums)
      sum.assign(system_.unknowns(), 0);
    for (std::size_t J = 0; J < stations_.size(); ++J) {
      const Transform f(tractions, J, k / rho(stations_[J].position.z));
      for (std::size_t c = 0; c < 3; ++c) {
        const bool along = c == component_x;
        const std::array<double, 2> amount{along ? f.sine[c] : f.cosine[c], along ? -f.cosine[c] : f.sine[c]};
        system_.functionals.for_each_entry(3 * J + c, [&](int row, double value) {
          for (std::size_t i = 0; i < 2; ++i)
            sums[i][static_cast<std::size_t>(row)] += amount[i] * value;
        });
      }
    }
    for (const std::vector<double>& sum : sums) {
      for (std::size_t row = 0; row < sum.size(); ++row)
        if (sum[row] != 0)
          out.add(static_cast<int>(row), sum[row]);
      out.end_column();
    }
  }

  /// What a solution is at a point (THEORY.md, section 2), turned into the frame of the surface above it.
  Amplitudes amplitudes(const Probe& probe, double k, std::span<const double> solution) const {
    std::array<double, 3> u{}, uy{}, uz{};
    const PointShapes& at = probe.shapes;
    for (std::size_t a = 0; a < at.nodes.size(); ++a)
      for (std::size_t c = 0; c < 3; ++c)
        if (const int row = system_.unknown[3 * static_cast<std::size_t>(at.nodes[a]) + c]; row >= 0) {
          const double v = solution[static_cast<std::size_t>(row)];
          u[c] += at.value[a] * v;
          uy[c] += at.d_dy[a] * v;
          uz[c] += at.d_dz[a] * v;
        }
    const double mu = system_.op.mu, lambda = system_.op.lambda, r = rho(probe.position.z),
                 over_r = radius_ == 0 ? 0 : 1 / (radius_ + probe.position.z);
    const double e_xx = k / r * u[0] + over_r * u[2], e_yy = uy[1], e_zz = uz[2];
    const double trace = lambda * (e_xx + e_yy + e_zz);
    const double xx = trace + 2 * mu * e_xx, yy = trace + 2 * mu * e_yy, zz = trace + 2 * mu * e_zz,
                 yz = mu * (uz[1] + uy[2]), xy = mu * (uy[0] - k / r * u[1]),
                 xz = mu * (uz[0] - over_r * u[0] - k / r * u[2]);
    const double c = std::cos(probe.delta), s = std::sin(probe.delta);
    return {{xx, yy * c * c + zz * s * s + 2 * yz * c * s, yy * s * s + zz * c * c - 2 * yz * c * s, 0, 0,
             (zz - yy) * c * s + yz * (c * c - s * s)},
            {0, 0, 0, xy * c + xz * s, xz * c - xy * s, 0}};
  }

  /// Adds what a wave of one load gives. `odd`: it is a quarter of a wave behind.
  void add(const Wavenumber& one, std::size_t load, bool odd, std::span<const double> solution) {
    for (std::size_t area = 0; area < probes_.size(); ++area) {
      if (task_.areas[area].load != load)
        continue;
      const std::vector<double>& x = task_.areas[area].x;
      std::vector<std::array<double, 2>> waves;
      for (const double at : x) {
        const double phase = one.k * at / place_[area] - (odd ? std::numbers::pi / 2 : 0);
        waves.push_back({one.weight * std::cos(phase), one.weight * std::sin(phase)});
      }
      for (std::size_t i = 0; i < probes_[area].size(); ++i) {
        if (probes_[area][i].shapes.nodes.empty())
          continue;
        const Amplitudes a = amplitudes(probes_[area][i], one.k, solution);
        for (std::size_t j = 0; j < x.size(); ++j)
          out_.areas[area][i][j].add(waves[j][0], a.even).add(waves[j][1], a.odd);
      }
    }
  }

  const SectionTask& task_;
  std::vector<Station> stations_;
  double radius_;
  std::vector<std::vector<Probe>> probes_; ///< [area][point]
  std::vector<double> place_;              ///< [area] rho of the surface above
  HarmonicSystem system_;
  SectionStresses out_;
};

} // namespace

SectionStresses section_stresses(const SectionTask& task,
                                 const std::function<void(std::size_t, std::size_t)>& progress) {
  return SectionRun(task).compute(progress);
}

} // namespace bem_contact::fem
