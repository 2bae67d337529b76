#include "bem_contact/contact/check/error_estimates.hpp"

#include "bem_contact/contact/check/error_shares.hpp"
#include "bem_contact/contact/check/regions.hpp"
#include "bem_contact/contact/dissipation.hpp"
#include "bem_contact/contact/flash_temperature.hpp"
#include "bem_contact/contact/grid/larger_elements.hpp"
#include "bem_contact/contact/settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact::contact {
namespace {

constexpr double rounding = 1e-9; ///< 1. A smaller relative error is one of rounding.

/// Root mean square of the fourth differences of the undeformed distance from element to element within the
/// contact, as the pressure on one element that moves its surface so far, MPa. Where the distance is smooth
/// on the scale of the elements they all but vanish; noise and kinks remain.
double roughness_of_gap(const ContactProblem& problem, const ContactResult& result) {
  const int mx = problem.grid.mx, ms = problem.grid.ms;
  double sum = 0;
  int count = 0;
  const auto look = [&](int i, int step) {
    for (int k = -2; k <= 2; ++k)
      if (k * k == 1 && result.state[i + k * step] == ElementState::exterior)
        return;
    const auto h = [&](int k) { return problem.gap[i + k * step]; };
    const double difference = h(-2) - 4 * h(-1) + 6 * h(0) - 4 * h(1) + h(2);
    sum += difference * difference;
    ++count;
  };
  for (int i = 0; i < problem.grid.size(); ++i) {
    if (result.state[i] == ElementState::exterior)
      continue;
    const int ix = i % mx, is = i / mx;
    if (is >= 2 && is + 2 < ms)
      look(i, mx);
    if (ix >= 2 && ix + 2 < mx)
      look(i, 1);
  }
  const double self = problem.numbers.at(0, 0, component_n, 0, component_n);
  return count > 0 ? std::sqrt(sum / count) / self : 0;
}

/// `roughness`: as roughness_of_gap() returns it, MPa.
bool is_rough(const Region& fine, double roughness) {
  return roughness > largest_roughness * fine.pmax;
}

/// False where the peak of the pressure is narrower than the elements can show, where larger elements change
/// it grossly, or where the undeformed distance is rough: then smaller elements show another field.
bool converges(const Region& fine, const Region& coarse, double roughness) {
  return std::abs(fine.pmax - coarse.pmax) <= largest_pmax_change * fine.pmax &&
         fine.curvature <= largest_curvature * fine.pmax && !is_rough(fine, roughness);
}

/// The error of these parts.
double weighed(const ErrorShares& share, const ErrorParts& parts) {
  return share.change * parts.change + share.local * parts.local + share.peak * parts.peak +
         share.adhesion * parts.adhesion + parts.fixed;
}
double weighed(const GridShares& shares, const Region& r, const ErrorParts& parts) {
  return weighed(shares.of(r.line), parts);
}

/// `roughness`: as converges() takes it, MPa.
ErrorParts pmax_parts(const Region& r, const Region& coarse, double roughness) {
  if (r.at_limit && coarse.at_limit)
    return {};
  return {.change = std::abs(r.pmax - coarse.pmax), .peak = r.curvature, .fixed = pmax_rough * roughness};
}

ErrorParts area_parts(const Region& r) {
  return {.local = r.area * r.border / r.contact};
}

/// By how much larger errors of sums of shear are on elements longer than wide.
double growth(const Region& r, double power = shear_elongation) {
  return std::pow(r.elongation(), power);
}

/// Of the error of a sum of shear tractions. `change` is its difference from the coarse result, `longer` as
/// growth() returns it. The local part is there even if larger elements give the same sum, because the two
/// may agree by chance.
ErrorParts shear_parts(double change, const UncertainSum& sum, const Region& r, double longer) {
  return {.change = longer * std::abs(change),
          .local = longer * std::min(sum.size, shear_deviation * sum.deviation) / r.contact,
          .adhesion = longer * std::sqrt(sum.adhering)};
}
ErrorParts shear_parts(double change, const UncertainSum& sum, const Region& r) {
  return shear_parts(change, sum, r, growth(r));
}

/// Of the error of an approach, or of a patch's overlap.
ErrorParts approach_parts(double change, const Region& r) {
  return {.change = std::abs(change), .local = r.overlap / r.contact, .peak = r.overlap * r.relative_fall()};
}

/// The local part of the error of the normal force at a given approach, N. Hertz's force grows as
/// approach^1.5, so the relative error is 1.5 times that of the approach.
double local_normal_force(const Region& r) {
  const ErrorShares& share = shares::approach.of(r.line);
  return 1.5 * r.fn * (share.local / r.contact + share.peak * r.relative_fall());
}

/// Of the power of friction. Where the influence numbers leave it open what drives a wheel, it is what slip
/// dissipates, without what each wave of the tractions loses on elements (slip_step.hpp).
ErrorParts power_parts(const Region& fine, const Region& coarse) {
  ErrorParts out =
      shear_parts(fine.driving_power.total - coarse.driving_power.total, fine.driving_power, fine);
  out.fixed = std::abs(fine.driving_power.total - fine.T_gamma) +
              missing_power * (fine.T_gamma - fine.T_gamma_in_slip);
  return out;
}

/// Of what friction does in a patch.
void estimate_patch_shear(const Region& fine, const Region& coarse, PatchSummary& out) {
  out.fx.error = weighed(shares::shear_x, fine, shear_parts(fine.fx.total - coarse.fx.total, fine.fx, fine));
  out.fs.error = weighed(shares::shear, fine, shear_parts(fine.fs.total - coarse.fs.total, fine.fs, fine));
  out.moment_n.error = weighed(shares::patch_moment, fine,
                               shear_parts(fine.moment.total - coarse.moment.total, fine.moment, fine,
                                           growth(fine, moment_elongation)));
  out.T_gamma.error = weighed(shares::shear_x, fine, power_parts(fine, coarse));
}

void estimate_patch(const Region& fine, const Region& coarse, double roughness, PatchSummary& out) {
  out.pmax.error = weighed(shares::pmax, fine, pmax_parts(fine, coarse, roughness));
  out.area.error = weighed(shares::area, fine, area_parts(fine));
  out.overlap.error = weighed(shares::overlap, fine, approach_parts(fine.overlap - coarse.overlap, fine));
  estimate_patch_shear(fine, coarse, out);
}

/// Of the normal force of a patch. Where the vertical force is prescribed, so is sum p_n dS + slope Fs but
/// for what turns within the contact: shear, and the pressure itself. `fs`: error of Fs.
double normal_error(const Region& fine, const Region& coarse, const ShearEffects& effects, double fs,
                    const Region& contact) {
  const double change = fine.fn - coarse.fn + effects.slope * (fine.fs.total - coarse.fs.total);
  return std::hypot(effects.slope * fs,
                    weighed(shares::normal, contact, shear_parts(change, effects.fn, contact))) +
         normal_bent * effects.bent / contact.contact;
}

/// Of Fy: by shear, and by the direction of the pressure. Where Fz and Fs are prescribed, nothing else can
/// change it.
ErrorParts lateral_parts(const ContactProblem& problem, double change, const ShearEffects& effects,
                         const Region& contact) {
  const bool prescribed = problem.load == LoadKind::force && problem.force_s;
  ErrorParts out =
      prescribed ? ErrorParts{.change = std::abs(change)} : shear_parts(change, effects.fy, contact);
  out.fixed = direction_local * effects.turned / contact.contact;
  return out;
}

/// Of the patches; none where the coarse result has other ones. `contact`: all patches.
void estimate_patches(const ContactProblem& problem, const std::vector<Region>& fine,
                      const std::vector<Region>& coarse, const ShearEffects& effects, const Region& contact,
                      double roughness, std::vector<PatchSummary>& patches) {
  const std::vector<Region> opposite = matched(fine, coarse);
  // Several patches share the force by how stiff they are at their common approach.
  const bool shared = problem.load == LoadKind::approach || fine.size() > 1;
  for (std::size_t i = 0; i < opposite.size(); ++i) {
    PatchSummary& patch = patches[i];
    estimate_patch(fine[i], opposite[i], roughness, patch);
    const double fs = problem.force_s && fine.size() == 1 ? 0.0 : patch.fs.error;
    patch.fn.error = normal_error(fine[i], opposite[i], effects, fs, contact) +
                     (shared ? local_normal_force(fine[i]) : 0.0);
    if (patch.fn.error < rounding * fine[i].fn)
      patch.fn.error = 0; // in the plane it is the prescribed vertical force
  }
  if (opposite.size() != 1)
    return;
  if (problem.force_x) // prescribed
    patches[0].fx.error = 0;
  if (problem.force_s)
    patches[0].fs.error = 0;
}

/// Forces of the patches in the track frame. The one patch of a contact has its totals.
void estimate_track_forces(ContactResult& result) {
  if (result.patches.size() == 1) {
    result.patches[0].fy.error = result.totals.Fy.error;
    result.patches[0].fz.error = result.totals.Fz.error;
    return;
  }
  for (PatchSummary& patch : result.patches) {
    const double cosine = std::cos(patch.delta), sine = std::sin(patch.delta);
    patch.fy.error = std::hypot(patch.fn.error * sine, patch.fs.error * cosine);
    patch.fz.error = std::hypot(patch.fn.error * cosine, patch.fs.error * sine);
  }
}

/// Larger elements carry the force elsewhere: the sum of the absolute changes of their forces, N. Where the
/// sum of the forces is prescribed, its own change is 0, and that of a creepage may be so by chance.
double moved_force(const LargerElements& larger, const std::vector<double>& fine,
                   const std::vector<double>& coarse, const ContactGrid& grid) {
  const std::vector<double> mean = larger.mean(fine);
  double sum = 0;
  for (std::size_t i = 0; i < mean.size(); ++i)
    sum += std::abs(mean[i] - coarse[i]);
  return sum * grid.dx * grid.ds;
}

/// Strain of the surface under a shear force, over that force, 1/N: from the displacement of one element that
/// bears pmax. It stands for the compliance where that is not known.
double strain_per_force(const ContactProblem& problem, const Region& r) {
  const double self = problem.numbers.at(0, 0, component_n, 0, component_n);
  return r.pmax * self / std::sqrt(problem.element_area()) / r.fn;
}

/// Mean change of the rigid slip across the rolling direction from an element in contact to the next, 1.
double turn_of_slip(const ContactProblem& problem, const ContactResult& result) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (result.state[i] != ElementState::exterior && i % problem.grid.mx + 1 < problem.grid.mx) {
      sum += std::abs(problem.slip_s[i + 1] - problem.slip_s[i]);
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

/// Of creepages that are found for prescribed forces. A force that is uncertain by so much asks for another
/// creepage by so much times the compliance, which grows without bound towards full slip.
void estimate_creepages(const ContactProblem& problem, const ContactResult& result,
                        const ContactGrid& coarse_grid, const ContactResult& coarse, const Region& fine,
                        ContactTotals& totals, PartsOfTotals& parts) {
  const LargerElements larger(problem.grid, result.pn);
  const auto parts_of = [&](double change, double compliance, double moved, double adhering) {
    if (!std::isfinite(compliance))
      compliance = strain_per_force(problem, fine);
    return ErrorParts{.change = std::abs(change),
                      .local = std::abs(compliance) * moved,
                      .adhesion = std::abs(compliance) * adhering};
  };
  const ContactTotals &now = result.totals, &was = coarse.totals;
  if (problem.force_x) {
    parts.creepage_x =
        parts_of(now.creepage_x - was.creepage_x, now.compliance_x,
                 moved_force(larger, result.px, coarse.px, coarse_grid), fine.fx.adhering_alike);
    totals.creepage_x.error = weighed(shares::creepage_x, parts.creepage_x);
  }
  if (problem.force_s) { // spin's tractions cancel in the sum, and not in what the elements are off by
    parts.creepage_s =
        parts_of(now.creepage_s - was.creepage_s, now.compliance_s,
                 moved_force(larger, result.ps, coarse.ps, coarse_grid), std::sqrt(fine.fs.adhering));
    parts.creepage_s.fixed = creepage_turn * turn_of_slip(problem, result);
    totals.creepage_s.error = weighed(shares::creepage_s, parts.creepage_s);
  }
}

/// Sets what needs friction, but for creepages: shear forces, adhesion, power.
void estimate_shear(const ContactProblem& problem, const ContactResult& result, const ContactResult& coarse,
                    const std::pair<Region, Region>& regions, ContactTotals& totals, PartsOfTotals& parts) {
  const auto& [fine, rough] = regions;
  if (!problem.force_x)
    parts.Fx = shear_parts(result.totals.Fx - coarse.totals.Fx, fine.fx, fine);
  if (!problem.force_s)
    parts.Fs = shear_parts(result.totals.Fs - coarse.totals.Fs, fine.fs, fine);
  parts.adhesion_share = {.change = std::abs(fine.adhesion_share() - rough.adhesion_share()),
                          .local = 1.0 / fine.contact,
                          .adhesion = std::sqrt(double(fine.adhesion_border)) / fine.contact};
  parts.T_gamma = power_parts(fine, rough);
  totals.Fx.error = weighed(shares::shear_x, fine, parts.Fx);
  totals.Fs.error = weighed(shares::shear, fine, parts.Fs);
  totals.adhesion_share.error = weighed(shares::adhesion_share, fine, parts.adhesion_share);
  totals.T_gamma.error = weighed(shares::shear_x, fine, parts.T_gamma);
}

/// Of the highest temperature of a surface, degrees C. `other`: with more or less of the heat that the slip
/// of elements does not show; `bulk`: what it has before the contact.
ErrorParts temperature_parts(const ContactGrid& grid, const std::vector<double>& fine,
                             const std::vector<double>& coarse, const std::vector<double>& other, double bulk,
                             int contact) {
  const int i = static_cast<int>(std::ranges::max_element(fine) - fine.begin());
  const auto curvature = [&](int step, int at, int count) {
    return at > 0 && at + 1 < count ? std::abs(2 * fine[i] - fine[i - step] - fine[i + step]) : 0.0;
  };
  const double beside = curvature(1, i % grid.mx, grid.mx) + curvature(grid.mx, i / grid.mx, grid.ms);
  return {.change = std::abs(fine[i] - std::ranges::max(coarse)),
          .local = (fine[i] - bulk) / contact,
          .peak = beside,
          .fixed = missing_heat * std::abs(fine[i] - std::ranges::max(other))};
}

/// Sets the errors of the highest temperatures.
void estimate_temperatures(const ContactProblem& problem, const ContactResult& result,
                           const ContactResult& coarse, const Region& fine, ContactTotals& totals,
                           PartsOfTotals& parts) {
  if (!result.temperatures || !coarse.temperatures || fine.T_gamma_in_slip < least_shown_power * fine.T_gamma)
    return;
  const SurfaceTemperatures other = flash_temperatures(
      problem, result, problem.heat_acts() ? friction_work_density(result) : dissipated_in_slip(result));
  const auto parts_of = [&](std::vector<double> SurfaceTemperatures::*surface, const ThermalBody& body) {
    const std::vector<double>& found = (*result.temperatures).*surface;
    ErrorParts out = temperature_parts(problem.grid, found, (*coarse.temperatures).*surface, other.*surface,
                                       body.temperature, fine.contact);
    if (fine.T_gamma_in_slip < all_shown_power * fine.T_gamma)
      out.fixed +=
          heat_between * (std::ranges::max(found) - body.temperature) / std::sqrt(double(fine.contact));
    return out;
  };
  parts.Tmax_rail = parts_of(&SurfaceTemperatures::rail, problem.heating->rail);
  parts.Tmax_wheel = parts_of(&SurfaceTemperatures::wheel, problem.heating->wheel);
  totals.Tmax_rail.error = weighed(shares::temperature, parts.Tmax_rail);
  totals.Tmax_wheel.error = weighed(shares::temperature, parts.Tmax_wheel);
}

} // namespace

double creepage_x_error(const ContactProblem& problem, const ContactResult& result,
                        const ContactProblem& coarse_problem, const ContactResult& coarse) {
  const Region fine = contact_of(problem, result, patches_of(problem, result)),
               rough = contact_of(coarse_problem, coarse, patches_of(coarse_problem, coarse));
  if (rough.contact < least_companion || !converges(fine, rough, roughness_of_gap(problem, result)))
    return unknown_error;
  ContactTotals totals;
  PartsOfTotals parts;
  estimate_creepages(problem, result, coarse_problem.grid, coarse, fine, totals, parts);
  return totals.creepage_x.error;
}

void estimate_errors(const ContactProblem& problem, const ContactProblem& coarse_problem,
                     const ContactResult& coarse, ContactResult& result) {
  const std::vector<Region> patches = patches_of(problem, result),
                            rough_patches = patches_of(coarse_problem, coarse);
  const std::pair<Region, Region> regions{contact_of(problem, result, patches),
                                          contact_of(coarse_problem, coarse, rough_patches)};
  const auto& [fine, rough] = regions;
  const double roughness = roughness_of_gap(problem, result);
  Discretisation& estimate = *result.trust.discretisation;
  estimate.converges = converges(fine, rough, roughness);
  estimate.rough = is_rough(fine, roughness);
  if (!estimate.converges)
    return;
  ContactTotals& totals = result.totals;
  PartsOfTotals& parts = estimate.parts;
  parts.area = area_parts(fine);
  parts.pmax = pmax_parts(fine, rough, roughness);
  totals.area.error = weighed(shares::area, fine, parts.area);
  totals.pmax.error = weighed(shares::pmax, fine, parts.pmax);
  for (Measured* number : {&totals.Fx, &totals.Fs, &totals.adhesion_share, &totals.T_gamma,
                           &totals.creepage_x, &totals.creepage_s})
    number->error = 0;
  if (problem.has_friction()) {
    estimate_shear(problem, result, coarse, regions, totals, parts);
    estimate_creepages(problem, result, coarse_problem.grid, coarse, fine, totals, parts);
  }
  estimate_temperatures(problem, result, coarse, fine, totals, parts);
  const bool force = problem.load == LoadKind::force;
  if (force)
    parts.approach = approach_parts(totals.approach - coarse.totals.approach, fine);
  totals.approach.error = weighed(shares::approach, fine, parts.approach);
  const ShearEffects effects = effects_of_shear(problem, result);
  parts.Fy = lateral_parts(problem, totals.Fy - coarse.totals.Fy, effects, fine);
  totals.Fy.error = weighed(shares::shear, fine, parts.Fy);
  totals.Fz.error =
      force ? 0
            : weighed(shares::shear, fine, shear_parts(totals.Fz - coarse.totals.Fz, effects.fz, fine)) +
                  local_normal_force(fine);
  const double longer = growth(fine, moment_elongation);
  parts.moment = shear_parts(0, fine.moment, fine, longer);
  estimate.local_moment = weighed(shares::moment, fine, parts.moment);
  parts.moment.change = longer;
  estimate.moment_change = longer * shares::moment.of(fine.line).change;
  estimate_patches(problem, patches, rough_patches, effects, fine, roughness, result.patches);
  estimate_track_forces(result);
}

} // namespace bem_contact::contact
