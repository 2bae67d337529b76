#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/contact/history.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace bem_contact {

namespace {

/// Elements in contact that are tried for an accuracy: a second or a few with either kind of numbers.
constexpr int most_translational = 12000, most_full = 4000;
/// To solve once more costs so much with numbers full in s that some elements in reserve are cheaper.
constexpr int least_full = 250;
/// Length of elements over their width at the most. Where numbers are full in s a product grows as the square
/// of the rows: there short elements in few rows are the cheaper ones.
constexpr double longest_translational = 1.1, longest_full = 0.8;

/// The shortest element that influence files have numbers for, mm; 0: any. A wheel's is that at its reference
/// radius, and the contact lies elsewhere.
double shortest_element(const PairFiles& files) {
  double shortest = 0;
  for (const auto& file : {files.rail, files.wheel})
    if (file && !file->wavenumber.empty() && file->wavenumber.back() > 0)
      shortest = std::max(shortest, 1.05 * 10 / file->wavenumber.back());
  return shortest;
}

/// From so many elements in contact on, tractions of larger elements, drawn out over much smaller ones, are
/// farther from the solution than what the solver itself finds on elements twice as large.
constexpr int many = 2000;
bool fine_enough(const ContactGrid& former, const SceneFile::Grid& wanted) {
  constexpr double much = 1.5;
  return former.dx <= much * wanted.dx && former.ds <= much * wanted.ds;
}

std::string not_accurate(const ContactResult& result, double asked, const std::string& why) {
  return fmt::format("the estimated discretisation error reached is {:.2g} %, above the {:.2g} % that "
                     "grid.accuracy asks for ({} elements in contact; {})",
                     100 * result.certificate.discretisation, 100 * asked, count_elements(result).contact,
                     why);
}

} // namespace

void Sequence::learn(const SceneResult& result, const ContactEstimate& estimate) {
  const ContactResult& r = result.result;
  const ContactGrid& grid = result.problem.grid;
  if (!r.converged || r.patches.empty() || !(estimate.approach > 0)) {
    former_.reset();
    return;
  }
  const double area = contact_extent(estimate).area;
  area_ratio_ = options_.learn && area > 0 ? count_elements(r).contact * grid.dx * grid.ds / area : 1.0;
  if (options_.keep_start)
    former_ = FormerTractions{
        grid, result.problem.rows.front().s, r.Fz, r.approach, potential_areas(estimate), r.px, r.ps, r.pn};
}

SceneResult Sequence::solve(const SceneFile& asked) {
  const Stopwatch watch;
  ++counts_.cases;
  if (asked.kind != SceneKind::wheel_rail || asked.motion.kind != MotionKind::steady) {
    ++counts_.solves;
    return solve_scene(asked);
  }
  if (!files_ || !options_.keep_files)
    files_ = std::make_shared<SceneFiles>();
  WheelRailScene placed = place_wheel_rail(asked, files_->profiles(asked), options_.foresee_shear);
  if (!options_.potential_contact)
    placed.estimate.reach *= 3;
  const PairFiles& read = files_->influence(asked);
  const double geometry = watch.seconds();
  const bool adapt = asked.grid.elements || asked.grid.accuracy;
  const std::optional<Model> model = asked.solver.model;
  const bool full = model != Model::halfspace && model != Model::hertz; // an automatic choice may be
  if (!count_ || asked_elements_ != asked.grid.elements || asked_accuracy_ != asked.grid.accuracy)
    count_.emplace(asked.grid.elements.value_or(0), asked.grid.accuracy.value_or(0),
                   full ? most_full : most_translational, full ? least_full : ElementCount::fewest);
  asked_elements_ = asked.grid.elements;
  asked_accuracy_ = asked.grid.accuracy;

  WorkBudget work;
  SceneAids aids{&placed,
                 &read,
                 options_.keep_numbers ? &numbers_ : nullptr,
                 nullptr,
                 &work,
                 options_.keep_numbers ? &workspace_ : nullptr,
                 options_.coarse_start};
  SceneFile scene = asked;
  // Half-space numbers serve any element; which model is chosen automatically is not known yet.
  const double shortest = !model || model == Model::fem ? shortest_element(read) : 0;
  const auto size = [&] {
    return size_of_elements(placed.estimate, count_->wanted(), area_ratio_, shortest,
                            full ? longest_full : longest_translational);
  };
  const std::vector<PotentialArea> areas = potential_areas(placed.estimate);
  if (!alike(areas, former_areas_)) { // what was learnt may not hold here
    count_->forget();
    area_ratio_ = std::clamp(area_ratio_, 0.7, 1.4);
  }
  former_areas_ = areas;
  PhaseSeconds spent;
  for (int round = 1;; ++round) {
    if (adapt)
      std::tie(scene.grid.dx, scene.grid.ds) = size();
    const bool near = former_ && alike(areas, former_->areas) &&
                      (count_->wanted() < many || fine_enough(former_->grid, scene.grid));
    aids.start = near ? &*former_ : nullptr;
    counts_.starts += near;
    ++counts_.solves;
    SceneResult out = solve_scene(scene, aids);
    learn(out, placed.estimate);
    spent.numbers += out.seconds.numbers;
    spent.solve += out.seconds.solve;
    spent.geometry += out.seconds.geometry;
    const double error = out.result.certificate.discretisation;
    const bool again = adapt && out.model != Model::hertz && out.result.converged &&
                       !out.result.patches.empty() &&
                       count_->learn(count_elements(out.result).contact, error);
    if (again && round < most_solves && size() != std::pair(scene.grid.dx, scene.grid.ds))
      continue;
    if (asked.grid.accuracy && out.result.converged && error > *asked.grid.accuracy)
      out.warnings.push_back(not_accurate(out.result, *asked.grid.accuracy,
                                          scene.grid.dx == shortest
                                              ? "the influence files have no numbers for shorter ones"
                                              : fmt::format("at most {} are tried", count_->most())));
    spent.geometry += geometry;
    spent.total = watch.seconds();
    out.seconds = spent;
    return out;
  }
}

Comparison Sequence::compare(const SceneFile& asked) {
  SceneFile scene = asked;
  if (asked.kind == SceneKind::wheel_rail && (asked.grid.elements || asked.grid.accuracy)) {
    const ContactGrid grid = solve(with_model(asked, Model::fem)).problem.grid;
    scene.grid.dx = grid.dx;
    scene.grid.ds = grid.ds;
  }
  Comparison out = compare_scene(scene);
  for (SceneResult* result : {&out.halfspace, &out.fem})
    if (asked.grid.accuracy && result->result.converged &&
        result->result.certificate.discretisation > *asked.grid.accuracy)
      result->warnings.push_back(
          not_accurate(result->result, *asked.grid.accuracy, "both models have the elements of fem"));
  return out;
}

Sequence::Counts Sequence::counts() const {
  Counts counts = counts_;
  counts.numbers_kept = numbers_.found;
  return counts;
}

} // namespace bem_contact
