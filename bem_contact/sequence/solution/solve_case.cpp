#include "bem_contact/sequence/solution/solve_case.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/scene/contact_centre.hpp"
#include "bem_contact/scene/elastic_limit.hpp"
#include "bem_contact/scene/network.hpp"
#include "bem_contact/scene/outlines.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/patch_places.hpp"
#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/solution/case_stresses.hpp"
#include "bem_contact/sequence/solution/derivatives_of.hpp"
#include "bem_contact/sequence/solution/grow_grid.hpp"
#include "bem_contact/sequence/solution/layer_slope.hpp"
#include "bem_contact/sequence/solution/structural_motion.hpp"
#include "bem_contact/sequence/solution/track_frame.hpp"
#include "bem_contact/sequence/solution/trim_plan.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Discretisation error above which the elements are said to be too large.
constexpr double poor_discretisation = 0.2;

/// Of all steps, as far as they are solutions, MPa.
double highest_pressure(const GridSolution& solved) {
  double highest = 0;
  const auto look = [&](const ContactResult& result) {
    if (result.certified())
      highest = std::max(highest, result.totals.pmax.value);
  };
  look(solved.result);
  std::ranges::for_each(solved.history, look);
  return highest;
}

void warn_of_discretisation(const ContactResult& result, Warnings& warnings) {
  const double error = result.trust.certificate.discretisation;
  if (error > poor_discretisation)
    warnings.add(
        WarningKind::large_elements,
        fmt::format(
            "the elements are too large for this contact: the estimated discretisation error is {:.0f} %",
            100 * error));
}

/// Undeformed distance and normals are those of surfaces that stay opposite each other.
void warn_of_slide(const ContactCase& asked, GridSolution& solved) {
  const double slide = unseen_slide(asked, solved), half_row = 0.5 * solved.contact.problem.grid.ds;
  const auto included = [](const Body& body) { return body.structural == StructuralCompliance::included; };
  if (has_files(solved.model) && (included(asked.setup.rail) || included(asked.setup.wheel)) &&
      slide > half_row)
    solved.warnings.add(
        WarningKind::unseen_slide,
        fmt::format("the surfaces move past each other by up to {:.3f} mm along s, more than half a row "
                    "({:.3f} mm), and "
                    "the undeformed distance and the normals do not follow: {}",
                    slide, half_row,
                    asked.setup.wheel_rail()
                        ? "solver.structural_motion = \"placed\" lets them follow a steady contact"
                        : "forces and approach may be some percent off"));
}

/// SceneResult::contact_radius: radius_at() is linear, so that its mean is that of the mean place; but on an
/// uneven rail.
double contact_radius(const WheelOnRail& pair, const ContactProblem& problem, const ContactResult& result) {
  double x = 0, pressed = 0;
  Point2 point{};
  for (int i = 0; i < problem.grid.size(); ++i) {
    if (!(result.pn[i] > 0))
      continue;
    const double at = problem.grid.x(i % problem.grid.mx);
    ContactRow row = problem.rows[i / problem.grid.mx];
    if (pair.uneven || pair.sections) {
      const Vector3 p = pair.in_space(at, row);
      row.position = {p[1], p[2]};
    }
    x += result.pn[i] * at;
    point = point + result.pn[i] * row.position;
    pressed += result.pn[i];
  }
  if (!(pressed > 0))
    return 0;
  const Point2 mean = (1 / pressed) * point;
  return pair.uneven ? radius_at(pair.wheel_frame(), {x / pressed, mean.y, mean.z})
                     : radius_at(pair, x / pressed, mean);
}

/// SceneMotion::slope_force, N: on a slope the normal of the rail leans back by it. The slope of an element
/// is that between its ends. Of a rail of sections as it is looked at (in_track_frame()).
double slope_force(const WheelOnRail& pair, const ContactProblem& problem, const ContactResult& result) {
  const ContactGrid& grid = problem.grid;
  double force = 0;
  if (pair.sections) {
    for (int i = 0; i < grid.size(); ++i)
      if (result.pn[i] > 0)
        force -= result.pn[i] * problem.element_area() *
                 pair.sections->slope(grid.x(i % grid.mx), problem.rows[i / grid.mx], grid.dx);
    return force;
  }
  for (int ix = 0; ix < grid.mx; ++ix) {
    double down = 0; // pressure along z
    for (int is = 0; is < grid.ms; ++is)
      down += result.pn[is * grid.mx + ix] * std::cos(problem.rows[is].delta);
    const double half = 0.5 * grid.dx;
    if (down != 0)
      force -= down * (pair.rail_lower(grid.x(ix) + half) - pair.rail_lower(grid.x(ix) - half)) * grid.ds;
  }
  return force;
}

/// Of the rigid bodies; nothing where a wheel without its yaw does not touch.
std::optional<Conformity> conformity_of_case(const ContactCase& asked) {
  const WheelRailGeometry& placed = *asked.setup.wheel_rail();
  const WheelsetPosition& position = asked.scene.position;
  if (placed.pair.roller || placed.pair.uneven || placed.pair.sections)
    return std::nullopt;
  if (placed.pair.yaw == 0 && placed.pair.deviation.yaw == 0 && !placed.structure) { // it stands there
    Conformity out = conformity(placed.pair, placed.touch.front(), position.gauge_height);
    out.lateral = position.lateral;
    return out;
  }
  try {
    return conformity_at(position, placed.pair.rail, placed.pair.wheel);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The creepages that the last step had.
void add_creepages(const ContactSetup& setup, SceneResult& out) {
  const Motion& motion = setup.motion;
  if (!motion.tangential || (setup.patch() && setup.patch()->slip))
    return;
  const Creepage last = motion.steps.empty() ? motion.creepage : motion.creepage_of(motion.steps.back());
  const double per_slip =
      out.motion.contact_radius > 0 ? out.motion.rolling.radius / out.motion.contact_radius : 1.0;
  out.motion.xi = last.xi + per_slip * (last.slip_x + out.result.totals.creepage_x);
  out.motion.eta = last.eta + out.result.totals.creepage_s;
  out.motion.phi = last.phi;
}

/// What is handed back of a solution: with totals about the reference point, outlines of the bodies, stresses
/// below the surface, and everything that a person should be warned of. Throws InputError for pressures that
/// are beyond elasticity.
SceneResult record_of(const ContactCase& asked, GridSolution solved, const ModelChoice& choice) {
  require_elastic(asked.setup, highest_pressure(solved));
  SceneResult out;
  out.approach_datum = approach_datum(asked, solved.model);
  out.track = track_text(asked.scene);
  warn_of_slide(asked, solved);
  out.patch_places = patch_places(asked.setup, solved.contact, solved.result);
  out.choice = choice;
  out.choice.model = solved.model;
  out.problem = std::move(solved.contact.problem);
  out.layer = std::move(solved.contact.layer);
  out.result = std::move(solved.result);
  out.history = std::move(solved.history);
  if (!out.layer.is_none())
    out.layer_slope = estimated_slope(asked.setup, out.layer, out.problem, out.result);
  out.warnings = std::move(solved.warnings);
  out.seconds = solved.seconds;
  warn_of_model(out);
  out.warnings.add(input_warnings(asked.scene, asked.setup));
  out.bodies.rail_poisson = asked.setup.rail.material.poisson;
  out.bodies.wheel_poisson = asked.setup.wheel.material.poisson;
  out.motion.left = asked.scene.position.side == WheelSide::left;
  out.motion.reference = asked.setup.reference();
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail()) {
    out.motion.lateral = asked.scene.position.lateral;
    out.motion.rolling = rolling_speed(placed->pair, out.motion.reference, asked.setup.motion.creepage);
    out.motion.contact_radius = contact_radius(placed->pair, out.problem, out.result);
    out.motion.lowered = placed->lowered;
    if (placed->pair.uneven || placed->pair.sections) // 0 where the wheel alone is uneven
      out.motion.slope_force = slope_force(placed->pair, out.problem, out.result);
    if (placed->pair.sections)
      out.bodies.rail_sections = std::make_shared<const SectionedRail>(*placed->pair.sections);
    out.bodies.rail_geometry = placed->pair.rail.digest();
    out.bodies.wheel_geometry = placed->pair.wheel.digest();
  }
  add_creepages(asked.setup, out);
  out.moment = moment_about(out.motion.reference, out.result);
  const bool on_files = has_influence_files_of_both(asked) || asked.rail_inside || asked.wheel_inside;
  if (asked.setup.wheel_rail() || on_files)
    out.bodies.wheel_s = std::move(solved.contact.wheel_s);
  if (asked.setup.patch() && on_files)
    out.bodies.rail_s = std::move(solved.contact.rail_s);
  Outlines bodies = outlines(asked.setup, out.problem);
  out.bodies.rail_profile = std::move(bodies.rail);
  out.bodies.wheel_profile = std::move(bodies.wheel);
  warn_of_discretisation(out.result, out.warnings);
  out.warnings.add(result_warnings(asked, out));
  add_stresses(asked, out);
  if (const WheelRailGeometry* placed = asked.setup.wheel_rail(); placed && placed->pair.sections)
    in_track_frame(placed->pair, out);
  return out;
}

/// A case with the influence files that its model needs, on its first grid.
struct FirstContact {
  ContactCase asked;
  ContactOnGrid contact;
};
FirstContact first_contact(const ContactCase& asked, Model model, const SceneFile::Grid& grid,
                           const SolveResources& resources) {
  const bool on_strips = has_files(model);
  ContactCase known = on_strips && resources.files ? with_influence(asked, *resources.files) : asked;
  const GridPlan plan = first_plan(known, grid, on_strips);
  ContactOnGrid contact = known.setup.on(fitted(known, plan, model, resources.start));
  return {std::move(known), std::move(contact)};
}

/// By the estimate; in plane strain, which has none, by the normal problem with half-space numbers.
ContactTraits foreseen_traits(const ContactCase& asked, const ContactOnGrid& contact,
                              const SolveResources& resources) {
  if (asked.estimate)
    return traits_of(asked, *asked.estimate);
  if (const auto estimate = estimate_contact(contact.problem, pair_compliance(asked.setup)))
    return traits_of(asked, *estimate);
  const GridSolution normal = solve_on_growing_grid(asked, contact, {rough_model, true}, resources, false);
  return traits_of(asked, {}, normal.contact.problem, normal.result);
}

/// What the solution itself says of the choice: a costlier model, or the same with what is known now.
ModelChoice checked(const ContactCase& asked, ModelChoice taken, const ContactTraits& foreseen,
                    const ModelRequest& request, const GridSolution& solved) {
  if (is_closed_form(taken.model) || has_files(taken.model) || !solved.result.certified() ||
      solved.result.patches.empty())
    return taken;
  ModelChoice known =
      choose_model(traits_of(asked, foreseen, solved.contact.problem, solved.result), request);
  return known.model < taken.model ? taken : known;
}

/// Whether the case will be solved again on smaller elements.
bool ends_here(const SolveResources& resources, const GridSolution& solved) {
  return !resources.early_end || !resources.early_end->ends(solved.contact.problem, solved.result);
}

std::optional<Measured> free_creepage_if_asked(PlacedSolution& placed, const SolveResources& resources) {
  const GridSolution& solved = placed.solved;
  const bool asked = resources.free_rolling && !is_closed_form(solved.model) && solved.result.certified() &&
                     !solved.result.patches.empty() && placed.asked.setup.motion.force_x != 0.0;
  if (!asked || !ends_here(resources, solved))
    return std::nullopt;
  std::optional<Measured> found = free_creepage_of(placed.asked, placed.solved, resources);
  if (found && placed.ends) {
    const std::optional<double> error = free_creepage_error(*placed.ends, resources);
    if (!error)
      return std::nullopt;
    found->error += *error;
  }
  return found;
}

ResultDerivatives derivatives_if_asked(PlacedSolution& placed, const SolveResources& resources) {
  const ContactResult& result = placed.solved.result;
  const bool asked = resources.derivatives && !resources.totals_only &&
                     !placed.asked.scene.derivatives.empty() && result.certified() &&
                     !result.patches.empty() && ends_here(resources, placed.solved);
  return asked ? derivatives_of(placed.asked, placed.solved, resources) : ResultDerivatives{};
}

/// SceneResult::free_rolling of what free_creepage_of() found.
FreeRolling free_rolling_at(const ContactCase& asked, const Measured& found, const SceneResult& solved) {
  const Creepage& given = asked.setup.motion.creepage;
  const double per_slip =
      solved.motion.contact_radius > 0 ? solved.motion.rolling.radius / solved.motion.contact_radius : 1.0;
  const double xi = (asked.scene.motion.pitch_rate ? given.xi : 0) + per_slip * (given.slip_x + found);
  const RollingSpeed& rolling = solved.motion.rolling;
  return {{xi, found.error}, rolling.radius_at(xi), solved.motion.contact_radius, rolling.radius};
}

SceneResult recorded(PlacedSolution placed, const ModelChoice& choice, const SolveResources& resources) {
  const Stopwatch finding;
  const std::optional<Measured> free = free_creepage_if_asked(placed, resources);
  const double seconds = finding.seconds();
  ResultDerivatives derivatives = derivatives_if_asked(placed, resources);
  SceneResult out = record_of(placed.asked, std::move(placed.solved), choice);
  out.structure = std::move(placed.structure);
  if (placed.ends)
    add_section_error(*placed.ends, placed.asked.setup.reference(), out.moment);
  out.derivatives = std::move(derivatives.numbers);
  out.profile_derivatives = std::move(derivatives.profiles);
  if (out.motion.lateral && resources.displacements &&
      !resources.totals_only) // not where one of many totals is wanted
    out.conformity = conformity_of_case(placed.asked);
  if (free)
    out.motion.free_rolling = free_rolling_at(placed.asked, *free, out);
  out.seconds.free_rolling += seconds;
  return out;
}

ModelRequest without_fem(ModelRequest request) {
  request.fem = false;
  request.without_fem = "the influence files do not cover this contact";
  return request;
}

/// With the influence files, if the model needs them.
PlacedSolution solve_with(const ContactCase& asked, Model model, const SceneFile::Grid& grid,
                          const SolveResources& resources) {
  const Stopwatch looking;
  FirstContact first = first_contact(asked, model, grid, resources);
  const double geometry = looking.seconds();
  PlacedSolution placed =
      solve_on_placed_bodies(first.asked, grid, std::move(first.contact), {model}, resources);
  placed.solved.seconds.geometry += geometry;
  if (has_files(model))
    placed.ends = section_ends(placed.asked, placed.solved, resources);
  if (placed.ends)
    add_section_errors(*placed.ends, placed.solved.result);
  return placed;
}

SceneResult solve_by_choice(const ContactCase& asked, const SceneFile::Grid& grid,
                            const SolveResources& resources) {
  const Stopwatch looking;
  const FirstContact first = first_contact(asked, rough_model, grid, resources);
  const ContactTraits foreseen = foreseen_traits(asked, first.contact, resources);
  ModelRequest request = request_of(asked);
  ModelChoice choice = choose_model(asked.setup, first.contact.problem, foreseen, request);
  PhaseSeconds spent{.geometry = looking.seconds()};
  for (;;) {
    std::optional<PlacedSolution> placed;
    try {
      placed = has_files(choice.model)
                   ? solve_with(asked, choice.model, grid, resources)
                   : solve_on_placed_bodies(first.asked, grid, first.contact, {choice.model}, resources);
    } catch (const OffStripError&) {
      if (foreseen.prescribed.structures) // no other model has them
        throw;
      request = without_fem(std::move(request));
      choice = choose_model(foreseen, request);
      continue;
    }
    spent += placed->solved.seconds;
    const Model taken = choice.model;
    choice = checked(asked, std::move(choice), foreseen, request, placed->solved);
    if (choice.model == taken) {
      placed->solved.seconds = spent;
      return recorded(std::move(*placed), choice, resources);
    }
  }
}

SceneResult solve_as_asked(const ContactCase& asked, Model model, const SceneFile::Grid& grid,
                           const SolveResources& resources) {
  PlacedSolution placed = solve_with(asked, model, grid, resources);
  std::string why = "asked for";
  if (const auto fit_of = elasticity_model(model).fit; fit_of && !resources.totals_only)
    if (const auto fit = fit_of(placed.asked.setup, placed.solved.contact.problem,
                                foreseen_traits(placed.asked, placed.solved.contact, resources)))
      why = asked_closed_form_text(model, *fit);
  return recorded(std::move(placed), {model, why}, resources);
}

} // namespace

SceneResult solve_case(const ContactCase& asked, const SceneFile::Grid& grid,
                       const SolveResources& resources) {
  const Stopwatch clock;
  const std::optional<Model> model = asked.scene.solver.model;
  SceneResult out =
      model ? solve_as_asked(asked, *model, grid, resources) : solve_by_choice(asked, grid, resources);
  out.seconds.total = clock.seconds();
  return out;
}

ModelChoice foreseen_model(const ContactCase& asked, bool covered) {
  WorkBudget work;
  const SolveResources resources{.work = work};
  const ContactOnGrid contact = first_contact(asked, rough_model, asked.scene.grid, resources).contact;
  const ModelRequest request = request_of(asked);
  return choose_model(asked.setup, contact.problem, foreseen_traits(asked, contact, resources),
                      covered ? request : without_fem(request));
}

} // namespace bem_contact
