#include "bem_contact/wheelset/potential_contact.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace bem_contact {

namespace {

/// The wheel cut by a plane x = const, over the arc length of its profile.
class WheelSection {
public:
  WheelSection(const WheelOnRail& pair, double x) : pair_(pair), x2_(x * x) {}

  /// Nothing where the wheel's radius is smaller than |x|.
  std::optional<Point2> at(double s) const { return from_section(pair_.wheel.at(s).position); }
  std::optional<Point2> from_section(Point2 p) const {
    const double r = pair_.wheel_radius + p.z, square = r * r - x2_;
    if (r <= 0 || square <= 0)
      return std::nullopt;
    return pair_.wheel_pose.to_track({p.y, std::sqrt(square) - pair_.wheel_radius});
  }

private:
  const WheelOnRail& pair_;
  double x2_;
};

double along(Point2 p, const ContactRow& row) {
  return dot(p - row.position, tangent_of(row.delta));
}
double outward(Point2 p, const ContactRow& row) {
  return -dot(p - row.position, normal_of(row.delta));
}

/// Root of along(section(s)) in [a, b], by the regula falsi of Anderson and Bjorck with bisection behind it.
double intersect(const WheelSection& section, const ContactRow& row, double a, double b, double fa,
                 double fb) {
  for (int i = 0; i < 100 && std::abs(b - a) > 1e-13; ++i) {
    const double m = i % 8 == 7 ? 0.5 * (a + b) : b - fb * (b - a) / (fb - fa);
    const auto p = section.at(std::clamp(m, std::min(a, b), std::max(a, b)));
    const double fm = p ? along(*p, row) : 0.0;
    if (std::abs(fm) < 1e-14)
      return m;
    if ((fm > 0) != (fb > 0)) {
      a = b, fa = fb;
    } else {
      const double g = 1 - fm / fb;
      fa *= g > 0 ? g : 0.5;
    }
    b = m, fb = fm;
  }
  return b;
}

} // namespace

std::vector<double> undeformed_distance(const WheelOnRail& pair, std::span<const ContactRow> rows,
                                        std::span<const double> x) {
  const double length = pair.wheel.s_end() - pair.wheel.s_begin();
  const int n = std::max(2, static_cast<int>(std::ceil(length / 0.25)));
  std::vector<double> s(n + 1);
  std::vector<Point2> profile(n + 1);
  for (int k = 0; k <= n; ++k) {
    s[k] = k == n ? pair.wheel.s_end() : pair.wheel.s_begin() + length * k / n;
    profile[k] = pair.wheel.at(s[k]).position;
  }

  // A wheel that overlaps the rail by more than this is on another side of the flange.
  constexpr double deepest_overlap = 2.0;
  std::vector<double> gap(rows.size() * x.size(), excluded_gap);
  std::vector<std::optional<Point2>> points(n + 1);
  for (std::size_t ix = 0; ix < x.size(); ++ix) {
    const WheelSection section(pair, x[ix]);
    std::ranges::transform(profile, points.begin(), [&](Point2 p) { return section.from_section(p); });
    for (std::size_t is = 0; is < rows.size(); ++is) {
      const ContactRow& row = rows[is];
      double& best = gap[is * x.size() + ix];
      for (int k = 0; k < n; ++k) {
        if (!points[k] || !points[k + 1])
          continue;
        const double fa = along(*points[k], row), fb = along(*points[k + 1], row);
        if ((fa > 0) == (fb > 0))
          continue;
        const double ha = outward(*points[k], row), hb = outward(*points[k + 1], row);
        if (std::max(ha, hb) < -deepest_overlap || std::min(ha, hb) > best)
          continue;
        const auto p = section.at(intersect(section, row, s[k], s[k + 1], fa, fb));
        if (p && outward(*p, row) > -deepest_overlap)
          best = std::min(best, outward(*p, row));
      }
    }
  }
  return gap;
}

ContactEstimate estimate_contact(const WheelOnRail& pair, const Material& rail, const Material& wheel,
                                 double force, double approach, bool approach_given) {
  constexpr double ds = 0.1, x1 = 4.0;
  ContactEstimate out;
  std::vector<ContactRow> rows;
  for (double s = pair.rail.s_begin() + ds; s < pair.rail.s_end(); s += ds) {
    const CurvePoint p = pair.rail_at(s);
    rows.push_back({s, p.position, p.delta});
  }
  const std::array<double, 2> x{0.0, x1};
  const std::vector<double> gap = undeformed_distance(pair, rows, x);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double h0 = gap[2 * i], h1 = gap[2 * i + 1];
    const bool missed = h0 >= excluded_gap || h1 >= excluded_gap;
    out.slices.push_back({rows[i].s, rows[i].delta, missed ? excluded_gap : h0,
                          missed ? 1.0 : std::max((h1 - h0) / (x1 * x1), 1e-6)});
  }

  const double compliance =
      (1 - rail.poisson) / (2 * rail.shear_modulus) + (1 - wheel.poisson) / (2 * wheel.shear_modulus);
  const auto half_length_squared = [](const ContactEstimate::Slice& c, double q) {
    return (q * std::cos(c.delta) - c.gap) / c.half;
  };
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
        constexpr int points = 32;
        for (int j = 0; j < points; ++j) {
          const double angle = std::numbers::pi * ((j + 0.5) / points - 0.5);
          i2 += ds * xl2 * std::pow(std::cos(angle), 2) /
                std::sqrt(xl2 * std::pow(std::sin(angle), 2) + t * t) * std::numbers::pi / points;
        }
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
    double lo = 0, hi = 1e-4;
    while (force_at(hi, nullptr) < force && hi < 10)
      hi *= 2;
    for (int i = 0; i < 50; ++i) {
      const double mid = 0.5 * (lo + hi);
      (force_at(mid, nullptr) < force ? lo : hi) = mid;
    }
    out.approach = hi;
  }
  out.force = force_at(out.approach, &out.turn);
  return out;
}

GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin) {
  GridPlan plan{origin, 0, grid.ms, grid.mx, grid.dx, grid.ds};
  const double q = 0.9 * std::max(estimate.approach, 1e-4);
  double from = 0, to = 0, half_length = 0;
  const ContactEstimate::Slice* nearest = nullptr;
  for (const ContactEstimate::Slice& c : estimate.slices) {
    if (!nearest || c.gap < nearest->gap)
      nearest = &c;
    const double depth = q * std::cos(c.delta) - c.gap;
    if (depth <= 0)
      continue;
    from = half_length == 0 ? c.s : from;
    to = c.s;
    half_length = std::max(half_length, std::sqrt(depth / c.half));
  }
  if (half_length == 0)
    from = to = nearest ? nearest->s : 0;
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
    plan.columns = 2 * (static_cast<int>(std::ceil(half_length / grid.dx)) + 2);
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

std::vector<double> wheel_stations(const WheelOnRail& pair, std::span<const ContactRow> rows) {
  std::vector<double> s;
  for (const ContactRow& row : rows)
    s.push_back(pair.wheel.nearest(pair.wheel_pose.to_section(row.position)).s);
  return s;
}

} // namespace bem_contact
