#include "bem_contact/uses/curves/linearised.hpp"

#include "bem_contact/contact/shear_sensitivity.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"

#include <cmath>
#include <vector>

namespace bem_contact {

namespace {

/// The planes in which these rows lie.
std::vector<TangentPlane> planes_of(const std::vector<ContactRow>& rows) {
  std::vector<TangentPlane> out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].delta == rows[i - 1].delta)
      continue;
    if (i > 0)
      out.back().s_to = 0.5 * (rows[i - 1].s + rows[i].s);
    out.push_back({{rows[i].position, rows[i].s, rows[i].delta}});
  }
  return out;
}

/// The plan of the grid on which the result was found.
GridPlan plan_of(const SceneResult& r, bool planar) {
  const ContactGrid& grid = r.problem.grid;
  return {.origin = r.problem.rows.front().s,
          .rows = grid.ms,
          .columns = grid.mx,
          .dx = grid.dx,
          .ds = grid.ds,
          .x_centre = grid.x0 + 0.5 * (grid.mx - 1) * grid.dx,
          .planes = planar ? planes_of(r.problem.rows) : std::vector<TangentPlane>()};
}

/// Rigid slip on that grid with one creepage changed.
RigidSlip slip_at(SceneFile scene, CreepKind kind, double change, const GridPlan& plan,
                  SequenceFiles& files) {
  double* const keys[] = {&scene.motion.xi, &scene.motion.eta, &scene.motion.phi};
  *keys[static_cast<std::size_t>(kind)] += change;
  const ContactOnGrid on = prepare_case(scene, files).setup.on(plan);
  return {on.problem.slip_x, on.problem.slip_s};
}

SlipChange slip_change(const SceneFile& scene, CreepKind kind, double step, const GridPlan& plan,
                       SequenceFiles& files) {
  const RigidSlip up = slip_at(scene, kind, step, plan, files),
                  down = slip_at(scene, kind, -step, plan, files);
  SlipChange out{up.x, up.s};
  for (std::size_t i = 0; i < out.x.size(); ++i) {
    out.x[i] = (up.x[i] - down.x[i]) / (2 * step);
    out.s[i] = (up.s[i] - down.s[i]) / (2 * step);
  }
  return out;
}

/// Of tractions with the pressure held: Fx, Fs and Mz, as results have them.
CreepForceValues forces_of(const SceneResult& r, const ShearChange& change) {
  CreepForceValues out{};
  const ContactGrid& grid = r.problem.grid;
  for (int i = 0; i < grid.size(); ++i) {
    const ContactRow& row = r.problem.rows[i / grid.mx];
    const double px = change.px[i], ps = change.ps[i];
    out[0] += px;
    out[1] += ps * r.problem.lateral_share(i / grid.mx);
    out[2] += (grid.x(i % grid.mx) - r.motion.reference.x) * ps * std::cos(row.delta) -
              (row.position.y - r.motion.reference.position.y) * px;
  }
  for (double& force : out)
    force *= r.problem.element_area();
  return out;
}

} // namespace

std::optional<CreepMatrix> linearised_sensitivities(const SceneFile& scene, const SceneResult& result,
                                                    const Creepages& steps, SequenceFiles& files) {
  if (is_closed_form(result.choice.model) || result.structure || !result.problem.is_coulomb())
    return std::nullopt;
  const GridPlan plan = plan_of(result, scene.grid.planar);
  const ContactCase asked = prepare_case(scene, files);
  ContactOnGrid on = asked.setup.on(plan);
  on.problem.numbers = pair_numbers(result.choice.model, asked.setup, asked.files, on);
  add_layer(result.layer, on.problem.numbers);
  std::vector<SlipChange> changes;
  for (const CreepKind kind : {CreepKind::xi, CreepKind::eta, CreepKind::phi})
    changes.push_back(slip_change(scene, kind, steps[static_cast<std::size_t>(kind)], plan, files));
  const std::vector<ShearChange> found = shear_sensitivities(on.problem, result.result, changes);
  CreepMatrix out{};
  for (std::size_t k = 0; k < found.size(); ++k) {
    const CreepForceValues column = forces_of(result, found[k]);
    for (std::size_t f = 0; f < column.size(); ++f)
      out[f][k] = column[f];
  }
  return out;
}

} // namespace bem_contact
