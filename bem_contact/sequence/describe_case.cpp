#include "bem_contact/sequence/describe_case.hpp"

#include "bem_contact/scene/warnings.hpp"
#include "bem_contact/sequence/model_choice.hpp"
#include "bem_contact/sequence/strips.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace bem_contact {

namespace {

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
