#include "bem_contact/sequence/strips.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/grow_grid.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Arc lengths on one body, mm.
struct Range {
  double from = 0, to = 0;
};

/// From the outer border of the first row to that of the last.
Range range_of(const std::vector<double>& s, double ds) {
  const auto [lo, hi] = std::ranges::minmax(s);
  return {lo - 0.5 * ds, hi + 0.5 * ds};
}

/// Whole millimetres, which every usual station width divides, with room for what friction changes; not
/// beyond the profile.
Range strip_for(const Range& rows, const TabulatedProfile& profile) {
  return {std::max(std::floor(rows.from - strip_reserve), std::ceil(profile.s_begin())),
          std::min(std::ceil(rows.to + strip_reserve), std::floor(profile.s_end()))};
}

/// The frictionless contact on the grid that it ends with.
ContactOnGrid grown_contact(const ContactCase& asked, const ContactOnGrid& contact, Model model) {
  WorkBudget work;
  return solve_on_growing_grid(asked, contact, {model, true}, {.work = work}, model == Model::fem).contact;
}

void add_strip(const char* body, const Range& strip, std::vector<std::string>& lines) {
  lines.push_back(fmt::format("strip that the model fem needs on the {0}, for its body file:\n"
                              "    [strip]\n    from = {1:g} # mm\n    to = {2:g}\n    station_width = {3:g}",
                              body, strip.from, strip.to, double(usual_station_width)));
}

} // namespace

std::string refusal_by_strips(const ContactCase& asked) {
  if (!asked.setup.wheel_rail() || !asked.files.complete())
    return {};
  try {
    grown_contact(asked, asked.setup.on(first_plan(asked, asked.scene.grid, true)), Model::fem);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

std::vector<std::string> describe_strips(const ContactCase& asked, const ContactOnGrid& contact) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  if (!placed)
    return {};
  std::vector<std::string> lines;
  const double ds = contact.problem.grid.ds;
  Range rail = range_of(contact.rail_s, ds), wheel = range_of(contact.wheel_s, ds);
  try {
    const ContactOnGrid grown = grown_contact(asked, contact, Model::halfspace);
    rail = range_of(grown.rail_s, ds);
    wheel = range_of(grown.wheel_s, ds);
  } catch (const Error&) { // what is wrong with the scene is said where it is solved; the first grid serves
  }
  add_strip("rail", strip_for(rail, placed->pair.rail), lines);
  add_strip("wheel", strip_for(wheel, placed->pair.wheel), lines);
  return lines;
}

} // namespace bem_contact
