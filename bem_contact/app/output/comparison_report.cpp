#include "bem_contact/app/output/comparison_report.hpp"

#include "bem_contact/app/output/report.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/sequence/compared_quantities.hpp"
#include "bem_contact/sequence/models.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <string_view>

namespace bem_contact::app {

namespace {

using namespace record; // of its texts of numbers
using Scale = DifferenceScale;

/// Whether two approaches are the same quantity: they are relative to the same places.
bool same_datum(const SceneResult& a, const SceneResult& b) {
  return a.approach_datum == b.approach_datum;
}

using Value = std::optional<double>;

/// `rounding`: what is smaller is zero.
std::string text_of(Value value, double error, double rounding) {
  if (!value)
    return "-";
  const double size = std::abs(*value);
  return size <= rounding  ? "0"
         : size >= 99999.5 ? fixed_fine(*value, error, 0)
         : size >= 10      ? fixed_fine(*value, error, 2)
                           : digits_fine(*value, error, 5);
}

std::string difference_text(const ComparedQuantity& q, Value difference) {
  return !difference                    ? "-"
         : q.scale == Scale::plain      ? fmt::format("{:+.3g}", *difference)
         : std::abs(*difference) < 5e-5 ? "0.00 %"
                                        : fmt::format("{:+.2f} %", 100 * *difference);
}

/// 1. Forces below this share of their scale are what the solvers leave of zero: the certificate's tolerance.
constexpr double rounding = 1e-6;

constexpr std::size_t label_width = 22, column_width = 14;

std::string cell(const std::string& text) {
  return fmt::format(" {:>{}}", text, column_width);
}

std::string row_label(const std::string& name, const std::string& unit) {
  return fmt::format("{:<{}}", unit.empty() ? name : fmt::format("{:<15}{}", name, unit), label_width);
}

std::string title_of(Model model) {
  return std::string(words_of(model).title);
}

std::string discretisation_text(const SceneResult& r) {
  const double estimate = r.result.trust.certificate.discretisation;
  return estimate < 0 ? "-" : fmt::format("{:.2f} %", 100 * estimate);
}

/// Stated errors, one a model; "" where there is none.
std::string errors_line(const std::vector<double>& errors) {
  std::string out = row_label("", "+-");
  for (const double error : errors)
    out += cell(two_digits(error));
  const bool any = std::ranges::any_of(errors, [](double e) { return e > 0; });
  return any ? out + '\n' : "";
}

/// A column for each model, then one for each difference.
std::string table(const Comparison& c, const std::vector<SceneResult>& results) {
  const SceneResult& reference = results[c.reference];
  std::string out(label_width, ' ');
  for (const Model model : c.models)
    out += cell(title_of(model));
  for (std::size_t i = 0; i < results.size(); ++i)
    if (i != c.reference)
      out += cell(results.size() == 2 ? "difference" : "to " + title_of(c.models[i]));
  out += '\n';
  for (const ComparedQuantity& q : compared_quantities()) {
    if (std::ranges::none_of(results, [&](const SceneResult& r) { return q.of(r).has_value(); }))
      continue;
    out += row_label(q.label, q.unit);
    std::vector<double> errors;
    for (const SceneResult& r : results) {
      const std::optional<Measured> number = q.of(r);
      errors.push_back(number ? number->error : unknown_error);
      const bool plain = q.scale == Scale::plain || q.scale == Scale::own;
      out += cell(text_of(number, errors.back(), plain ? 0 : rounding * q.scale_of(0, r)));
    }
    for (std::size_t i = 0; i < results.size(); ++i)
      if (i != c.reference)
        out += cell(difference_text(q, q.difference(results[i], reference)));
    out += '\n' + errors_line(errors);
  }
  const auto add = [&](const char* name, const char* unit, const auto& of) {
    out += row_label(name, unit);
    for (const SceneResult& r : results)
      out += cell(of(r));
    out += '\n';
  };
  add("patches", "", [](const SceneResult& r) { return fmt::format("{}", r.result.patches.size()); });
  add("certified", "", [](const SceneResult& r) { return certified(r) ? "yes" : "NO"; });
  add("worst violation", "",
      [](const SceneResult& r) { return fmt::format("{:.1e}", r.result.trust.certificate.worst()); });
  add("discretisation (est.)", "", discretisation_text);
  add("seconds", "", [](const SceneResult& r) { return fmt::format("{:.2f}", r.seconds.total); });
  return out;
}

/// Why approaches have no difference; "" where they have.
std::string datum_text(const Comparison& c, const std::vector<SceneResult>& results) {
  const SceneResult& reference = results[c.reference];
  if (std::ranges::all_of(results, [&](const SceneResult& r) { return same_datum(r, reference); }))
    return "";
  std::string out = "Approaches are not compared, because they are relative to different places:\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    out += fmt::format("  {}: {}\n", title_of(c.models[i]), results[i].approach_datum);
  return out;
}

/// What closed forms are predicted to miss.
std::string closed_forms_text(const Comparison& c) {
  std::string out;
  for (const SceneResult& r : c.leading())
    if (is_closed_form(r.choice.model))
      out += fmt::format("{}: {}\n", title_of(r.choice.model), r.choice.why_this_model);
  return out;
}

std::string forces_title(const Comparison& c) {
  const SceneResult& r = c.at_forces[c.reference];
  const bool patch = c.at_position.empty();
  return patch ? fmt::format("At equal normal force, {:.6g} N:\n", r.result.totals.Fz.value)
               : fmt::format("At equal forces on the rail, {}Fy {:.6g} N, Fz {:.6g} N:\n",
                             r.problem.force_x ? fmt::format("Fx {:.6g} N, ", *r.problem.force_x) : "",
                             r.result.totals.Fy.value, r.result.totals.Fz.value);
}

std::string creep_text(const Comparison& c) {
  std::string out =
      "\nFx at equal creepage beyond free rolling, with each model at its position of the table above:\n";
  const CreepForces& forces = c.creep_forces;
  const SceneResult& reference = c.at_forces[c.reference];
  const double scale = friction_bound(reference.problem, reference.result);
  for (std::size_t k = 0; k < forces.creepage.size(); ++k) {
    out += row_label(fmt::format("{:+.1e}", forces.creepage[k]), "N");
    std::string differences;
    std::vector<double> errors;
    for (std::size_t i = 0; i < c.models.size(); ++i) {
      errors.push_back(forces.Fx_error[i][k]);
      out += cell(text_of(forces.Fx[i][k], errors.back(), 0));
      if (i != c.reference)
        differences +=
            cell(fmt::format("{:+.2f} %", 100 * (forces.Fx[c.reference][k] - forces.Fx[i][k]) / scale));
    }
    out += differences + '\n' + errors_line(errors);
  }
  return out;
}

} // namespace

std::string to_text(const Comparison& c) {
  const bool one_set = c.at_forces.empty() || c.at_position.empty();
  const SceneResult& shown = c.leading()[c.reference];
  const ContactGrid& grid = shown.problem.grid;
  std::string out = shown.track.empty() ? "" : shown.track + "\n";
  out += reference_text(shown);
  out += fmt::format(
      "elements of {:g} x {:g} mm; differences: {} less the other, in %: of Fx over the sum of mu "
      "p_n dS, of Fy and Fz over their resultant, of Mz over that sum times sqrt(area / pi), "
      "of pmax, area and T-gamma over the other's value\n\n",
      grid.dx, grid.ds, title_of(c.models[c.reference]));
  if (const std::string text = closed_forms_text(c); !text.empty())
    out += text + "\n";
  if (!c.at_forces.empty())
    out += forces_title(c) + table(c, c.at_forces) + datum_text(c, c.at_forces);
  if (!c.creep_forces.empty())
    out += creep_text(c);
  if (!c.at_position.empty())
    out += fmt::format("{}At equal position, {}Fz {:.6g} N:\n", one_set ? "" : "\n",
                       one_set ? ""
                               : fmt::format("lateral displacement {:g} mm, ",
                                             c.at_position[c.reference].motion.lateral.value_or(0)),
                       c.at_position[c.reference].result.totals.Fz.value) +
           table(c, c.at_position) + datum_text(c, c.at_position);
  return out;
}

} // namespace bem_contact::app
