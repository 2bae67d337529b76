#include "bem_contact/sequence/plan/contact_estimate.hpp"

#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/approach_search.hpp"
#include "bem_contact/scene/contact_centre.hpp"
#include "bem_contact/scene/elastic_limit.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// 1. Least value of the vertical force of pressure and shear over that of the pressure: where friction takes
/// all of it away, the estimate would be without end.
constexpr double least_lift = 0.05;
/// 1. Largest value of the same ratio.
constexpr double most_lift = 4.0;
/// 1. With shear, the approach of the estimate may be so many times largest_approach (scene/settings.hpp): an
/// overestimate costs a grid that is too coarse.
constexpr double most_approach_with_shear = 2.0;
/// 1/mm. Least half of the curvature along x that the estimate of a given distance takes: of a wheel of
/// radius 50 m. Chosen.
constexpr double least_half_curvature = 1e-5;

/// K(m) - E(m), complete elliptic integrals of the parameter m < 1, by the arithmetic-geometric mean: the
/// difference itself, because K and E cancel for the small m of slices far from the deepest one.
double k_minus_e(double m) {
  double a = 1, b = std::sqrt(1 - m), sum = m, power = 1;
  while (a - b > elliptic_tolerance) { // each step doubles the digits
    const double c = 0.5 * (a - b), mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  return std::numbers::pi / (2 * a) * 0.5 * sum;
}

/// Normal force of the slices of an area that touch at the approach q. Kik and Piotrowski: N = pi E*
/// q I1/I2, I1 and I2 the integrals of sqrt(x_l^2 - x^2) and of the same over r; along x, I2 is 2 S (K - E)
/// with S^2 = x_l^2 + t^2, m = x_l^2 / S^2 at the distance t in s.
/// `width`: of a slice, mm.
double normal_force(std::span<const RailSlice> area, const RailSlice& deepest, double q, double compliance,
                    double width) {
  double i1 = 0, i2 = 0;
  for (const RailSlice& c : area) {
    const double xl2 = c.depth(penetration_share * q) / c.half;
    if (!(xl2 > 0)) // it touches the layer alone
      continue;
    const double t = std::max(std::abs(c.s - deepest.s), slice_self_distance * width);
    i1 += std::numbers::pi * xl2 / 2;
    i2 += 2 * std::sqrt(xl2 + t * t) * k_minus_e(xl2 / (xl2 + t * t));
  }
  return i2 > 0 ? std::numbers::pi / compliance * deepest.depth(q) * i1 / i2 : 0.0;
}

/// The same of a layer alone, between rigid bodies: depth - half x^2 over its compliance, integrated.
double layer_force(std::span<const RailSlice> area, double q, double layer, double width) {
  double sum = 0;
  for (const RailSlice& c : area) {
    const double depth = c.depth(q);
    sum += 4.0 / 3 * depth * std::sqrt(depth / c.half) * width;
  }
  return sum / layer;
}

/// Two bodies and a layer in series.
struct Series {
  double force;         ///< N
  double elastic_share; ///< of the approach that is the bodies' own
};

/// `elastic`, `layer`: what either alone bears at the whole approach. Under a part of the force the bodies
/// approach by its power 2/3 (Hertz) and the layer by its power 1/2 (Winkler); both make up the approach.
Series in_series(double elastic, double layer) {
  double lo = 0, hi = 1; // the bodies' share
  for (int i = 0; i < 60; ++i) {
    const double share = 0.5 * (lo + hi), force = elastic * std::pow(share, 1.5);
    (share + std::sqrt(force / layer) < 1 ? lo : hi) = share;
  }
  return {elastic * std::pow(lo, 1.5), lo};
}

/// The share of the approach at which bodies that touch would overlap, at the most: a layer alone has 1.
double widest_penetration(const PairCompliance& compliance) {
  return compliance.layer > 0 ? 1.0 : double(penetration_share);
}

/// Slices of one width, mm.
double width_of(std::span<const RailSlice> slices) {
  return slices.size() > 1 ? slices[1].s - slices[0].s : slice_width;
}

/// Largest pressure and extent of one area that bears `normal` at the approach q: the pressure is
/// proportional to sqrt(x_l^2 - x^2). `q`: what is left of the approach to overlap.
void set_extent(std::span<const RailSlice> area, const RailSlice& deepest, double q, double normal,
                double width, EstimatedContact& out) {
  double half_lengths = 0;
  for (const RailSlice& c : area) {
    const double squared = c.depth(q) / c.half;
    half_lengths += 0.5 * std::numbers::pi * squared;
    out.length = std::max(out.length, 2 * std::sqrt(squared));
  }
  out.width = width * double(area.size());
  out.pressure = normal * 0.5 * out.length / (half_lengths * width);
  out.turn = std::abs(area.back().delta - area.front().delta);
  out.x = deepest.x;
  out.s = deepest.s;
  out.delta = deepest.delta;
  out.position = deepest.position;
}

/// Of the inclination, weighted by the pressure.
double mean_sine(std::span<const RailSlice> area, double q) {
  double sum = 0, weights = 0;
  for (const RailSlice& c : area) {
    const double weight = c.depth(q) / c.half;
    sum += weight * std::sin(c.delta);
    weights += weight;
  }
  return sum / weights;
}

/// Calls take(area, deepest, series, vertical) for each area of slices that touch at the approach q, along s.
template <class Take>
void for_each_area(std::span<const RailSlice> slices, std::span<const double> lift, double q,
                   const PairCompliance& compliance, double width, const Take& take) {
  const double most = widest_penetration(compliance);
  const auto inside = [&](const RailSlice& c) { return c.depth(most * q) > 0; };
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (!inside(slices[i]))
      continue;
    std::size_t end = i, deepest = i;
    for (; end < slices.size() && inside(slices[end]); ++end)
      if (slices[end].depth(q) > slices[deepest].depth(q))
        deepest = end;
    const std::span<const RailSlice> area = slices.subspan(i, end - i);
    Series series{normal_force(area, slices[deepest], q, compliance.elastic, width), 1};
    if (compliance.layer > 0)
      series = in_series(series.force, layer_force(area, q, compliance.layer, width));
    take(area, slices[deepest], series, series.force * slices[deepest].cosine * lift[deepest]);
    i = end;
  }
}

/// Vertical force as a function of the approach. It looks only at slices that have the wheel near.
class BorneForce {
public:
  BorneForce(const ContactEstimate& estimate, const PairCompliance& compliance)
      : compliance_(compliance), width_(width_of(estimate.slices)) {
    const auto near = [](const RailSlice& c) { return c.gap < excluded_gap; };
    const auto first = std::ranges::find_if(estimate.slices, near);
    const auto last = std::ranges::find_if(estimate.slices.rbegin(), estimate.slices.rend(), near).base();
    if (first == estimate.slices.end())
      return;
    slices_ = std::span(first, last);
    lift_ = std::span(estimate.lift).subspan(first - estimate.slices.begin(), slices_.size());
  }
  double operator()(double q) const {
    double force = 0;
    for_each_area(slices_, lift_, q, compliance_, width_,
                  [&](auto, const RailSlice&, const Series&, double vertical) { force += vertical; });
    return force;
  }

private:
  PairCompliance compliance_;
  double width_;
  std::span<const RailSlice> slices_;
  std::span<const double> lift_;
};

/// What is known of the area that bears most of the vertical force at the approach q.
EstimatedContact contact_at(const ContactEstimate& estimate, double q, const PairCompliance& compliance) {
  EstimatedContact out;
  double largest = 0;
  const double width = width_of(estimate.slices);
  const double overlap = estimate.penetration * q;
  for_each_area(
      estimate.slices, estimate.lift, q, compliance, width,
      [&](std::span<const RailSlice> area, const RailSlice& deepest, const Series& series, double vertical) {
        while (area.size() > 1 && !(area.front().depth(overlap) > 0))
          area = area.subspan(1);
        while (area.size() > 1 && !(area.back().depth(overlap) > 0))
          area = area.first(area.size() - 1);
        if (!(deepest.depth(overlap) > 0))
          return;
        out.normal += series.force;
        out.lateral -= series.force * mean_sine(area, overlap);
        if (vertical > largest) {
          largest = vertical;
          set_extent(area, deepest, overlap, series.force, width, out);
        }
      });
  return out;
}

double approach_under(const ContactEstimate& estimate, double force, const PairCompliance& compliance) {
  return approach_for(force, BorneForce(estimate, compliance));
}

void set_approach(ContactEstimate& estimate, double q, const PairCompliance& compliance) {
  estimate.approach = q;
  estimate.force = BorneForce(estimate, compliance)(q);
  if (!(compliance.layer > 0))
    return;
  double largest = 0;
  for_each_area(estimate.slices, estimate.lift, q, compliance, width_of(estimate.slices),
                [&](auto, const RailSlice&, const Series& series, double vertical) {
                  if (vertical <= largest)
                    return;
                  largest = vertical;
                  estimate.penetration =
                      series.elastic_share * penetration_share + (1 - series.elastic_share);
                });
}

/// Whether the slice may be the deepest of an area at some approach up to `most`: its depth grows linearly
/// with the approach, so that a neighbour that is deeper at both ends always is.
bool may_be_deepest(std::span<const RailSlice> slices, std::size_t i, double most) {
  const auto is_deeper = [&](std::size_t other) {
    return slices[other].gap < slices[i].gap && slices[other].depth(most) > slices[i].depth(most);
  };
  return !(i > 0 && is_deeper(i - 1)) && !(i + 1 < slices.size() && is_deeper(i + 1));
}

/// Of the slices that can touch and be the deepest there, where each is nearest to the wheel. Every other one
/// takes over what the nearest of them has: it counts only if the wheel is moved aside a little.
void set_lift(const ContactSetup& setup, ContactEstimate& estimate) {
  const std::vector<RailSlice>& slices = estimate.slices;
  std::size_t last = slices.size(); // of the slices that know their own; at first none
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const RailSlice& c = slices[i];
    if (c.gap >= largest_approach || !may_be_deepest(slices, i, last_approach))
      continue;
    const RigidSlip slip = setup.rigid_slip({}, {{c.s, c.position, c.delta}}, {c.x});
    const double along_s = slip.s[0] / std::hypot(slip.x[0], slip.s[0], half_slip_creepage);
    estimate.lift[i] = std::clamp(1 + setup.motion.coefficients.friction * along_s * std::tan(c.delta),
                                  least_lift, most_lift);
    const bool first = last == slices.size();
    for (std::size_t k = first ? 0 : last + 1; k < i; ++k)
      estimate.lift[k] = first || i - k < k - last ? estimate.lift[i] : estimate.lift[last];
    last = i;
  }
  if (last < slices.size())
    std::fill(estimate.lift.begin() + static_cast<std::ptrdiff_t>(last), estimate.lift.end(),
              estimate.lift[last]);
}

} // namespace

PairCompliance pair_compliance(const ContactSetup& setup) {
  return {contact_compliance(setup.rail.material, setup.wheel.material), setup.layer.normal};
}

ContactEstimate estimate_contact(std::vector<RailSlice> slices, const PairCompliance& compliance,
                                 const ContactLoad& load) {
  ContactEstimate out;
  out.slices = std::move(slices);
  out.lift.assign(out.slices.size(), 1.0);
  set_approach(out,
               load.kind == LoadKind::approach ? load.approach : approach_under(out, load.force, compliance),
               compliance);
  return out;
}

ContactEstimate estimate_contact(const ContactSetup& setup, bool foresee_shear) {
  const PairCompliance compliance = pair_compliance(setup);
  ContactEstimate out = estimate_contact(setup.wheel_rail()->slices, compliance, setup.load);
  require_small_approach(out.approach);
  const Motion& motion = setup.motion;
  if (foresee_shear && motion.tangential && motion.kind != MotionKind::shift && setup.load.force > 0 &&
      !motion.force_x && !motion.force_s) {
    set_lift(setup, out);
    set_approach(out,
                 std::min(approach_under(out, setup.load.force, compliance),
                          most_approach_with_shear * largest_approach),
                 compliance);
  }
  return out;
}

EstimatedContact estimated_contact(const ContactEstimate& estimate, const PairCompliance& compliance,
                                   double shift_y) {
  if (shift_y == 0)
    return contact_at(estimate, estimate.approach, compliance);
  ContactEstimate moved = estimate;
  for (RailSlice& c : moved.slices)
    c.gap += shift_y * std::sin(c.delta);
  const double q = estimate.force > 0 ? approach_under(moved, estimate.force, compliance) : 0;
  return contact_at(moved, q, compliance);
}

namespace {

/// The overlap up to which an area does not reach the end of the slices, at most `reach`, mm. A contact that
/// is long along x is narrower than its overlap, and slices need not reach beyond the contact.
double uncut_reach(std::span<const RailSlice> slices, std::span<const RailSlice> area,
                   const RailSlice& deepest, double reach) {
  double out = reach;
  if (&area.front() == &slices.front())
    out = std::min(out, area.front().gap / area.front().cosine);
  if (&area.back() == &slices.back())
    out = std::min(out, area.back().gap / area.back().cosine);
  return deepest.depth(out) > 0 ? out : reach;
}

} // namespace

std::vector<EstimatedArea> estimated_areas(const ContactEstimate& estimate,
                                           const PairCompliance& compliance) {
  std::vector<EstimatedArea> out;
  const double width = width_of(estimate.slices), most = estimate.penetration * estimate.approach;
  for_each_area(
      estimate.slices, estimate.lift, estimate.approach, compliance, width,
      [&](std::span<const RailSlice> area, const RailSlice& deepest, const Series& series, double) {
        const double reach = uncut_reach(estimate.slices, area, deepest, most);
        EstimatedArea& one = out.emplace_back(EstimatedArea{
            .normal = series.force, .x = deepest.x, .half = deepest.half, .depth = deepest.depth(reach)});
        double weights = 0;
        for (const RailSlice& c : area) {
          const double squared = std::max(c.depth(reach), 0.0) / c.half;
          one.overlap += 2 * std::sqrt(squared) * width;
          one.s += squared * c.s;
          one.delta += squared * c.delta;
          weights += squared;
        }
        one.s /= weights;
        one.delta /= weights;
      });
  return out;
}

std::optional<ContactEstimate> estimate_contact(const ContactProblem& problem,
                                                const PairCompliance& compliance) {
  const ContactGrid& grid = problem.grid;
  if (problem.plane_strain() || grid.mx < 3)
    return std::nullopt;
  std::vector<RailSlice> slices;
  for (int is = 0; is < grid.ms; ++is) {
    const double* h = problem.gap.data() + std::size_t(is) * grid.mx;
    const int ix = std::clamp(int(std::min_element(h, h + grid.mx) - h), 1, grid.mx - 2);
    const double curvature = (h[ix - 1] - 2 * h[ix] + h[ix + 1]) / (grid.dx * grid.dx);
    const ContactRow& row = problem.rows[is];
    slices.push_back({.s = row.s,
                      .delta = row.delta,
                      .cosine = std::cos(row.delta),
                      .gap = h[ix],
                      .x = grid.x(ix),
                      .half = std::max(0.5 * curvature, least_half_curvature),
                      .position = row.position});
  }
  return estimate_contact(std::move(slices), compliance, {problem.load, problem.force, problem.approach});
}

} // namespace bem_contact
