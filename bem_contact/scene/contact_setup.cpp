#include "bem_contact/scene/contact_setup.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/elastic_limit.hpp"
#include "bem_contact/scene/steels.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// mm. The approach of a plane-strain contact is relative to a point this far away; on a curved strip to one
/// at the distance of its radius.
constexpr double plane_strain_distance = 100.0;

Body body_of(const SceneFile::Side& side, const std::filesystem::path& folder) {
  return {side.material, side.influence.empty() ? std::filesystem::path() : folder / side.influence,
          side.structural,
          side.steel.empty() || side.limit_pressure ? side.limit_pressure
                                                    : steel_named(side.steel).indentation_pressure()};
}

ContactLoad load_of(const SceneFile& scene, double approach) {
  if (scene.load.force)
    return {LoadKind::force, *scene.load.force, 0.0};
  return {LoadKind::approach, 0.0, approach};
}

/// V / omega where xi = 0, mm: what the scene gives, or what rolls freely at the centre of the contact.
double rolling_radius_of(const SceneFile::Motion& motion, double free) {
  return motion.rolling_radius ? *motion.rolling_radius
         : motion.pitch_rate   ? motion.speed.value_or(0) / *motion.pitch_rate
                               : free;
}

template <class Geometry> auto share(Geometry geometry) {
  return std::make_shared<const std::variant<WheelRailGeometry, PatchGeometry>>(std::move(geometry));
}

/// The wheel of a pair, lowered until it touches. The members are made in this order: the last one lowers
/// pair and locus.
struct LoweredWheel {
  WheelOnRail pair;
  double from = pair.wheel_pose.origin.z;
  ContactLocus locus{pair};
  std::vector<TouchPoint> touch = lower_to_touch(pair, locus);

  double drop() const { return pair.wheel_pose.origin.z - from; }
};

/// The scene's motion of bodies that stand there. `free_radius`: V / omega of what rolls freely.
Motion motion_over(const SceneFile& scene, const WheelOnRail& pair, const ReferencePoint& reference,
                   double free_radius) {
  Motion motion = read_motion(scene);
  motion.creepage.rolling_radius = rolling_radius_of(scene.motion, free_radius);
  motion.speed *= mean_surface_speed(pair, reference, motion.creepage);
  return motion;
}

/// What is known of the bodies before they touch: WheelRailGeometry's members of these names.
struct PlacementBeforeContact {
  double lowered = 0;
  RailInclination rail_inclination;
  std::optional<StructuralPlacement> structure = {};
};

/// All that follows from where the bodies stand as they touch.
ContactSetup set_up_touching(const SceneFile& scene, LoweredWheel bodies, const ContactLoad& load,
                             const PlacementBeforeContact& origin) {
  const WheelOnRail& pair = bodies.pair;
  std::vector<RailSlice> slices = slice_rail(pair, bodies.locus);
  const std::optional<ContactCentre> centre =
      contact_centre(slices, pair, bodies.locus.frame(),
                     contact_compliance(scene.rail.material, scene.wheel.material), load);
  const TouchPoint& deepest = bodies.touch.front();
  ReferencePoint reference{deepest.position, deepest.rail_s, deepest.delta, deepest.x, deepest.ahead};
  double free_radius = pair.wheel_radius + pair.wheel.at(deepest.wheel_s).position.z;
  if (centre) {
    const CurvePoint p = pair.rail_at(centre->s);
    reference = {p.position, p.s, p.delta, centre->x, centre->ahead};
    free_radius = centre->rolling_radius;
  }
  Motion motion = motion_over(scene, pair, reference, free_radius);
  // A smooth function of the position: not that of the deepest point.
  const double contact_radius = centre ? centre->rolling_radius : pair.wheel_radius;
  return {body_of(scene.rail, scene.folder),
          body_of(scene.wheel, scene.folder),
          load,
          std::move(motion),
          share(WheelRailGeometry{.pair = std::move(bodies.pair),
                                  .locus = std::move(bodies.locus),
                                  .touch = std::move(bodies.touch),
                                  .slices = std::move(slices),
                                  .lowered = origin.lowered,
                                  .planar = scene.grid.planar,
                                  .reference = reference,
                                  .contact_radius = contact_radius,
                                  .rail_inclination = origin.rail_inclination,
                                  .structure = origin.structure}),
          read_layer(scene)};
}

/// Throws InputError where a number of it is none.
RigidSlip require_finite(RigidSlip slip) {
  const auto is_finite = [](double w) { return std::isfinite(w); };
  if (!std::ranges::all_of(slip.x, is_finite) || !std::ranges::all_of(slip.s, is_finite))
    throw InputError("The motion makes no rigid slip",
                     "its creepages, or its rates over motion.speed, are beyond all numbers",
                     "Check motion.speed, the rates and the creepages; a creepage of 0.001 is usual.");
  return slip;
}

/// Rows as seen from the wheel before its structure moved it.
std::vector<ContactRow> rows_before(const StructuralPlacement& structure, std::vector<ContactRow> rows) {
  for (ContactRow& row : rows)
    row.position = structure.wheel.before(row.position - structure.wheel_by());
  return rows;
}

} // namespace

double ContactSetup::reference_distance() const {
  return patch() && patch()->radius != 0 ? std::abs(patch()->radius) : plane_strain_distance;
}

std::optional<double> ContactSetup::limit_pressure() const {
  if (!rail.limit_pressure || !wheel.limit_pressure)
    return rail.limit_pressure ? rail.limit_pressure : wheel.limit_pressure;
  return std::min(*rail.limit_pressure, *wheel.limit_pressure);
}

RowsOnBodies ContactSetup::rows_on(const GridPlan& plan) const {
  if (const PatchGeometry* own = patch())
    return {own->rows, own->rail_s, own->wheel_s};
  const WheelRailGeometry& placed = *wheel_rail();
  std::vector<ContactRow> rows = placed.rows(plan);
  std::vector<double> rail_s = placed.rail_stations(rows), wheel_s = placed.wheel_stations(rows);
  return {std::move(rows), std::move(rail_s), std::move(wheel_s)};
}

ContactOnGrid ContactSetup::on(const GridPlan& plan) const {
  RowsOnBodies rows = rows_on(plan);
  ContactOnGrid out;
  out.plan = plan;
  ContactProblem& problem = out.problem;
  problem.rows = std::move(rows.rows);
  out.layer = layer.on(problem.rows);
  out.rail_s = std::move(rows.rail_s);
  out.wheel_s = std::move(rows.wheel_s);
  problem.load = load.kind;
  problem.force = load.force;
  problem.approach = load.approach;
  problem.limit_pressure = limit_pressure();
  if (const PatchGeometry* own = patch()) {
    problem.grid = own->grid;
    problem.gap = own->gap;
    problem.numbers.dx = own->plane_strain ? 0 : problem.grid.dx; // what ContactProblem::plane_strain() reads
  } else {
    problem.grid = plan.grid();
    problem.gap = wheel_rail()->gap(plan, problem.rows);
    problem.numbers.dx = problem.grid.dx;
    out.contact_radius = wheel_rail()->contact_radius;
    out.roller_contact_radius = wheel_rail()->roller_contact_radius();
  }
  apply_motion(motion, reference().delta, problem);
  if (wheel_rail() && wheel_rail()->pair.sections)
    problem.rise = wheel_rail()->pair.sections->frame().rise();
  if (!problem.tangential)
    return out;
  problem.yield = layer.yield;
  if (const PatchGeometry* own = patch())
    problem.previous = own->start;
  prescribe({}, problem);
  return out;
}

void ContactSetup::prescribe(const MotionStep& step, ContactProblem& problem) const {
  const double upright = wheel_rail() ? wheel_rail()->pair.upright() : 1;
  if (step.load && problem.load == LoadKind::force)
    problem.force = *step.load / upright;
  else if (step.load)
    problem.approach = *step.load * upright;
  if (motion.force_x)
    problem.force_x = step.force_x.value_or(*motion.force_x);
  if (motion.force_s)
    problem.force_s = step.force_s.value_or(*motion.force_s);
  if (step.x && patch())
    problem.gap = patch()->gap_at(*step.x);
  RigidSlip slip = rigid_slip(step, problem.rows, problem.grid.columns());
  if (step.slip != 1)
    for (std::vector<double>* w : {&slip.x, &slip.s})
      std::ranges::for_each(*w, [&](double& value) { value *= step.slip; });
  problem.slip_x = std::move(slip.x);
  problem.slip_s = std::move(slip.s);
}

RigidSlip ContactSetup::rigid_slip(const MotionStep& step, const std::vector<ContactRow>& rows,
                                   const std::vector<double>& x) const {
  const Creepage creepage = motion.creepage_of(step);
  if (const PatchGeometry* own = patch())
    return own->slip ? *own->slip : require_finite(planar_slip(creepage, rows, x, step.x.value_or(0.0)));
  if (motion.kind == MotionKind::shift)
    return require_finite(rigid_shift(reference(), creepage, rows, x));
  const WheelRailGeometry& placed = *wheel_rail();
  if (!placed.structure)
    return require_finite(bem_contact::rigid_slip(placed.pair, reference(), creepage, rows, x));
  // The wheel's material turns about its axle, which did not move with the rim.
  ReferencePoint before = reference();
  before.position = placed.structure->wheel.before(before.position - placed.structure->wheel_by());
  return require_finite(bem_contact::rigid_slip(with_wheel_before(placed.pair, *placed.structure), before,
                                                creepage, rows_before(*placed.structure, rows), x));
}

ContactSetup set_up_contact(const SceneFile& scene, const WheelRailProfiles& profiles) {
  if (scene.load.approach)
    require_small_approach(*scene.load.approach);
  LoweredWheel bodies{placed_bodies(scene, profiles, scene.position)};
  const double lowered = bodies.drop(), upright = bodies.pair.upright();
  ContactLoad load = load_of(scene, scene.position.vertical ? *scene.position.vertical - lowered
                                                            : scene.load.approach.value_or(0));
  load.force /= upright; // as the rail is looked at
  load.approach *= upright;
  ContactSetup out = set_up_touching(scene, std::move(bodies), load,
                                     {.lowered = lowered, .rail_inclination = profiles.rail_inclination});
  out.rail.sections = profiles.rail_bodies.influence;
  return out;
}

namespace {

/// Whether a structure moves its body.
bool gives_way(const StructuralPlacement& by) {
  const auto moves = [](const PlaneMotion& body) { return norm(body.by) > 0 || body.angle != 0; };
  return moves(by.rail) || moves(by.wheel);
}

} // namespace

ContactSetup moved(const SceneFile& scene, const ContactSetup& setup, StructuralPlacement by) {
  const WheelRailGeometry& before = *setup.wheel_rail();
  LoweredWheel bodies{moved(before.pair, by)};
  by.lowered = bodies.drop();
  ContactLoad load = setup.load;
  load.approach -= load.kind == LoadKind::approach ? by.lowered : 0.0;
  ContactSetup out = set_up_touching(
      scene, std::move(bodies), load,
      {.lowered = before.lowered, .rail_inclination = before.rail_inclination, .structure = by});
  out.rail = setup.rail;
  // What is prescribed need not be the scene's: free rolling is solved with force_x = 0.
  const double rolling_radius = out.motion.creepage.rolling_radius;
  out.motion = setup.motion;
  if (gives_way(by)) // a contact's own slide is no other place of the bodies: creepages count as without it
    out.motion.creepage.rolling_radius = rolling_radius;
  return out;
}

ContactSetup with_motion_of(const SceneFile& scene, const ContactSetup& setup) {
  ContactSetup out = setup;
  out.layer = read_layer(scene);
  const WheelRailGeometry* placed = setup.wheel_rail();
  out.motion = placed ? motion_over(scene, placed->pair, placed->reference, placed->contact_radius)
                      : read_motion(scene);
  return out;
}

ContactSetup set_up_patch(const SceneFile& scene) {
  ContactSetup out{body_of(scene.rail, scene.folder),
                   body_of(scene.wheel, scene.folder),
                   load_of(scene, scene.load.approach.value_or(0)),
                   read_motion(scene),
                   share(read_patch(scene)),
                   read_layer(scene)};
  require_bearable(out);
  return out;
}

} // namespace bem_contact
