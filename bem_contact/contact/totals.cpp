#include "bem_contact/contact/totals.hpp"

#include "bem_contact/contact/grid/patches.hpp"

namespace bem_contact {

namespace {

void sum_forces(const ContactProblem& problem, ContactResult& result) {
  const double area = problem.element_area();
  const int mx = problem.grid.mx;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const Point2 tangent = tangent_of(row.delta), normal = normal_of(row.delta);
    const double share = problem.lateral_share(is);
    for (int ix = 0; ix < mx; ++ix) {
      const int i = is * mx + ix;
      const double fx = result.px[i] * area;
      const Point2 f = area * (result.ps[i] * tangent + result.pn[i] * normal);
      result.Fx += fx;
      result.Fy += f.y;
      result.Fz += f.z;
      result.Fs += result.ps[i] * area * share;
      result.Mz += problem.grid.x(ix) * f.y - row.position.y * fx;
    }
  }
}

} // namespace

void set_totals(const ContactProblem& problem, ContactResult& result) {
  result.Fx = result.Fy = result.Fz = result.Fs = result.Mz = 0;
  sum_forces(problem, result);
  result.patches = contact::find_patches(problem, result);
  result.touches_border = contact::touches_border(problem.grid, result.state);
}

} // namespace bem_contact
