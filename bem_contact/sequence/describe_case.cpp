#include "bem_contact/sequence/describe_case.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/contact_case.hpp"
#include "bem_contact/sequence/grow_grid.hpp"
#include "bem_contact/sequence/model_choice.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <vector>

namespace bem_contact {

namespace {

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
/// beyond the profile.
Range strip_for(const Range& rows, const TabulatedProfile& profile) {
  return {std::max(std::floor(rows.from - strip_reserve), std::ceil(profile.s_begin())),
          std::min(std::ceil(rows.to + strip_reserve), std::floor(profile.s_end()))};
}

/// The frictionless contact on the grid that it ends with.
ContactOnGrid grown_contact(const ContactCase& asked, const ContactOnGrid& contact, Model model) {
  WorkBudget work;
  return solve_on_growing_grid(asked, contact, {model, true}, {.work = work}, model == Model::fem).contact;
}

void add_strip(const char* body, const Range& strip, std::vector<std::string>& lines) {
  lines.push_back(fmt::format("strip that the model fem needs on the {0}, for its body file:\n"
                              "    [strip]\n    from = {1:g} # mm\n    to = {2:g}\n    station_width = {3:g}",
                              body, strip.from, strip.to, double(usual_station_width)));
}

/// Why fem would refuse a wheel on a rail whose influence files are both there: the contact does not fit on
/// their strips. Empty where they hold the contact. The frictionless problem is solved for this, because a
/// conformal contact is wider than any estimate without elasticity.
std::string refusal_by_strips(const ContactCase& asked) {
  if (!asked.setup.wheel_rail() || !asked.files.complete())
    return {};
  try {
    grown_contact(asked, asked.setup.on(first_plan(asked, asked.scene.grid, true)), Model::fem);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Which strips of both bodies a wheel on a rail needs for fem, line by line, as the table [strip] of their
/// body files (profile/body_file.hpp): the rows that the frictionless contact has with half-space numbers,
/// and strip_reserve beyond them. `contact`: on its first grid.
std::vector<std::string> describe_strips(const ContactCase& asked, const ContactOnGrid& contact) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed)
    return {};
  std::vector<std::string> lines;
  const double ds = contact.problem.grid.ds;
  Range rail = range_of(contact.rail_s, ds), wheel = range_of(contact.wheel_s, ds);
  try {
    const ContactOnGrid grown = grown_contact(asked, contact, Model::halfspace);
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
      lines.push_back(fmt::format("touch point: rail s = {:.3f} mm, wheel s = {:.3f} mm, x = {:.3f} mm, y = "
                                  "{:.3f} mm, z = {:.3f} mm, "
                                  "inclination {:.2f} degrees, vertical distance {:.4f} mm",
                                  p.rail_s, p.wheel_s, p.x, p.position.y, p.position.z, degrees(p.delta),
                                  p.distance));
  for (const PotentialArea& area : potential_areas(estimate))
    lines.push_back(fmt::format("potential contact: s = {:.2f} .. {:.2f} mm, x = {:.2f} .. {:.2f} mm",
                                area.s_from, area.s_to, area.x_from, area.x_to));
  lines.push_back(fmt::format("estimate: approach {:.4f} mm, vertical force {:.0f} N", estimate.approach,
                              estimate.force));
  const ReferencePoint reference = setup.reference();
  lines.push_back(fmt::format("reference point: s = {:.3f} mm, x = {:.3f} mm, inclination {:.2f} degrees; "
                              "rolling radius {:.3f} mm",
                              reference.s, reference.x, degrees(reference.delta),
                              setup.motion.creepage.rolling_radius));
}

std::string load_text(const ContactLoad& load) {
  return load.kind == LoadKind::force ? fmt::format("load: vertical force {:g} N", load.force)
                                      : fmt::format("load: approach {:g} mm", load.approach);
}

std::string grid_text(const SceneFile::Grid& asked, const ContactProblem& problem) {
  if (asked.accuracy)
    return fmt::format("grid: dx and ds are chosen for an error of {:g} %", 100 * *asked.accuracy);
  if (asked.elements)
    return fmt::format("grid: dx and ds are chosen for {} elements in contact", *asked.elements);
  return fmt::format("grid: {} x {} elements of {:g} x {:g} mm, s = {:.3f} .. {:.3f} mm, inclination "
                     "{:.2f} .. {:.2f} degrees",
                     problem.grid.mx, problem.grid.ms, problem.grid.dx, problem.grid.ds,
                     problem.rows.front().s, problem.rows.back().s, degrees(problem.rows.front().delta),
                     degrees(problem.rows.back().delta));
}

std::string friction_text(const Motion& motion, const ContactProblem& problem) {
  if (!problem.tangential)
    return "friction: none";
  const std::size_t steps = motion.steps.size();
  const std::string falls =
      fmt::format("{}{}", problem.friction_falls() ? ", falls with the slip velocity" : "",
                  problem.friction_falls_with_heat() ? ", falls with temperature" : "");
  return fmt::format("friction: {:g}{}, {}", problem.largest_friction(), falls,
                     motion.kind == MotionKind::steady ? std::string("steady rolling")
                     : motion.kind == MotionKind::shift
                         ? fmt::format("shift in {} steps", steps)
                         : fmt::format("transient rolling, {} steps of dx", steps));
}

/// One body's influence file, and whether its strip covers the rows at the stations s. `refusal`: why fem
/// refuses the contact all the same; empty: it does not.
std::string influence_text(const char* body, const std::shared_ptr<const InfluenceFunction>& f,
                           const std::vector<double>& s, double ds, const std::string& refusal) {
  if (!f)
    return fmt::format("{}: no influence file", body);
  const auto [lo, hi] = std::ranges::minmax(s);
  const double from = f->stations.front().s - f->station_width / 2,
               to = f->stations.back().s + f->station_width / 2;
  const double off = std::max(from - (lo - ds / 2), hi + ds / 2 - to);
  return fmt::format(
      "{}: influence file of '{}', strip s = {:.2f} .. {:.2f} mm; rows need {:.2f} .. {:.2f} mm: {}", body,
      f->body, from, to, lo - ds / 2, hi + ds / 2,
      off <= (0.5 - row_on_strip) * ds
          ? (refusal.empty() ? "covered" : "the first rows are covered, but fem refuses: " + refusal)
          : fmt::format("they leave the strip by {:.2f} mm, where fem serves no contact", off));
}

} // namespace

SceneDescription describe_case(const ContactCase& asked) {
  const SceneFile& scene = asked.scene;
  const ContactOnGrid contact =
      asked.setup.on(first_plan(asked, scene.grid, scene.solver.model == Model::fem));
  const ContactProblem& problem = contact.problem;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("kind: {}", name_of(scene.kind)));
  if (asked.estimate)
    add_touch_points(asked.setup, *asked.estimate, lines);
  lines.push_back(load_text(asked.setup.load));
  lines.push_back(grid_text(scene.grid, problem));
  lines.push_back(friction_text(asked.setup.motion, problem));
  const std::string refusal = refusal_by_strips(asked);
  lines.push_back(influence_text("rail", asked.files.rail, contact.rail_s, problem.grid.ds, refusal));
  lines.push_back(influence_text("wheel", asked.files.wheel, contact.wheel_s, problem.grid.ds, refusal));
  std::ranges::move(describe_strips(asked, contact), std::back_inserter(lines));
  lines.push_back(fmt::format(
      "model: {}{}", name_of(scene.solver.model),
      asked.estimate
          ? "; by the estimate " + choose_model(traits_of(asked, *asked.estimate), request_of(asked)).reason
          : ""));
  return {std::move(lines), input_warnings(scene, asked.setup)};
}

} // namespace bem_contact
