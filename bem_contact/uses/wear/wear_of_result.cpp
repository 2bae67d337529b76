#include "bem_contact/uses/wear/wear_of_result.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <cmath>
#include <numeric>

namespace bem_contact::wear {

namespace {

void require_steady_friction(const SceneResult& r) {
  require_certified(r);
  if (r.problem.motion != MotionKind::steady)
    throw InputError("There is no wear of this motion", "wear is taken from steady rolling",
                     "Give motion.kind = \"steady\".");
  if (!r.problem.tangential || r.problem.plane_strain())
    throw InputError("There is no wear without friction", "what does not slide does not wear",
                     "Give a friction above 0 and a motion.");
}

std::vector<double> row_sums(const ContactGrid& grid, const std::vector<double>& field, double factor) {
  std::vector<double> out(grid.ms);
  for (int is = 0; is < grid.ms; ++is)
    out[is] = factor * std::accumulate(field.begin() + is * grid.mx, field.begin() + (is + 1) * grid.mx, 0.0);
  return out;
}

RowsOnSections rows_on_sections(const SceneResult& r) {
  RowsOnSections out;
  const ContactGrid& grid = r.problem.grid;
  for (int is = 0; is < grid.ms; ++is) {
    double sum = 0, moment = 0;
    for (int ix = 0; ix < grid.mx; ++ix) {
      sum += r.result.pn[is * grid.mx + ix];
      moment += r.result.pn[is * grid.mx + ix] * grid.x(ix);
    }
    const SectionedRail::OnBody at =
        r.bodies.rail_sections->on_body(sum > 0 ? moment / sum : 0, r.problem.rows[is]);
    out.u.push_back(at.u);
    out.body.push_back(at.body);
    out.t.push_back(at.t);
  }
  return out;
}

} // namespace

double DepthOverS::area() const {
  return width * std::accumulate(depth.begin(), depth.end(), 0.0);
}

Wear wear_of(const SceneResult& r, const Law& law) {
  validate(law);
  require_steady_friction(r);
  const ContactGrid& grid = r.problem.grid;
  const std::vector<double> power = friction_work_density(r.result);
  Wear out;
  out.rate.resize(grid.size());
  out.sliding_distance.resize(grid.size());
  for (int i = 0; i < grid.size(); ++i) {
    if (!(r.result.pn[i] > 0))
      continue;
    const double sliding = std::hypot(r.result.slip_x[i], r.result.slip_s[i]);
    out.rate[i] =
        depth_rate(law, {.power = std::abs(power[i]), .pressure = r.result.pn[i], .sliding = sliding});
    out.sliding_distance[i] = sliding * grid.dx;
  }
  out.rail.depth = row_sums(grid, out.rate, grid.dx);
  out.rail.width = grid.ds;
  for (const ContactRow& row : r.problem.rows)
    out.rail.s.push_back(row.s);
  if (!r.bodies.wheel_s.empty())
    out.wheel = {r.bodies.wheel_s, out.rail.depth, grid.ds};
  out.volume_per_distance = r.problem.element_area() * std::accumulate(out.rate.begin(), out.rate.end(), 0.0);
  if (r.bodies.rail_sections)
    out.on_sections = rows_on_sections(r);
  out.sliding_over_s = row_sums(grid, out.sliding_distance, 1);
  return out;
}

} // namespace bem_contact::wear
