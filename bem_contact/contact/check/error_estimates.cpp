#include "bem_contact/contact/check/error_estimates.hpp"

#include "bem_contact/contact/grid/patches.hpp"
#include "bem_contact/contact/settings.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace bem_contact::contact {
namespace {

/// A set of elements in contact: all of them, or a patch.
struct Region {
  int contact = 0, border = 0;           ///< elements; border: one beside it is exterior
  int adhesion = 0, adhesion_border = 0; ///< border: one beside it slips
  double fn = 0, fx = 0, fs = 0;         ///< sums of p_n dS, p_x dS, p_s dS, N
  double friction = 0;                   ///< sum of mu p_n dS, N
  double pmax = 0;                       ///< MPa
  double curvature = 0;                  ///< at the peak: how far p_n falls to its neighbours, twice the mean
                                         ///< along x and twice that along s, MPa
  double approach = 0;                   ///< PatchSummary::approach, mm
  double area = 0;                       ///< mm^2
  double x = 0, s = 0;                   ///< centre of pressure, mm

  double steepness = 0; ///< sum of |p_n sin(delta)| dS over fn

  double border_root() const { return std::sqrt(double(adhesion_border)); }
  /// Share of the elements on the border of adhesion, times that on the border of the contact.
  double border_share() const { return double(adhesion_border) / contact * border / contact; }
  /// How far the pressure falls from its peak to the next elements, over the peak.
  double relative_fall() const { return curvature / pmax; }
  double adhesion_share() const { return double(adhesion) / contact; }
};

/// Looks up fields by column and row; zero pressure and exterior beyond the grid.
struct Field {
  const ContactProblem& problem;
  const ContactResult& result;

  bool inside(int ix, int is) const {
    return ix >= 0 && ix < problem.grid.mx && is >= 0 && is < problem.grid.ms;
  }
  double pressure(int ix, int is) const {
    return inside(ix, is) ? std::max(0.0, result.pn[is * problem.grid.mx + ix]) : 0.0;
  }
  ElementState state(int ix, int is) const {
    return inside(ix, is) ? result.state[is * problem.grid.mx + ix] : ElementState::exterior;
  }
  bool beside(int ix, int is, ElementState wanted) const {
    const bool along_x = state(ix - 1, is) == wanted || state(ix + 1, is) == wanted;
    const bool along_s = state(ix, is - 1) == wanted || state(ix, is + 1) == wanted;
    return (problem.grid.mx > 1 && along_x) || (problem.grid.ms > 1 && along_s);
  }
  double curvature(int ix, int is) const {
    const double p = pressure(ix, is);
    const double x = 2 * p - pressure(ix - 1, is) - pressure(ix + 1, is);
    const double s = 2 * p - pressure(ix, is - 1) - pressure(ix, is + 1);
    return (problem.grid.mx > 1 ? std::abs(x) : 0.0) + (problem.grid.ms > 1 ? std::abs(s) : 0.0);
  }
};

Region region_of(const ContactProblem& problem, const ContactResult& result, std::span<const int> elements) {
  const Field field{problem, result};
  const double dS = problem.element_area();
  Region out;
  for (const int i : elements) {
    const int ix = i % problem.grid.mx, is = i / problem.grid.mx;
    const double fn = result.pn[i] * dS;
    const bool adheres = result.state[i] == ElementState::adhesion;
    ++out.contact;
    out.border += field.beside(ix, is, ElementState::exterior);
    out.adhesion += adheres;
    out.adhesion_border += adheres && field.beside(ix, is, ElementState::slip);
    out.fn += fn;
    out.fx += result.px[i] * dS;
    out.fs += result.ps[i] * dS;
    out.friction += problem.has_friction() ? problem.friction_of(is) * fn : 0.0;
    out.x += fn * problem.grid.x(ix);
    out.s += fn * problem.rows[is].s;
    out.steepness += std::abs(fn * std::sin(problem.rows[is].delta));
    out.approach =
        std::max(out.approach, result.approach * std::cos(problem.rows[is].delta) - problem.gap[i]);
    if (result.pn[i] > out.pmax) {
      out.pmax = result.pn[i];
      out.curvature = field.curvature(ix, is);
    }
  }
  out.area = out.contact * dS;
  out.x /= out.fn;
  out.s /= out.fn;
  out.steepness /= out.fn;
  return out;
}

/// Root mean square of the fourth differences of the undeformed distance from element to element within the
/// contact, mm. Where it is smooth on the scale of the elements they all but vanish; noise and kinks remain.
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
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// False where the peak of the pressure is narrower than the elements can show, where larger elements change
/// it grossly, or where the undeformed distance is rough: then smaller elements show another field.
bool converges(const ContactProblem& problem, const ContactResult& result, const Region& fine,
               const Region& coarse) {
  const double self = problem.numbers.at(0, 0, component_n, 0, component_n);
  return std::abs(fine.pmax - coarse.pmax) <= largest_pmax_change * fine.pmax &&
         fine.curvature <= largest_curvature * fine.pmax &&
         roughness_of_gap(problem, result) <= largest_roughness * fine.pmax * self;
}

/// Of the patches, in the order of ContactResult::patches.
std::vector<Region> patches_of(const ContactProblem& problem, const ContactResult& result) {
  std::vector<Region> out;
  for (const std::vector<int>& elements : connected_elements(problem.grid, result.state))
    out.push_back(region_of(problem, result, elements));
  std::ranges::stable_sort(out, std::ranges::greater{}, &Region::fn);
  return out;
}

Region contact_of(const ContactProblem& problem, const ContactResult& result) {
  std::vector<int> all;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (result.state[i] != ElementState::exterior)
      all.push_back(i);
  return region_of(problem, result, all);
}

double pmax_error(const Region& r, const Region& coarse) {
  return pmax_change * std::abs(r.pmax - coarse.pmax) + pmax_local * r.curvature;
}

double area_error(const Region& r) {
  return area_border * r.area * r.border / r.contact;
}

/// How the parts of an estimate that have to do with friction are weighted.
struct Weights {
  double change, of_element, of_border;
};

Weights shear_x() {
  return {shear_x_change, shear_x_local, shear_x_border};
}

Weights shear_s() {
  return {shear_s_change, shear_s_local, shear_s_border};
}

/// Of a force, N. The border of adhesion lies somewhere within its elements, each by chance: the root of
/// their number counts.
double force_error(const Weights& w, double change, const Region& r) {
  return w.change * std::abs(change) +
         (w.of_element + w.of_border * r.border_root()) * r.friction / r.contact;
}

/// Coarse patches that lie where the fine ones do; empty where their numbers differ.
std::vector<Region> matched(const std::vector<Region>& fine, std::vector<Region> coarse) {
  std::vector<Region> out;
  if (fine.size() != coarse.size())
    return out;
  for (const Region& patch : fine) {
    const auto distance = [&](const Region& r) { return std::hypot(r.x - patch.x, r.s - patch.s); };
    const auto nearest = std::ranges::min_element(coarse, {}, distance);
    out.push_back(*nearest);
    coarse.erase(nearest);
  }
  return out;
}

PatchErrors patch_errors(const Region& fine, const Region& coarse) {
  PatchErrors out;
  out.pmax = pmax_error(fine, coarse);
  out.area = area_error(fine);
  out.fn = force_change * std::abs(fine.fn - coarse.fn) + force_local * fine.fn / fine.contact +
           force_border * fine.steepness * fine.border_root() * fine.friction / fine.contact;
  out.approach = overlap_change * std::abs(fine.approach - coarse.approach) +
                 fine.approach * (overlap_local / fine.contact + overlap_peak * fine.relative_fall());
  out.fx = fine.friction > 0 ? force_error(shear_x(), fine.fx - coarse.fx, fine) : 0;
  out.fs = fine.friction > 0 ? force_error(shear_s(), fine.fs - coarse.fs, fine) : 0;
  return out;
}

/// The strain of the surface under full friction, from the displacement of one element that bears pmax.
double friction_strain(const ContactProblem& problem, const Region& r) {
  const double self = problem.numbers.at(0, 0, component_n, 0, component_n);
  return r.friction / r.fn * r.pmax * self / std::sqrt(problem.element_area());
}

/// Sets what needs friction: shear forces, adhesion, creepages, power. `power_gained`: the power of the
/// result less that of the coarse one.
void estimate_shear(const ContactProblem& problem, const ContactResult& result, const ContactResult& coarse,
                    const std::pair<Region, Region>& regions, double power_gained, TotalErrors& e) {
  const auto& [fine, rough] = regions;
  e.Fx = problem.force_x ? 0 : force_error(shear_x(), result.Fx - coarse.Fx, fine);
  e.Fs = problem.force_s ? 0 : force_error(shear_s(), result.Fs - coarse.Fs, fine);
  e.adhesion_share = adhesion_change * std::abs(fine.adhesion_share() - rough.adhesion_share()) +
                     (adhesion_local + adhesion_border * fine.border_root()) / fine.contact;
  e.friction_power = power_change * std::abs(power_gained) +
                     power_local * std::abs(friction_power(result, problem.element_area())) / fine.contact;
  const double local = friction_strain(problem, fine) *
                       (creepage_local / fine.contact + creepage_border * fine.border_share());
  if (problem.force_x)
    e.creepage_x = creepage_change * std::abs(result.creepage_x - coarse.creepage_x) + local;
  if (problem.force_s)
    e.creepage_s = creepage_change * std::abs(result.creepage_s - coarse.creepage_s) + local;
}

} // namespace

void estimate_errors(const ContactProblem& problem, const ContactResult& result,
                     const ContactProblem& coarse_problem, const ContactResult& coarse,
                     double friction_moment, Discretisation& out) {
  const std::pair<Region, Region> regions{contact_of(problem, result), contact_of(coarse_problem, coarse)};
  const auto& [fine, rough] = regions;
  const std::vector<Region> patches = patches_of(problem, result);
  out.coarse_pmax = rough.pmax;
  out.converges = converges(problem, result, fine, rough);
  out.patches.resize(patches.size());
  if (!out.converges)
    return;
  TotalErrors& e = out.errors;
  e.area = area_error(fine);
  e.pmax = pmax_error(fine, rough);
  e.Fx = e.Fs = e.adhesion_share = e.friction_power = e.creepage_x = e.creepage_s = 0;
  if (problem.has_friction())
    estimate_shear(problem, result, coarse, regions,
                   friction_power(result, problem.element_area()) -
                       friction_power(coarse, coarse_problem.element_area()),
                   e);
  const bool force = problem.load == LoadKind::force;
  e.approach =
      force ? approach_change * std::abs(result.approach - coarse.approach) +
                  fine.approach * (approach_local / fine.contact + approach_peak * fine.relative_fall())
            : 0;
  const Weights lateral{lateral_change, lateral_local, lateral_border};
  e.Fy = force_error(lateral, result.Fy - coarse.Fy, fine);
  e.Fz = force ? 0 : force_error(lateral, result.Fz - coarse.Fz, fine);
  out.local_moment = friction_moment * (moment_local + moment_border * fine.border_root()) / fine.contact;
  const std::vector<Region> coarse_patches = matched(patches, patches_of(coarse_problem, coarse));
  for (std::size_t i = 0; i < coarse_patches.size(); ++i)
    out.patches[i] = patch_errors(patches[i], coarse_patches[i]);
  if (problem.force_x && coarse_patches.size() == 1)
    out.patches[0].fx = 0; // prescribed
}

} // namespace bem_contact::contact
