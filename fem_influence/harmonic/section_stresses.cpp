#include "fem_influence/harmonic/section_stresses.hpp"

#include "bem_contact/inside/settings.hpp"
#include "bem_contact/inside/waves.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"
#include "fem_influence/harmonic/section_probes.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/mumps_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bem_contact::fem {

namespace {

using halfspace::Stress;
using inside::Wavenumber;

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
      loaded = std::max(loaded, reach_of(t));
    const std::vector<Wavenumber> all =
        inside::waves_of_series(half_period_of(task_.body),
                                inside::largest_wavenumber_times_depth / task_.least_depth, reach + loaded);
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
  double rho(double z) const { return inside::relative_radius(radius_, z); }

  void find_probes(const Section& section) {
    for (const AskedStresses& area : task_.areas) {
      const SectionProbes& probes =
          probes_.emplace_back(section, task_.curve, radius_, std::span(area.points));
      double middle = 0;
      for (const inside::BelowSurface& p : area.points)
        middle += rho(task_.curve.at(p.s).position.z) / static_cast<double>(area.points.size());
      const Stress none{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0, 0};
      std::vector<inside::Passage> stresses;
      for (std::size_t i = 0; i < probes.count(); ++i)
        stresses.emplace_back(area.x.size(), probes.is_there(i) ? Stress{} : none);
      place_.push_back(middle);
      out_.areas.push_back(std::move(stresses));
    }
  }

  /// Two columns a load (inside/waves.hpp).
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
      const inside::WaveOfRow wave(tractions, J, k / rho(stations_[J].position.z));
      for (std::size_t c = 0; c < 3; ++c) {
        const std::array<double, 2> amount = wave.amplitudes(c);
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

  /// Adds what a wave of one load gives. `odd`: it is a quarter of a wave behind.
  void add(const Wavenumber& one, std::size_t load, bool odd, std::span<const double> solution) {
    for (std::size_t area = 0; area < probes_.size(); ++area) {
      if (task_.areas[area].load != load)
        continue;
      const std::vector<double>& x = task_.areas[area].x;
      std::vector<inside::WaveAt> waves;
      for (const double at : x)
        waves.emplace_back(one.k * at / place_[area], odd);
      const SectionProbes& probes = probes_[area];
      for (std::size_t i = 0; i < probes.count(); ++i) {
        if (!probes.is_there(i))
          continue;
        const WaveStress a = probes.stress(system_, i, one.k, solution);
        for (std::size_t j = 0; j < x.size(); ++j)
          out_.areas[area][i][j]
              .add(one.weight * waves[j].even, a.even)
              .add(one.weight * waves[j].odd, a.odd);
      }
    }
  }

  const SectionTask& task_;
  std::vector<Station> stations_;
  double radius_;
  std::vector<SectionProbes> probes_; ///< [area]
  std::vector<double> place_;         ///< [area] rho of the surface above
  HarmonicSystem system_;
  SectionStresses out_;
};

} // namespace

SectionStresses section_stresses(const SectionTask& task,
                                 const std::function<void(std::size_t, std::size_t)>& progress) {
  return SectionRun(task).compute(progress);
}

} // namespace bem_contact::fem
