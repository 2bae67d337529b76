#include "bem_contact/wheelset/potential_contact.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact {

ContactEstimate estimate_contact(const WheelOnRail& pair, const ContactLocus& locus, const Material& rail,
                                 const Material& wheel, double force, double approach, bool approach_given) {
  constexpr double ds = 0.1;
  ContactEstimate out;
  std::vector<ContactRow> rows;
  int near = 0;
  for (double s = pair.rail.s_begin() + ds; s < pair.rail.s_end(); s += ds) {
    const CurvePoint p = pair.rail.quick(s, near);
    rows.push_back({s, pair.rail_pose.to_track(p.position), p.delta + pair.rail_pose.angle});
  }
  const std::vector<RowOnLocus> nearest = rows_on_locus(locus, rows);
  for (std::size_t i = 0; i < rows.size(); ++i)
    out.slices.push_back({rows[i].s, rows[i].delta, nearest[i].distance, nearest[i].x,
                          nearest[i].hit() ? std::max(nearest[i].half, 0.05 / pair.wheel_radius) : 1.0});

  const double compliance =
      (1 - rail.poisson) / (2 * rail.shear_modulus) + (1 - wheel.poisson) / (2 * wheel.shear_modulus);
  const auto half_length_squared = [](const ContactEstimate::Slice& c, double q) {
    return (q * std::cos(c.delta) - c.gap) / c.half;
  };
  // Midpoint rule in the angle: I2 = integral of xl cos^2 / sqrt(xl^2 sin^2 + t^2).
  constexpr int points = 32;
  std::array<double, points> sine2{}, cosine2{};
  for (int j = 0; j < points; ++j) {
    sine2[j] = std::pow(std::sin(std::numbers::pi * ((j + 0.5) / points - 0.5)), 2);
    cosine2[j] = 1 - sine2[j];
  }
  // N = pi E* q I1/I2 for each area; I1, I2: Kik and Piotrowski, integrals of sqrt(x_l^2 - x^2) and the same
  // over r.
  const auto force_at = [&](double q, double* turn) {
    double sum = 0, largest = 0;
    for (std::size_t i = 0; i < out.slices.size(); ++i) {
      if (half_length_squared(out.slices[i], 0.55 * q) <= 0)
        continue;
      std::size_t end = i, deepest = i;
      const auto depth = [&](std::size_t k) { return q * std::cos(out.slices[k].delta) - out.slices[k].gap; };
      for (; end < out.slices.size() && half_length_squared(out.slices[end], 0.55 * q) > 0; ++end)
        if (depth(end) > depth(deepest))
          deepest = end;
      double i1 = 0, i2 = 0;
      for (std::size_t k = i; k < end; ++k) {
        const double xl2 = half_length_squared(out.slices[k], 0.55 * q);
        const double t = std::max(std::abs(out.slices[k].s - out.slices[deepest].s), 0.25 * ds);
        i1 += ds * std::numbers::pi * xl2 / 2;
        for (int j = 0; j < points; ++j)
          i2 += ds * xl2 * cosine2[j] / std::sqrt(xl2 * sine2[j] + t * t) * std::numbers::pi / points;
      }
      const double normal = std::numbers::pi / compliance * depth(deepest) * i1 / i2;
      const double vertical = normal * std::cos(out.slices[deepest].delta);
      sum += vertical;
      if (turn && vertical > largest) {
        largest = vertical;
        *turn = std::abs(out.slices[end - 1].delta - out.slices[i].delta);
      }
      i = end;
    }
    return sum;
  };

  if (approach_given) {
    out.approach = approach;
  } else {
    // F^(2/3) is nearly linear in q: regula falsi (Illinois) in it.
    const auto excess = [&](double q) { return std::cbrt(std::pow(force_at(q, nullptr) / force, 2)) - 1; };
    double lo = 0, hi = 1e-4, at_lo = -1, at_hi = excess(hi);
    while (at_hi < 0 && hi < 10)
      lo = hi, at_lo = at_hi, hi *= 2, at_hi = excess(hi);
    for (int i = 0; i < 60 && at_hi > 0 && hi - lo > 1e-9 * hi; ++i) {
      const double q = lo - at_lo * (hi - lo) / (at_hi - at_lo), f = excess(q);
      if ((f > 0) == (at_hi > 0))
        hi = q, at_hi = f, at_lo *= 0.5;
      else
        lo = q, at_lo = f, at_hi *= 0.5;
      if (std::abs(f) < 1e-8)
        break;
    }
    out.approach = hi;
  }
  out.force = force_at(out.approach, &out.turn);
  return out;
}

ContactExtent contact_extent(const ContactEstimate& estimate) {
  ContactExtent out;
  if (estimate.slices.size() < 2)
    return out;
  const double ds = estimate.slices[1].s - estimate.slices[0].s;
  for (const ContactEstimate::Slice& c : estimate.slices) {
    const double depth = 0.55 * estimate.approach * std::cos(c.delta) - c.gap;
    if (depth <= 0)
      continue;
    const double length = 2 * std::sqrt(depth / c.half);
    out.along_x = std::max(out.along_x, length);
    out.along_s += ds;
    out.area += length * ds;
  }
  return out;
}

GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin,
                   double share) {
  GridPlan plan{origin, 0, grid.ms, grid.mx, grid.dx, grid.ds};
  const double q = share * std::max(estimate.approach, 1e-4);
  double from = 0, to = 0, x_from = 0, x_to = 0;
  bool any = false;
  const ContactEstimate::Slice* nearest = nullptr;
  for (const ContactEstimate::Slice& c : estimate.slices) {
    if (!nearest || c.gap < nearest->gap)
      nearest = &c;
    const double depth = q * std::cos(c.delta) - c.gap;
    if (depth <= 0)
      continue;
    const double half_length = std::sqrt(depth / c.half);
    from = any ? from : c.s;
    to = c.s;
    x_from = any ? std::min(x_from, c.x - half_length) : c.x - half_length;
    x_to = any ? std::max(x_to, c.x + half_length) : c.x + half_length;
    any = true;
  }
  if (!any && nearest)
    from = to = nearest->s, x_from = x_to = nearest->x;
  if (grid.s_from != 0 || grid.s_to != 0)
    from = grid.s_from + 0.5 * grid.ds, to = grid.s_to - 0.5 * grid.ds;

  const auto row_of = [&](double s) { return static_cast<int>(std::lround((s - origin) / grid.ds)); };
  if (plan.rows == 0) {
    plan.first = row_of(from) - (grid.s_from == grid.s_to ? 2 : 0);
    plan.rows = std::max(row_of(to) + (grid.s_from == grid.s_to ? 2 : 0) - plan.first + 1, 3);
  } else {
    plan.first = row_of(0.5 * (from + to)) - plan.rows / 2;
  }
  if (plan.columns == 0)
    plan.columns = 2 * (static_cast<int>(std::ceil(0.5 * (x_to - x_from) / grid.dx)) + 2);
  plan.x_centre = grid.dx * std::round(0.5 * (x_from + x_to) / grid.dx);
  return plan;
}

std::vector<ContactRow> rail_rows(const WheelOnRail& pair, const GridPlan& plan) {
  if (plan.s_from() < pair.rail.s_begin() || plan.s_to() > pair.rail.s_end())
    throw InputError("The potential contact leaves the rail's profile",
                     fmt::format("rows need s = {:.2f} .. {:.2f} mm and '{}' spans {:.2f} .. {:.2f} mm",
                                 plan.s_from(), plan.s_to(), pair.rail.name(), pair.rail.s_begin(),
                                 pair.rail.s_end()),
                     "Change position.lateral, grid.s_from and grid.s_to, or give a longer profile.");
  std::vector<ContactRow> rows;
  for (int i = 0; i < plan.rows; ++i) {
    const CurvePoint p = pair.rail_at(plan.s(i));
    rows.push_back({p.s, p.position, p.delta});
  }
  return rows;
}

} // namespace bem_contact
