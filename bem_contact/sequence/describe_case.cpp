#include "bem_contact/sequence/describe_case.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/fixed_text.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/scene/network.hpp"
#include "bem_contact/scene/surface_states.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"
#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/section_lines.hpp"
#include "bem_contact/sequence/solution/grow_grid.hpp"
#include "bem_contact/sequence/solution/solve_case.hpp"
#include "bem_contact/sequence/solution/trim_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <optional>

namespace bem_contact {

namespace {

/// mm. Touch points that are nearer than this are described by bem_contact check.
constexpr double described_distance = 1.0;
/// mm. Room that a strip gets on either side beyond the rows of the frictionless contact. Chosen.
constexpr double strip_reserve = 1.0;
/// mm. The station width of the body files of data/bodies.
constexpr double usual_station_width = 0.25;

/// Arc lengths on one body, mm.
struct Range {
  double from = 0, to = 0;
};

/// From the outer border of the first row to that of the last.
Range range_of(const std::vector<double>& s, double ds) {
  const auto [lo, hi] = std::ranges::minmax(s);
  return {lo - 0.5 * ds, hi + 0.5 * ds};
}

/// Whole millimetres, which every usual station width divides, with room for what friction changes; not
/// beyond the profile. The sum with 0 makes 0 of -0.
Range strip_for(const Range& rows, const TabulatedProfile& profile) {
  return {std::max(std::floor(rows.from - strip_reserve), std::ceil(profile.s_begin())) + 0.0,
          std::min(std::ceil(rows.to + strip_reserve), std::floor(profile.s_end())) + 0.0};
}

/// The frictionless contact on the grid that it ends with.
GridSolution grown_contact(const ContactCase& asked, const ContactOnGrid& contact, Model model) {
  WorkBudget work;
  return solve_on_growing_grid(asked, contact, {model, true}, {.work = work}, has_files(model));
}

void add_strip(const char* body, const Range& strip, std::vector<std::string>& lines) {
  lines.push_back(fmt::format("strip that the model fem needs on the {0}, for its body file:\n"
                              "    [strip]\n    from = {1:g} # mm\n    to = {2:g}\n    station_width = {3:g}",
                              body, strip.from, strip.to, double(usual_station_width)));
}

/// From the contact to the nearer end of a strip, mm.
double room_on(const RowsOnStrip& on, const GridSolution& solved) {
  const ContactGrid& grid = solved.contact.problem.grid;
  const auto [from, to] = on.file->strip().ends();
  double room = to - from;
  for (int i = 0; i < grid.size(); ++i)
    if (const int row = i / grid.mx - on.first;
        row >= 0 && row < static_cast<int>(on.s.size()) && solved.result.state[i] != ElementState::exterior) {
      const double s = on.s[row];
      room = std::min({room, s - 0.5 * grid.ds - from, to - s - 0.5 * grid.ds});
    }
  return std::max(room, 0.0); // less is rounding: rows lie on the strip
}

/// What becomes of the frictionless contact on the strips of both influence files. `room`: from the contact
/// to the nearer end of the strip, mm; nothing where it is not known.
struct FitOnStrips {
  std::string refusal = {}; ///< why fem refuses it; empty: it does not
  bool covered = true;      ///< false: because the contact leaves the strips
  std::optional<double> rail_room = {}, wheel_room = {};
};

/// Of a wheel on a rail whose influence files are both there; nothing is known of others. The frictionless
/// problem is solved for this, because a conformal contact is wider than any estimate without elasticity.
FitOnStrips fit_on_strips(const ContactCase& asked) {
  if (!asked.setup.wheel_rail() || !asked.files.complete())
    return {};
  try {
    const GridSolution solved =
        grown_contact(asked, asked.setup.on(first_plan(asked, asked.scene.grid, true)), model_of_files());
    FitOnStrips out;
    const ContactOnGrid& contact = solved.contact;
    for (const RowsOnStrip& on :
         rows_on_files(asked.setup, asked.files, {contact.problem.rows, contact.rail_s, contact.wheel_s},
                       contact.problem.grid.ds)) {
      std::optional<double>& room = on.file == asked.files.wheel ? out.wheel_room : out.rail_room;
      room = std::min(room.value_or(std::numeric_limits<double>::infinity()), room_on(on, solved));
    }
    return out;
  } catch (const OffStripError& error) {
    return {.refusal = error.what(), .covered = false};
  } catch (const Error& error) {
    return {.refusal = error.what()};
  }
}

/// Which strips of both bodies a wheel on a rail needs for fem, line by line, as the table [strip] of their
/// body files (profile/bodies/body_file.hpp): the rows that the frictionless contact has with half-space
/// numbers, and strip_reserve beyond them. `contact`: on its first grid.
std::vector<std::string> describe_strips(const ContactCase& asked, const ContactOnGrid& contact) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed)
    return {};
  std::vector<std::string> lines;
  const double ds = contact.problem.grid.ds;
  Range rail = range_of(contact.rail_s, ds), wheel = range_of(contact.wheel_s, ds);
  try {
    const ContactOnGrid grown = grown_contact(asked, contact, rough_model).contact;
    rail = range_of(grown.rail_s, ds);
    wheel = range_of(grown.wheel_s, ds);
  } catch (const Error&) { // what is wrong with the scene is said where it is solved; the first grid serves
  }
  add_strip("rail", strip_for(rail, placed->pair.rail), lines);
  add_strip("wheel", strip_for(wheel, placed->pair.wheel), lines);
  return lines;
}

void add_touch_points(const ContactSetup& setup, const ContactEstimate& estimate,
                      std::vector<std::string>& lines) {
  for (const TouchPoint& p : setup.wheel_rail()->touch)
    if (p.distance < described_distance)
      lines.push_back(fmt::format("touch point: rail s = {} mm, wheel s = {} mm, x = {} mm, y = "
                                  "{} mm, z = {} mm, "
                                  "inclination {} degrees, vertical distance {:.4f} mm",
                                  fixed_text(p.rail_s, 3), fixed_text(p.wheel_s, 3), fixed_text(p.x, 3),
                                  fixed_text(p.position.y, 3), fixed_text(p.position.z, 3),
                                  fixed_text(degrees(p.delta), 2), p.distance));
  for (const PotentialArea& area : potential_areas(estimate))
    lines.push_back(fmt::format("potential contact: s = {:.2f} .. {:.2f} mm, x = {:.2f} .. {:.2f} mm",
                                area.s_from, area.s_to, area.x_from, area.x_to));
  lines.push_back(fmt::format("estimate: approach {:.4f} mm, vertical force {:.0f} N", estimate.approach,
                              estimate.force));
  const ReferencePoint reference = setup.reference();
  lines.push_back(fmt::format("reference point: s = {} mm, x = {} mm, inclination {} degrees; "
                              "rolling radius {:.3f} mm",
                              fixed_text(reference.s, 3), fixed_text(reference.x, 3),
                              fixed_text(degrees(reference.delta), 2), setup.motion.creepage.rolling_radius));
}

/// Of the rigid bodies at this displacement and at the flange; then the turn of the normal under the load.
void add_conformity(const ContactCase& asked, std::vector<std::string>& lines) {
  const WheelOnRail& pair = asked.setup.wheel_rail()->pair;
  if (pair.roller || pair.uneven || pair.sections)
    return;
  const WheelsetPosition& position = asked.scene.position;
  try {
    lines.push_back(conformity_text(conformity_at(position, pair.rail, pair.wheel), "the first touch"));
    if (const auto flange = conformity_at_flange(position, pair.rail, pair.wheel))
      lines.push_back(conformity_text(
          *flange, fmt::format("the gauge corner (lateral displacement {:.3f} mm)", flange->lateral)));
  } catch (const InputError&) { // without its yaw the wheel does not touch
  }
  if (asked.estimate)
    for (const PotentialArea& area : potential_areas(*asked.estimate))
      lines.push_back(fmt::format(
          "under the load, by the estimate, the normal turns by {:.1f} degrees from s = {:.2f} to {:.2f} mm",
          degrees(std::abs(pair.rail.at(area.s_to).delta - pair.rail.at(area.s_from).delta)), area.s_from,
          area.s_to));
}

std::string load_text(const ContactLoad& load) {
  return load.kind == LoadKind::force ? fmt::format("load: vertical force {:g} N", load.force)
                                      : fmt::format("load: approach {:g} mm", load.approach);
}

/// Nothing is searched for here: the rest of the description holds where the search of solve begins.
std::string lateral_force_text(double force_y, double lateral) {
  return fmt::format(
      "lateral force {:g} N: solve looks for the lateral displacement that bears it, beginning at "
      "position.lateral = {:g} mm; everything else here is said of that position",
      force_y, lateral);
}

/// What solve makes of the first grid of a wheel on a rail. `trimmed`: it does not keep all of it
/// (trim_plan.hpp).
std::string later_grid_text(bool trimmed) {
  return fmt::format("; it covers where the bodies may touch by the estimate: solve {}enlarges it if the "
                     "contact reaches its edge",
                     trimmed ? "leaves out the rows and columns that the contact does not come near to, and "
                             : "");
}

std::string grid_text(const SceneFile& scene, const ContactProblem& problem, bool trimmed) {
  const SceneFile::Grid& asked = scene.grid;
  const bool on_rail = scene.kind == SceneKind::wheel_rail;
  if (asked.accuracy)
    return fmt::format("grid: dx and ds are chosen for an error of {:g} %", 100 * *asked.accuracy);
  if (asked.elements)
    return fmt::format("grid: dx and ds are chosen for {} elements in contact", *asked.elements);
  return fmt::format(
      "{}grid: {} x {} elements of {:g} x {:g} mm, s = {:.3f} .. {:.3f} mm, inclination "
      "{} .. {} degrees{}",
      on_rail ? "first " : "", problem.grid.mx, problem.grid.ms, problem.grid.dx, problem.grid.ds,
      problem.rows.front().s, problem.rows.back().s, fixed_text(degrees(problem.rows.front().delta), 2),
      fixed_text(degrees(problem.rows.back().delta), 2), on_rail ? later_grid_text(trimmed) : "");
}

std::string friction_text(const Motion& motion, const ContactProblem& problem) {
  if (!problem.tangential)
    return "friction: none";
  const std::string steps = counted(motion.steps.size(), "step", "steps");
  const std::string falls =
      fmt::format("{}{}{}", problem.friction_falls() ? ", falls with the slip velocity" : "",
                  problem.memory ? fmt::format(" over {:g} mm of slip", problem.memory->distance) : "",
                  problem.friction_falls_with_heat() ? ", falls with temperature" : "");
  return fmt::format("friction: {:g}{}, {}", problem.largest_friction(), falls,
                     motion.kind == MotionKind::steady  ? std::string("steady rolling")
                     : motion.kind == MotionKind::shift ? fmt::format("shift in {}", steps)
                                                        : fmt::format("transient rolling, {} of dx", steps));
}

/// The layer between the surfaces, in one line; nothing without one.
std::optional<std::string> layer_text(const ContactLayer& layer) {
  std::vector<std::string> parts;
  if (const SurfaceState* state = find_state(layer.state))
    parts.push_back(fmt::format("state {} ({}; {})", state->name, state->source, state->range));
  if (layer.slope)
    parts.push_back(fmt::format("the compliance with which Fx grows with xi at {:g} of the slope without it, "
                                "found where the contact is solved",
                                *layer.slope));
  else if (!layer.table.empty())
    parts.push_back("compliance along s from its table");
  else if (layer.compliance > 0)
    parts.push_back(fmt::format("compliance {:g} mm3/N", layer.compliance));
  if (layer.normal > 0)
    parts.push_back(fmt::format("{:g} mm3/N under pressure", layer.normal));
  if (layer.yield)
    parts.push_back(yield_text(*layer.yield));
  if (parts.empty())
    return std::nullopt;
  return fmt::format("layer between the surfaces: {}", fmt::join(parts, ", "));
}

/// `choice`: of auto; nothing where it was not looked for.
std::string model_text(std::optional<Model> asked_for, const std::optional<ModelChoice>& choice) {
  std::string out = fmt::format("model: {}", name_of(asked_for));
  if (choice)
    out += fmt::format("{} {} by the estimate: {}", asked_for ? "; auto would take" : ", which takes",
                       name_of(choice->model), choice->why_this_model);
  return out;
}

/// `off`: by how much the rows leave the strip, mm; 0: they do not. Friction moves a contact along s, by up
/// to about strip_reserve, but is not solved for here: a contact with less room is covered closely.
std::string covered_text(double off, const std::string& refusal, std::optional<double> room, bool friction) {
  const std::string leave = fmt::format("they leave the strip by {:.2f} mm", off);
  if (!refusal.empty())
    return fmt::format("{} fem refuses the contact without friction: {}",
                       off > 0 ? leave + ", and" : "the first rows are covered, but", refusal);
  if (!room)
    return off > 0 ? leave + ", where fem serves no contact" : "covered";
  const std::string covered = off > 0 ? leave + ", but the contact itself is covered" : "covered";
  return friction && *room < strip_reserve
             ? fmt::format(
                   "{}, but closely: without friction the contact ends {:.2f} mm before the end of the "
                   "strip. If friction moves it beyond, fem refuses it.",
                   covered, *room)
             : covered;
}

/// One body's influence files, and whether their strips cover the rows. `room`: from the contact to the end
/// of the strip; nothing where it is not known.
std::string influence_text(const char* body, const std::vector<RowsOnStrip>& strips,
                           const ContactProblem& problem, const std::string& refusal,
                           std::optional<double> room) {
  if (strips.empty())
    return fmt::format("{}: {}", body, refusal.empty() ? "no influence file" : refusal);
  std::vector<std::string> texts;
  for (const RowsOnStrip& on : strips) {
    const Range rows = range_of(on.s, problem.grid.ds);
    const auto [from, to] = on.file->strip().ends();
    const double off = std::max(from - rows.from, rows.to - to);
    const bool leave = off > (0.5 - row_on_strip) * problem.grid.ds;
    texts.push_back(fmt::format(
        "{}: influence file of '{}'{}, strip s = {:.2f} .. {:.2f} mm; rows need {:.2f} .. {:.2f} mm: {}",
        body, on.file->strip().body, on.section.empty() ? "" : fmt::format(", {}", on.section), from, to,
        rows.from, rows.to, covered_text(leave ? off : 0, refusal, room, problem.has_friction())));
  }
  return fmt::format("{}", fmt::join(texts, "\n"));
}

/// Where the rows lie on the strips of all files; nothing where a rail of sections has none there.
std::vector<RowsOnStrip> strips_under(const ContactCase& asked, const ContactOnGrid& contact) {
  try {
    return rows_on_files(asked.setup, asked.files, {contact.problem.rows, contact.rail_s, contact.wheel_s},
                         contact.problem.grid.ds);
  } catch (const OffStripError&) { // FitOnStrips::refusal says so
    return {};
  }
}

} // namespace

SceneDescription describe_case(const ContactCase& asked) {
  const SceneFile& scene = asked.scene;
  const ContactOnGrid contact =
      asked.setup.on(first_plan(asked, scene.grid, scene.solver.model && has_files(*scene.solver.model)));
  const ContactProblem& problem = contact.problem;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("kind: {}", name_of(scene.kind)));
  if (scene.kind == SceneKind::wheel_rail)
    lines.push_back(track_text(scene));
  if (const auto joined = section_lines(scene, "the scene"))
    lines.push_back(joined->words.substr(0, joined->words.size() - 1)); // without its last end of line
  if (asked.estimate)
    add_touch_points(asked.setup, *asked.estimate, lines);
  if (asked.setup.wheel_rail())
    add_conformity(asked, lines);
  const double upright = asked.setup.wheel_rail() ? asked.setup.wheel_rail()->pair.upright() : 1;
  const ContactLoad& load = asked.setup.load;
  lines.push_back(load_text({load.kind, load.force * upright, load.approach / upright}));
  if (scene.load.force_y)
    lines.push_back(lateral_force_text(*scene.load.force_y, scene.position.lateral));
  const FitOnStrips fit = fit_on_strips(asked);
  const std::optional<Model> asked_for = scene.solver.model;
  std::optional<ModelChoice> choice;
  if (!asked_for || asked.estimate)
    choice = foreseen_model(asked, fit.covered);
  const Model model = asked_for ? *asked_for : choice->model;
  lines.push_back(grid_text(scene, problem, has_large_numbers(asked, contact.plan, model)));
  lines.push_back(friction_text(asked.setup.motion, problem));
  if (const auto layer = layer_text(asked.setup.layer))
    lines.push_back(*layer);
  std::vector<RowsOnStrip> of_rail = strips_under(asked, contact), of_wheel;
  if (!of_rail.empty() && of_rail.back().file == asked.files.wheel) {
    of_wheel.push_back(std::move(of_rail.back()));
    of_rail.pop_back();
  }
  lines.push_back(influence_text("rail", of_rail, problem, fit.refusal, fit.rail_room));
  lines.push_back(influence_text("wheel", of_wheel, problem, fit.refusal, fit.wheel_room));
  std::ranges::move(describe_strips(asked, contact), std::back_inserter(lines));
  lines.push_back(model_text(asked_for, choice));
  return {std::move(lines), input_warnings(scene, asked.setup)};
}

} // namespace bem_contact
