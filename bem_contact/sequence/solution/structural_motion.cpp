#include "bem_contact/sequence/solution/structural_motion.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/solution/tangent_planes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// mm. The bodies stand still when a solution moves the contact by less: the lateral force on a gauge corner
/// then is good to about 10 N of 6e4.
constexpr double position_tolerance = 1e-4;
/// mm. A turn of a body counts as the motion that it makes at this distance from the reference point: half
/// the width of a contact.
constexpr double half_contact = 5.0;
/// 1. Most solutions until the bodies stand still: a bound.
constexpr int most_placements = 12;

/// Both parts, along and about the axes.
SixNumbers turned(const SixNumbers& v, double angle) {
  const Point2 along = bem_contact::turned(Point2{v[1], v[2]}, angle),
               about = bem_contact::turned(Point2{v[4], v[5]}, angle);
  return {v[0], along.y, along.z, v[3], about.y, about.z};
}

/// The same matrix in axes that are turned back by `angle`: it takes vectors turned by `angle`.
SixBySix turned(const SixBySix& matrix, double angle) {
  SixBySix out{};
  for (int j = 0; j < 6; ++j) {
    SixNumbers unit{};
    unit[j] = 1;
    const SixNumbers column = turned(product(matrix, turned(unit, -angle)), angle);
    for (int i = 0; i < 6; ++i)
      out[i][j] = column[i];
  }
  return out;
}

/// The bodies whose structural compliance counts, about the reference point of the position that the scene
/// gives. Nothing where there is none, or where the files do not hold it.
std::optional<StructuralResult> structures_of(const ContactCase& asked, Model model) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed || !has_files(model))
    return std::nullopt;
  const Point2 point = placed->reference.position;
  const auto one = [&](const Body& body, const std::shared_ptr<InfluenceFile>& file,
                       const Pose& pose) -> std::optional<BodyMotion> {
    if (!file || body.structural == StructuralCompliance::removed) // no file: it is of sections, and removed
      return std::nullopt;
    const std::optional<SixBySix> own = structural_compliance(file->strip(), pose.to_section(point));
    if (!own)
      return std::nullopt;
    BodyMotion out{.before = point, .after = point, .compliance = turned(*own, pose.angle), .stiffness = {}};
    out.stiffness = inverse(out.compliance);
    return out;
  };
  StructuralResult out{.rail = one(asked.setup.rail, asked.files.rail, placed->pair.rail_pose),
                       .wheel = one(asked.setup.wheel, asked.files.wheel, placed->pair.wheel_pose),
                       .shift_y = {}};
  return out.rail || out.wheel ? std::optional(out) : std::nullopt;
}

PlaneMotion plane_motion(const std::optional<BodyMotion>& body) {
  return body ? PlaneMotion{body->before, {body->motion[1], body->motion[2]}, body->motion[3]}
              : PlaneMotion{};
}

/// In the section's axes, about the same point.
PlaneMotion motion_in_numbers(const std::optional<BodyMotion>& body, const Pose& pose) {
  if (!body)
    return {};
  const SixNumbers& m = body->motion_in_numbers;
  return {pose.to_section(body->before), {m[1], m[2]}, m[3]};
}

/// `asked`: the case as the scene gives it.
StructuralPlacement placement_of(const ContactCase& asked, const StructuralResult& structure) {
  const WheelOnRail& pair = asked.setup.wheel_rail()->pair;
  return {.rail = plane_motion(structure.rail),
          .wheel = plane_motion(structure.wheel),
          .shift_y = structure.shift_y.value_or(0),
          .rail_in_numbers = motion_in_numbers(structure.rail, pair.rail_pose),
          .wheel_in_numbers = motion_in_numbers(structure.wheel, pair.wheel_pose)};
}

std::vector<ContactRow> rows_of(const TabulatedProfile& profile, const std::vector<double>& stations) {
  std::vector<ContactRow> rows;
  for (const double s : stations) {
    const CurvePoint p = profile.at(s);
    rows.push_back({s, p.position, p.delta});
  }
  return rows;
}

/// The motion under the force of a solution. `asked`: the case as the scene gives it.
void take_motion(const ContactCase& asked, const GridSolution& solved, StructuralResult& structure) {
  const WheelOnRail& pair = asked.setup.wheel_rail()->pair;
  const ContactProblem& problem = solved.contact.problem;
  const auto take = [&](std::optional<BodyMotion>& body, double side, const Pose& pose,
                        const std::vector<ContactRow>& own) {
    if (!body)
      return;
    body->force = force_and_moment(problem, solved.result, problem.rows, body->after, side, side);
    body->motion = product(body->compliance, body->force);
    // The wheel's own s and n are opposite to the rail's, as the traction on it is; x is not.
    const SixNumbers force =
        force_and_moment(problem, solved.result, own, pose.to_section(body->before), side);
    body->motion_in_numbers = product(turned(body->compliance, -pose.angle), force);
  };
  take(structure.rail, 1, pair.rail_pose, rows_of(pair.rail, solved.contact.rail_s));
  take(structure.wheel, -1, pair.wheel_pose, rows_of(pair.wheel, solved.contact.wheel_s));
}

/// How far along y the wheel has to be moved so that it, lowered until it touches, slides along the rail's
/// surface as the surfaces in contact do (mean weighted with pressure): what the structures do not do, mm.
double contact_shift_y(const ContactCase& asked, const GridSolution& solved,
                       const StructuralResult& structure) {
  const ContactProblem& problem = solved.contact.problem;
  const ContactResult& result = solved.result;
  const WheelRailGeometry& placed = *asked.setup.wheel_rail();
  StructuralPlacement by = placement_of(asked, structure);
  by.shift_y = 0;
  double moved = 0, pressure = 0;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const Point2 s = tangent_of(problem.rows[is].delta);
    const Point2 away = counted_twice(placed.pair, by, solved.contact.rail_s[is], solved.contact.wheel_s[is]);
    for (int ix = 0; ix < problem.grid.mx; ++ix) {
      const int i = is * problem.grid.mx + ix;
      const double p = result.pn[i];
      pressure += p;
      const double slide = result.displacements.us[i] + result.totals.approach * s.z + away.y;
      moved += p * (slide * s.y - away.z * s.z);
    }
  }
  return pressure > 0 ? moved / pressure : 0.0;
}

/// By how much the contact moves from one motion to another, mm: the bodies' points against each other, and
/// the surfaces at the distance of a contact's half width from them.
double change_between(const StructuralResult& a, const StructuralResult& b) {
  const auto relative = [](const StructuralResult& of) {
    const PlaneMotion rail = plane_motion(of.rail), wheel = plane_motion(of.wheel);
    return std::pair(rail.by - wheel.by, rail.angle - wheel.angle);
  };
  const auto [by_a, angle_a] = relative(a);
  const auto [by_b, angle_b] = relative(b);
  const Point2 moved = by_b - by_a;
  return std::hypot(moved.y, moved.z) + half_contact * std::abs(angle_b - angle_a) +
         std::abs(b.shift_y.value_or(0) - a.shift_y.value_or(0));
}

/// The case with its bodies where `by` takes them.
ContactCase placed_case(const ContactCase& asked, const StructuralPlacement& by) {
  ContactCase out = asked;
  out.setup = moved(asked.scene, asked.setup, by);
  out.estimate = std::make_shared<const ContactEstimate>(estimate_contact(out.setup, true));
  out.setup.load = asked.setup.load; // the approach is counted from where the scene puts the bodies
  return out;
}

/// Where the bodies' points are in a placed case.
void take_places(const WheelRailGeometry& placed, StructuralResult& structure) {
  if (structure.rail)
    structure.rail->after = placed.structure->rail.of(structure.rail->before);
  if (structure.wheel)
    structure.wheel->after =
        placed.structure->wheel.of(structure.wheel->before) + Point2{0, placed.structure->lowered};
  structure.lowered = placed.structure->lowered;
}

bool can_be_placed(const SceneFile& scene) {
  const bool steady = scene.motion.kind == MotionKind::steady || scene.motion.frictionless;
  return steady && scene.solver.structural_motion == StructuralMotion::placed;
}

/// Solves the placed case, from the solution that `out` has; `out` then has the new one.
void solve_where_placed(ContactCase placed, const SceneFile::Grid& grid, const SolveTask& task,
                        const SolveResources& resources, PlacedSolution& out) {
  const Stopwatch geometry;
  const bool on_strips = has_files(task.model);
  ContactOnGrid contact = placed.setup.on(first_plan(placed, grid, on_strips));
  PhaseSeconds spent = out.solved.seconds;
  spent.geometry += geometry.seconds();
  const std::optional<FormerSolution> former =
      former_of(out.solved.model, out.solved.contact.problem, out.solved.result, *out.asked.estimate);
  const bool start = former && alike(potential_areas(*placed.estimate), former->areas);
  WorkBudget work = resources.work.another();
  out.solved = solve_on_tangent_planes(placed, std::move(contact), task,
                                       resources.with(work, start ? &*former : nullptr), on_strips);
  out.solved.seconds += spent;
  out.asked = std::move(placed);
}

std::string body_datum(const Body& body, const std::shared_ptr<InfluenceFile>& file) {
  return file && body.structural == StructuralCompliance::included
             ? fmt::format("where it is held ({})", file->strip().held)
             : "the mean of its remote section";
}

} // namespace

PlacedSolution solve_on_placed_bodies(const ContactCase& asked, const SceneFile::Grid& grid,
                                      ContactOnGrid first, const SolveTask& task,
                                      const SolveResources& resources) {
  const bool on_strips = has_files(task.model);
  PlacedSolution out{asked,
                     solve_on_tangent_planes(asked, std::move(first), task, resources, on_strips),
                     structures_of(asked, task.model),
                     {}};
  const bool by_contact = is_placed_by_contact(asked.scene) && !is_closed_form(task.model);
  if (by_contact && !out.structure)
    out.structure.emplace();
  if (!out.structure)
    return out;
  StructuralResult& structure = *out.structure;
  const auto take = [&] {
    take_motion(asked, out.solved, structure);
    if (by_contact)
      structure.shift_y = contact_shift_y(out.asked, out.solved, structure);
  };
  take();
  if (!can_be_placed(asked.scene))
    return out;
  while (out.solved.result.certified()) {
    if (structure.solutions == most_placements)
      throw ConvergenceError(
          "The bodies do not come to rest under their structures' motion",
          fmt::format("after {} solutions the contact still moves by {:.2g} mm", structure.solutions,
                      structure.change),
          "Set solver.structural_motion = \"linear\", or structural = \"removed\" for one of the bodies.");
    solve_where_placed(placed_case(asked, placement_of(asked, structure)), grid, task, resources, out);
    const StructuralResult former = structure;
    take_places(*out.asked.setup.wheel_rail(), structure);
    take();
    structure.placed = true;
    structure.change = change_between(former, structure);
    ++structure.solutions;
    if (structure.change < position_tolerance)
      break;
  }
  return out;
}

bool is_placed_by_contact(const SceneFile& scene) {
  return scene.kind == SceneKind::wheel_rail && can_be_placed(scene) &&
         scene.solver.contact_motion == ContactMotion::placed;
}

double local_approach(const ContactCase& asked, const GridSolution& solved) {
  const double q = solved.result.totals.approach;
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail(); placed && placed->structure)
    return q - placed->structure->lowered;
  std::optional<StructuralResult> structure = structures_of(asked, solved.model);
  if (!structure)
    return q;
  take_motion(asked, solved, *structure);
  const Point2 away = plane_motion(structure->rail).by - plane_motion(structure->wheel).by;
  const double delta = asked.setup.reference().delta;
  return q - dot(away, normal_of(delta)) / std::cos(delta);
}

double unseen_slide(const ContactCase& asked, const GridSolution& solved) {
  const ContactProblem& problem = solved.contact.problem;
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  double largest = 0;
  for (int is = 0; is < problem.grid.ms; ++is)
    for (int ix = 0; ix < problem.grid.mx; ++ix) {
      const int i = is * problem.grid.mx + ix;
      if (solved.result.displacements.us.empty() || solved.result.state[i] == ElementState::exterior)
        continue;
      const double known = placed && placed->structure
                               ? -counted_twice(placed->pair, *placed->structure, solved.contact.rail_s[is],
                                                solved.contact.wheel_s[is])
                                      .y
                               : 0.0;
      largest = std::max(largest, std::abs(solved.result.displacements.us[i] - known));
    }
  return largest;
}

std::string approach_datum(const ContactCase& asked, Model model) {
  if (has_files(model)) {
    const std::string rail = body_datum(asked.setup.rail, asked.files.rail),
                      wheel = body_datum(asked.setup.wheel, asked.files.wheel);
    return rail == wheel ? fmt::format("both bodies: {}", rail)
                         : fmt::format("rail: {}; wheel: {}", rail, wheel);
  }
  return "points of the two half-spaces far from the contact";
}

} // namespace bem_contact
