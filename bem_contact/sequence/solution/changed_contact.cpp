#include "bem_contact/sequence/solution/changed_contact.hpp"

namespace bem_contact {

namespace {

/// The bodies of a scene that differs from that of `asked` in one number.
ContactSetup changed_setup(const ContactCase& asked, const SceneFile& scene, InputReach reach) {
  if (reach != InputReach::bodies)
    return with_motion_of(scene, asked.setup);
  if (asked.setup.patch())
    return set_up_patch(scene);
  const WheelRailGeometry& placed = *asked.setup.wheel_rail();
  return set_up_contact(scene, {placed.pair.rail, placed.pair.wheel, placed.rail_inclination});
}

ContactOnGrid contact_of(const ContactSetup& setup, const ContactOnGrid& before, InputReach reach) {
  if (reach == InputReach::bodies)
    return setup.on(before.plan);
  ContactOnGrid out = before;
  out.problem.friction_rows.clear();
  apply_motion(setup.motion, setup.reference().delta, out.problem);
  if (out.problem.tangential) {
    out.problem.yield = setup.layer.yield;
    setup.prescribe({}, out.problem);
  }
  if (reach == InputReach::layer)
    out.layer = setup.layer.on(out.problem.rows);
  return out;
}

} // namespace

ChangedContact changed_contact(const ContactCase& asked, const ContactOnGrid& contact, int which) {
  SceneFile scene = asked.scene;
  const SceneNumber number = derivative_inputs(scene)[std::size_t(which)];
  const double at = *number.value, below = at - number.step, above = at + number.step;
  const auto set_up = [&](double value) {
    *number.value = value;
    ContactCase out = asked;
    out.scene = scene;
    out.setup = changed_setup(asked, scene, number.reach);
    return out;
  };
  ChangedContact out{set_up(below), set_up(above), {}, {}, 0.5 * (above - below)};
  out.lower = contact_of(out.lower_case.setup, contact, number.reach);
  out.upper = contact_of(out.upper_case.setup, contact, number.reach);
  return out;
}

} // namespace bem_contact
