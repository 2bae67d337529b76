#include "bem_contact/scene/motion.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/scene/patch_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Coefficient of each row: linear between the points of the table, constant beyond its ends.
std::vector<double> friction_of_rows(const ContactProblem& problem, const std::filesystem::path& file) {
  const auto table = read_csv(file, {"s", "mu"});
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i][1] < 0 || (i > 0 && table[i][0] <= table[i - 1][0]))
      throw InputError(fmt::format("The table '{}' is no friction coefficient", file.string()),
                       fmt::format("its row {} has s = {:g}, mu = {:g}", i + 1, table[i][0], table[i][1]),
                       "Give rows of ascending s and mu >= 0.");
  }
  std::vector<double> mu;
  for (const ContactRow& row : problem.rows) {
    const auto after = std::ranges::find_if(table, [&](const auto& point) { return point[0] > row.s; });
    if (after == table.begin() || after == table.end()) {
      mu.push_back(after == table.begin() ? table.front()[1] : table.back()[1]);
      continue;
    }
    const auto before = std::prev(after);
    const double share = (row.s - (*before)[0]) / ((*after)[0] - (*before)[0]);
    mu.push_back((1 - share) * (*before)[1] + share * (*after)[1]);
  }
  return mu;
}

} // namespace

std::vector<MotionStep> read_steps(const SceneFile& scene) {
  if (scene.motion.step_table.empty())
    return std::vector<MotionStep>(scene.motion.steps);
  const std::filesystem::path file = scene.folder / scene.motion.step_table;
  const std::vector<std::pair<std::string, std::optional<double> MotionStep::*>> known{
      {"load", &MotionStep::load}, {"xi", &MotionStep::xi},           {"eta", &MotionStep::eta},
      {"phi", &MotionStep::phi},   {"force_x", &MotionStep::force_x}, {"force_s", &MotionStep::force_s},
      {"x", &MotionStep::x}};
  const std::vector<std::string> columns = csv_columns(file);
  std::vector<std::optional<double> MotionStep::*> members;
  for (const std::string& name : columns) {
    const auto found = std::ranges::find(known, name, [](const auto& k) { return k.first; });
    if (found == known.end() || std::ranges::count(columns, name) > 1)
      throw InputError(fmt::format("The table '{}' has other columns", file.string()),
                       fmt::format("'{}' is {}", name, found == known.end() ? "not known" : "there twice"),
                       "Columns are some of load, xi, eta, phi, force_x, force_s, x.");
    if ((name == "force_x" && !scene.load.has_force_x) || (name == "force_s" && !scene.load.has_force_s))
      throw InputError(fmt::format("The table '{}' has forces that are not prescribed", file.string()),
                       fmt::format("load.{} is not given", name), "Give it, with any value.");
    if ((name == "xi" || name == "eta" || name == "phi") && !scene.motion.slip_table.empty())
      throw InputError(fmt::format("The table '{}' has creepages", file.string()),
                       "motion.slip_table gives the rigid slip", "Leave out one of the two.");
    if ((name == "xi" && scene.motion.xi != 0) || (name == "eta" && scene.motion.eta != 0) ||
        (name == "phi" && scene.motion.phi != 0))
      throw InputError(fmt::format("The table '{}' has the creepage {}", file.string(), name),
                       fmt::format("motion.{} is given too", name), "Leave out one of the two.");
    if (name == "x" && (scene.motion.kind != "shift" || scene.kind != "patch" || !scene.gap.table.empty()))
      throw InputError(fmt::format("The table '{}' moves a contact that cannot be moved", file.string()),
                       "column x is for shifts of a patch whose gap is given by coefficients",
                       "Leave it out.");
    members.push_back(found->second);
  }
  std::vector<MotionStep> steps;
  for (const std::vector<double>& row : read_csv(file, columns)) {
    MotionStep step;
    for (std::size_t i = 0; i < members.size(); ++i)
      step.*members[i] = row[i];
    steps.push_back(step);
  }
  return steps;
}

void set_motion(ContactProblem& problem, const SceneFile& scene, double reference_delta) {
  problem.friction = scene.motion.friction;
  problem.tangential = !scene.motion.frictionless && scene.motion.friction > 0;
  if (!problem.tangential)
    return;
  problem.reference_delta = reference_delta;
  problem.motion = scene.motion.kind == "shift"       ? MotionKind::shift
                   : scene.motion.kind == "transient" ? MotionKind::transient
                                                      : MotionKind::steady;
  if (!scene.motion.friction_table.empty())
    problem.friction_rows = friction_of_rows(problem, scene.folder / scene.motion.friction_table);
  const double largest = problem.largest_friction();
  if (scene.motion.kinetic_friction > largest)
    throw InputError(fmt::format("Kinetic friction cannot be {:g}", scene.motion.kinetic_friction),
                     fmt::format("friction in adhesion is at most {:g} on these rows", largest),
                     "Give a smaller motion.kinetic_friction.");
  if (scene.motion.kinetic_friction > 0)
    problem.kinetic = scene.motion.kinetic_friction / largest;
  if (scene.load.has_force_x)
    problem.force_x = scene.load.force_x;
  if (scene.load.has_force_s)
    problem.force_s = scene.load.force_s;
}

void prescribe_step(ContactProblem& problem, const SceneFile& scene, const WheelRailScene* placed,
                    const MotionStep& step) {
  if (step.load)
    (problem.load == LoadKind::force ? problem.force : problem.approach) = *step.load;
  if (problem.force_x)
    problem.force_x = step.force_x.value_or(scene.load.force_x);
  if (problem.force_s)
    problem.force_s = step.force_s.value_or(scene.load.force_s);
  if (step.x)
    set_gap(problem, scene, *step.x);
  if (!scene.motion.slip_table.empty())
    return;
  Creepage creepage{step.xi.value_or(scene.motion.xi), step.eta.value_or(scene.motion.eta),
                    step.phi.value_or(scene.motion.phi), placed ? placed->rolling_radius : 0.0};
  if (scene.motion.speed > 0) {
    const SceneFile::Motion& m = scene.motion;
    const double right = (scene.position.side == "left" ? -1 : 1) / m.speed;
    creepage.velocity = {0, right * m.lateral_velocity, m.vertical_velocity / m.speed};
    creepage.roll = right * m.roll_rate;
    creepage.yaw = right * m.yaw_rate;
  }
  const std::vector<double> x = problem.grid.columns();
  RigidSlip slip = !placed ? planar_slip(creepage, problem.rows, x, step.x.value_or(0.0))
                   : problem.motion == MotionKind::shift
                       ? rigid_shift(placed->reference, creepage, problem.rows, x)
                       : rigid_slip(placed->pair, placed->reference, creepage, problem.rows, x);
  problem.slip_x = std::move(slip.x);
  problem.slip_s = std::move(slip.s);
}

} // namespace bem_contact
