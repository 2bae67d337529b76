#include "bem_contact/sequence/numbers/section_blend.hpp"

#include "bem_contact/influence/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace bem_contact {

namespace {

/// mm. A contact this near to the first or the last section with a file is there: the wheel touches a little
/// ahead of or behind its centre, and rounding.
constexpr double at_section = 0.5;

/// Rows of one body, or of none (-1), that follow each other.
struct RowsOfBody {
  int body = -1, first = 0, count = 0;
};
std::vector<RowsOfBody> rows_of_bodies(const SectionedRail& rail, const std::vector<ContactRow>& rows) {
  std::vector<RowsOfBody> out;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const auto on = rail.on_section(rows[i]);
    const int body = on ? on->body : -1;
    if (out.empty() || out.back().body != body)
      out.push_back({body, i, 0});
    ++out.back().count;
  }
  return out;
}

/// Two neighbouring files of a body, or the one that it has, and how far the contact is from the first of
/// them to the second.
struct Neighbours {
  std::size_t first = 0, count = 0; ///< Body::sections
  double share = 0, distance = 0;   ///< 1; mm
};

Neighbours neighbours_of(const std::vector<SectionInfluence>& files, int body, double u) {
  const auto [begin, end] = std::ranges::equal_range(files, body, {}, &SectionInfluence::body);
  const auto first = static_cast<std::size_t>(begin - files.begin());
  if (std::distance(begin, end) == 1)
    return {first, 1, 0, 0};
  const double from = begin->at, to = std::prev(end)->at;
  if (!(u > from - at_section && u < to + at_section))
    throw OffStripError("The contact is not between sections of the rail that have influence files",
                        fmt::format("it is at {:.6g} mm along the track, and the files of this body are of "
                                    "sections from {:g} to {:g} mm",
                                    u, from, to),
                        "Give influence files of sections on either side, or choose solver.model = "
                        "\"halfspace\" or \"tangent_plane\".");
  const double place = std::clamp(u, from, to);
  const auto after =
      std::min(std::upper_bound(begin, end, place, [](double at, const auto& one) { return at < one.at; }),
               std::prev(end));
  const auto before = std::prev(after);
  const double distance = after->at - before->at;
  return {static_cast<std::size_t>(before - files.begin()), 2, (place - before->at) / distance, distance};
}

double weight_of(std::size_t part, double share, SectionEnd end) {
  switch (end) {
  case SectionEnd::before:
    return part == 0 ? 1 : 0;
  case SectionEnd::after:
    return part == 0 ? 0 : 1;
  default:
    return part == 0 ? 1 - share : share;
  }
}

/// The row of the reference point, or the one in the middle of those.
int middle_row(const RowsOfBody& of, const std::vector<ContactRow>& rows, double reference_s) {
  const ContactRow &first = rows[of.first], &last = rows[of.first + of.count - 1];
  if (!(reference_s >= first.s && reference_s <= last.s))
    return of.first + of.count / 2;
  const auto begin = rows.begin() + of.first;
  return of.first + static_cast<int>(std::ranges::min_element(
                                         begin, begin + of.count, {},
                                         [&](const ContactRow& r) { return std::abs(r.s - reference_s); }) -
                                     begin);
}

/// Arc length of a row's point on the profile of a section less that of the row.
double shift_to(const SectionInfluence& section, const SectionedRail& rail, const ContactRow& row) {
  const auto on = rail.on_section(row);
  const auto s = on ? rail.arc_length(*on, section.at) : std::nullopt;
  if (!s)
    throw OffStripError(fmt::format("No part of {} corresponds to the contact", section_in_words(section)),
                        "its feature lines end before the contact, or begin behind it, and its influence "
                        "file is wanted there",
                        "Give an influence file of a section that has the part where the wheel stands.");
  return *s - row.s;
}

} // namespace

std::string section_in_words(const SectionInfluence& section) {
  return section.all_along ? fmt::format("body {} of the rail", section.body + 1)
                           : fmt::format("the section at {:g} mm along the track", section.at);
}

SectionBlend section_blend(const ContactSetup& setup, const std::vector<ContactRow>& rows) {
  const WheelRailGeometry& placed = *setup.wheel_rail();
  const SectionedRail& rail = *placed.pair.sections;
  const std::vector<SectionInfluence>& files = setup.rail.sections;
  SectionBlend out;
  for (const RowsOfBody& of : rows_of_bodies(rail, rows)) {
    SectionBlend::Stretch& stretch =
        out.stretches.emplace_back(SectionBlend::Stretch{of.first, of.count, 0, {}});
    if (of.body < 0)
      continue;
    const ContactRow& middle = rows[middle_row(of, rows, placed.reference.s)];
    const Neighbours near = neighbours_of(files, of.body, rail.on_section(middle)->u);
    stretch.distance = near.distance;
    for (std::size_t part = 0; part < near.count; ++part) {
      const double weight = weight_of(part, near.share, setup.rail.section_end);
      if (weight == 0 && near.count > 1)
        continue;
      const SectionInfluence& section = files[near.first + part];
      const double shift = shift_to(section, rail, middle);
      double off = 0;
      for (const ContactRow* end : {&rows[of.first], &rows[of.first + of.count - 1]})
        if (const auto on = rail.on_section(*end))
          if (const auto s = rail.arc_length(*on, section.at))
            off = std::max(off, std::abs(*s - end->s - shift));
      stretch.parts.push_back({near.first + part, near.count > 1 ? weight : 1, shift, off});
    }
  }
  return out;
}

} // namespace bem_contact
