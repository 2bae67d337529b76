#include "bem_contact/sequence/plan/element_size.hpp"

#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/model_errors.hpp"
#include "bem_contact/sequence/plan/potential_area.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. That error, relative.
constexpr double usual_error = 0.003;
/// 1. One contact in a hundred has this relative error with usual_elements.
constexpr double rare_error = 0.02;
/// 1. Errors scatter: the number of elements comes down to no less than this share of the last one.
constexpr double least_change = 0.35;
/// 1. The next case begins between the usual number of elements and what this one needed: at this share of
/// the way in the logarithm. A case that needed many says little of the next. With 0.5 the cases of
/// data/scenes/cases_*.toml take 0.5 to 1 times the processor's time that they take with 1, with 0 more.
constexpr double learnt_share = 0.5;
/// 1. Fewest elements in contact for usual_accuracy with influence files; for another accuracy in proportion
/// to its power -0.5. Of 180 to 900 elements tried on the cases of data/scenes/cases_fem.toml, 180, 300 and
/// 400 take the least time for 5, 2 and 1 %: fewer are solved more often, more are dear each time.
constexpr int fewest_elements_bodies = 300;
/// 1. Of `fewest_elements_bodies`.
constexpr double usual_accuracy = 0.02;
/// 1. Length of elements over their width at the least, in a contact that is wider than long.
constexpr double shortest_element_aspect = 0.4;
/// 1. Where elements cannot get shorter, they get no narrower than this share of their length: ever narrower
/// rows would cost much and say little.
constexpr double narrowest_element_share = 0.25;
/// mm. Length of elements where the estimate has no contact.
constexpr double default_dx = 0.5;
/// mm. Width of elements there.
constexpr double default_ds = 0.25;
/// 1. An influence file serves elements of at least 10 / (its largest wavenumber). Elements are chosen so
/// many times as long: a wheel's file means lengths at its reference radius, and the contact lies elsewhere.
constexpr double wavelength_reserve = 1.05;

/// Rounded in the logarithm; `down`: not larger.
double on_ladder(double length, bool down) {
  const double step = sizes_per_octave * std::log2(length);
  return std::exp2((down ? std::floor(step + 1e-9) : std::round(step)) / sizes_per_octave); // 1e-9: rounding
}

/// Fewest elements in contact for an accuracy, with influence numbers that depend on both rows. There a
/// second solution costs so much that some elements in reserve are cheaper.
int fewest_with_bodies(double accuracy) {
  const double wanted = accuracy > 0 ? fewest_elements_bodies * std::sqrt(usual_accuracy / accuracy) : 0.0;
  return static_cast<int>(std::clamp(wanted, double(fewest_elements), double(most_elements_full)));
}

} // namespace

ElementCount::ElementCount(int elements, double accuracy, int limit, int least)
    : accuracy_(accuracy), least_(least), usual_(elements > 0 ? elements : int(usual_elements)),
      wanted_(usual_) {
  const auto elements_for = [&](double error) {
    return usual_elements * (accuracy > 0 ? std::pow(error / accuracy, 1 / error_order) : 1.0);
  };
  const double needed = elements_for(usual_error);
  most_ = static_cast<int>(
      std::clamp(rare_factor * elements_for(rare_error), rare_factor * usual_elements, double(limit)));
  if (elements == 0)
    usual_ = wanted_ =
        static_cast<int>(std::clamp(needed, double(std::max(int(usual_elements), least)), double(limit)));
}

void ElementCount::forget() {
  wanted_ = std::min(wanted_, usual_);
}

bool ElementCount::learn(int contact, double error) {
  if (accuracy_ <= 0 || contact <= 0)
    return false;
  if (error < 0) { // nothing is known but that there are few
    const bool more = contact < most_ / 2 && wanted_ < most_;
    wanted_ = more ? std::min(most_, 2 * std::max(wanted_, contact)) : wanted_;
    return more;
  }
  const double needed = element_reserve * contact * std::pow(error / accuracy_, 1 / error_order);
  const bool again = error > accuracy_ && contact < most_;
  // Errors scatter: come down not at once, and go up by no more than a retry can correct.
  const double lo = (again ? least_retry : least_change) * contact, hi = most_change * contact;
  wanted_ = static_cast<int>(std::clamp(std::clamp(needed, lo, hi), double(least_), double(most_)));
  if (!again && wanted_ > usual_) // the next case may well be a usual one
    wanted_ = static_cast<int>(usual_ * std::pow(double(wanted_) / usual_, learnt_share));
  return again && wanted_ > contact;
}

namespace {

/// Length of elements over their width. Behind the leading edge tractions grow over the shorter axis of a
/// contact, whichever way that lies: long elements in a contact drawn out along x, as at the gauge corner,
/// cost three times the error.
double aspect_of(const ContactExtent& extent, double longest) {
  return std::clamp(extent.along_x / extent.along_s, double(shortest_element_aspect), longest);
}

} // namespace

std::pair<double, double> size_of_elements(const ContactEstimate& estimate, int elements, double area_ratio,
                                           const ElementLimits& limits) {
  const ContactExtent extent = contact_extent(estimate);
  if (!(extent.area > 0) || !(extent.along_x > 0) || !(extent.along_s > 0))
    return {default_dx, default_ds};
  const double area = extent.area * area_ratio, element = area / elements;
  const double aspect = aspect_of(extent, limits.longest);
  // One is rounded to the nearest, the other such that there are not fewer elements than asked for.
  const double dx = std::max(limits.shortest, on_ladder(std::sqrt(element * aspect), false));
  if (dx > limits.shortest)
    return {dx, on_ladder(element / dx, true)};
  // Where dx may not follow, rows as narrow as if it did say all that can be said: what is left of the error
  // is that of the length. Only a contact of too few elements for an estimate gets narrower ones.
  const double wide =
      std::max(element / dx, std::min(std::sqrt(element / aspect), area / limits.fewest / dx));
  return {dx, std::max(narrowest_element_share * dx, on_ladder(wide, true))};
}

namespace {

/// Whether the case leaves the size of its elements open.
bool open_size(const SceneFile::Grid& grid) {
  return grid.elements || grid.accuracy;
}

/// The shortest element that influence files have numbers for, mm; 0: any.
double shortest_element(const PairFiles& files) {
  double shortest = 0;
  for (const auto& file : files.all())
    shortest = std::max(shortest, wavelength_reserve * shortest_dx(file->strip()));
  return shortest;
}

} // namespace

void ElementSize::begin(const ContactCase& asked, bool alike) {
  const std::optional<Model> model = asked.scene.solver.model;
  // Which model is chosen automatically is not known yet: it may have numbers that depend on both rows.
  const bool full = depends_on_both_rows(model);
  const bool by_bodies = model ? has_files(*model) : has_influence_files_of_both(asked);
  const Request request{asked.scene.grid.elements.value_or(0), asked.scene.grid.accuracy.value_or(0)};
  if (!count_ || request != request_)
    count_.emplace(request.elements, request.accuracy, full ? most_elements_full : most_elements,
                   by_bodies ? fewest_with_bodies(request.accuracy) : fewest_elements);
  request_ = request;
  // Half-space numbers serve any element.
  shortest_ = !model || has_files(*model) ? shortest_element(asked.files) : 0;
  longest_ = full ? longest_element_full : longest_element;
  if (!alike) {
    count_->forget();
    area_ratio_ = std::clamp(area_ratio_, double(least_area_ratio), double(most_area_ratio));
  }
}

SceneFile::Grid ElementSize::grid(const ContactCase& asked) const {
  SceneFile::Grid grid = asked.scene.grid;
  if (open_size(grid))
    std::tie(grid.dx, grid.ds) =
        size_of_elements(*asked.estimate, count_->wanted(), area_ratio_,
                         {shortest_, longest_, request_.accuracy > 0 ? count_->least() : count_->wanted()});
  return grid;
}

int ElementSize::counted(const ContactCase& asked, const ContactGrid& grid, int contact) const {
  if (grid.dx != shortest_)
    return contact;
  const double follows = grid.ds * aspect_of(contact_extent(*asked.estimate), longest_);
  return static_cast<int>(contact * std::max(1.0, grid.dx / follows));
}

bool ElementSize::learn(const ContactCase& asked, const SceneResult& out) {
  const bool known = out.result.certified() || out.result.trust.ended_early;
  return known && learn(asked, out.problem, out.result, !is_closed_form(out.choice.model));
}

bool ElementSize::asks_for_more(const ContactCase& asked, const ContactProblem& problem,
                                const ContactResult& result) const {
  return ElementSize(*this).learn(asked, problem, result, true);
}

bool ElementSize::learn(const ContactCase& asked, const ContactProblem& problem, const ContactResult& result,
                        bool by_elements) {
  if (result.patches.empty())
    return false;
  const ContactGrid& solved = problem.grid;
  const int contact = count_elements(result).contact;
  const double area = contact_extent(*asked.estimate).area;
  if (asked.estimate->approach > 0)
    area_ratio_ = learn_area_ && area > 0 ? contact * solved.dx * solved.ds / area : 1.0;
  if (!open_size(asked.scene.grid) || !by_elements ||
      !count_->learn(counted(asked, solved, contact), asked_error(asked.scene.grid, result)))
    return false;
  const SceneFile::Grid next = grid(asked);
  return next.dx != solved.dx || next.ds != solved.ds;
}

std::string ElementSize::limit(double dx) const {
  return dx == shortest_ ? "the influence files have no numbers for shorter ones"
                         : fmt::format("at most {} are tried", count_->most());
}

} // namespace bem_contact
