#include "bem_contact/scene/motion.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/scene/table_place.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// The first column of a friction table that is by inclination, not by arc length "s".
constexpr const char* by_inclination = "inclination";

std::vector<Motion::Friction> read_friction(const std::filesystem::path& file, const std::string& place) {
  std::vector<Motion::Friction> table;
  std::vector<std::string> columns{place, "mu"};
  const bool falls = csv_columns(file).size() > columns.size();
  if (falls)
    columns.insert(columns.end(), {"falling_friction", "half_slip_velocity"});
  for (const std::vector<double>& row : read_csv(file, columns)) {
    if (row[1] < 0 || (!table.empty() && row[0] <= table.back().at))
      throw InputError(
          fmt::format("The friction table '{}' cannot be used", file.string()),
          fmt::format("its row {} has {} = {:g}, mu = {:g}", table.size() + 1, place, row[0], row[1]),
          fmt::format("Give rows of ascending {} and mu >= 0.", place));
    if (falls && !(row[2] > 0 && row[2] <= row[1] && row[3] > 0))
      throw InputError(
          fmt::format("The friction table '{}' cannot be used", file.string()),
          fmt::format("its row {} has mu = {:g}, falling_friction = {:g}, half_slip_velocity = {:g}",
                      table.size() + 1, row[1], row[2], row[3]),
          "Give 0 < falling_friction <= mu, and a velocity above 0 in mm/s.");
    table.push_back({row[0], row[1], falls ? row[2] : 0, falls ? row[3] : 0});
  }
  return table;
}

/// Linear between the points of the table, constant beyond its ends.
Motion::Friction friction_at(const Motion& motion, const ContactRow& row) {
  const double place = motion.friction_by_inclination ? row.delta : row.s;
  const TablePlace<Motion::Friction> at = place_in(motion.friction_table, place);
  const auto between = [&](double Motion::Friction::*number) {
    return (1 - at.share) * at.before->*number + at.share * at.after->*number;
  };
  using Friction = Motion::Friction;
  return {place, between(&Friction::mu), between(&Friction::falling), between(&Friction::half)};
}

[[noreturn]] void refuse_coefficient(double coefficient, double adhesion, const char* key) {
  throw InputError(fmt::format("{} cannot be {:g}", key, coefficient),
                   fmt::format("friction in adhesion is at most {:g} on these rows", adhesion),
                   "Give a smaller coefficient.");
}

/// A coefficient over that of adhesion. `key` gave it.
double ratio_of(double coefficient, double adhesion, const char* key) {
  if (coefficient > adhesion)
    refuse_coefficient(coefficient, adhesion, key);
  return coefficient / adhesion;
}

std::vector<FallingFriction> laws_of(const Motion& motion, const ContactProblem& problem) {
  const FrictionCoefficients& c = motion.coefficients;
  std::vector<FallingFriction> laws;
  if (!motion.friction_table.empty() && motion.friction_table.front().half > 0) {
    for (const ContactRow& row : problem.rows) {
      const Motion::Friction at = friction_at(motion, row);
      laws.push_back(exponential_friction(at.falling, at.mu - at.falling, at.half));
    }
  } else if (const AskedLaw* asked = asked_law(c)) {
    const double adhesion = problem.largest_friction();
    laws.push_back(asked->law(c, adhesion));
    if (laws.back().ratio > 1)
      refuse_coefficient(*(c.*asked->numbers[0].member), adhesion, asked->numbers[0].key);
  }
  return laws;
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
  const double side = scene.position.side == WheelSide::left ? -1 : 1;
  creepage.yaw = side * scene.track.curvature();
  if (m.speed) {
    const double right = side / *m.speed;
    creepage.velocity = {0, right * m.lateral_velocity, m.vertical_velocity / *m.speed};
    creepage.roll = right * m.roll_rate;
    creepage.yaw += right * m.yaw_rate;
    creepage.roller_speed = m.roller_speed.value_or(0) / *m.speed;
    creepage.wheel_velocity = {m.wheel.forward / *m.speed, right * m.wheel.lateral,
                               m.wheel.vertical / *m.speed};
    creepage.wheel_rates = {right * m.wheel.roll, m.wheel.pitch / *m.speed, right * m.wheel.yaw};
  }
  return creepage;
}

std::optional<Heating> heating_of(const SceneFile::Temperature& asked, double adhesion) {
  if (!asked.flash)
    return std::nullopt;
  Heating out{asked.rail, asked.wheel, asked.rail_share, std::nullopt};
  if (asked.hot_friction)
    out.friction = HotFriction{ratio_of(*asked.hot_friction, adhesion, "temperature.hot_friction"),
                               asked.falls_from, asked.falls_to};
  return out;
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
  motion.coefficients = scene.motion;
  motion.tangential = !scene.motion.frictionless && scene.motion.friction > 0;
  motion.creepage = creepage_of_scene(scene);
  if (!motion.tangential)
    return motion;
  motion.kind = scene.motion.kind;
  motion.radial_displacement = scene.motion.radial_displacement;
  motion.steps = read_steps(scene);
  motion.steps.front().slip = scene.motion.first_shift;
  if (!scene.motion.friction_table.empty()) {
    const std::filesystem::path file = scene.folder / scene.motion.friction_table;
    motion.friction_by_inclination = csv_columns(file).front() == by_inclination;
    motion.friction_table = read_friction(file, motion.friction_by_inclination ? by_inclination : "s");
  }
  motion.speed = scene.motion.speed.value_or(0);
  const bool by_row = !motion.friction_table.empty() && motion.friction_table.front().half > 0;
  if (const AskedLaw* asked = asked_law(scene.motion); by_row && asked)
    throw InputError(
        "There are two laws of falling friction",
        fmt::format("motion.friction_table has one for each row, and {} is given", asked->numbers[0].key),
        "Leave out one of the two.");
  motion.temperature = scene.temperature;
  motion.force_x = scene.load.force_x;
  motion.force_s = scene.load.force_s;
  return motion;
}

void apply_motion(const Motion& motion, double reference_delta, ContactProblem& problem) {
  problem.friction = motion.coefficients.friction;
  problem.tangential = motion.tangential;
  if (!motion.tangential)
    return;
  problem.reference_delta = reference_delta;
  problem.motion = motion.kind;
  if (!motion.friction_table.empty())
    for (const ContactRow& row : problem.rows)
      problem.friction_rows.push_back(friction_at(motion, row).mu);
  const double largest = problem.largest_friction();
  if (const auto& kinetic = motion.coefficients.kinetic_friction)
    problem.kinetic = ratio_of(*kinetic, largest, "motion.kinetic_friction");
  problem.speed = motion.speed;
  problem.falling = laws_of(motion, problem);
  if (const auto& distance = motion.coefficients.friction_memory)
    problem.memory = FrictionMemory{*distance, motion.coefficients.memory_velocity};
  problem.heating = heating_of(motion.temperature, largest);
  problem.force_x = motion.force_x;
  problem.force_s = motion.force_s;
}

} // namespace bem_contact
