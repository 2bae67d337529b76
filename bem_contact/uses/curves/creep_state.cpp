#include "bem_contact/uses/curves/creep_state.hpp"

#include "bem_contact/sequence/quantities.hpp"

namespace bem_contact {

MeasuredCreepForces forces_of(const SceneResult& result) {
  MeasuredCreepForces out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = quantity(EnumNames<CreepForce>::names[i]).measured(result);
  return out;
}

CreepForceValues coarse_forces_of(const SceneResult& result) {
  const std::optional<Discretisation>& estimate = result.result.trust.discretisation;
  if (!estimate || !estimate->converges)
    return {unknown_error, unknown_error, unknown_error};
  const ContactTotals& coarse = estimate->coarse;
  const ReferencePoint& at = result.motion.reference;
  return {coarse.Fx, coarse.Fs, coarse.Mz + at.position.y * coarse.Fx - at.x * coarse.Fy};
}

Creepages rigid_creepages(const SceneResult& r) {
  const ContactGrid& grid = r.problem.grid;
  // Weighted sums: 1, x, s, their squares, the slips, and slips times the other coordinate.
  double w = 0, x1 = 0, s1 = 0, squares = 0, wx = 0, ws = 0, turning = 0;
  for (int i = 0; i < grid.size(); ++i) {
    const double p = r.result.pn[i], x = grid.x(i % grid.mx) - r.motion.reference.x,
                 s = r.problem.rows[i / grid.mx].s - r.motion.reference.s;
    w += p, x1 += p * x, s1 += p * s, squares += p * (x * x + s * s);
    wx += p * r.problem.slip_x[i], ws += p * r.problem.slip_s[i];
    turning += p * (x * r.problem.slip_s[i] - s * r.problem.slip_x[i]);
  }
  if (!(w > 0))
    return {};
  const double phi = (turning - (x1 * ws - s1 * wx) / w) / (squares - (x1 * x1 + s1 * s1) / w);
  return {(wx + phi * s1) / w, (ws - phi * x1) / w, phi};
}

} // namespace bem_contact
