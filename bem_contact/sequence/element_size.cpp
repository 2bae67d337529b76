#include "bem_contact/sequence/element_size.hpp"

#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/scene/accuracy_of.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Whether the case leaves the size of its elements open.
bool open_size(const SceneFile::Grid& grid) {
  return grid.elements || grid.accuracy;
}

/// The shortest element that influence files have numbers for, mm; 0: any.
double shortest_element(const PairFiles& files) {
  double shortest = 0;
  for (const auto& file : {files.rail, files.wheel})
    if (file)
      shortest = std::max(shortest, wavelength_reserve * shortest_dx(*file));
  return shortest;
}

double relative(double error, double value) {
  return value != 0 ? error / std::abs(value) : 0.0;
}

double error_of(AccuracyOf what, const SceneResult& out) {
  const ContactResult& r = out.result;
  const TotalErrors& e = r.discretisation->errors;
  switch (what) {
  case AccuracyOf::pmax:
    return relative(e.pmax, largest_pressure(r));
  case AccuracyOf::area:
    return relative(e.area, contact_area(r));
  case AccuracyOf::adhesion:
    return e.adhesion_share;
  case AccuracyOf::approach:
    return relative(e.approach, r.approach);
  case AccuracyOf::creepages:
    return std::max(relative(e.creepage_x, r.creepage_x), relative(e.creepage_s, r.creepage_s));
  case AccuracyOf::friction_power:
    return relative(e.friction_power, friction_power(r, out.problem.element_area()));
  case AccuracyOf::forces:
    break;
  }
  return r.certificate.discretisation;
}

} // namespace

double asked_error(const SceneFile::Grid& grid, const SceneResult& out) {
  const double forces = out.result.certificate.discretisation;
  if (!out.result.discretisation || !out.result.discretisation->converges)
    return forces;
  double largest = 0;
  for (const AccuracyOf what : accuracy_of(grid.accuracy_of))
    largest = std::max(largest, error_of(what, out));
  return largest;
}

void ElementSize::begin(const ContactCase& asked, bool alike) {
  const std::optional<Model> model = asked.scene.solver.model;
  // Which model is chosen automatically is not known yet: it may have numbers that depend on both rows.
  const bool full = model != Model::halfspace && model != Model::hertz;
  const Request request{asked.scene.grid.elements.value_or(0), asked.scene.grid.accuracy.value_or(0)};
  if (!count_ || request != request_)
    count_.emplace(request.elements, request.accuracy, full ? most_elements_full : most_elements,
                   full ? fewest_elements_full : fewest_elements);
  request_ = request;
  // Half-space numbers serve any element.
  shortest_ = !model || model == Model::fem ? shortest_element(asked.files) : 0;
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
        size_of_elements(*asked.estimate, count_->wanted(), area_ratio_, shortest_, longest_);
  return grid;
}

bool ElementSize::learn(const ContactCase& asked, const SceneResult& out) {
  const ContactResult& r = out.result;
  if (!r.converged || r.patches.empty())
    return false;
  const ContactGrid& solved = out.problem.grid;
  const int contact = count_elements(r).contact;
  const double area = contact_extent(*asked.estimate).area;
  if (asked.estimate->approach > 0)
    area_ratio_ = learn_area_ && area > 0 ? contact * solved.dx * solved.ds / area : 1.0;
  if (!open_size(asked.scene.grid) || out.model == Model::hertz ||
      !count_->learn(contact, asked_error(asked.scene.grid, out)))
    return false;
  const SceneFile::Grid next = grid(asked);
  return next.dx != solved.dx || next.ds != solved.ds;
}

std::string ElementSize::limit(double dx) const {
  return dx == shortest_ ? "the influence files have no numbers for shorter ones"
                         : fmt::format("at most {} are tried", count_->most());
}

} // namespace bem_contact
