#include "bem_contact/app/output/comparison_report.hpp"

#include "bem_contact/app/output/error_text.hpp"
#include "bem_contact/app/output/report.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string_view>

namespace bem_contact::app {

namespace {

using nlohmann::json;

/// What a difference is divided by, and how it is printed.
enum class Scale { own, resultant, friction, friction_moment, plain };

double scale_of(Scale scale, double own, const SceneResult& r) {
  return scale == Scale::own         ? std::abs(own)
         : scale == Scale::resultant ? std::hypot(r.result.Fy, r.result.Fz)
         : scale == Scale::friction  ? friction_bound(r.problem, r.result)
         : scale == Scale::friction_moment
             ? friction_bound(r.problem, r.result) * std::sqrt(contact_area(r.result) / std::numbers::pi)
             : 1;
}

using Value = std::optional<double>;

/// One line of a table.
struct ComparedQuantity {
  const char *label, *unit;
  std::string_view name; ///< of the quantity
  Scale scale;
  bool friction = false; ///< without friction there is none

  Value of(const SceneResult& r) const {
    const double value = quantity(name).value(r);
    return std::isnan(value) || (friction && !r.problem.has_friction()) ? Value() : Value(value);
  }
};

constexpr std::string_view approach_name = "approach";
constexpr ComparedQuantity compared[] = {
    {"pmax", "MPa", "pmax", Scale::own},
    {"area", "mm2", "area", Scale::own},
    {"approach", "mm", approach_name, Scale::own},
    {"Fx", "N", "Fx", Scale::friction, true},
    {"Fy", "N", "Fy", Scale::resultant},
    {"Fz", "N", "Fz", Scale::resultant},
    {"Mz", "N mm", "Mz", Scale::friction_moment, true},
    {"friction power", "N", "friction_power", Scale::own, true},
    {"adhesion", "share", "adhesion_share", Scale::plain, true},
    {"free rolling", "xi", "free_rolling_xi", Scale::plain},
    {"rolling radius", "mm", "free_rolling_radius", Scale::plain},
    {"lateral", "mm", "lateral", Scale::plain},
};

/// Whether two approaches are the same quantity: they are relative to the same places.
bool same_datum(const SceneResult& a, const SceneResult& b) {
  return a.approach_datum == b.approach_datum;
}

/// By how much the reference's number is larger than the model's, over its scale. Nothing where one of them
/// is missing or the scale is zero.
Value difference(const ComparedQuantity& q, const SceneResult& model, const SceneResult& reference) {
  const Value a = q.of(model), b = q.of(reference);
  if (!a || !b || (q.name == approach_name && !same_datum(model, reference)))
    return std::nullopt;
  const double scale = scale_of(q.scale, *a, model);
  return scale > 0 ? Value((*b - *a) / scale) : std::nullopt;
}

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
  constexpr const char* titles[] = {"Hertz", "half-space", "tangent plane", "FEM"};
  static_assert(std::size(titles) == EnumNames<Model>::names.size());
  return titles[static_cast<std::size_t>(model)];
}

std::string discretisation_text(const SceneResult& r) {
  const double estimate = r.result.certificate.discretisation;
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

double error_of(const ComparedQuantity& q, const SceneResult& r) {
  const auto error = quantity(q.name).error;
  return error && q.of(r) ? error(r) : unknown_error;
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
  for (const ComparedQuantity& q : compared) {
    if (std::ranges::none_of(results, [&](const SceneResult& r) { return q.of(r).has_value(); }))
      continue;
    out += row_label(q.label, q.unit);
    std::vector<double> errors;
    for (const SceneResult& r : results) {
      errors.push_back(error_of(q, r));
      const bool plain = q.scale == Scale::plain || q.scale == Scale::own;
      out += cell(text_of(q.of(r), errors.back(), plain ? 0 : rounding * scale_of(q.scale, 0, r)));
    }
    for (std::size_t i = 0; i < results.size(); ++i)
      if (i != c.reference)
        out += cell(difference_text(q, difference(q, results[i], reference)));
    out += '\n' + errors_line(errors);
  }
  const auto add = [&](const char* name, const char* unit, const auto& of) {
    out += row_label(name, unit);
    for (const SceneResult& r : results)
      out += cell(of(r));
    out += '\n';
  };
  add("patches", "", [](const SceneResult& r) { return fmt::format("{}", r.result.patches.size()); });
  add("certificate", "worst",
      [](const SceneResult& r) { return fmt::format("{:.1e}", r.result.certificate.worst()); });
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

std::string forces_title(const Comparison& c) {
  const SceneResult& r = c.at_forces[c.reference];
  const bool patch = c.at_position.empty();
  return patch ? fmt::format("At equal normal force, {:.6g} N:\n", r.result.Fz)
               : fmt::format("At equal forces on the rail, {}Fy {:.6g} N, Fz {:.6g} N:\n",
                             r.problem.force_x ? fmt::format("Fx {:.6g} N, ", *r.problem.force_x) : "",
                             r.result.Fy, r.result.Fz);
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

json set_json(const Comparison& c, const std::vector<SceneResult>& results) {
  if (results.empty())
    return nullptr;
  json set = json::object(), differences = json::object();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string name(name_of(c.models[i]));
    set[name] = to_json(results[i]);
    if (i == c.reference)
      continue;
    for (const ComparedQuantity& q : compared) {
      const Value d = difference(q, results[i], results[c.reference]);
      differences[name][std::string(q.name)] = d ? json(*d) : json(nullptr);
    }
  }
  set["difference"] = differences;
  return set;
}

} // namespace

json to_json(const Comparison& c) {
  json models = json::array(), creep = json::array();
  for (const Model model : c.models)
    models.push_back(name_of(model));
  for (std::size_t k = 0; k < c.creep_forces.creepage.size(); ++k) {
    json& at = creep.emplace_back(json{{"xi_from_free_rolling", c.creep_forces.creepage[k]}});
    for (std::size_t i = 0; i < c.models.size(); ++i) {
      const std::string name(name_of(c.models[i]));
      at["Fx"][name] = c.creep_forces.Fx[i][k];
      at["Fx_error"][name] = c.creep_forces.Fx_error[i][k];
    }
  }
  return {{"models", models},
          {"reference", name_of(c.models[c.reference])},
          {"at_equal_forces", set_json(c, c.at_forces)},
          {"creep_forces", creep},
          {"at_equal_position", set_json(c, c.at_position)}};
}

std::string to_text(const Comparison& c) {
  const bool one_set = c.at_forces.empty() || c.at_position.empty();
  const SceneResult& shown = c.leading()[c.reference];
  const ContactGrid& grid = shown.problem.grid;
  std::string out = reference_text(shown);
  out += fmt::format(
      "elements of {:g} x {:g} mm; differences: {} less the other, in %: of Fx over the sum of mu "
      "p_n dS, of Fy and Fz over their resultant, of Mz over that sum times sqrt(area / pi), "
      "of pmax, area and friction power over the other's value\n\n",
      grid.dx, grid.ds, title_of(c.models[c.reference]));
  if (!c.at_forces.empty())
    out += forces_title(c) + table(c, c.at_forces) + datum_text(c, c.at_forces);
  if (!c.creep_forces.empty())
    out += creep_text(c);
  if (!c.at_position.empty())
    out += fmt::format("{}At equal position, {}Fz {:.6g} N:\n", one_set ? "" : "\n",
                       one_set ? ""
                               : fmt::format("lateral displacement {:g} mm, ",
                                             c.at_position[c.reference].lateral.value_or(0)),
                       c.at_position[c.reference].result.Fz) +
           table(c, c.at_position) + datum_text(c, c.at_position);
  return out;
}

} // namespace bem_contact::app
