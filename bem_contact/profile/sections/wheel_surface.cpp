#include "bem_contact/profile/sections/wheel_surface.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/sections/section_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Sections are repeated before and behind the turn, so that the ends of the splines are felt nowhere in
/// it: from section to section they die down by 2 + sqrt(3), and 4^-20 is 1e-12.
constexpr int sections_beyond = 20;
/// 1. The way from the last section to the first one is no part of the drawing if it is so many times as long
/// as that between the two beside it. Chosen.
constexpr double left_open = 4;
/// rad. A section this near to the first one, a turn on, is that one.
constexpr double same_angle = 1e-4;

/// mm. A section beyond a whole turn says again what the wheel is there, but for this: more than two
/// measurements of one wheel differ by. Chosen.
constexpr double said_again = 0.05;
/// mm. Distance of the points of it that are looked at.
constexpr double said_again_step = 1.0;
/// mm. The radius of a wheel, nearly.
constexpr double usual_radius = 460;
/// rad.
constexpr double whole_turn = 2 * std::numbers::pi;

BodySection turned_on(BodySection section, double by) {
  section.at += by;
  return section;
}

/// The first section lies less than a turn from 0.
void turn_to_zero(std::vector<BodySection>& sections) {
  const double by = -whole_turn * std::trunc(sections.front().at / whole_turn);
  for (BodySection& section : sections)
    section.at += by;
}

/// Those that lie a turn behind the first one or farther: they are taken out.
std::vector<BodySection> beyond_a_turn(std::vector<BodySection>& sections) {
  std::vector<BodySection> out;
  for (; sections.size() > 2 && sections.back().at - sections.front().at > whole_turn - same_angle;
       sections.pop_back())
    out.push_back(sections.back());
  return out;
}

void require_said_again(const SectionedSurface& wheel, const BodySection& section) {
  std::vector<double> t;
  const double at = std::remainder(section.at, whole_turn);
  double most = 0;
  for (const CurvePoint& p : points_along(wheel.section(at, t), said_again_step)) {
    const CurvePoint near = section.profile.nearest(p.position);
    if (near.s > section.profile.s_begin() && near.s < section.profile.s_end())
      most = std::max(most, norm(near.position - p.position));
  }
  if (most > said_again)
    throw InputError(fmt::format("Section '{}' at {:g} rad is not what the wheel is there a turn before",
                                 section.profile.name(), section.at),
                     fmt::format("it lies up to {:.3g} mm off the sections about {:g} rad", most, at),
                     "Give each angle of a turn (6.2832 rad) once.");
}

} // namespace

SectionedSurface wheel_surface(std::vector<BodySection> sections, bool approximated) {
  const SectionsAre are{"wheel", "rad", usual_radius, approximated};
  require_sections(sections, are);
  const double given_from = sections.front().at, given_to = sections.back().at;
  turn_to_zero(sections);
  const std::vector<BodySection> again =
      given_to - given_from < 2 * whole_turn ? beyond_a_turn(sections) : std::vector<BodySection>();
  if (sections.back().at - sections.front().at > whole_turn - same_angle)
    throw InputError(fmt::format("The sections of the wheel go from {:g} to {:g} rad", given_from, given_to),
                     "a turn has 6.2832 rad", "Give the angles in rad; of a slices file, correct its scale.");
  if (!again.empty()) {
    const SectionedSurface through = wheel_surface(sections);
    for (const BodySection& section : again)
      require_said_again(through, section);
  }
  const std::size_t last = sections.size() - 1;
  const double open = sections.front().at + whole_turn - sections.back().at,
               at_end = sections[last].at - sections[last - 1].at, at_begin = sections[1].at - sections[0].at;
  if (open > left_open * std::max(at_end, at_begin)) {
    sections.push_back(turned_on(sections.back(), at_end));
    sections.insert(sections.begin(), turned_on(sections.front(), -at_begin));
  }
  const int count = static_cast<int>(sections.size());
  std::vector<BodySection> all;
  const double first = -std::numbers::pi, end = std::numbers::pi;
  const auto at = [&](int i) {
    const int whole = static_cast<int>(std::floor(static_cast<double>(i) / count));
    return turned_on(sections[i - whole * count], whole_turn * whole);
  };
  int from = 0, to = 0;
  while (at(from).at > first)
    --from;
  while (at(to).at < end)
    ++to;
  for (int i = from - sections_beyond; i <= to + sections_beyond; ++i)
    all.push_back(at(i));
  return SectionedSurface(std::move(all), are);
}

} // namespace bem_contact
