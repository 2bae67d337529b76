#include "bem_contact/sequence/result_warnings.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/steels.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/settings.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace bem_contact {

namespace {

/// 1. Elements across a patch below which they are said to be too large: each is a fifth of it.
constexpr int fewest_across = 5;
/// 1. A patch that bears less than this share of the largest one's force has no such warning.
constexpr double minor_patch = 0.05;
/// MPa. Least yield strength of wheels of grade ER7 (EN 13262); rails of grade R260 have about the same.
constexpr double yield_strength = 520.0;
/// 1. The mean pressure of a fully plastic contact is about so many times the yield strength (Tabor 1951).
constexpr double yield_factor = 3.0;
/// MPa. A body with a smaller Young's modulus is not of steel, and its strength is not known.
constexpr double least_steel_modulus = 1.5e5;
/// 1. A larger creepage is probably a mistake: a wheel that slides or spins as a whole.
constexpr double largest_creepage = 0.1;
/// mm. Contact lower than this below the top of the rail is beyond its head: gauge is measured 14 mm below
/// the top, and worn flanges touch little lower.
constexpr double head_depth = 18.0;

/// What a limit of the pressure would give.
std::string limit_text(const ContactResult& r) {
  const Steel& usual = steel_named("R260");
  const double limit = usual.indentation_pressure();
  double pressed = 0;
  for (const PatchSummary& patch : r.patches)
    pressed += patch.fn;
  return fmt::format("rail.material.limit_pressure bounds the pressure (the hardness of {} is {:.0f} MPa{})",
                     usual.name, limit,
                     r.totals.pmax > limit ? fmt::format(", and under it more than {:.0f} mm2 are in contact",
                                                         std::max<double>(pressed / limit, r.totals.area))
                                           : "");
}

void warn_of_yield(const ContactSetup& setup, const ContactResult& r, Warnings& out) {
  const double softer = std::min(setup.rail.material.young(), setup.wheel.material.young()),
               pmax = r.totals.pmax;
  if (softer > least_steel_modulus && pmax > yield_factor * yield_strength && !setup.limit_pressure())
    out.add(WarningKind::yield,
            fmt::format("the largest pressure is above three times the yield strength of usual steels "
                        "({:.0f} MPa, 3 x {:g} MPa) Take it as an elastic result: steel flows there. {}.",
                        pmax, double(yield_strength), limit_text(r)));
}

/// The mean over the contact of the rigid slip, in which yaw and spin are. A shift has lengths in place of
/// creepages.
void warn_of_creepage(const SceneResult& r, Warnings& out) {
  const ContactProblem& problem = r.problem;
  if (!problem.has_friction() || problem.motion == MotionKind::shift)
    return;
  double x = 0, s = 0;
  int contact = 0;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (r.result.pn[i] > 0) {
      x += problem.slip_x[i];
      s += problem.slip_s[i];
      ++contact;
    }
  const double xi = r.result.totals.creepage_x + x / std::max(contact, 1);
  const double eta = r.result.totals.creepage_s + s / std::max(contact, 1);
  if (std::hypot(xi, eta) > largest_creepage)
    out.add(WarningKind::large_creepage,
            fmt::format("the creepage is above 10 % (along x {:.3g}, along s {:.3g}). Check motion and "
                        "position: creepages are ratios, and 0.001 is usual.",
                        xi, eta));
}

/// First and last element of a set, along x and s.
struct Span {
  int first_x = std::numeric_limits<int>::max(), last_x = -1, first_s = first_x, last_s = -1;

  int along_x() const { return last_x - first_x + 1; }
  int along_s() const { return last_s - first_s + 1; }
};

Span span_of(const std::vector<int>& elements, int mx) {
  Span span;
  for (const int i : elements) {
    const int ix = i % mx, is = i / mx;
    span.first_x = std::min(span.first_x, ix), span.last_x = std::max(span.last_x, ix);
    span.first_s = std::min(span.first_s, is), span.last_s = std::max(span.last_s, is);
  }
  return span;
}

/// Patches that bear little of the load are left out: they matter little.
void warn_of_large_elements(const SceneResult& r, Warnings& out) {
  const ContactGrid& grid = r.problem.grid;
  const std::vector<std::vector<int>> elements = patch_elements(r.problem, r.result);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PatchSummary& patch = r.result.patches[i];
    if (patch.fn < minor_patch * r.result.patches.front().fn)
      continue;
    const Span span = span_of(elements[i], grid.mx);
    const int x = span.along_x(), s = span.along_s();
    const bool coarse_x = grid.mx > 1 && x<fewest_across, coarse_s = grid.ms> 1 && s < fewest_across;
    if (coarse_x || coarse_s)
      out.add(WarningKind::large_elements,
              fmt::format("the elements are too large for this contact (patch {}: {:.3g} of {:.3g} mm "
                          "along {}). Give smaller grid.dx and grid.ds.",
                          i + 1, coarse_x ? grid.dx : grid.ds, coarse_x ? x * grid.dx : s * grid.ds,
                          coarse_x ? "x" : "s"));
    else if (grid.mx > 1 && grid.ms > 1 && patch.contact < least_elements_of_patch)
      out.add(WarningKind::large_elements,
              fmt::format("the elements are too large for this contact (patch {} has {}, {} are needed "
                          "for errors of a few per cent). Give smaller grid.dx and grid.ds.",
                          i + 1, patch.contact, int(least_elements_of_patch)));
  }
}

void warn_of_head(const ContactCase& asked, const SceneResult& r, Warnings& out) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed || !asked.estimate || asked.estimate->slices.empty() || r.result.patches.empty())
    return;
  double top = std::numeric_limits<double>::infinity(), deepest = -top;
  for (const RailSlice& slice : asked.estimate->slices)
    top = std::min(top, slice.position.z);
  bool rail_end = false, wheel_end = false;
  const auto near = [&](const TabulatedProfile& profile, double s) {
    return s < profile.s_begin() + r.problem.grid.ds || s > profile.s_end() - r.problem.grid.ds;
  };
  for (int i = 0; i < r.problem.grid.size(); ++i) {
    if (r.result.state[i] == ElementState::exterior)
      continue;
    const int is = i / r.problem.grid.mx;
    deepest = std::max(deepest, r.problem.rows[is].position.z);
    rail_end = rail_end || near(placed->pair.rail, r.problem.rows[is].s);
    wheel_end = wheel_end || (!r.bodies.wheel_s.empty() && near(placed->pair.wheel, r.bodies.wheel_s[is]));
  }
  if (rail_end || wheel_end)
    out.add(WarningKind::end_of_profile,
            fmt::format("the contact reaches the end of the {}'s profile ({:.1f} mm below the top of the "
                        "rail). Give a longer profile, or check position.lateral.",
                        rail_end ? "rail" : "wheel", deepest - top));
  else if (deepest - top > head_depth)
    out.add(
        WarningKind::beyond_head,
        fmt::format("the contact lies beyond the rail's head ({:.1f} mm below the top of the rail; "
                    "contact is usual to {:g} mm). Check position.lateral and the frames of the profiles.",
                    deepest - top, double(head_depth)));
}

/// A jump of friction has no limit as elements shrink: which element slips first decides.
void warn_of_kinetic_friction(const ContactProblem& problem, Warnings& out) {
  if (problem.kinetic < 1)
    out.add(
        WarningKind::friction_jump,
        "motion.kinetic_friction: friction that drops at once gives results that depend on the size of the "
        "elements. Try another size, or let it fall with the slip velocity (motion.falling_friction).");
}

void warn_of_convergence(const ContactResult& r, Warnings& out) {
  if (r.trust.discretisation && !r.trust.discretisation->converges)
    out.add(WarningKind::no_convergence,
            fmt::format("the pressure does not converge with the size of the elements ({}). {}",
                        why_not_convergent(r),
                        r.trust.discretisation->rough
                            ? "Smooth the profiles (rail.smoothing, wheel.smoothing)."
                            : "Give smaller grid.dx and grid.ds, or smooth a profile that is noisy."));
}

} // namespace

Warnings result_warnings(const ContactCase& asked, const SceneResult& r) {
  Warnings out;
  if (!r.result.certified())
    return out;
  warn_of_yield(asked.setup, r.result, out);
  warn_of_creepage(r, out);
  warn_of_head(asked, r, out);
  warn_of_kinetic_friction(r.problem, out);
  warn_of_convergence(r.result, out);
  if (!is_closed_form(r.choice.model) && !r.result.trust.touches_border)
    warn_of_large_elements(r, out);
  return out;
}

void warn_of_model(SceneResult& out) {
  if (!out.choice.enough)
    out.warnings.add(WarningKind::model_needed,
                     "the finite-element model is needed here: " + out.choice.why_this_model);
}

void take_choice(const ModelChoice& chosen, SceneResult& out) {
  const Model model = out.choice.model;
  out.choice = chosen;
  out.choice.model = model;
  warn_of_model(out);
}

void warn_of_accuracy(const SceneFile::Grid& asked, const std::string& why, SceneResult& out) {
  const double error = asked_error(asked, out.result);
  if (!asked.accuracy || !out.result.certified() || error <= *asked.accuracy)
    return;
  out.warnings.add(
      WarningKind::missed_accuracy,
      fmt::format("the estimated discretisation error reached is {:.2g} %, above the {:.2g} % that "
                  "grid.accuracy asks for ({} elements in contact; {})",
                  100 * error, 100 * *asked.accuracy, count_elements(out.result).contact, why));
}

void warn_of_lateral(const SceneFile& asked, std::optional<double> at_start, SceneResult& out) {
  const LateralPosition& found = *out.motion.found_lateral;
  if (std::isnan(found.lateral.error)) {
    const double likely_error = lateral::uneven * std::hypot(out.result.totals.Fy, out.result.totals.Fz);
    if (likely_error > lateral::unsure * std::abs(found.slope))
      out.warnings.add(
          WarningKind::unsure_position,
          fmt::format(
              "load.force_y says little of the lateral displacement (Fy changes by {:.3g} N per mm at "
              "{:.2f} mm, and its error is not known). Give position.lateral without load.force_y, or "
              "smaller elements.",
              found.slope, found.lateral.value));
    return;
  }
  if (found.lateral.error <= lateral::unsure)
    return;
  const double force_error = out.result.totals.Fy.error;
  out.warnings.add(
      WarningKind::unsure_position,
      fmt::format(
          "load.force_y says little of the lateral displacement (Fy is known to {:.2g} N and changes "
          "by {:.3g} N per "
          "mm: {:.2f} +- {:.2g} mm). Give position.lateral without load.force_y, or smaller elements.",
          force_error, found.slope, found.lateral.value, found.lateral.error));
  const double start = asked.position.lateral;
  if (at_start && std::abs(*at_start - *asked.load.force_y) <= force_error &&
      std::abs(start - found.lateral) > found.lateral.error)
    out.warnings.add(WarningKind::other_position,
                     fmt::format("position.lateral bears load.force_y within its error, too (Fy {:.6g} N at "
                                 "{:.2f} mm). Solve it without load.force_y if it is meant.",
                                 *at_start, start));
}

} // namespace bem_contact
