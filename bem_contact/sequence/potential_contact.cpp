#include "bem_contact/sequence/potential_contact.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

using Slice = RailSlice;

/// What is left of the approach q where the rail is inclined, mm.
double depth_of(const Slice& c, double q) {
  return q * c.cosine - c.gap;
}

/// K(m) - E(m), complete elliptic integrals of the parameter m < 1, by the arithmetic-geometric mean.
double k_minus_e(double m) {
  double a = 1, b = std::sqrt(1 - m), sum = m, power = 1;
  for (int i = 0; i < 12 && a - b > 1e-9; ++i) {
    const double c = 0.5 * (a - b), mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  return std::numbers::pi / (2 * a) * 0.5 * sum;
}

/// Vertical force at the approach q and the turn of the normal in the area that bears most of it. Kik and
/// Piotrowski: N = pi E* q I1/I2 for each area, I1 and I2 the integrals of sqrt(x_l^2 - x^2) and of the same
/// over r; along x, I2 is 2 S (K - E) with S^2 = x_l^2 + t^2, m = x_l^2 / S^2 at the distance t in s.
struct Borne {
  double force = 0, turn = 0;
};
Borne borne_at(const ContactEstimate& estimate, double q, double compliance) {
  const std::vector<Slice>& slices = estimate.slices;
  Borne out;
  double largest = 0;
  const auto inside = [&](const Slice& c) { return depth_of(c, 0.55 * q) > 0; };
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (!inside(slices[i]))
      continue;
    std::size_t end = i, deepest = i;
    for (; end < slices.size() && inside(slices[end]); ++end)
      if (depth_of(slices[end], q) > depth_of(slices[deepest], q))
        deepest = end;
    double i1 = 0, i2 = 0;
    for (std::size_t k = i; k < end; ++k) {
      const double xl2 = depth_of(slices[k], 0.55 * q) / slices[k].half;
      const double t = std::max(std::abs(slices[k].s - slices[deepest].s), 0.25 * slice_width);
      i1 += std::numbers::pi * xl2 / 2;
      i2 += 2 * std::sqrt(xl2 + t * t) * k_minus_e(xl2 / (xl2 + t * t));
    }
    const double normal = std::numbers::pi / compliance * depth_of(slices[deepest], q) * i1 / i2;
    const double vertical = normal * slices[deepest].cosine * estimate.lift[deepest];
    out.force += vertical;
    if (vertical > largest) {
      largest = vertical;
      out.turn = std::abs(slices[end - 1].delta - slices[i].delta);
    }
    i = end;
  }
  return out;
}

double compliance_of(const Material& rail, const Material& wheel) {
  return (1 - rail.poisson) / (2 * rail.shear_modulus) + (1 - wheel.poisson) / (2 * wheel.shear_modulus);
}

/// The q at which a growing force(q), nearly q^1.5, is `wanted`: regula falsi (Illinois) in its power 2/3.
template <class Force> double approach_for(double wanted, const Force& force) {
  const auto excess = [&](double q) { return std::cbrt(std::pow(force(q) / wanted, 2)) - 1; };
  double lo = 0, hi = 1e-4, at_lo = -1, at_hi = excess(hi);
  while (at_hi < 0 && hi < 10)
    lo = hi, at_lo = at_hi, hi *= 2, at_hi = excess(hi);
  for (int i = 0; i < 60 && at_hi > 0 && hi - lo > 1e-12; ++i) {
    const double q = lo - at_lo * (hi - lo) / (at_hi - at_lo), f = excess(q);
    if (std::abs(f) < 1e-10)
      return q;
    if (f > 0)
      hi = q, at_hi = f, at_lo *= 0.5;
    else
      lo = q, at_lo = f, at_hi *= 0.5;
  }
  return hi;
}

/// Force of a slice of the foundation, up to its stiffness: depth - half x^2 integrated over x.
double foundation(const Slice& c, double q) {
  const double depth = depth_of(c, q);
  return depth > 0 ? 4.0 / 3 * depth * std::sqrt(depth / c.half) * slice_width : 0.0;
}

void set_centre(ContactEstimate& out, const WheelFrame& frame, double compliance, double force, double approach, bool approach_given) {
  // Of a Hertzian contact with p of a few 100 to 1000 MPa at a depth of some 0.05 mm.
  constexpr double foundation_depth = 10; // mm: p = depth E* / this
  const auto vertical = [&](double q) {
    double sum = 0;
    for (const Slice& c : out.slices)
      sum += foundation(c, q) * c.cosine;
    return sum / (compliance * foundation_depth);
  };
  const double q = approach_given ? 0.55 * approach : approach_for(force, vertical);
  double sum = 0, s = 0, x = 0, radius = 0;
  for (const Slice& c : out.slices) {
    const double share = foundation(c, q);
    const Vector3 arm{c.x - frame.centre[0], c.position.y - frame.centre[1], c.position.z - frame.centre[2]};
    sum += share;
    s += share * c.s;
    x += share * c.x;
    radius += share * (frame.axle[1] * arm[2] - frame.axle[2] * arm[1]); // (a x arm) along x
  }
  out.touching = sum > 0;
  if (out.touching)
    out.s = s / sum, out.x = x / sum, out.rolling_radius = radius / sum;
}

} // namespace

ContactEstimate estimate_contact(const WheelOnRail& pair, const ContactLocus& locus, const Material& rail,
                                 const Material& wheel, double force, double approach, bool approach_given) {
  ContactEstimate out;
  out.slices = slice_rail(pair, locus);
  out.lift.assign(out.slices.size(), 1.0);
  const double compliance = compliance_of(rail, wheel);
  out.approach = approach_given ? approach : approach_for(force, [&](double q) {
    return borne_at(out, q, compliance).force;
  });
  const Borne borne = borne_at(out, out.approach, compliance);
  out.force = borne.force;
  out.turn = borne.turn;
  set_centre(out, locus.frame(), compliance, force, approach, approach_given);
  return out;
}

void estimate_with_shear(ContactEstimate& estimate, const Material& rail, const Material& wheel, double force,
                         double most) {
  const double compliance = compliance_of(rail, wheel);
  const double q =
      approach_for(force, [&](double at) { return borne_at(estimate, at, compliance).force; });
  estimate.approach = std::min(q, most);
  const Borne borne = borne_at(estimate, estimate.approach, compliance);
  estimate.force = borne.force;
  estimate.turn = borne.turn;
}

ContactExtent contact_extent(const ContactEstimate& estimate) {
  ContactExtent out;
  if (estimate.slices.size() < 2)
    return out;
  const double ds = estimate.slices[1].s - estimate.slices[0].s;
  for (const RailSlice& c : estimate.slices) {
    const double depth = 0.55 * estimate.approach * c.cosine - c.gap;
    if (depth <= 0)
      continue;
    const double length = 2 * std::sqrt(depth / c.half);
    out.along_x = std::max(out.along_x, length);
    out.along_s += ds;
    out.area += length * ds;
  }
  return out;
}

std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate, double q) {
  std::vector<PotentialArea> areas;
  bool open = false;
  for (const Slice& c : estimate.slices) {
    const double depth = depth_of(c, q);
    if (depth > 0) {
      const double half_length = std::sqrt(depth / c.half);
      if (!open)
        areas.push_back({c.s, c.s, c.x - half_length, c.x + half_length});
      PotentialArea& area = areas.back();
      area.s_to = c.s;
      area.x_from = std::min(area.x_from, c.x - half_length);
      area.x_to = std::max(area.x_to, c.x + half_length);
    }
    open = depth > 0;
  }
  return areas;
}

std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate) {
  return potential_areas(estimate, estimate.reach * std::max(estimate.approach, 1e-4));
}

} // namespace bem_contact
