#include "bem_contact/app/output/report.hpp"

#include "bem_contact/app/output/asked_output.hpp"
#include "bem_contact/app/output/derivatives_text.hpp"
#include "bem_contact/base/fixed_text.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact::app {

namespace {

using namespace record; // of its texts of numbers

/// Decimals that leave five digits of `largest`, at least one.
int decimals_for_five(double largest) {
  return largest > 0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(largest))), 1, 9) : 1;
}

/// "-289.6 +- 12": a quantity with so many decimals, unless its error says more or less.
std::string fixed(const SceneResult& r, const char* name, int decimals) {
  const Measured number = quantity(name).measured(r);
  return fixed_within(number, number.error, decimals) + plus_minus(number.error);
}
/// "191.5 +- 4.2": with so many digits, unless its error says more or less.
std::string digits(const SceneResult& r, const char* name, int most) {
  const Measured number = quantity(name).measured(r);
  return digits_within(number, number.error, most) + plus_minus(number.error);
}
/// The same, always with a sign.
std::string signed_digits(const SceneResult& r, const char* name, int most) {
  return (quantity(name).value(r) < 0 ? "" : "+") + digits(r, name, most);
}

/// The layer between the surfaces, in one line; "" without one.
std::string layer_text(const SceneResult& r) {
  const SurfaceLayer& layer = r.layer;
  std::vector<std::string> parts;
  if (layer.by_row()) {
    const auto [least, most] = std::ranges::minmax(layer.shear);
    parts.push_back(fmt::format("compliance {:.4g} .. {:.4g} mm3/N under shear, by row", least, most));
  } else if (!layer.shear.empty() && layer.shear.front() > 0)
    parts.push_back(fmt::format("compliance {:.4g} mm3/N under shear", layer.shear.front()));
  if (!parts.empty())
    parts.push_back(fmt::format("about {:.2g} of the slope without it", r.layer_slope));
  if (layer.normal > 0)
    parts.push_back(
        fmt::format("{}{:.4g} mm3/N under pressure", parts.empty() ? "compliance " : "", layer.normal));
  if (const auto& yield = r.problem.yield)
    parts.push_back(fmt::format("{}; plastic slip at most {}", yield_text(*yield),
                                digits(r, "largest_plastic_slip", 4) + " mm"));
  return parts.empty() ? "" : fmt::format("layer between the surfaces: {}\n", fmt::join(parts, ", "));
}

/// Displacement and creepage that were found, and free rolling; "" of a patch.
std::string rolling_text(const SceneResult& r) {
  std::string out;
  if (r.motion.found_lateral) {
    out += fmt::format("the lateral force asked for: at a lateral displacement of {} mm, where Fy "
                       "changes by {:.4g} N per mm",
                       fixed(r, "lateral", 5), r.motion.found_lateral->slope);
    for (const double& other : r.motion.found_lateral->others)
      out += fmt::format("{} about {:.2f} mm",
                         &other == &r.motion.found_lateral->others.front() ? "; also at" : ",", other);
    out += '\n';
  }
  if (r.motion.free_rolling)
    out += fmt::format(
        "creepage xi {:+.5g}; the wheel rolls freely at {} (rolling radius {} mm): {}{} from there\n",
        r.motion.xi, signed_digits(r, "free_rolling_xi", 5), fixed(r, "free_rolling_radius", 4),
        r.motion.xi < r.motion.free_rolling->xi ? "" : "+",
        digits_within(r.motion.xi - r.motion.free_rolling->xi, r.motion.free_rolling->xi.error, 5));
  return out;
}

/// "pmax 437.0 +- 4.2 MPa, area ..." in one line, with what each stands for.
std::string pressure_text(const SceneResult& r) {
  const Measured& adhesion = r.result.totals.adhesion_share;
  const double error = 100 * adhesion.error;
  std::string out = fmt::format("pmax {} MPa, area {} mm2", fixed(r, "pmax", 1), digits(r, "area", 4));
  if (r.problem.has_friction())
    out +=
        fmt::format(", {}{} % of it in adhesion", fixed_within(100 * adhesion, error, 1), plus_minus(error));
  return out + "\n";
}

/// The table of patches, each with its errors in a line below. Without friction nothing adheres or slips.
std::string patches_text(const SceneResult& r, double force) {
  const bool friction = r.problem.has_friction(),
             errors = r.result.trust.discretisation && r.result.trust.discretisation->converges;
  const int decimals = decimals_for_five(force);
  const auto line = [](const auto&... cells) {
    return fmt::format("{:>5} {:>11} {:>11} {:>11} {:>10} {:>9} {:>9}", cells...);
  };
  const auto within = [](const Measured& number, int places) {
    return fixed_within(number, number.error, places);
  };
  std::string out = line("patch", "Fn N", "Fx N", "Fs N", "overlap", "pmax MPa", "area mm2") +
                    fmt::format(" {:>8}{}\n", "contact", friction ? " adhesion   slip" : "");
  for (std::size_t i = 0; i < r.result.patches.size(); ++i) {
    const PatchSummary& p = r.result.patches[i];
    out +=
        line(i + 1, within(p.fn, decimals), within(p.fx, decimals), within(p.fs, decimals),
             within(p.overlap, 5), within(p.pmax, decimals_for_five(1e1 * p.pmax)),
             digits_within(p.area, p.area.error, 5)) +
        fmt::format(" {:>8}{}\n", p.contact, friction ? fmt::format(" {:>8} {:>6}", p.adhesion, p.slip) : "");
    if (errors)
      out += line("+-", two_digits(p.fn.error), two_digits(p.fx.error), two_digits(p.fs.error),
                  two_digits(p.overlap.error), two_digits(p.pmax.error), two_digits(p.area.error)) +
             "\n";
  }
  return out;
}

/// Where all adheres the sum may be rounding, and below zero.
std::string t_gamma_text(const SceneResult& r) {
  const Measured& power = r.result.totals.T_gamma;
  return count_elements(r.result).slip > 0 || power > power.error ? digits(r, "T_gamma", 4) : "0";
}

/// Each total with its error. `force`: the largest, whose digits all have.
std::string totals_text(const SceneResult& r, double force) {
  const ContactResult& c = r.result;
  const int decimals = decimals_for_five(force);
  std::string out = fmt::format("on the rail{}: Fx {} N, Fy {} N, Fz {} N, Mz {} N mm; approach {} mm\n",
                                r.problem.plane_strain() ? ", forces and area per mm of x" : "",
                                fixed(r, "Fx", decimals), fixed(r, "Fy", decimals), fixed(r, "Fz", decimals),
                                fixed(r, "Mz", decimals), fixed(r, "approach", 5));
  if (!c.patches.empty())
    out += pressure_text(r);
  if (r.problem.has_friction())
    out += fmt::format(fmt::runtime(r.problem.motion == MotionKind::shift
                                        ? "work of friction {} N mm\n"
                                        : "T-gamma (work of friction per rolled length) {} N\n"),
                       t_gamma_text(r));
  if (c.temperatures)
    out += fmt::format("flash temperature: rail at most {}, wheel {} degrees C\n", fixed(r, "Tmax_rail", 1),
                       fixed(r, "Tmax_wheel", 1));
  if (r.problem.force_x || r.problem.force_s)
    out += fmt::format(fmt::runtime(r.problem.motion == MotionKind::shift
                                        ? "shift found for the shear forces: along x {} mm, along s {} mm\n"
                                        : "creepages found for the shear forces: xi {}, eta {}\n"),
                       signed_digits(r, "creepage_x", 6), signed_digits(r, "creepage_s", 6));
  return out;
}

/// Why this model. On a plane the half-space is no approximation, and the long reason says nothing.
std::string reason_text(const SceneResult& r) {
  const std::vector<ContactRow>& rows = r.problem.rows;
  const bool plane =
      std::ranges::all_of(rows, [&](const ContactRow& row) { return row.delta == rows.front().delta; });
  return !is_closed_form(r.choice.model) && !depends_on_both_rows(r.choice.model) && plane &&
                 r.choice.by_turn && r.choice.enough
             ? "the surfaces are flat"
             : r.choice.why_this_model;
}

/// "certified: yes, ..."
std::string certified_text(const SceneResult& r) {
  const Certificate& c = r.result.trust.certificate;
  const std::string why = why_not_certified(r);
  return fmt::format(
      "certified: {}{}\n",
      why.empty() ? fmt::format("yes, worst violation {:.1e} of {:.0e} allowed", c.worst(), c.tolerance)
                  : "NO, " + why,
      c.discretisation < 0 ? ""
                           : fmt::format("; discretisation error about {:.1f} %", 100 * c.discretisation));
}

} // namespace

std::string reference_text(const SceneResult& r) {
  return fmt::format(
      "{}reference point: s = {} mm, y = {} mm, z = {} mm, inclination {} degrees\n",
      r.motion.left ? "left wheel: y, s, Fy, Fs, Mz, eta and phi are counted to the left\n" : "",
      fixed_text(r.motion.reference.s, 3), fixed_text(r.motion.reference.position.y, 3),
      fixed_text(r.motion.reference.position.z, 3), fixed_text(degrees(r.motion.reference.delta), 2));
}

std::string to_text(const SceneResult& r) {
  const ContactResult& c = r.result;
  const double force = std::max({std::abs(c.totals.Fx), std::abs(c.totals.Fy), std::abs(c.totals.Fz)});
  std::string out = r.track.empty() ? "" : r.track + "\n";
  out += fmt::format("model: {} ({})\n", name_of(r.choice.model), reason_text(r));
  out += reference_text(r);
  out += r.result.patches.empty() ? "no contact: all forces are zero\n" : patches_text(r, force);
  out += totals_text(r, force);
  out += layer_text(r);
  out += rolling_text(r);
  out += derivatives_text(r);
  if (const std::string why = why_no_errors(r); !why.empty() && !r.result.patches.empty())
    out += fmt::format("no errors (+-) are stated: {}\n", why);
  if (!r.history.empty())
    out += r.history.size() == 1 ? "one step\n" : fmt::format("the last of {} steps\n", r.history.size());
  if (r.conformity)
    out += conformity_text(*r.conformity, "the first touch") + "\n";
  out += fmt::format("approach relative to {}\n", r.approach_datum);
  out += structure_text(r.structure);
  out += stresses_text(r.stresses);
  out += certified_text(r);
  if (!r.result.trust.solver_note.empty())
    out += fmt::format("solver: {}\n", r.result.trust.solver_note);
  const PhaseSeconds& spent = r.seconds;
  out += fmt::format("seconds: geometry {:.2f}, influence numbers {:.2f}, solve {:.2f}, certificate {:.2f}, "
                     "error estimate {:.2f}{}{}, total {:.2f}\n",
                     spent.geometry, spent.numbers, spent.solve, spent.check, spent.estimate,
                     r.motion.free_rolling ? fmt::format(", free rolling {:.2f}", spent.free_rolling) : "",
                     r.motion.found_lateral ? fmt::format(", search of the displacement {:.2f}", spent.search)
                                            : "",
                     spent.total);
  return out;
}

} // namespace bem_contact::app
