#include "bem_contact/sequence/solution/slide_errors.hpp"

#include "bem_contact/sequence/solution/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact {

namespace {

/// What the slide of one patch changes, all of them at least 0.
struct SlideChange {
  double normal = 0;   ///< of its normal force, and so of shear and power, over itself
  double approach = 0; ///< of the approach, over itself
  double lateral = 0;  ///< of Fy, N
};

/// By how much the rail turns over one millimetre of these elements, rad/mm; 0 on one row.
double turn_along(const ContactProblem& problem, const std::vector<int>& elements) {
  const auto [first, last] = std::ranges::minmax_element(elements);
  const ContactRow &from = problem.rows[*first / problem.grid.mx],
                   &to = problem.rows[*last / problem.grid.mx];
  return to.s > from.s ? (to.delta - from.delta) / (to.s - from.s) : 0;
}

SlideChange slide_change(const ContactProblem& problem, const PatchSummary& patch,
                         const std::vector<int>& elements) {
  if (!(patch.fn > 0 && patch.fz > 0))
    return {};
  const double tangent = std::tan(patch.delta), slope = std::abs(patch.fy / patch.fz);
  const double slide = patch.overlap * (tangent + shear_slide * patch.fs / patch.fn);
  const double turn = std::abs(turn_along(problem, elements) * slide);
  return {.normal = slope * turn,
          .approach = (2.0 / 3.0 * slope + std::abs(tangent)) * turn,
          .lateral = patch.fz * (1 + slope * slope) * turn};
}

void add_error(double error, Measured& to) {
  if (to.error > 0)
    to.error += error;
}

void add_error_share(double share, Measured& to) {
  add_error(share * std::abs(to), to);
}

/// `normal`: change of the normal force, over itself.
template <class Numbers> void add_hertzian_errors(double normal, Numbers& to) {
  add_error_share(normal / 3, to.pmax);
  add_error_share(2 * normal / 3, to.area);
  add_error_share(normal, to.T_gamma);
}

void add_patch_errors(const SlideChange& change, PatchSummary& patch) {
  add_hertzian_errors(change.normal, patch);
  add_error_share(change.approach, patch.overlap);
  for (Measured* of_force : {&patch.fn, &patch.fx, &patch.fs, &patch.moment_n})
    add_error_share(change.normal, *of_force);
  add_error(change.lateral, patch.fy);
}

/// The trial whose lateral force is about as far away as `by`, N; null: none is.
const LateralTrial* trial_beside(const std::vector<LateralTrial>& trials, double by,
                                 const SceneResult& solved) {
  const LateralTrial* best = nullptr;
  double least = std::log(farthest_trial);
  for (const LateralTrial& trial : trials)
    if (const double away = std::abs(trial.totals.Fy - solved.result.totals.Fy); away > 0)
      if (const double ratio = std::abs(std::log(away / by)); ratio < least) {
        least = ratio;
        best = &trial;
      }
  return best;
}

} // namespace

double add_slide_errors(SceneResult& solved) {
  if (!solved.motion.lateral || (solved.structure && solved.structure->shift_y) || !solved.result.certified())
    return 0;
  ContactResult& result = solved.result;
  const std::vector<std::vector<int>> elements = patch_elements(solved.problem, result);
  double pressed = 0;
  for (const PatchSummary& patch : result.patches)
    pressed += patch.fn;
  SlideChange all;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    PatchSummary& patch = result.patches[k];
    const SlideChange change = slide_change(solved.problem, patch, elements[k]);
    all.normal += patch.fn / pressed * change.normal;
    all.approach += patch.fn / pressed * change.approach;
    all.lateral += change.lateral;
    add_patch_errors(change, patch);
  }
  ContactTotals& totals = result.totals;
  add_hertzian_errors(all.normal, totals);
  add_error_share(all.approach, totals.approach);
  for (Measured* number : {&totals.Fx, &totals.Fs, &solved.moment})
    add_error_share(all.normal, *number);
  add_error(all.lateral, totals.Fy);
  return totals.Fy.error > 0 ? all.lateral : 0;
}

void add_position_errors(const std::vector<LateralTrial>& trials, double lateral_force, SceneResult& solved) {
  const LateralTrial* beside = lateral_force > 0 ? trial_beside(trials, lateral_force, solved) : nullptr;
  if (!beside)
    return;
  ContactTotals& totals = solved.result.totals;
  const double share = lateral_force / std::abs(beside->totals.Fy - totals.Fy);
  for (Measured ContactTotals::*number :
       {&ContactTotals::Fx, &ContactTotals::Fs, &ContactTotals::pmax, &ContactTotals::area,
        &ContactTotals::approach, &ContactTotals::adhesion_share, &ContactTotals::T_gamma})
    add_error(share * std::abs(beside->totals.*number - totals.*number), totals.*number);
  add_error(share * std::abs(beside->moment - solved.moment), solved.moment);
}

} // namespace bem_contact
