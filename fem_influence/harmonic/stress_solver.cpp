#include "fem_influence/harmonic/stress_solver.hpp"

#include "bem_contact/base/lagrange.hpp"
#include "bem_contact/halfspace/wave_stress.hpp"
#include "bem_contact/inside/settings.hpp"
#include "bem_contact/inside/waves.hpp"
#include "fem_influence/harmonic/error_estimate.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"
#include "fem_influence/harmonic/run_plan.hpp"
#include "fem_influence/harmonic/section_probes.hpp"
#include "fem_influence/harmonic/stress_forms.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/mumps_solver.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace bem_contact::fem {

namespace {

using halfspace::Stress;
using halfspace::UnitStresses;

std::vector<ContactRow> places_along(const BodyFile& body, const ProfileCurve& curve,
                                     const std::vector<Station>& stations) {
  const double width = body.strip.station_width, from = stations.front().s;
  const auto beside = static_cast<int>(std::lround(body.stress.beyond / width));
  std::vector<ContactRow> out;
  for (int i = -beside; i < static_cast<int>(stations.size()) + beside; ++i) {
    const double s = from + i * width;
    if (s < curve.s_begin() || s > curve.s_end())
      continue;
    const CurvePoint at = curve.at(s);
    out.push_back({s, at.position, at.delta});
  }
  return out;
}

/// In equal ratios.
std::vector<double> graded_depths(double least, double deepest, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i)
    out.push_back(least * std::pow(deepest / least, double(i) / (count - 1)));
  return out;
}

} // namespace

StressPlan plan_stresses(const BodyFile& body, const ProfileCurve& curve) {
  StressPlan out{.body = body,
                 .stations = make_stations(body.strip, curve),
                 .places = {},
                 .depths = {},
                 .wavenumber = {},
                 .has_error = {}};
  out.body.harmonic.border_levels = 0;
  const double least = inside::least_depth_of_station * body.strip.station_width;
  out.places = places_along(body, curve, out.stations);
  out.depths = graded_depths(least, body.stress.deepest, body.stress.depths);
  // The last wavenumber is that which an element of this length would need.
  const double shortest_dx = 10 / (inside::largest_wavenumber_times_depth / least);
  const double samples = settings::stress_samples * body.harmonic.samples_per_decade;
  out.wavenumber =
      wavenumber_samples(half_period_of(body), shortest_dx, static_cast<int>(std::ceil(samples)));
  out.has_error.assign(out.wavenumber.size(), 0);
  if (body.harmonic.degree > 1)
    for (std::size_t k = 0; k < out.wavenumber.size(); ++k)
      out.has_error[k] = k <= 1 || k % settings::stress_error_every == 0 || k + 1 == out.wavenumber.size();
  return out;
}

namespace {

/// The half-space's amplitudes under a wave on each station. Of a body of revolution stations have radii of
/// their own; amplitudes are interpolated between three of them.
class FlatWaves {
public:
  FlatWaves(const StressPlan& plan, double radius, double k)
      : plan_(plan), radius_(radius), count_(1 + plan.stations.size()) {
    for (const double s : {plan.places.front().s, plan.places.back().s})
      for (const double other : {plan.stations.front().s, plan.stations.back().s})
        count_ = std::max(count_, 1 + static_cast<std::size_t>(
                                          std::lround(std::abs(s - other) / plan.body.strip.station_width)));
    double least = 1e9, most = -1e9;
    for (const Station& station : plan.stations) {
      least = std::min(least, rho(station));
      most = std::max(most, rho(station));
    }
    radii_ = {least};
    if (most - least > 1e-9)
      radii_ = {least, 0.5 * (least + most), most};
    for (const double at : radii_)
      waves_.push_back(halfspace::strip_wave_stresses(plan.body.material.poisson, k / at,
                                                      plan.body.strip.station_width, count_, plan.depths));
  }

  /// At a place so many stations beside a station.
  UnitStresses at(std::size_t station, int beside, std::size_t depth) const {
    const double own = rho(plan_.stations[station]);
    std::array<double, most_radii> weights{};
    lagrange_weights(radii_, own, weights);
    UnitStresses sum{};
    for (std::size_t i = 0; i < radii_.size(); ++i) {
      const UnitStresses& wave = waves_[i][depth * count_ + static_cast<std::size_t>(std::abs(beside))];
      for (std::size_t load = 0; load < 3; ++load)
        sum[load].add(weights[i] / own, wave[load]);
    }
    return beside < 0 ? halfspace::mirrored(sum) : sum;
  }

private:
  double rho(const Station& station) const { return inside::relative_radius(radius_, station.position.z); }
  static constexpr std::size_t most_radii = 3;
  const StressPlan& plan_;
  double radius_;
  std::size_t count_;
  std::vector<double> radii_; ///< over R_ref
  std::vector<std::vector<UnitStresses>> waves_;
};

} // namespace

/// A section with its factors and its points.
class StressSection {
public:
  StressSection(const StressPlan& plan, int degree, const ProfileCurve& curve,
                const std::filesystem::path& mesh)
      : plan_(plan) {
    BodyFile body = plan.body;
    body.harmonic.degree = degree;
    Timing timing;
    MeshedSystem meshed(body, curve, mesh, {}, timing);
    std::vector<inside::BelowSurface> points;
    for (const ContactRow& place : plan.places)
      for (const double depth : plan.depths)
        points.push_back({place.s, depth});
    probes_.emplace(*meshed.section, curve, reference_radius_of(body), points);
    AssembledSystem assembled = add_matrices(std::move(meshed), timing);
    system_ = std::move(assembled.system);
    renumber(system_, assembled.order);
    std::vector<std::size_t> loads(3 * plan.stations.size());
    std::iota(loads.begin(), loads.end(), std::size_t{0});
    loads_ = select_columns(system_.functionals, loads);
    solver_.emplace(static_cast<int>(system_.unknowns()), unknowns_of_cells(system_));
    place_.assign(system_.unknowns(), -1);
    for (std::size_t probe = 0; probe < probes_->count(); ++probe)
      probes_->for_each_unknown(system_, probe, 0, [&](int unknown, const WaveStress&) {
        if (Eigen::Index& place = place_[static_cast<std::size_t>(unknown)]; place < 0) {
          place = static_cast<Eigen::Index>(needed_.size());
          needed_.push_back(unknown);
        }
      });
    solutions_.resize(static_cast<Eigen::Index>(needed_.size()), static_cast<Eigen::Index>(loads_.columns()));
  }

  const SectionProbes& probes() const { return *probes_; }

  /// Of the finite elements; 0 where the body is not.
  DepthMatrices at(double k) {
    evaluate(system_, k, matrix_);
    solver_->factorize(matrix_);
    solver_->solve(loads_, [&](std::size_t column, std::span<const double> solution) {
      for (std::size_t i = 0; i < needed_.size(); ++i)
        solutions_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)) =
            solution[static_cast<std::size_t>(needed_[i])];
    });
    const auto rows = static_cast<Eigen::Index>(6 * plan_.places.size());
    DepthMatrices out(plan_.depths.size(), Eigen::MatrixXd::Zero(rows, solutions_.cols()));
    ByRow at_point(6, solutions_.cols());
    for (std::size_t probe = 0; probe < probes_->count(); ++probe) {
      if (!probes_->is_there(probe))
        continue;
      at_point.setZero();
      probes_->for_each_unknown(system_, probe, k, [&](int unknown, const WaveStress& of_one) {
        const auto& [even, odd] = of_one;
        const auto solution = solutions_.row(place_[static_cast<std::size_t>(unknown)]);
        Eigen::Index component = 0;
        for (const double factor : {even.xx, even.ss, even.nn, odd.xs, odd.xn, even.sn})
          at_point.row(component++) += factor * solution;
      });
      const auto place = static_cast<Eigen::Index>(probe / plan_.depths.size());
      out[probe % plan_.depths.size()].middleRows<6>(6 * place) = at_point;
    }
    return out;
  }

private:
  const StressPlan& plan_;
  std::optional<SectionProbes> probes_;
  HarmonicSystem system_;
  SparseColumns loads_;
  std::optional<MumpsSolver> solver_;
  std::vector<double> matrix_;
  std::vector<int> needed_;         ///< unknowns of cells with points
  std::vector<Eigen::Index> place_; ///< of each unknown among them
  using ByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  ByRow solutions_; ///< [needed unknown][load]
};

struct StressSolver::Impl {
  const StressPlan& plan;
  StressSection fine;
  std::optional<StressSection> coarse;

  Impl(const StressPlan& p, const ProfileCurve& curve, const std::filesystem::path& mesh)
      : plan(p), fine(p, p.body.harmonic.degree, curve, mesh) {
    if (p.body.harmonic.degree > 1)
      coarse.emplace(p, p.body.harmonic.degree - 1, curve, mesh);
  }

  void subtract_flat(DepthMatrices& from, double k) const {
    const FlatWaves flat(plan, reference_radius_of(plan.body), k);
    const std::size_t depths = plan.depths.size();
    const double width = plan.body.strip.station_width;
    for (std::size_t p = 0; p < plan.places.size(); ++p)
      for (std::size_t J = 0; J < plan.stations.size(); ++J) {
        const auto beside = static_cast<int>(std::lround((plan.places[p].s - plan.stations[J].s) / width));
        for (std::size_t d = 0; d < depths; ++d) {
          if (!fine.probes().is_there(p * depths + d))
            continue;
          const UnitStresses at = flat.at(J, beside, d);
          for (std::size_t c = 0; c < 3; ++c) {
            const Stress& t = at[c];
            Eigen::Matrix<double, 6, 1> values;
            values << t.xx, t.ss, t.nn, t.xs, t.xn, t.sn;
            from[d].col(static_cast<Eigen::Index>(3 * J + c)).segment<6>(static_cast<Eigen::Index>(6 * p)) -=
                values;
          }
        }
      }
  }
};

StressSolver::StressSolver(const StressPlan& plan, const ProfileCurve& curve,
                           const std::filesystem::path& mesh)
    : impl_(std::make_unique<Impl>(plan, curve, mesh)) {}

StressSolver::~StressSolver() = default;

std::vector<char> StressSolver::there() const {
  std::vector<char> out;
  for (std::size_t probe = 0; probe < impl_->fine.probes().count(); ++probe)
    out.push_back(impl_->fine.probes().is_there(probe));
  return out;
}

std::vector<double> StressSolver::at(std::size_t k) {
  const double wavenumber = impl_->plan.wavenumber[k];
  DepthMatrices fine = impl_->fine.at(wavenumber), more;
  if (impl_->coarse && impl_->plan.has_error[k]) {
    more = impl_->coarse->at(wavenumber);
    for (std::size_t d = 0; d < more.size(); ++d)
      more[d] -= fine[d];
  }
  impl_->subtract_flat(fine, wavenumber);
  std::vector<double> out = few_columns(fine, settings::stress_tolerance);
  const std::vector<double> error = few_columns(more, settings::stress_error_tolerance);
  out.insert(out.end(), error.begin(), error.end());
  return out;
}

} // namespace bem_contact::fem
