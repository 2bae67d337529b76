#include "bem_contact/contact/check/error_estimates.hpp"

#include "bem_contact/contact/check/error_shares.hpp"
#include "bem_contact/contact/check/regions.hpp"
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

/// `roughness`: as converges() takes it, MPa.
double pmax_error(const Region& r, const Region& coarse, double roughness) {
  const ErrorShares& share = shares::pmax.of(r.line);
  return share.change * std::abs(r.pmax - coarse.pmax) + share.peak * r.curvature + pmax_rough * roughness;
}

double area_error(const Region& r) {
  return shares::area.of(r.line).local * r.area * r.border / r.contact;
}

/// The local part of the error of a sum of shear tractions. It is there even if larger elements give the same
/// sum, because the two may agree by chance.
double local_error(const UncertainSum& sum, const Region& r, const GridShares& shares) {
  const ErrorShares& share = shares.of(r.line);
  return share.local * std::min(sum.size, shear_deviation * sum.deviation) / r.contact +
         share.adhesion * std::sqrt(sum.adhering);
}

/// By how much larger errors of such sums are on elements longer than wide.
double growth(const Region& r, double power = shear_elongation) {
  return std::pow(r.elongation(), power);
}

/// The error of such a sum. `change` is its difference from the coarse result.
double shear_error(double change, const UncertainSum& sum, const Region& r,
                   const GridShares& shares = shares::shear) {
  return growth(r) * (shares.of(r.line).change * std::abs(change) + local_error(sum, r, shares));
}

/// The local part of the error of an approach, or of a patch's overlap, relative to it.
double local_approach(const Region& r, const GridShares& shares = shares::approach) {
  const ErrorShares& share = shares.of(r.line);
  return share.local / r.contact + share.peak * r.relative_fall();
}

/// The local part of the error of the normal force at a given approach, N. Hertz's force grows as
/// approach^1.5, so the relative error is 1.5 times that of the approach.
double local_normal_force(const Region& r) {
  return 1.5 * r.fn * local_approach(r);
}

/// Of the power of friction. Each wave of the tractions loses energy on elements (slip_step.hpp), and that is
/// missing in what slip dissipates. The driving power has no such part.
double power_error(const Region& fine, const Region& coarse) {
  return std::abs(fine.driving_power.total - fine.T_gamma) +
         shear_error(fine.driving_power.total - coarse.driving_power.total, fine.driving_power, fine,
                     shares::shear_x);
}

/// Of what friction does in a patch.
void estimate_patch_shear(const Region& fine, const Region& coarse, PatchSummary& out) {
  out.fx.error = shear_error(fine.fx.total - coarse.fx.total, fine.fx, fine, shares::shear_x);
  out.fs.error = shear_error(fine.fs.total - coarse.fs.total, fine.fs, fine);
  out.moment_n.error =
      growth(fine, moment_elongation) *
      (shares::patch_moment.of(fine.line).change * std::abs(fine.moment.total - coarse.moment.total) +
       local_error(fine.moment, fine, shares::patch_moment));
  out.T_gamma.error = power_error(fine, coarse);
}

void estimate_patch(const Region& fine, const Region& coarse, double roughness, PatchSummary& out) {
  out.pmax.error = pmax_error(fine, coarse, roughness);
  out.area.error = area_error(fine);
  out.overlap.error = shares::overlap.of(fine.line).change * std::abs(fine.overlap - coarse.overlap) +
                      fine.overlap * local_approach(fine, shares::overlap);
  estimate_patch_shear(fine, coarse, out);
}

/// Of the normal force of a patch. Where the vertical force is prescribed, so is sum p_n dS + slope Fs but
/// for what turns within the contact: shear, and the pressure itself. `fs`: error of Fs.
double normal_error(const Region& fine, const Region& coarse, const ShearEffects& effects, double fs,
                    const Region& contact) {
  const double change = fine.fn - coarse.fn + effects.slope * (fine.fs.total - coarse.fs.total);
  return std::hypot(effects.slope * fs, shear_error(change, effects.fn, contact, shares::normal)) +
         normal_bent * effects.bent / contact.contact;
}

/// Of Fy: by shear, and by the direction of the pressure. Where Fz and Fs are prescribed, nothing else can
/// change it.
double lateral_error(const ContactProblem& problem, double change, const ShearEffects& effects,
                     const Region& contact) {
  const bool prescribed = problem.load == LoadKind::force && problem.force_s;
  const double shear = prescribed ? shares::shear.of(contact.line).change * std::abs(change)
                                  : shear_error(change, effects.fy, contact);
  return shear + direction_local * effects.turned / contact.contact;
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
                        ContactTotals& totals) {
  const LargerElements larger(problem.grid, result.pn);
  const auto error = [&](const ErrorShares& share, double change, double compliance, double moved,
                         double adhering) {
    if (!std::isfinite(compliance))
      compliance = strain_per_force(problem, fine);
    return share.change * std::abs(change) +
           std::abs(compliance) * (share.local * moved + share.adhesion * adhering);
  };
  const ContactTotals &now = result.totals, &was = coarse.totals;
  if (problem.force_x)
    totals.creepage_x.error =
        error(shares::creepage_x, now.creepage_x - was.creepage_x, now.compliance_x,
              moved_force(larger, result.px, coarse.px, coarse_grid), fine.fx.adhering_alike);
  if (problem.force_s) // spin's tractions cancel in the sum, and not in what the elements are off by
    totals.creepage_s.error =
        error(shares::creepage_s, now.creepage_s - was.creepage_s, now.compliance_s,
              moved_force(larger, result.ps, coarse.ps, coarse_grid), std::sqrt(fine.fs.adhering)) +
        creepage_turn * turn_of_slip(problem, result);
}

/// Sets what needs friction, but for creepages: shear forces, adhesion, power.
void estimate_shear(const ContactProblem& problem, const ContactResult& result, const ContactResult& coarse,
                    const std::pair<Region, Region>& regions, ContactTotals& totals) {
  const auto& [fine, rough] = regions;
  totals.Fx.error =
      problem.force_x ? 0 : shear_error(result.totals.Fx - coarse.totals.Fx, fine.fx, fine, shares::shear_x);
  totals.Fs.error = problem.force_s ? 0 : shear_error(result.totals.Fs - coarse.totals.Fs, fine.fs, fine);
  const ErrorShares& share = shares::adhesion_share.of(fine.line);
  totals.adhesion_share.error =
      share.change * std::abs(fine.adhesion_share() - rough.adhesion_share()) +
      (share.local + share.adhesion * std::sqrt(double(fine.adhesion_border))) / fine.contact;
  totals.T_gamma.error = power_error(fine, rough);
}

/// Of the highest temperature of a surface, degrees C. `bulk`: what it has before the contact.
double temperature_error(const ContactGrid& grid, const std::vector<double>& fine,
                         const std::vector<double>& coarse, double bulk, int contact) {
  const int i = static_cast<int>(std::ranges::max_element(fine) - fine.begin());
  const auto curvature = [&](int step, int at, int count) {
    return at > 0 && at + 1 < count ? std::abs(2 * fine[i] - fine[i - step] - fine[i + step]) : 0.0;
  };
  const double beside = curvature(1, i % grid.mx, grid.mx) + curvature(grid.mx, i / grid.mx, grid.ms);
  const ErrorShares& share = shares::temperature;
  return share.change * std::abs(fine[i] - std::ranges::max(coarse)) + share.peak * beside +
         share.local * (fine[i] - bulk) / contact;
}

} // namespace

double creepage_x_error(const ContactProblem& problem, const ContactResult& result,
                        const ContactProblem& coarse_problem, const ContactResult& coarse) {
  const Region fine = contact_of(problem, result, patches_of(problem, result)),
               rough = contact_of(coarse_problem, coarse, patches_of(coarse_problem, coarse));
  if (rough.contact < least_companion || !converges(fine, rough, roughness_of_gap(problem, result)))
    return unknown_error;
  ContactTotals totals;
  estimate_creepages(problem, result, coarse_problem.grid, coarse, fine, totals);
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
  totals.area.error = area_error(fine);
  totals.pmax.error = pmax_error(fine, rough, roughness);
  for (Measured* number : {&totals.Fx, &totals.Fs, &totals.adhesion_share, &totals.T_gamma,
                           &totals.creepage_x, &totals.creepage_s})
    number->error = 0;
  if (problem.has_friction()) {
    estimate_shear(problem, result, coarse, regions, totals);
    estimate_creepages(problem, result, coarse_problem.grid, coarse, fine, totals);
  }
  if (result.temperatures && coarse.temperatures) {
    const auto error = [&](std::vector<double> SurfaceTemperatures::*surface, const ThermalBody& body) {
      return temperature_error(problem.grid, (*result.temperatures).*surface, (*coarse.temperatures).*surface,
                               body.temperature, fine.contact);
    };
    totals.Tmax_rail.error = error(&SurfaceTemperatures::rail, problem.heating->rail);
    totals.Tmax_wheel.error = error(&SurfaceTemperatures::wheel, problem.heating->wheel);
  }
  const bool force = problem.load == LoadKind::force;
  totals.approach.error =
      force ? shares::approach.of(fine.line).change * std::abs(totals.approach - coarse.totals.approach) +
                  fine.overlap * local_approach(fine)
            : 0;
  const ShearEffects effects = effects_of_shear(problem, result);
  totals.Fy.error = lateral_error(problem, totals.Fy - coarse.totals.Fy, effects, fine);
  totals.Fz.error =
      force ? 0 : shear_error(totals.Fz - coarse.totals.Fz, effects.fz, fine) + local_normal_force(fine);
  const double longer = growth(fine, moment_elongation);
  estimate.moment_change = longer * shares::moment.of(fine.line).change;
  estimate.local_moment = longer * local_error(fine.moment, fine, shares::moment);
  estimate_patches(problem, patches, rough_patches, effects, fine, roughness, result.patches);
  estimate_track_forces(result);
}

} // namespace bem_contact::contact
