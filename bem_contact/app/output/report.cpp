#include "bem_contact/app/output/report.hpp"

#include "bem_contact/app/output/asked_output.hpp"
#include "bem_contact/app/output/error_text.hpp"
#include "bem_contact/base/fixed_text.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

namespace bem_contact::app {

namespace {

using nlohmann::json;

json certificate_json(const Certificate& c) {
  return {{"pressure", c.pressure},
          {"penetration", c.penetration},
          {"complementarity", c.complementarity},
          {"friction_cone", c.friction_cone},
          {"adhesion", c.adhesion},
          {"slip_direction", c.slip_direction},
          {"force_balance", c.force_balance},
          {"worst", c.worst()},
          {"tolerance", c.tolerance},
          {"holds", c.holds()},
          {"discretisation", c.discretisation < 0 ? json(nullptr) : json(c.discretisation)}};
}

/// null where it was not estimated
json extrapolated_json(const SceneResult& r) {
  if (!r.result.discretisation)
    return nullptr;
  const ContactTotals& e = r.result.discretisation->extrapolated;
  return {{"Fx", e.Fx},
          {"Fy", e.Fy},
          {"Fz", e.Fz},
          {"Mz", e.Mz + r.reference.position.y * e.Fx - r.reference.x * e.Fy},
          {"approach", e.approach}};
}

/// What prescribed forces added to the creepages of the scene; null where none was prescribed.
json creepages_json(const ContactProblem& problem, const ContactResult& result) {
  return {{"xi", problem.force_x ? json(result.creepage_x) : json(nullptr)},
          {"eta", problem.force_s ? json(result.creepage_s) : json(nullptr)}};
}

/// One object a step, [] for steady rolling.
json history_json(const SceneResult& r) {
  json steps = json::array();
  for (const ContactResult& step : r.history) {
    json numbers = {{"creepage_found", creepages_json(r.problem, step)}};
    for (const StepQuantity& q : step_quantities())
      numbers[q.name] = q.value(r, step);
    numbers["converged"] = step.converged;
    steps.push_back(std::move(numbers));
  }
  return steps;
}

/// Decimals that leave five digits of `largest`, at least one.
int decimals_for_five(double largest) {
  return largest > 0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(largest))), 1, 9) : 1;
}

/// "-289.6 +- 12": a quantity with so many decimals, unless its error says more or less.
std::string fixed(const SceneResult& r, const char* name, int decimals) {
  const Quantity& q = quantity(name);
  const double error = q.error ? q.error(r) : unknown_error;
  return fixed_within(q.value(r), error, decimals) + plus_minus(error);
}
/// "191.5 +- 4.2": with so many digits, unless its error says more or less.
std::string digits(const SceneResult& r, const char* name, int most) {
  const Quantity& q = quantity(name);
  const double error = q.error ? q.error(r) : unknown_error;
  return digits_within(q.value(r), error, most) + plus_minus(error);
}
/// The same, always with a sign.
std::string signed_digits(const SceneResult& r, const char* name, int most) {
  return (quantity(name).value(r) < 0 ? "" : "+") + digits(r, name, most);
}

/// Displacement and creepage that were found, and free rolling; "" of a patch.
std::string rolling_text(const SceneResult& r) {
  std::string out;
  if (r.found_lateral) {
    out += fmt::format("the lateral force asked for: at a lateral displacement of {} mm, where Fy "
                       "changes by {:.4g} N per mm",
                       fixed(r, "lateral", 5), r.found_lateral->slope);
    for (const double& other : r.found_lateral->others)
      out += fmt::format("{} about {:.2f} mm", &other == &r.found_lateral->others.front() ? "; also at" : ",",
                         other);
    out += '\n';
  }
  if (r.free_rolling)
    out += fmt::format(
        "creepage xi {:+.5g}; the wheel rolls freely at {} (rolling radius {} mm): {}{} from there\n", r.xi,
        signed_digits(r, "free_rolling_xi", 5), fixed(r, "free_rolling_radius", 4),
        r.xi < r.free_rolling->xi ? "" : "+",
        digits_within(r.xi - r.free_rolling->xi, r.free_rolling->xi_error, 5));
  return out;
}

/// null of a patch, and where it was not looked for
json free_rolling_json(const SceneResult& r) {
  if (!r.free_rolling)
    return nullptr;
  return {{"xi", r.free_rolling->xi},
          {"xi_error", r.free_rolling->xi_error},
          {"rolling_radius", r.free_rolling->rolling_radius},
          {"rolling_radius_error", r.free_rolling->radius_error()},
          {"xi_from_there", r.xi - r.free_rolling->xi}};
}

/// The unit of every name in "quantities", "patches" and "history", and of what only this object has.
json units_json(const SceneResult& r) {
  json units = {{"seconds", "s"},         {"stress", "MPa"},        {"von_mises", "MPa"},
                {"largest_shear", "MPa"}, {"depths", "mm"},         {"s_from", "mm"},
                {"s_to", "mm"},           {"other_laterals", "mm"}, {"lateral_slope", "N/mm"},
                {"xi_from_there", "1"},   {"rolling_radius", "mm"}};
  const auto add = [&](const auto& table) {
    for (const auto& q : table)
      units[q.name] = q.unit.of(r);
  };
  add(quantities());
  add(patch_quantities());
  add(step_quantities());
  return units;
}

/// Every number of the result under the name that it has in all outputs, with its error.
template <class Table, class... Patch>
json quantities_json(const Table& table, const SceneResult& r, Patch... patch) {
  json out = json::object();
  with_errors(table, [&](const std::string& name, const QuantityUnit&, auto value, const char*) {
    out[name] = value(r, patch...);
  });
  return out;
}

/// Of these numbers some, each with its error.
json some_of(const json& numbers, std::initializer_list<const char*> names) {
  json out = json::object();
  for (const char* name : names)
    for (const std::string& key : {std::string(name), error_name(name)})
      if (numbers.contains(key))
        out[key] = numbers[key];
  return out;
}

json patches_json(const SceneResult& r) {
  json patches = json::array();
  for (std::size_t i = 0; i < r.result.patches.size(); ++i) {
    json& patch = patches.emplace_back(quantities_json(patch_quantities(), r, i));
    for (const char* count : {"contact", "adhesion", "slip"}) // whole numbers, not 12.0
      patch[count] = patch[count].get<int>();
  }
  return patches;
}

/// "pmax 437.0 +- 4.2 MPa, area ..." in one line, with what each stands for.
std::string pressure_text(const SceneResult& r) {
  const auto& estimate = r.result.discretisation;
  const double error = estimate ? 100 * estimate->errors.adhesion_share : unknown_error;
  std::string out = fmt::format("pmax {} MPa, area {} mm2", fixed(r, "pmax", 1), digits(r, "area", 4));
  if (r.problem.has_friction())
    out += fmt::format(", {}{} % of it in adhesion", fixed_within(100 * adhesion_share(r.result), error, 1),
                       plus_minus(error));
  return out + "\n";
}

/// The table of patches, each with its errors in a line below. Without friction nothing adheres or slips.
std::string patches_text(const SceneResult& r, double force) {
  const bool friction = r.problem.has_friction(),
             errors = r.result.discretisation && r.result.discretisation->converges;
  const int decimals = decimals_for_five(force);
  const auto line = [](const auto&... cells) {
    return fmt::format("{:>5} {:>11} {:>11} {:>11} {:>10} {:>9} {:>9}", cells...);
  };
  std::string out = line("patch", "Fn N", "Fx N", "Fs N", "approach", "pmax MPa", "area mm2") +
                    fmt::format(" {:>8}{}\n", "contact", friction ? " adhesion   slip" : "");
  for (std::size_t i = 0; i < r.result.patches.size(); ++i) {
    const PatchSummary& p = r.result.patches[i];
    const PatchErrors e = errors ? r.result.discretisation->patches.at(i) : PatchErrors{};
    out +=
        line(i + 1, fixed_within(p.fn, e.fn, decimals), fixed_within(p.fx, e.fx, decimals),
             fixed_within(p.fs, e.fs, decimals), fixed_within(p.approach, e.approach, 5),
             fixed_within(p.pmax, e.pmax, decimals_for_five(1e1 * p.pmax)),
             digits_within(p.area, e.area, 5)) +
        fmt::format(" {:>8}{}\n", p.contact, friction ? fmt::format(" {:>8} {:>6}", p.adhesion, p.slip) : "");
    if (errors)
      out += line("+-", two_digits(e.fn), two_digits(e.fx), two_digits(e.fs), two_digits(e.approach),
                  two_digits(e.pmax), two_digits(e.area)) +
             "\n";
  }
  return out;
}

/// Where all adheres the sum is rounding, and may be below zero.
std::string friction_power_text(const SceneResult& r) {
  return count_elements(r.result).slip > 0 ? digits(r, "friction_power", 4) : "0";
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
    out += fmt::format("friction dissipates {} {}\n", friction_power_text(r),
                       r.problem.motion == MotionKind::shift ? "N mm" : "N mm per mm rolled");
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

json grid_json(const ContactProblem& problem) {
  const ContactGrid& grid = problem.grid;
  return {{"mx", grid.mx},
          {"ms", grid.ms},
          {"dx", grid.dx},
          {"ds", grid.ds},
          {"s_from", problem.rows.front().s},
          {"s_to", problem.rows.back().s}};
}

json solvers_json(const ContactResult& result) {
  return {{"normal", result.normal_solver},
          {"tangential", result.tangential_solver},
          {"outer_iterations", result.outer_iterations},
          {"work", result.work},
          {"outer_rate", result.outer_rate},
          {"creepage_iterations", result.creepage_iterations},
          {"normal_iterations", result.normal_iterations},
          {"tangential_iterations", result.tangential_iterations},
          {"remark", result.remark}};
}

} // namespace

std::string reference_text(const SceneResult& r) {
  return fmt::format("{}reference point: s = {} mm, y = {} mm, z = {} mm, inclination {} degrees\n",
                     r.left ? "left wheel: y, s, Fy, Fs, Mz, eta and phi are counted to the left\n" : "",
                     fixed_text(r.reference.s, 3), fixed_text(r.reference.position.y, 3),
                     fixed_text(r.reference.position.z, 3), fixed_text(degrees(r.reference.delta), 2));
}

json to_json(const SceneResult& r) {
  const json all = quantities_json(quantities(), r);
  json out = {{"program", provenance("bem_contact")},
              {"commit", commit()},
              {"model", name_of(r.model)},
              {"reason", r.reason},
              {"frame", {{"y", r.left ? "to the left" : "to the right"}, {"units", units_json(r)}}},
              {"quantities", all},
              {"converged", r.result.converged},
              {"patches", patches_json(r)},
              {"totals", some_of(all, {"Fx", "Fy", "Fz", "Mz", "Fs", "friction_power"})},
              {"creepage_found", creepages_json(r.problem, r.result)},
              {"other_laterals", r.found_lateral ? json(r.found_lateral->others) : json(nullptr)},
              {"lateral_slope", r.found_lateral ? json(r.found_lateral->slope) : json(nullptr)},
              {"free_rolling", free_rolling_json(r)},
              {"history", history_json(r)},
              {"extrapolated", extrapolated_json(r)},
              {"approach_datum", r.approach_datum},
              {"structure", structure_json(r.structure)},
              {"why_no_errors", why_no_errors(r).empty() ? json(nullptr) : json(why_no_errors(r))},
              {"converges_with_elements",
               r.result.discretisation ? json(r.result.discretisation->converges) : json(nullptr)},
              {"reference",
               {{"s", r.reference.s},
                {"y", r.reference.position.y},
                {"z", r.reference.position.z},
                {"delta", r.reference.delta}}},
              {"grid", grid_json(r.problem)},
              {"certificate", certificate_json(r.result.certificate)},
              {"solvers", solvers_json(r.result)},
              {"stresses", stresses_json(r.stresses)},
              {"warnings", r.warnings},
              {"seconds",
               {{"geometry", r.seconds.geometry},
                {"numbers", r.seconds.numbers},
                {"solve", r.seconds.solve},
                {"check", r.seconds.check},
                {"estimate", r.seconds.estimate},
                {"free_rolling", r.seconds.free_rolling},
                {"search", r.seconds.search},
                {"total", r.seconds.total}}}};
  out.update(some_of(all, {"lateral", "xi", "approach", "pmax", "area", "adhesion_share"}));
  for (const char* error : {"xi_error", "eta_error"})
    out["creepage_found"][error] = all[error];
  return out;
}

std::string to_text(const SceneResult& r) {
  const ContactResult& c = r.result;
  const double force = std::max({std::abs(c.Fx), std::abs(c.Fy), std::abs(c.Fz)});
  std::string out = fmt::format("model: {} ({})\n", name_of(r.model), r.reason);
  out += reference_text(r);
  out += r.result.patches.empty() ? "no contact: all forces are zero\n" : patches_text(r, force);
  out += totals_text(r, force);
  out += rolling_text(r);
  if (const std::string why = why_no_errors(r); !why.empty() && !r.result.patches.empty())
    out += fmt::format("no errors (+-) are stated: {}\n", why);
  if (!r.history.empty())
    out += r.history.size() == 1 ? "one step\n" : fmt::format("the last of {} steps\n", r.history.size());
  out += fmt::format("approach relative to {}\n", r.approach_datum);
  out += structure_text(r.structure);
  out += stresses_text(r.stresses);
  const Certificate& certificate = c.certificate;
  out += fmt::format("certificate: worst violation {:.1e} of {:.0e} allowed, {}", certificate.worst(),
                     certificate.tolerance, certificate.holds() ? "holds" : "DOES NOT HOLD");
  out += certificate.discretisation < 0
             ? "\n"
             : fmt::format("; discretisation error about {:.1f} %\n", 100 * certificate.discretisation);
  if (!r.result.remark.empty())
    out += fmt::format("solver: {}\n", r.result.remark);
  const PhaseSeconds& spent = r.seconds;
  out += fmt::format("seconds: geometry {:.2f}, influence numbers {:.2f}, solve {:.2f}, certificate {:.2f}, "
                     "error estimate {:.2f}{}{}, total {:.2f}\n",
                     spent.geometry, spent.numbers, spent.solve, spent.check, spent.estimate,
                     r.free_rolling ? fmt::format(", free rolling {:.2f}", spent.free_rolling) : "",
                     r.found_lateral ? fmt::format(", search of the displacement {:.2f}", spent.search) : "",
                     spent.total);
  return out;
}

} // namespace bem_contact::app
