#include "bem_contact/contact/result.hpp"

#include "bem_contact/contact/dissipation.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

struct Violation {
  const char* name;
  double value; ///< infinite if it is not a number
};

Violation worst_of(const Certificate& c) {
  Violation worst{"", 0};
  for (const Violation& v :
       {Violation{"pressure", c.pressure}, Violation{"penetration", c.penetration},
        Violation{"complementarity", c.complementarity}, Violation{"friction_cone", c.friction_cone},
        Violation{"adhesion", c.adhesion}, Violation{"slip_direction", c.slip_direction},
        Violation{"force_balance", c.force_balance}}) {
    if (std::isnan(v.value))
      return {v.name, std::numeric_limits<double>::infinity()};
    if (v.value > worst.value)
      worst = v;
  }
  return worst;
}

} // namespace

Certificate Certificate::without_violation() {
  Certificate out;
  out.pressure = out.penetration = out.complementarity = 0;
  out.friction_cone = out.adhesion = out.slip_direction = out.force_balance = 0;
  return out;
}

double Certificate::worst() const {
  return worst_of(*this).value;
}

const char* Certificate::worst_name() const {
  return worst_of(*this).name;
}

double Discretisation::moment_error(const ContactTotals& totals, double x, double y) const {
  const double change = (totals.Mz - coarse.Mz) + y * (totals.Fx - coarse.Fx) - x * (totals.Fy - coarse.Fy);
  return moment_change * std::abs(change) + local_moment;
}

Tractions tractions_of(const ContactResult& result) {
  return {result.px, result.ps, result.pn, result.plastic};
}

std::vector<double> friction_work_density(const ContactResult& result) {
  return result.dissipated.empty() ? contact::dissipated_in_slip(result) : result.dissipated;
}

std::array<double, 6> force_and_moment(const ContactProblem& problem, const ContactResult& result,
                                       const std::vector<ContactRow>& rows, Point2 about, double side_x,
                                       double side) {
  std::array<double, 6> sum{};
  const double area = problem.element_area();
  for (int i = 0; i < problem.grid.size(); ++i) {
    const ContactRow& row = rows[i / problem.grid.mx];
    const Point2 arm = row.position - about;
    const Point2 f =
        side * area * (result.ps[i] * tangent_of(row.delta) + result.pn[i] * normal_of(row.delta));
    const double x = problem.grid.x(i % problem.grid.mx), fx = side_x * area * result.px[i];
    const double parts[6] = {
        fx, f.y, f.z, arm.y * f.z - arm.z * f.y, arm.z * fx - x * f.z, x * f.y - arm.y * fx};
    for (int k = 0; k < 6; ++k)
      sum[k] += parts[k];
  }
  return sum;
}

double shear_bound(const ContactProblem& problem, const ContactResult& result, int i) {
  const double friction = problem.friction_of(i / problem.grid.mx) * result.pn[i];
  if (!problem.yield || (problem.hardens() && result.plastic.empty()))
    return friction;
  const double plastic = problem.hardens() ? result.plastic[i] : 0;
  const double limit =
      result.temperatures ? problem.yield->at(result.temperatures->mean(i)) : problem.yield->shear;
  return std::min(friction, std::max(0.0, limit + problem.yield->hardening * plastic));
}

double friction_bound(const ContactProblem& problem, const ContactResult& result) {
  double sum = 0;
  for (int i = 0; i < problem.grid.size() && problem.has_friction(); ++i)
    sum += shear_bound(problem, result, i);
  return sum * problem.element_area();
}

ElementCounts count_elements(const ContactResult& result) {
  ElementCounts counts;
  for (const PatchSummary& p : result.patches) {
    counts.contact += p.contact;
    counts.adhesion += p.adhesion;
    counts.slip += p.slip;
  }
  return counts;
}

} // namespace bem_contact
