#include "bem_contact/wheelset/wheel_forces.hpp"

namespace bem_contact {

Wrench& Wrench::operator+=(const Wrench& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    force[i] += other.force[i];
    moment[i] += other.moment[i];
  }
  return *this;
}

Wrench operator+(Wrench a, const Wrench& b) {
  return a += b;
}

Wrench wrench_at(const Vector3& f, const Vector3& r) {
  return {f, {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]}};
}

Wrench mirrored(Wrench w) {
  w.force[1] *= -1;
  w.moment[0] *= -1;
  w.moment[2] *= -1;
  return w;
}

Wrench wrench_of(const SceneResult& result, Point2 centre) {
  const ContactProblem& problem = result.problem;
  const ContactResult& c = result.result;
  const std::vector<double> x = problem.grid.columns();
  const double area = problem.element_area();
  Wrench sum;
  for (std::size_t i = 0; i < c.pn.size(); ++i) {
    if (c.pn[i] == 0)
      continue;
    const ContactRow& row = problem.rows[i / x.size()];
    const Point2 across = c.ps[i] * tangent_of(row.delta) + c.pn[i] * normal_of(row.delta);
    const Point2 arm = row.position - centre;
    sum += wrench_at({area * c.px[i], area * across.y, area * across.z}, {x[i % x.size()], arm.y, arm.z});
  }
  return sum;
}

} // namespace bem_contact
