#include "bem_contact/scene/doubts.hpp"
#include "bem_contact/scene/motion.hpp"
#include "bem_contact/sequence/scene_stage.hpp"
#include "bem_contact/sequence/solve_scene.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <numbers>

namespace bem_contact {

namespace {

std::string motion_text(const SceneFile& scene) {
  const std::size_t steps = read_steps(scene).size();
  return scene.motion.kind == MotionKind::steady  ? std::string("steady rolling")
         : scene.motion.kind == MotionKind::shift ? fmt::format("shift in {} steps", steps)
                                                  : fmt::format("transient rolling, {} steps of dx", steps);
}

} // namespace

std::vector<std::string> check_scene(const SceneFile& scene) {
  const Stage stage = prepare_stage(scene, scene.solver.model == Model::fem);
  const ContactProblem& problem = stage.contact.problem;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("kind: {}", name_of(scene.kind)));
  if (stage.wheel_rail)
    std::ranges::copy(describe(*stage.wheel_rail), std::back_inserter(lines));
  lines.push_back(problem.load == LoadKind::force ? fmt::format("load: vertical force {:g} N", problem.force)
                                                  : fmt::format("load: approach {:g} mm", problem.approach));
  const SceneFile::Grid& asked = scene.grid;
  if (asked.accuracy)
    lines.push_back(fmt::format("grid: dx and ds are chosen for an error of {:g} %", 100 * *asked.accuracy));
  else if (asked.elements)
    lines.push_back(fmt::format("grid: dx and ds are chosen for {} elements in contact", *asked.elements));
  else
    lines.push_back(fmt::format(
        "grid: {} x {} elements of {:g} x {:g} mm, s = {:.3f} .. {:.3f} mm, inclination "
        "{:.2f} .. {:.2f} degrees",
        problem.grid.mx, problem.grid.ms, problem.grid.dx, problem.grid.ds, problem.rows.front().s,
        problem.rows.back().s, problem.rows.front().delta * 180 / std::numbers::pi,
        problem.rows.back().delta * 180 / std::numbers::pi));
  lines.push_back(problem.tangential
                      ? fmt::format("friction: {:g}, {}", problem.largest_friction(), motion_text(scene))
                      : std::string("friction: none"));
  const auto side = [&](const char* name, const std::shared_ptr<const InfluenceFunction>& f,
                        const std::vector<double>& s) {
    if (!f) {
      lines.push_back(fmt::format("{}: no influence file", name));
      return;
    }
    const auto [lo, hi] = std::ranges::minmax(s);
    const double from = f->stations.front().s - f->station_width / 2,
                 to = f->stations.back().s + f->station_width / 2;
    const double off = std::max(from - (lo - problem.grid.ds / 2), hi + problem.grid.ds / 2 - to);
    lines.push_back(fmt::format(
        "{}: influence file of '{}', strip s = {:.2f} .. {:.2f} mm; rows need {:.2f} .. {:.2f} mm: {}", name,
        f->body, from, to, lo - problem.grid.ds / 2, hi + problem.grid.ds / 2,
        off <= 0.01 * problem.grid.ds
            ? "covered"
            : fmt::format("they leave the strip by {:.2f} mm, where fem serves no contact", off)));
  };
  side("rail", stage.files.rail, stage.contact.rail_s);
  side("wheel", stage.files.wheel, stage.contact.wheel_s);
  lines.push_back(fmt::format(
      "model: {}{}", name_of(scene.solver.model),
      stage.wheel_rail ? "; by the estimate " + halfspace_text(stage.wheel_rail->estimate.turn) : ""));
  for (const std::string& doubt : doubts(scene, stage.wheel_rail ? &*stage.wheel_rail : nullptr))
    lines.push_back("warning: " + doubt);
  return lines;
}

} // namespace bem_contact
