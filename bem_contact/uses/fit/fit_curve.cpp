#include "bem_contact/uses/fit/fit_curve.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/fit/bootstrap.hpp"
#include "bem_contact/uses/fit/undetermined.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace bem_contact::fit {

namespace {

/// 1, of the first guess. A key that must be above 0, or that 0 switches off, stays above this.
constexpr double nearly_zero = 1e-6;
/// Points of the curve that is shown, besides zero.
constexpr int curve_points = 30;
/// 1. The curve begins at this share of the smallest creepage that was measured.
constexpr double curve_begins = 0.2;

/// Keys that say which of the creepages a point has.
constexpr const char* creepage_keys[] = {"motion.xi", "motion.eta", "motion.phi"};

struct NamedUnknown {
  std::string key, unit;
  Unknown unknown;
};

SceneReader reader_of(const Question& q) {
  SceneReader reader(q.text);
  for (const SceneChange& change : q.changes)
    reader.set(change);
  return reader;
}

KeyDescription rule_of(const SceneReader& reader, const std::string& key) {
  reader.require_key(key);
  const std::vector<KeyDescription> all = keys_of_scenes();
  const auto at = std::ranges::find(all, key, &KeyDescription::path);
  if (at == all.end() || at->type != KeyType::number)
    throw InputError(fmt::format("'{}' cannot be fitted", key),
                     "its value is no number that may grow or shrink",
                     "Name keys like layer.compliance, motion.friction or motion.falling_friction.");
  return *at;
}

NamedUnknown unknown_of(const SceneReader& reader, const toml::table& values, const std::string& key) {
  const KeyRule rule = rule_of(reader, key).rule;
  const std::optional<double> start = values.at_path(key).value<double>();
  if (!start || *start == 0)
    throw InputError(fmt::format("'{}' cannot be fitted", key),
                     start ? "its value in the scene is 0, which says nothing of its size"
                           : "the scene gives it no value to begin with",
                     "Give it a first guess; the right order of magnitude will do.");
  const double least = nearly_zero * std::abs(*start);
  NamedUnknown out{key, rule.unit, {*start, rule.at_least, rule.at_most}};
  if (std::isfinite(rule.above))
    out.unknown.at_least = std::max(out.unknown.at_least, rule.above + least);
  if (rule.zero_is_none && rule.at_least >= 0)
    out.unknown.at_least = std::max(out.unknown.at_least, least);
  if (std::isfinite(rule.below))
    out.unknown.at_most = std::min(out.unknown.at_most, rule.below - least);
  return out;
}

std::vector<NamedUnknown> unknowns_of(const Question& q, const SceneReader& reader, const SceneFile& scene) {
  std::vector<NamedUnknown> out;
  const toml::table values = parse_toml(scene_with_defaults(scene), "scene");
  for (const std::string& key : q.keys) {
    if (std::ranges::count(q.keys, key) > 1)
      throw InputError(fmt::format("'{}' is named twice", key), "each key has one value", "Name it once.");
    if (std::ranges::any_of(q.measured.forces, [&](const MeasuredForces& m) {
          return key == creepage_keys[static_cast<std::size_t>(m.which)];
        }))
      throw InputError(fmt::format("'{}' cannot be fitted", key), "it is what the points vary",
                       "Name keys that are the same for all points.");
    out.push_back(unknown_of(reader, values, key));
  }
  reader.require_effect(q.keys);
  return out;
}

void require_points(const Question& q) {
  if (q.keys.empty())
    throw InputError("There is nothing to fit", "no key is named", "Name one, as layer.compliance.");
  if (q.measured.points() <= q.keys.size())
    throw InputError(fmt::format("{} points are too few", q.measured.points()),
                     fmt::format("{} numbers are fitted, and what is left over says how well", q.keys.size()),
                     fmt::format("Give {} points or more.", q.keys.size() + 1));
  std::size_t with_scatter = 0, without = 0;
  const auto look_at = [&](const auto& table) {
    (table.scatter.empty() ? without : with_scatter) += 1;
    if (std::ranges::find(table.scatter, 0.0) != table.scatter.end())
      throw InputError("A point has a scatter of 0", "it would outweigh all others",
                       "Give its standard deviation, or leave out the column scatter.");
    if (table.scatter.empty() && std::ranges::all_of(table.measured, [](double v) { return v == 0; }))
      throw InputError("A table of what was measured is 0 everywhere", "nothing says how its points count",
                       "Give the column scatter, or leave the table out.");
  };
  std::ranges::for_each(q.measured.forces, look_at);
  std::ranges::for_each(q.measured.pressures, look_at);
  if (with_scatter > 0 && without > 0)
    throw InputError("One table has the scatter of its points, and another has not",
                     "nothing says how their points count beside each other",
                     "Give the column scatter in all of them, or in none.");
}

/// What the program has for each point that was measured, for values of the keys.
class FittedScene {
public:
  FittedScene(const Question& q, SceneReader& reader, HeldContact held, const std::atomic<bool>* stop)
      : question_(q), reader_(reader), held_(std::move(held)), stop_(stop) {
    if (std::ranges::find(q.keys, "layer.slope") != q.keys.end())
      held_.layer_compliance.reset();
    if (std::ranges::find(q.keys, "position.lateral") != q.keys.end())
      held_.lateral.reset();
    for (const std::string& key : q.keys)
      inputs_.push_back(derivative_name_of(key));
    if (!q.measured.pressures.empty() || std::ranges::count(inputs_, std::string()) > 0)
      inputs_.clear();
  }

  /// Solves at the first guess. If that has no derivatives, nothing asks for them again.
  void begin(std::span<const double> guess) {
    all(guess);
    if (!slopes(guess))
      inputs_.clear();
  }

  /// What all() said last for these values changes by per unit of each key.
  std::optional<std::vector<double>> slopes(std::span<const double> values) const {
    const auto known = slopes_.find({values.begin(), values.end()});
    return known == slopes_.end() ? std::nullopt : std::optional(known->second);
  }

  SceneFile with(std::span<const double> values) {
    for (std::size_t k = 0; k < values.size(); ++k)
      reader_.set_number(question_.keys[k], values[k]);
    return with_model(reader_.scene(), question_.model);
  }

  /// Throws InputError where such a scene is refused, ConvergenceError where it has no certified solution.
  std::vector<double> all(std::span<const double> values) {
    std::vector<double> out, slopes;
    for (const MeasuredForces& m : question_.measured.forces)
      for (const CreepPoint& point : points(values, m, m.creepage, inputs_)) {
        out.push_back(point.forces[static_cast<std::size_t>(m.force)]);
        for (const CreepForceValues& by : point.slopes)
          slopes.push_back(by[static_cast<std::size_t>(m.force)]);
      }
    if (!slopes.empty() && slopes.size() == out.size() * values.size())
      slopes_[{values.begin(), values.end()}] = std::move(slopes);
    if (question_.measured.pressures.empty())
      return out;
    const SceneResult result = solve_held(with(values), held_, stop_);
    if (!certified(result))
      throw ConvergenceError("The measured pressures have no certified solution (its certificate does not "
                             "hold) Use other elements (grid).");
    for (const MeasuredPressures& m : question_.measured.pressures)
      std::ranges::copy(pressures_at(m, result), std::back_inserter(out));
    return out;
  }

  /// The force of these points at these creepages.
  std::vector<double> forces(std::span<const double> values, const MeasuredForces& like,
                             std::span<const double> creepages) {
    std::vector<double> out;
    for (const CreepPoint& point : points(values, like, creepages, {}))
      out.push_back(point.forces[static_cast<std::size_t>(like.force)]);
    return out;
  }

  Theory theory() {
    return searched([this](std::span<const double> values) { return all(values); });
  }
  Theory theory(const MeasuredForces& points, std::span<const double> creepages) {
    return searched([this, &points, creepages](std::span<const double> values) {
      return forces(values, points, creepages);
    });
  }

private:
  /// With derivatives by `inputs`, where there are any.
  std::vector<CreepPoint> points(std::span<const double> values, const MeasuredForces& like,
                                 std::span<const double> creepages, const std::vector<std::string>& inputs) {
    SceneFile scene = with(values);
    std::vector<Creepages> at(creepages.size(), {scene.motion.xi, scene.motion.eta, scene.motion.phi});
    for (std::size_t i = 0; i < at.size(); ++i)
      at[i][static_cast<std::size_t>(like.which)] = creepages[i];
    std::vector<CreepPoint> out;
    scene.derivatives = inputs;
    try {
      out = creep_points(scene, held_, at, stop_);
    } catch (const Error&) {
      if (inputs.empty())
        throw;
      scene.derivatives.clear();
      out = creep_points(scene, held_, at, stop_);
    }
    if (!std::ranges::all_of(out, &CreepPoint::certified))
      throw ConvergenceError("A measured point has no certified solution (its certificate does not hold) "
                             "Use other elements (grid), or leave the point out.");
    return out;
  }

  template <class Computed> static Theory searched(const Computed& computed) {
    return [computed](std::span<const double> values) -> std::optional<std::vector<double>> {
      try {
        return computed(values);
      } catch (const InputError&) {
      } catch (const ConvergenceError&) {
      }
      return std::nullopt; // the search tries others
    };
  }

  const Question& question_;
  SceneReader& reader_;
  HeldContact held_;
  const std::atomic<bool>* stop_;
  std::vector<std::string> inputs_; ///< of derivatives, one for each key; empty: there are none
  std::map<std::vector<double>, std::vector<double>> slopes_; ///< [point][key], by the values of the keys
};

/// From zero, or the least that was measured, to the most; narrower where creepages are small.
std::vector<double> curve_over(const std::vector<double>& measured) {
  const auto [least, most] = std::ranges::minmax(measured);
  std::vector<double> out;
  if ((least < 0 && most > 0) || least == most) {
    const double from = std::min(least, 0.0), to = std::max(most, 0.0);
    for (int i = 0; i <= curve_points; ++i)
      out.push_back(from + (to - from) * i / curve_points);
    return out;
  }
  const double sign = most > 0 ? 1 : -1, far = std::max(std::abs(least), std::abs(most));
  double near = far;
  for (const double creepage : measured)
    near = creepage == 0 ? near : std::min(near, std::abs(creepage));
  near *= curve_begins;
  out.push_back(0);
  for (int i = 0; i < curve_points; ++i)
    out.push_back(sign * near * std::pow(far / near, double(i) / (curve_points - 1)));
  std::ranges::sort(out);
  return out;
}

Points points_of(const Measurements& all) {
  Points out;
  const auto add = [&](const auto& table) {
    const auto [least, most] = std::ranges::minmax(table.measured);
    for (std::size_t i = 0; i < table.measured.size(); ++i) {
      out.measured.push_back(table.measured[i]);
      out.weights.push_back(
          1 / (table.scatter.empty() ? std::max(std::abs(least), std::abs(most)) : table.scatter[i]));
    }
  };
  std::ranges::for_each(all.forces, add);
  std::ranges::for_each(all.pressures, add);
  return out;
}

/// The curve over the first forces at the found values, and the band of what else the points allow.
void add_curve(CurveFit& out, FittedScene& fitted, const Solution& solution, const Spread& spread,
               std::span<const Unknown> unknowns, const std::atomic<bool>* stop) {
  MeasuredForces& first = out.measured.forces.front();
  std::vector<double> measured;
  for (const MeasuredForces& m : out.measured.forces)
    if (m.which == first.which)
      measured.insert(measured.end(), m.creepage.begin(), m.creepage.end());
  const std::vector<double> over = curve_over(measured);
  out.curves = creep_curves_beside(first, out.scene, {{first.which, over}}, stop);
  const std::vector<double> slopes = slopes_of(fitted.theory(first, over), unknowns, solution.values);
  const std::size_t count = unknowns.size();
  for (std::size_t i = 0; i < over.size(); ++i)
    out.band.push_back(band_of(spread, solution.values,
                               out.curves->curves[0].points[i].forces[static_cast<std::size_t>(first.force)],
                               std::span(slopes).subspan(i * count, count)));
}

/// What the found values give at the points.
void add_computed(CurveFit& out, FittedScene& fitted, const Solution& solution, const Spread& spread,
                  std::span<const Unknown> unknowns, const std::atomic<bool>* stop) {
  Measurements& m = out.measured;
  if (m.forces.empty())
    out.solution = Sequence({.displacements = false}, shared_files()).solve(out.scene, stop);
  else {
    add_curve(out, fitted, solution, spread, unknowns, stop);
    out.solution = out.curves->solution;
  }
  for (std::size_t i = 1; i < m.forces.size(); ++i)
    creep_curves_beside(m.forces[i], out.scene, {}, stop);
  std::size_t first = 0;
  for (const MeasuredForces& forces : m.forces)
    first += forces.measured.size();
  for (MeasuredPressures& line : m.pressures) {
    const auto here = std::span(solution.computed).subspan(first, line.measured.size());
    line.computed.assign(here.begin(), here.end());
    line.certified = true; // the theory has no others
    first += here.size();
  }
}

} // namespace

bool certified(const CurveFit& fit) {
  return fit.converged && certified(fit.solution) && (!fit.curves || certified(*fit.curves)) &&
         std::ranges::all_of(fit.measured.forces,
                             [](const MeasuredForces& m) { return bem_contact::certified(m); }) &&
         std::ranges::all_of(fit.measured.pressures, &MeasuredPressures::certified);
}

std::size_t Measurements::points() const {
  std::size_t count = 0;
  for (const MeasuredForces& m : forces)
    count += m.measured.size();
  for (const MeasuredPressures& m : pressures)
    count += m.measured.size();
  return count;
}

void add_measured(Measurements& all, const std::string& source, const std::vector<std::string>& columns,
                  const std::vector<std::vector<double>>& rows) {
  if (rows.empty())
    throw InputError(fmt::format("The table '{}' cannot be used", source), "it has no points",
                     "Give points, or leave it out.");
  if (holds_pressures(columns))
    all.pressures.push_back(measured_pressures(source, columns, rows));
  else
    all.forces.push_back(measured_forces(source, columns, rows));
}

Measurements read_measured(const std::vector<std::string>& files) {
  Measurements out;
  for (const std::string& file : files) {
    const std::vector<std::string> columns = csv_columns(file);
    add_measured(out, file, columns, read_csv(file, columns));
  }
  return out;
}

CurveFit fit_curve(const Question& question, const std::atomic<bool>* stop) {
  require_points(question);
  SceneReader reader = reader_of(question);
  const SceneFile first = with_model(reader.scene(), question.model);
  for (const MeasuredForces& m : question.measured.forces)
    require_creepages(first, std::vector<CreepRange>{{m.which, m.creepage}});
  const std::vector<NamedUnknown> named = unknowns_of(question, reader, first);
  std::vector<Unknown> unknowns;
  for (const NamedUnknown& one : named)
    unknowns.push_back(one.unknown);
  const SceneResult start = Sequence({.displacements = false}, shared_files()).solve(first, stop);
  FittedScene fitted(question, reader, held_by(first, start), stop);
  std::vector<double> guess;
  for (const Unknown& unknown : unknowns)
    guess.push_back(unknown.start);
  fitted.begin(guess); // throws where the search had nothing to begin from
  const Points points = points_of(question.measured);
  const Solution solution =
      least_squares(fitted.theory(), points, unknowns,
                    [&fitted](std::span<const double> values) { return fitted.slopes(values); });
  const Spread spread = bootstrap(solution, points, unknowns);
  CurveFit out;
  for (std::size_t k = 0; k < named.size(); ++k)
    out.keys.push_back({named[k].key, named[k].unit, named[k].unknown.start, solution.values[k],
                        spread.low[k], spread.high[k], spread.standard_error[k], solution.bounds[k],
                        spread.determined[k]});
  out.correlation = spread.correlation;
  out.measured = question.measured;
  out.tried = solution.evaluations;
  out.converged = solution.converged;
  out.scene = fitted.with(solution.values);
  add_computed(out, fitted, solution, spread, unknowns, stop);
  out.undetermined = undetermined(out);
  return out;
}

} // namespace bem_contact::fit
