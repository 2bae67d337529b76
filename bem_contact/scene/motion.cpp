#include "bem_contact/scene/motion.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

std::vector<Motion::Friction> read_friction(const std::filesystem::path& file) {
  std::vector<Motion::Friction> table;
  for (const std::vector<double>& row : read_csv(file, {"s", "mu"})) {
    if (row[1] < 0 || (!table.empty() && row[0] <= table.back().s))
      throw InputError(fmt::format("The table '{}' is no friction coefficient", file.string()),
                       fmt::format("its row {} has s = {:g}, mu = {:g}", table.size() + 1, row[0], row[1]),
                       "Give rows of ascending s and mu >= 0.");
    table.push_back({row[0], row[1]});
  }
  return table;
}

/// Linear between the points of the table, constant beyond its ends.
double friction_at(const std::vector<Motion::Friction>& table, double s) {
  const auto after = std::ranges::find_if(table, [s](const auto& point) { return point.s > s; });
  if (after == table.begin() || after == table.end())
    return after == table.begin() ? table.front().mu : table.back().mu;
  const auto before = std::prev(after);
  const double share = (s - before->s) / (after->s - before->s);
  return (1 - share) * before->mu + share * after->mu;
}

using Member = std::optional<double> MotionStep::*;

/// The member that a column of the step table sets. Throws InputError for a column that does not belong
/// there.
Member member_of(const std::string& name, const std::vector<std::string>& columns, const SceneFile& scene) {
  const std::pair<const char*, Member> known[] = {
      {"load", &MotionStep::load}, {"xi", &MotionStep::xi},           {"eta", &MotionStep::eta},
      {"phi", &MotionStep::phi},   {"force_x", &MotionStep::force_x}, {"force_s", &MotionStep::force_s},
      {"x", &MotionStep::x}};
  const SceneFile::Motion& motion = scene.motion;
  const std::string file = (scene.folder / motion.step_table).string();
  const auto found = std::ranges::find(known, name, [](const auto& k) { return std::string(k.first); });
  if (found == std::end(known) || std::ranges::count(columns, name) > 1)
    throw InputError(fmt::format("The table '{}' has other columns", file),
                     fmt::format("'{}' is {}", name, found == std::end(known) ? "not known" : "there twice"),
                     "Columns are some of load, xi, eta, phi, force_x, force_s, x.");
  if ((name == "force_x" && !scene.load.force_x) || (name == "force_s" && !scene.load.force_s))
    throw InputError(fmt::format("The table '{}' has forces that are not prescribed", file),
                     fmt::format("load.{} is not given", name), "Give it, with any value.");
  if ((name == "xi" || name == "eta" || name == "phi") && !motion.slip_table.empty())
    throw InputError(fmt::format("The table '{}' has creepages", file),
                     "motion.slip_table gives the rigid slip", "Leave out one of the two.");
  if ((name == "xi" && motion.xi != 0) || (name == "eta" && motion.eta != 0) ||
      (name == "phi" && motion.phi != 0))
    throw InputError(fmt::format("The table '{}' has the creepage {}", file, name),
                     fmt::format("motion.{} is given too", name), "Leave out one of the two.");
  if (name == "x" &&
      (motion.kind != MotionKind::shift || scene.kind != SceneKind::patch || !scene.gap.table.empty()))
    throw InputError(fmt::format("The table '{}' moves a contact that cannot be moved", file),
                     "column x is for shifts of a patch whose gap is given by coefficients", "Leave it out.");
  return found->second;
}

std::vector<MotionStep> read_steps(const SceneFile& scene) {
  if (scene.motion.step_table.empty())
    return std::vector<MotionStep>(scene.motion.steps);
  const std::filesystem::path file = scene.folder / scene.motion.step_table;
  const std::vector<std::string> columns = csv_columns(file);
  std::vector<Member> members;
  for (const std::string& name : columns)
    members.push_back(member_of(name, columns, scene));
  std::vector<MotionStep> steps;
  for (const std::vector<double>& row : read_csv(file, columns)) {
    MotionStep step;
    for (std::size_t i = 0; i < members.size(); ++i)
      step.*members[i] = row[i];
    steps.push_back(step);
  }
  return steps;
}

/// Creepages and the wheelset's velocities over its speed; those to the right change sign for a left wheel.
Creepage creepage_of_scene(const SceneFile& scene) {
  const SceneFile::Motion& m = scene.motion;
  Creepage creepage{m.xi, m.eta, m.phi};
  if (m.speed) {
    const double right = (scene.position.side == WheelSide::left ? -1 : 1) / *m.speed;
    creepage.velocity = {0, right * m.lateral_velocity, m.vertical_velocity / *m.speed};
    creepage.roll = right * m.roll_rate;
    creepage.yaw = right * m.yaw_rate;
  }
  return creepage;
}

} // namespace

Creepage Motion::creepage_of(const MotionStep& step) const {
  Creepage out = creepage;
  out.xi = step.xi.value_or(out.xi);
  out.eta = step.eta.value_or(out.eta);
  out.phi = step.phi.value_or(out.phi);
  return out;
}

Motion read_motion(const SceneFile& scene) {
  Motion motion;
  motion.friction = scene.motion.friction;
  motion.tangential = !scene.motion.frictionless && scene.motion.friction > 0;
  motion.creepage = creepage_of_scene(scene);
  if (!motion.tangential)
    return motion;
  motion.kind = scene.motion.kind;
  motion.radial_displacement = scene.motion.radial_displacement;
  motion.steps = read_steps(scene);
  if (!scene.motion.friction_table.empty())
    motion.friction_table = read_friction(scene.folder / scene.motion.friction_table);
  motion.kinetic = scene.motion.kinetic_friction;
  motion.force_x = scene.load.force_x;
  motion.force_s = scene.load.force_s;
  return motion;
}

void apply_motion(const Motion& motion, double reference_delta, ContactProblem& problem) {
  problem.friction = motion.friction;
  problem.tangential = motion.tangential;
  if (!motion.tangential)
    return;
  problem.reference_delta = reference_delta;
  problem.motion = motion.kind;
  if (!motion.friction_table.empty())
    for (const ContactRow& row : problem.rows)
      problem.friction_rows.push_back(friction_at(motion.friction_table, row.s));
  const double largest = problem.largest_friction();
  if (motion.kinetic.value_or(0) > largest)
    throw InputError(fmt::format("Kinetic friction cannot be {:g}", *motion.kinetic),
                     fmt::format("friction in adhesion is at most {:g} on these rows", largest),
                     "Give a smaller motion.kinetic_friction.");
  if (motion.kinetic.value_or(0) > 0)
    problem.kinetic = *motion.kinetic / largest;
  problem.force_x = motion.force_x;
  problem.force_s = motion.force_s;
}

} // namespace bem_contact
