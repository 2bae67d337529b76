#include "bem_contact/uses/fit/fit_curve.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/fit/bootstrap.hpp"
#include "bem_contact/uses/fit/undetermined.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

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
    if (key == creepage_keys[static_cast<std::size_t>(q.measured.which)])
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
  if (q.measured.measured.size() <= q.keys.size())
    throw InputError(fmt::format("{} points are too few", q.measured.measured.size()),
                     fmt::format("{} numbers are fitted, and what is left over says how well", q.keys.size()),
                     fmt::format("Give {} points or more.", q.keys.size() + 1));
  if (std::ranges::find(q.measured.scatter, 0.0) != q.measured.scatter.end())
    throw InputError("A point has a scatter of 0", "it would outweigh all others",
                     "Give its standard deviation, or leave out the column scatter.");
}

/// Forces at creepages for values of the keys.
class FittedScene {
public:
  FittedScene(const Question& q, SceneReader& reader, HeldContact held, const std::atomic<bool>* stop)
      : question_(q), reader_(reader), held_(std::move(held)), stop_(stop) {
    if (std::ranges::find(q.keys, "layer.slope") != q.keys.end())
      held_.layer_compliance.reset();
  }

  SceneFile with(std::span<const double> values) {
    for (std::size_t k = 0; k < values.size(); ++k)
      reader_.set_number(question_.keys[k], values[k]);
    return with_model(reader_.scene(), question_.model);
  }

  /// Throws InputError where such a scene is refused, ConvergenceError where it has no certified solution.
  std::vector<double> forces(std::span<const double> values, std::span<const double> creepages) {
    const SceneFile scene = with(values);
    std::vector<Creepages> at(creepages.size(), {scene.motion.xi, scene.motion.eta, scene.motion.phi});
    for (std::size_t i = 0; i < at.size(); ++i)
      at[i][static_cast<std::size_t>(question_.measured.which)] = creepages[i];
    std::vector<double> out;
    for (const CreepPoint& point : creep_points(scene, held_, at, stop_)) {
      out.push_back(point.forces[static_cast<std::size_t>(question_.measured.force)]);
      if (!point.certified)
        throw ConvergenceError("A measured point has no certified solution (its certificate does not hold) "
                               "Use other elements (grid), or leave the point out.");
    }
    return out;
  }

  Theory theory(std::span<const double> creepages) {
    return [this, creepages](std::span<const double> values) -> std::optional<std::vector<double>> {
      try {
        return forces(values, creepages);
      } catch (const InputError&) {
      } catch (const ConvergenceError&) {
      }
      return std::nullopt; // the search tries others
    };
  }

private:
  const Question& question_;
  SceneReader& reader_;
  HeldContact held_;
  const std::atomic<bool>* stop_;
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

Points points_of(const MeasuredForces& m) {
  Points out{m.measured, std::vector(m.measured.size(), 1.0)};
  for (std::size_t i = 0; i < m.scatter.size(); ++i)
    out.weights[i] = 1 / m.scatter[i];
  return out;
}

/// The curve at the found values, and the band of what else the points allow.
void add_curves(CurveFit& out, FittedScene& fitted, const Solution& solution, const Spread& spread,
                std::span<const Unknown> unknowns, const std::atomic<bool>* stop) {
  const std::vector<double> over = curve_over(out.measured.creepage);
  out.curves = creep_curves_beside(out.measured, out.scene, {{out.measured.which, over}}, stop);
  const std::vector<double> slopes = slopes_of(fitted.theory(over), unknowns, solution.values);
  const std::size_t count = unknowns.size();
  for (std::size_t i = 0; i < over.size(); ++i)
    out.band.push_back(
        band_of(spread, solution.values,
                out.curves.curves[0].points[i].forces[static_cast<std::size_t>(out.measured.force)],
                std::span(slopes).subspan(i * count, count)));
  double squares = 0;
  for (std::size_t i = 0; i < out.measured.measured.size(); ++i)
    squares += std::pow(out.measured.computed[i].forces[static_cast<std::size_t>(out.measured.force)] -
                            out.measured.measured[i],
                        2);
  out.misfit = std::sqrt(squares / double(out.measured.measured.size()));
}

} // namespace

bool certified(const CurveFit& fit) {
  return fit.converged && certified(fit.curves) && certified(fit.measured);
}

CurveFit fit_curve(const Question& question, const std::atomic<bool>* stop) {
  require_points(question);
  SceneReader reader = reader_of(question);
  const SceneFile first = with_model(reader.scene(), question.model);
  require_creepages(first, std::vector<CreepRange>{{question.measured.which, question.measured.creepage}});
  const std::vector<NamedUnknown> named = unknowns_of(question, reader, first);
  std::vector<Unknown> unknowns;
  for (const NamedUnknown& one : named)
    unknowns.push_back(one.unknown);
  const SceneResult start = Sequence({.displacements = false}, shared_files()).solve(first, stop);
  FittedScene fitted(question, reader, held_by(first, start), stop);
  std::vector<double> guess;
  for (const Unknown& unknown : unknowns)
    guess.push_back(unknown.start);
  fitted.forces(guess, question.measured.creepage); // throws where the search had nothing to begin from
  const Points points = points_of(question.measured);
  const Solution solution = least_squares(fitted.theory(question.measured.creepage), points, unknowns);
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
  add_curves(out, fitted, solution, spread, unknowns, stop);
  out.undetermined = undetermined(out);
  return out;
}

} // namespace bem_contact::fit
