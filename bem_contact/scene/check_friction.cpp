#include "bem_contact/scene/check_friction.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

void check_falling(const SceneFile::Motion& m, const Schema& s) {
  if (m.falling_friction && m.polach_a)
    s.refuse("motion.polach_a", "motion.falling_friction is given too", "Give one law of friction.");
  if (m.falling_friction && !m.half_slip_velocity)
    s.refuse("motion.falling_friction", "motion.half_slip_velocity is not given",
             "Give the slip velocity at which half of the difference is left, in mm/s.");
  if (m.polach_a.has_value() != m.polach_b.has_value())
    s.refuse(m.polach_a ? "motion.polach_a" : "motion.polach_b", "Polach's law has both A and B",
             "Give motion.polach_a and motion.polach_b.");
  if (m.kinetic_friction && (m.falling_friction || m.polach_a))
    s.refuse("motion.kinetic_friction", "friction falls with the slip velocity too",
             "Give one law of friction.");
  if (!m.falling_friction && !m.polach_a)
    return;
  const char* key = m.falling_friction ? "motion.falling_friction" : "motion.polach_a";
  if (m.kind == MotionKind::shift)
    s.refuse(key, "a shift has no slip velocity", "Choose rolling, or give motion.kinetic_friction.");
  if (!m.speed)
    s.refuse(key, "the slip velocity is the slip times motion.speed, which is not given",
             "Give motion.speed in mm/s.");
  if (m.friction_table.empty() && m.falling_friction.value_or(0) > m.friction)
    s.refuse(key, fmt::format("friction in adhesion is only {}", m.friction), "Give a smaller coefficient.");
}

void check_temperature(const SceneFile& f, const Schema& s) {
  const SceneFile::Temperature& t = f.temperature;
  if (!t.flash && t.hot_friction)
    s.refuse("temperature.hot_friction", "temperatures are not asked for", "Set temperature.flash = true.");
  if (!t.flash || f.motion.frictionless)
    return;
  if (f.motion.kind != MotionKind::steady)
    s.refuse("temperature.flash", "the temperatures are those of steady rolling",
             "Choose motion.kind = \"steady\", or leave it out.");
  if (!f.motion.speed)
    s.refuse("temperature.flash", "heat is proportional to the speed, and motion.speed is not given",
             "Give motion.speed in mm/s.");
  if (!t.hot_friction)
    return;
  if (t.falls_to <= t.falls_from)
    s.refuse("temperature.falls_to",
             fmt::format("friction begins to fall at {} degrees C (temperature.falls_from)", t.falls_from),
             "Give a higher temperature.");
  if (f.motion.kinetic_friction)
    s.refuse("temperature.hot_friction", "motion.kinetic_friction is given too", "Give one law of friction.");
  if (f.motion.friction_table.empty() && *t.hot_friction > f.motion.friction)
    s.refuse("temperature.hot_friction", fmt::format("friction is only {}", f.motion.friction),
             "Give a smaller coefficient.");
}

} // namespace

void check_friction(const SceneFile& file, const Schema& schema) {
  if (!file.motion.frictionless)
    check_falling(file.motion, schema);
  check_temperature(file, schema);
}

} // namespace bem_contact
