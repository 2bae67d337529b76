#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/shakedown/fatigue_criteria.hpp"
#include "bem_contact/uses/shakedown/fatigue_limits.hpp"
#include "bem_contact/uses/shakedown/melan.hpp"
#include "bem_contact/uses/shakedown/residual_fields.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace bem_contact::shakedown {

namespace {

/// 1 (radius of a convex surface). Residual stresses reach no deeper.
constexpr double most_of_the_radius = 0.8;
/// 1 (smaller half width of the patch). A column of points beside the patch counts if it is as deep at least:
/// twice as deep as where limits are decided.
constexpr double least_depth_beside = 1;

void require_between(double value, double least, double most, const char* name) {
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("{} cannot be {}", name, value),
                     fmt::format("it must lie between {} and {}", least, most), "Correct it.");
}

} // namespace

double ShakedownProperties::crossland() const {
  return alpha.value_or(crossland_alpha(dang_van_a));
}

ShakedownProperties properties_of(const std::string& name) {
  const Steel& steel = steel_named(name);
  ShakedownProperties out;
  out.yield_shear = steel.yield_shear().value_or(out.yield_shear);
  out.dang_van_a = dang_van_a_of_steels();
  out.fatigue_limit = torsion_limit(steel);
  out.steel = steel.name;
  return out;
}

double PatchShakedown::fatigue_share() const {
  return std::max(dang_van.value, dang_van_surface) / fatigue_limit;
}
double PatchShakedown::damage() const {
  return std::isfinite(fatigue_limit)
             ? 1 / cycles_of(std::max(dang_van.value, dang_van_surface), fatigue_limit)
             : fatigue_limit;
}

void validate(const ShakedownProperties& p) {
  if (p.fatigue_limit)
    require_between(*p.fatigue_limit, 1, 1e4, "The fatigue limit in torsion");
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

/// The largest block of points at which the body is, from the surface on, about the middle of the patch.
/// Where the surface is convex, normals meet in its centre of curvature: it ends before.
struct Block {
  std::size_t first = 0, last = 0, depths = 0;    ///< of the points: columns from first to before last
  double least_s = 0, most_s = 0, most_depth = 0; ///< mm

  explicit Block(const inside::AreaStresses& area) {
    const inside::Section& section = *area.section;
    const auto deep = [&](std::size_t is) { // how many depths are there
      std::size_t id = 0;
      while (id < area.depths && area.curvature * section.depths[id] < most_of_the_radius &&
             std::isfinite(area.best()[is * area.depths + id].front().xx))
        ++id;
      return id;
    };
    const std::size_t middle = area.rows / 2;
    depths = deep(middle);
    first = middle, last = middle + 1;
    const auto fits = [&](std::size_t is) {
      const std::size_t here = deep(is);
      if (section.depths[here == 0 ? 0 : here - 1] < least_depth_beside * section.size)
        return false;
      depths = std::min(depths, here);
      return true;
    };
    while (first > 0 && fits(first - 1))
      --first;
    while (last < area.rows && fits(last))
      ++last;
    least_s = first == 0 ? section.s_knots.front() : section.s[first];
    most_s = last == area.rows ? section.s_knots.back() : section.s[last - 1];
    most_depth = depths == area.depths ? section.depth_knots.back() : section.depths[depths - 1];
  }
};

/// The largest factor >= 0 with |initial + factor load| <= k; 0 where the initial stress exceeds k alone.
double largest_factor(const Deviator& load, const Deviator& initial, double k) {
  const double a = load.squaredNorm(), b = load.dot(initial), c = k * k - initial.squaredNorm();
  if (c <= 0)
    return 0;
  if (a == 0)
    return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(b * b + a * c);
  return b > 0 ? c / (root + b) : (root - b) / a; // without cancellation
}

class Patch {
public:
  Patch(const inside::AreaStresses& area, const ShakedownProperties& properties)
      : properties_(properties), section_(*area.section), curvature_(area.curvature) {
    const Block block(area);
    cut(block);
    fields_.emplace(section_.s_knots, section_.depth_knots, properties.residual, curvature_);
    const std::vector<inside::Passage>& all = area.best();
    for (std::size_t is = block.first; is < block.last; ++is)
      for (std::size_t id = 0; id < block.depths && is_within(area.section->s[is]); ++id) {
        stresses_.push_back(all[is * area.depths + id]);
        stresses_.back().emplace_back(); // without load
      }
  }

  void fill(PatchShakedown& out) {
    for (std::size_t i = 0; i < section_.count(); ++i)
      add_point(i, out.maps);
    const MelanLoad melan = largest_load(points_, fields_->size());
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
  /// Whether residual stresses may be below it.
  bool is_within(double s) const { return s > section_.s_knots.front() && s < section_.s_knots.back(); }
  /// Leaves what the body has.
  void cut(const Block& block) {
    const auto from = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    section_.s = {section_.s.begin() + from(block.first), section_.s.begin() + from(block.last)};
    section_.depths.resize(block.depths);
    std::erase_if(section_.s_knots, [&](double s) { return s < block.least_s || s > block.most_s; });
    std::erase_if(section_.depth_knots, [&](double depth) { return depth > block.most_depth; });
    if (section_.s_knots.size() < 4 || section_.depth_knots.size() < 4)
      throw InputError("There is no room for residual stresses below this patch",
                       "the body is thinner than the patch is wide",
                       "Look at the stresses alone (bem_contact stresses).");
    std::erase_if(section_.s, [&](double s) { return !is_within(s); });
  }
  void add_point(std::size_t i, SectionMaps& maps) {
    const double s = section_.s[i / section_.depths.size()],
                 depth = section_.depths[i % section_.depths.size()];
    const double k = properties_.yield_shear;
    const halfspace::Stress initial =
        properties_.initial ? properties_.initial->at(s, depth) : halfspace::Stress{};
    YieldPoint point{{}, fields_->at(s, depth)};
    std::vector<halfspace::Stress> whole = stresses_[i]; // with the initial stress
    DeviatorPath elastic, path;
    double first = std::numeric_limits<double>::infinity();
    for (halfspace::Stress& t : whole) {
      elastic.push_back(deviator(t));
      point.path.push_back(elastic.back() / k);
      path.push_back(deviator(t.add(1, initial)));
      first = std::min(first, largest_factor(elastic.back(), deviator(initial), k));
    }
    maps.first_yield.push_back(first);
    maps.cycle.push_back(k / smallest_ball(elastic, free_components(properties_.residual, depth == 0)).least);
    const Ball ball = smallest_ball(path);
    maps.dang_van.push_back(dang_van(whole, ball, properties_.dang_van_a));
    maps.crossland.push_back(crossland(whole, ball, properties_.crossland()));
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
  inside::Section section_;
  double curvature_;
  std::optional<ResidualFields> fields_;
  std::vector<std::vector<halfspace::Stress>> stresses_;
  std::vector<YieldPoint> points_;
};

} // namespace

std::vector<std::size_t> patches_told(const SceneResult& solved) {
  const inside::SurfaceTractions tractions =
      surface_tractions(solved.problem, solved.result, solved.bodies.rail_poisson);
  const std::vector<std::vector<int>> patches = inside::loaded_patches(tractions);
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (!inside::is_too_small(patches[k], tractions.columns))
      out.push_back(k);
  return out;
}

Shakedown shakedown_of(const SceneResult& solved, const ShakedownProperties& properties) {
  require_certified(solved);
  validate(properties);
  if (solved.problem.plane_strain())
    throw InputError("There is no shakedown in plane strain",
                     "its elements are endless along x: nothing passes",
                     "Give a scene with elements along x.");
  const inside::SurfaceTractions tractions =
      surface_tractions(solved.problem, solved.result, solved.bodies.rail_poisson);
  Shakedown out = shakedown_of(inside::halfspace_inside(tractions, inside::Side::rail), properties);
  const std::vector<std::size_t> told = patches_told(solved);
  for (std::size_t i = 0; i < out.patches.size(); ++i) {
    out.patches[i].s = solved.result.patches[told[i]].s;
    out.patches[i].y = solved.result.patches[told[i]].position.y;
  }
  return out;
}

Shakedown shakedown_of(const inside::StressesInside& stresses, const ShakedownProperties& properties) {
  validate(properties);
  Shakedown out;
  out.too_small = stresses.too_small;
  for (const inside::AreaStresses& area : stresses.areas) {
    if (!area.section)
      throw InputError("There is no shakedown of points of one's own",
                       "the limit needs the whole section below a patch",
                       "Make the file of stresses without --points.");
    PatchShakedown patch;
    patch.s = 0.5 * (area.section->s.front() + area.section->s.back());
    patch.y = std::numeric_limits<double>::quiet_NaN();
    patch.pmax = area.pmax;
    patch.yield_shear = properties.yield_shear;
    patch.fatigue_limit = properties.fatigue_limit.value_or(std::numeric_limits<double>::quiet_NaN());
    Patch(area, properties).fill(patch);
    out.patches.push_back(std::move(patch));
  }
  return out;
}

} // namespace bem_contact::shakedown
