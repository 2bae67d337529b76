#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/shakedown/fatigue_criteria.hpp"
#include "bem_contact/uses/shakedown/melan.hpp"
#include "bem_contact/uses/shakedown/residual_fields.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::shakedown {

namespace {

/// 1. A patch with fewer rows or columns has no stresses worth a limit.
constexpr int least_across = 4;

void require_between(double value, double least, double most, const char* name) {
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("{} cannot be {}", name, value),
                     fmt::format("it must lie between {} and {}", least, most), "Correct it.");
}

} // namespace

double ShakedownProperties::crossland() const {
  return alpha.value_or(crossland_alpha(dang_van_a));
}

void validate(const ShakedownProperties& p) {
  require_between(p.yield_shear, 1, 1e4, "The yield stress in shear");
  require_between(p.dang_van_a, 0, 3, "Dang Van's a");
  if (p.alpha)
    require_between(*p.alpha, 0, 3, "Crossland's alpha");
}

const char* word_of(Yielding yielding) {
  switch (yielding) {
  case Yielding::never:
    return "never";
  case Yielding::once:
    return "once";
  case Yielding::for_ever:
    return "for ever";
  case Yielding::open:
    break;
  }
  return "once or for ever";
}

namespace {

Yielding yielding_of(const PatchShakedown& p) {
  return p.first_yield.value >= 1 ? Yielding::never
         : p.lower.value >= 1     ? Yielding::once
         : p.upper.value < 1      ? Yielding::for_ever
                                  : Yielding::open;
}

/// Which residual stresses a point may have. The surface bears no tractions of them.
FreeComponents free_components(Residual kind, bool surface) {
  const bool shear = kind == Residual::all;
  return {true, true, shear, shear && !surface, !surface};
}

class Patch {
public:
  Patch(const SceneResult& solved, std::span<const int> elements, const ShakedownProperties& properties)
      : properties_(properties), section_(section_below(solved.problem, elements)),
        fields_(section_.s_knots, section_.depth_knots, properties.residual),
        stresses_(stresses_of_passage(section_, solved.problem, solved.result, solved.bodies.rail_poisson)) {}

  void fill(PatchShakedown& out) {
    for (std::size_t i = 0; i < section_.points(); ++i)
      add_point(i, out.maps);
    const MelanLoad melan = largest_load(points_, fields_.size());
    for (const Deviator& residual : melan.residual)
      out.maps.residual.push_back(stress_of(properties_.yield_shear * residual));
    out.first_yield = least(out.maps.first_yield);
    out.upper = least(out.maps.cycle);
    out.lower = largest(melan.work);
    out.lower.value = std::min(melan.factor, out.upper.value); // both may be rounded
    out.dang_van = largest_below(out.maps.dang_van);
    out.crossland = largest_below(out.maps.crossland);
    out.dang_van_surface = largest_at(out.maps.dang_van, 0).value;
    out.yielding = yielding_of(out);
    out.section = section_;
  }

private:
  void add_point(std::size_t i, SectionMaps& maps) {
    const double s = section_.s[i / section_.depths.size()],
                 depth = section_.depths[i % section_.depths.size()];
    const double k = properties_.yield_shear;
    const std::vector<halfspace::Stress>& stresses = stresses_[i];
    YieldPoint point{{}, fields_.at(s, depth)};
    DeviatorPath path;
    double longest = 0;
    for (const halfspace::Stress& t : stresses) {
      path.push_back(deviator(t));
      point.path.push_back(path.back() / k);
      longest = std::max(longest, path.back().norm());
    }
    maps.first_yield.push_back(k / longest);
    maps.cycle.push_back(k / smallest_ball(path, free_components(properties_.residual, depth == 0)).least);
    const Ball ball = smallest_ball(path);
    maps.dang_van.push_back(dang_van(stresses, ball, properties_.dang_van_a));
    maps.crossland.push_back(crossland(stresses, ball, properties_.crossland()));
    points_.push_back(std::move(point));
  }

  AtPoint at(std::size_t i, double value) const {
    return {value, section_.s[i / section_.depths.size()], section_.depths[i % section_.depths.size()]};
  }
  AtPoint least(const std::vector<double>& map) const {
    const std::size_t i = std::ranges::min_element(map) - map.begin();
    return at(i, map[i]);
  }
  AtPoint largest(const std::vector<double>& map) const {
    const std::size_t i = std::ranges::max_element(map) - map.begin();
    return at(i, map[i]);
  }

  AtPoint largest_at(const std::vector<double>& map, std::size_t id) const {
    std::size_t best = section_.point(0, id);
    for (std::size_t is = 1; is < section_.s.size(); ++is)
      if (const std::size_t i = section_.point(is, id); map[i] > map[best])
        best = i;
    return at(best, map[best]);
  }
  /// With much friction there are two places: the surface, and one below it. Between them the stress is less.
  AtPoint largest_below(const std::vector<double>& map) const {
    AtPoint out = largest_at(map, 0);
    bool falling = true;
    for (std::size_t id = 1; id < section_.depths.size(); ++id) {
      const AtPoint here = largest_at(map, id);
      falling = falling && here.value <= out.value;
      if (falling || here.value > out.value)
        out = here;
    }
    return falling ? largest_at(map, 0) : out;
  }

  const ShakedownProperties& properties_;
  Section section_;
  ResidualFields fields_;
  std::vector<std::vector<halfspace::Stress>> stresses_;
  std::vector<YieldPoint> points_;
};

bool is_too_small(std::span<const int> elements, int columns) {
  int least_row = elements.front(), most_row = 0, least_column = columns, most_column = 0;
  for (const int i : elements) {
    least_row = std::min(least_row, i / columns);
    most_row = std::max(most_row, i / columns);
    least_column = std::min(least_column, i % columns);
    most_column = std::max(most_column, i % columns);
  }
  return most_row - least_row + 1 < least_across || most_column - least_column + 1 < least_across;
}

} // namespace

Shakedown shakedown_of(const SceneResult& solved, const ShakedownProperties& properties) {
  require_certified(solved);
  validate(properties);
  if (!solved.result.certified())
    throw InputError("There is no shakedown of a result that did not converge",
                     "its tractions are not a solution", "Solve the scene first.");
  Shakedown out;
  const std::vector<std::vector<int>> elements = patch_elements(solved.problem, solved.result);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (!solved.problem.plane_strain() && is_too_small(elements[k], solved.problem.grid.mx)) {
      ++out.too_small;
      continue;
    }
    PatchShakedown patch;
    const PatchSummary& summary = solved.result.patches[k];
    patch.s = summary.s;
    patch.y = summary.position.y;
    patch.pmax = summary.pmax;
    patch.yield_shear = properties.yield_shear;
    Patch(solved, elements[k], properties).fill(patch);
    out.patches.push_back(std::move(patch));
  }
  return out;
}

} // namespace bem_contact::shakedown
