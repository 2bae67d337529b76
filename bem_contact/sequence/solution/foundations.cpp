#include "bem_contact/sequence/solution/foundations.hpp"

#include "bem_contact/scene/sectioned_bodies.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace bem_contact {

namespace {

/// mm. How well the difference of both depths is known: a contact yields by 1e-6 mm under one newton.
constexpr double depth_tolerance = 1e-6;
/// 1. Solutions on the way: eight are usual. A bound.
constexpr std::uintmax_t most_solutions = 40;

/// Compliance of what each of the two lies on, mm/N, in the order of the scene, and its place in
/// `rail.bodies`.
struct TwoBodies {
  std::array<double, 2> compliance{};
  std::array<std::string, 2> name;

  explicit TwoBodies(const SceneFile& scene) {
    const std::vector<SceneFile::Section>& sections = scene.rail.sections;
    name[0] = sections.front().body;
    name[1] = std::ranges::find_if(sections, [&](const auto& s) { return s.body != name[0]; })->body;
    for (int i = 0; i < 2; ++i)
      if (const auto known = std::ranges::find(scene.rail.bodies, name[i], &SceneFile::Body::name);
          known != scene.rail.bodies.end() && known->stiffness)
        compliance[i] = 1 / *known->stiffness;
  }
  /// Both lowered further by these depths, mm, and rigid.
  SceneFile lowered(SceneFile scene, const std::array<double, 2>& by) const {
    for (int i = 0; i < 2; ++i) {
      std::vector<SceneFile::Body>& all = scene.rail.bodies;
      auto known = std::ranges::find(all, name[i], &SceneFile::Body::name);
      if (known == all.end())
        known = all.insert(all.end(), SceneFile::Body{name[i]});
      known->lowered += by[i];
      known->stiffness.reset();
    }
    return scene;
  }
};

/// Vertical forces on both, N.
std::array<double, 2> shares_of(const SceneResult& r) {
  std::array<double, 2> out{};
  for (std::size_t i = 0; i < r.result.patches.size(); ++i)
    out[r.patch_places[i].body > 1 ? 1 : 0] += r.result.patches[i].fz;
  return out;
}

bool has_foundations(const SceneFile& scene) {
  return std::ranges::any_of(scene.rail.bodies, [](const auto& b) { return b.stiffness.has_value(); });
}

} // namespace

SceneFile on_foundations(const SceneFile& scene, const std::function<SceneResult(const SceneFile&)>& solve) {
  if (!has_foundations(scene))
    return scene;
  const TwoBodies bodies(scene);
  SceneFile search = scene;
  search.motion.free_rolling = search.motion.from_free_rolling;
  const auto depths = [&](double q) {
    const std::array<double, 2> force = shares_of(solve(bodies.lowered(search, {q, 0})));
    return std::array{force[0] * bodies.compliance[0], force[1] * bodies.compliance[1]};
  };
  const auto excess = [&](double q) {
    const auto [first, second] = depths(q);
    return first - second - q;
  };
  double low = -*scene.load.force * bodies.compliance[1], high = *scene.load.force * bodies.compliance[0];
  std::uintmax_t steps = most_solutions;
  const double at_low = excess(low), at_high = excess(high);
  if (at_low > 0 && at_high < 0)
    std::tie(low, high) = boost::math::tools::toms748_solve(
        excess, low, high, at_low, at_high,
        [](double a, double b) { return std::abs(a - b) < depth_tolerance; }, steps);
  else if (at_low <= 0) // the second one bears all
    high = low;
  else
    low = high;
  const double q = 0.5 * (low + high);
  const auto [first, second] = depths(q);
  // Both depths by the forces, and their difference as it was found.
  const double mean = 0.5 * (first + second);
  return bodies.lowered(scene, {mean + 0.5 * q, mean - 0.5 * q});
}

} // namespace bem_contact
