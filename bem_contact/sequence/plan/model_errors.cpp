#include "bem_contact/sequence/plan/model_errors.hpp"

#include "bem_contact/scene/contact_centre.hpp"
#include "bem_contact/sequence/plan/settings.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// 1. Tangent planes in plane strain, likewise, on what is no circle of equal bodies: against the influence
/// functions of a 60E1 rail and an S1002 wheel 0.04 to 0.22.
constexpr double tangent_plane_error = 0.24;
/// 1/rad. Either, more of it between unlike materials: steel on aluminium is off by 0.008.
constexpr double unlike_turn_error = 0.01;
/// mm. Least distance by which the wheel is moved aside to see how steep results are in its position. Chosen.
constexpr double least_shift_y = 1e-3;
/// mm. Of a wheel on a rail the creepage of free rolling differs by approach / this, times 1 +
/// creep_inclination times the inclination: by 1e-5 to 6e-5 on the tread, 1e-4 and more at the flange.
constexpr double wheel_creep_radius = 1100.0;
/// 1/rad.
constexpr double creep_inclination = 7.0;
/// mm. The same of rollers in grooves, small bodies whose surfaces stretch differently: 4e-5 to 2e-4.
constexpr double roller_creep_radius = 190.0;
/// 1. Kalker's C11 of a circle, nu = 0.28.
constexpr double creep_coefficient = 4.2;
/// 1. Least slope of the shear force over that without slip: spin and yaw leave some of it. Chosen.
constexpr double least_slope_share = 0.05;
/// 1. If only the longitudinal force is given, the lateral creepage is prescribed: its error counts by this
/// share.
constexpr double side_creep_share = 0.45;
/// 1. Of shear forces, of either model.
constexpr double least_shear_error = 0.001;
/// 1/rad. Of them: this times the turn.
constexpr double shear_turn_error = 0.02;
/// 1. Of friction's power, of either model.
constexpr double least_power_error = 0.004;
/// 1/rad. Of it: this times the turn.
constexpr double power_turn_error = 0.01;
/// 1. Of it where creepages are given: this times the error of creepage over the slip.
constexpr double given_creep_power = 1.5;
/// 1. Power of friction on a rail: both of these terms count by this share, because spin does most of the
/// work there. At most 0.15 was seen.
constexpr double rail_power_share = 0.2;
/// 1. Of it where creepages are found: this times their error over least_creepage.
constexpr double found_creep_power = 0.5;

/// The rows lie on one circle, all of them.
bool on_a_circle(const ContactProblem& problem) {
  const std::vector<ContactRow>& rows = problem.rows;
  const double turn = rows.size() > 1 ? rows[1].delta - rows[0].delta : 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (std::abs(rows[i].delta - rows[i - 1].delta - turn) > equal_turn)
      return false;
  return true;
}

double edge_distance(const ContactCase& asked, const EstimatedContact& contact) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed || placed->touch.empty())
    return 0;
  const double wheel_s = placed->touch.front().wheel_s;
  return std::min({contact.s - placed->pair.rail.s_begin(), placed->pair.rail.s_end() - contact.s,
                   wheel_s - placed->pair.wheel.s_begin(), placed->pair.wheel.s_end() - wheel_s});
}

/// Slip in the middle of the contact, and how steeply the shear force grows with it: Kalker's linear theory
/// for a circle, and Johnson and Vermeulen's saturation.
void set_creep(const ContactCase& asked, const EstimatedContact& contact, ContactTraits& traits) {
  const Motion& motion = asked.setup.motion;
  const double limit = motion.coefficients.friction * traits.normal;
  if (!motion.tangential || motion.kind == MotionKind::shift || limit <= 0)
    return;
  const RigidSlip slip =
      asked.setup.rigid_slip({}, {{contact.s, contact.position, contact.delta}}, {contact.x});
  traits.slip = std::hypot(slip.x[0], slip.s[0]);
  const double shear = traits.modulus * (1 - asked.setup.rail.material.poisson);
  const double linear = creep_coefficient * shear * 0.25 * contact.length * contact.width / limit;
  const double share = std::min(1.0, linear * traits.slip / 3);
  traits.creep_stiffness = linear * std::max(least_slope_share, (1 - share) * (1 - share));
}

/// How far the wheel stands aside for the same lateral force, mm: bodies stretch along the normal, and what
/// of it points along z is approach.
double position_error(const ContactTraits& traits) {
  const double stretch = traits.normal / (traits.modulus * stretch_depth);
  return traits.prescribed.place ? stretch * std::sin(traits.inclination) : 0;
}

/// Of the creepage of free rolling.
double creepage_error(const ContactTraits& traits) {
  return traits.on_rail ? traits.approach / wheel_creep_radius * (1 + creep_inclination * traits.inclination)
                        : traits.approach / roller_creep_radius;
}

/// `line_error`, `turn_error`: of the model, in plane strain and else.
double pressure_error(const ContactTraits& traits, double line_error, double turn_error) {
  if (traits.line)
    return line_error * 0.25 * traits.turn * traits.turn;
  return least_pressure_error + turn_error * traits.turn +
         (traits.unlike ? unlike_turn_error * traits.turn : 0);
}

/// What a creepage that is off does to shear forces, and to their power over itself.
void add_creepage(const ContactTraits& traits, double xi, ModelErrors& out) {
  const bool friction = traits.creep_stiffness > 0;
  const double share = traits.on_rail ? rail_power_share : 1;
  if (traits.prescribed.force) {
    out.creepages = xi / least_creepage;
    out.forces += side_creep_share * traits.creep_stiffness * xi;
    out.friction_power += share * found_creep_power * xi / least_creepage;
  } else if (traits.prescribed.creepage && friction) {
    out.forces += traits.creep_stiffness * xi;
    out.friction_power += share * given_creep_power * xi / (traits.slip + xi);
  }
}

/// `pressure`: the model's own error.
ModelErrors errors_with(double pressure, const ContactTraits& traits) {
  if (traits.prescribed.structures)
    return {1, 1, 1, 1};
  const double shift_y = position_error(traits);
  const double near = traits.edge > 0 ? traits.size / traits.edge : 0;
  ModelErrors out;
  out.pmax = pressure + traits.pressure_steepness * shift_y + edge_error * near * near;
  out.forces = traits.force_steepness * shift_y;
  if (traits.creep_stiffness > 0) {
    out.friction_power = least_power_error + power_turn_error * traits.turn + out.forces;
    out.forces += least_shear_error + shear_turn_error * traits.turn;
  }
  if (traits.bodies)
    add_creepage(traits, creepage_error(traits), out);
  return out;
}

} // namespace

double ModelErrors::of(ErrorQuantity what) const {
  switch (what) {
  case ErrorQuantity::forces:
    return forces;
  case ErrorQuantity::pmax:
    return pmax;
  case ErrorQuantity::creepages:
    return creepages;
  case ErrorQuantity::friction_power:
    return friction_power;
  default:
    return 0;
  }
}

ErrorQuantity ModelErrors::worst(std::span<const ErrorQuantity> named) const {
  return *std::ranges::max_element(named, {}, [&](ErrorQuantity what) { return of(what); });
}

PrescribedMotion prescribed_of(const ContactCase& asked) {
  const SceneFile& scene = asked.scene;
  const Motion& motion = asked.setup.motion;
  PrescribedMotion out;
  out.place = scene.kind == SceneKind::wheel_rail && !asked.lateral_force;
  out.force = motion.tangential && (scene.load.force_x || scene.load.force_s);
  out.creepage = motion.tangential && motion.kind != MotionKind::shift && !scene.load.force_x &&
                 !scene.motion.from_free_rolling;
  for (const Body* body : {&asked.setup.rail, &asked.setup.wheel})
    out.structures |= body->structural == StructuralCompliance::included && !body->influence.empty();
  return out;
}

bool has_influence_files_of_both(const ContactCase& asked) {
  return asked.setup.rail.has_influence() && asked.setup.wheel.has_influence();
}

ContactTraits traits_of(const ContactCase& asked, const ContactEstimate& estimate) {
  const PairCompliance compliance = pair_compliance(asked.setup);
  const EstimatedContact contact = estimated_contact(estimate, compliance);
  ContactTraits out;
  out.prescribed = prescribed_of(asked);
  out.bodies = has_influence_files_of_both(asked);
  out.on_rail = asked.setup.wheel_rail() != nullptr;
  out.unlike = !(asked.setup.rail.material == asked.setup.wheel.material);
  out.turn = contact.turn;
  out.normal = contact.normal;
  out.modulus = 1 / compliance.elastic;
  out.approach = estimate.approach;
  out.inclination = std::abs(contact.delta);
  out.size = std::sqrt(contact.length * contact.width);
  out.edge = edge_distance(asked, contact);
  if (contact.normal <= 0)
    return out;
  if (out.prescribed.place) {
    const double shift_y = std::max(position_error(out), least_shift_y);
    for (const double step : {-shift_y, shift_y}) {
      const EstimatedContact moved = estimated_contact(estimate, compliance, step);
      out.force_steepness = std::max(out.force_steepness,
                                     std::abs(moved.lateral - contact.lateral) / (contact.normal * shift_y));
      out.pressure_steepness =
          std::max(out.pressure_steepness, std::abs(moved.pressure / contact.pressure - 1) / shift_y);
    }
  }
  set_creep(asked, contact, out);
  return out;
}

ContactTraits traits_of(const ContactCase& asked, ContactTraits estimated, const ContactProblem& problem,
                        const ContactResult& result) {
  ContactTraits out = estimated;
  out.prescribed = prescribed_of(asked);
  out.modulus = 1 / contact_compliance(asked.setup.rail.material, asked.setup.wheel.material);
  out.turn = turn_of_contact(problem, result);
  out.normal = 0;
  for (const PatchSummary& patch : result.patches)
    out.normal += patch.fn;
  out.line = problem.plane_strain();
  out.one_circle =
      out.line && asked.setup.rail.material == asked.setup.wheel.material && on_a_circle(problem);
  return out;
}

ModelErrors halfspace_errors(const ContactTraits& traits) {
  return errors_with(pressure_error(traits, halfspace_error, halfspace_turn_error), traits);
}

ModelErrors tangent_plane_errors(const ContactTraits& traits) {
  const double pressure =
      traits.one_circle ? 0 : pressure_error(traits, tangent_plane_error, tangent_plane_turn_error);
  return errors_with(pressure, traits);
}

double turn_of_contact(const ContactProblem& problem, const ContactResult& result) {
  const ContactGrid& grid = problem.grid;
  double largest = 0, lo = 0, hi = 0;
  bool inside = false;
  for (int is = 0; is < grid.ms; ++is) {
    bool contact = false;
    for (int ix = 0; ix < grid.mx && !result.state.empty(); ++ix)
      contact |= result.state[is * grid.mx + ix] != ElementState::exterior;
    const double delta = problem.rows[is].delta;
    lo = contact && inside ? std::min(lo, delta) : delta;
    hi = contact && inside ? std::max(hi, delta) : delta;
    inside = contact;
    if (contact)
      largest = std::max(largest, hi - lo);
  }
  return largest;
}

} // namespace bem_contact
