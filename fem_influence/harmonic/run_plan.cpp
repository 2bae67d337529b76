#include "fem_influence/harmonic/run_plan.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/error_estimate.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::fem {

namespace {

/// 1. The largest wavenumber times the shortest element length dx. Half of it is k_max a with the half length
/// a = dx / 2: k_max a of 5 leaves no error to see, 2.4 costs 0.45 % and 1.2 costs 2 % of the self number.
constexpr double largest_wavenumber_times_dx = 10.0;

} // namespace

std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade) {
  const double unit = std::numbers::pi / half_period, largest = largest_wavenumber_times_dx / shortest_dx;
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

namespace {

CompanionPlan plan_companion(const BodyFile& body, const InfluenceFunction& function) {
  CompanionPlan companion{body, compared_stations(function.station_count()), without_numbers(function)};
  --companion.body.harmonic.degree;
  companion.body.harmonic.border_levels = std::max(0, body.harmonic.border_levels - 1);
  for (const std::size_t J : companion.stations)
    companion.function.stations.push_back(function.stations[J]);
  for (const std::size_t k : companion_samples(function.wavenumber_count()))
    companion.function.wavenumber.push_back(function.wavenumber[k]);
  return companion;
}

} // namespace

double RunPlan::wavenumber(const WavenumberTask& task) const {
  return (task.companion ? companion->function : function).wavenumber[task.k];
}

RunPlan plan_run(const BodyFile& body, const ProfileCurve& curve) {
  RunPlan plan;
  plan.function = describe(body, curve);
  plan.function.held = held_part(body.body) +
                       ": all three displacements are zero on the mesh's group 'held' (physical curve 2)";
  plan.function.wavenumber =
      wavenumber_samples(half_period_of(body), shortest_reference_dx(body, plan.function.stations),
                         body.harmonic.samples_per_decade);
  for (std::size_t k = 0; k < plan.function.wavenumber_count(); ++k)
    plan.tasks.push_back({false, k});
  if (body.harmonic.degree > 1) {
    plan.companion = plan_companion(body, plan.function);
    for (std::size_t k = 0; k < plan.companion->function.wavenumber_count(); ++k)
      plan.tasks.push_back({true, k});
  }
  return plan;
}

double shortest_reference_dx(const BodyFile& body, std::span<const Station> stations) {
  const double reference = reference_radius_of(body);
  double longest = 1;
  if (reference != 0)
    for (const Station& station : stations)
      longest = std::max(longest, (reference + station.position.z) / reference);
  return body.harmonic.shortest_dx / longest;
}

} // namespace bem_contact::fem
