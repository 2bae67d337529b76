#include "bem_contact/sequence/solution/section_ends.hpp"

#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/numbers/section_blend.hpp"
#include "bem_contact/sequence/solution/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Rows and columns in contact: first row, last row, length along x in mm.
struct InContact {
  int first_row = 0, last_row = -1;
  double length = 0;
};
InContact extent_of(const ContactGrid& grid, const ContactResult& result, const SectionBlend::Stretch& of) {
  InContact out;
  int first = grid.mx, last = -1;
  for (int row = of.first; row < of.first + of.rows; ++row)
    for (int column = 0; column < grid.mx; ++column)
      if (result.state[row * grid.mx + column] != ElementState::exterior) {
        out.first_row = out.last_row < 0 ? row : out.first_row;
        out.last_row = row;
        first = std::min(first, column);
        last = std::max(last, column);
      }
  out.length = last < first ? 0 : (last - first + 1) * grid.dx;
  return out;
}

/// Of the stretches in contact the one that changes most over it.
struct Change {
  double over_contact = 0, bend = 0, length = 0;
};
Change change_over(const SectionBlend& blend, const ContactOnGrid& contact, const ContactResult& result) {
  Change out;
  for (const SectionBlend::Stretch& stretch : blend.stretches) {
    const InContact here = extent_of(contact.problem.grid, result, stretch);
    if (here.last_row < 0 || !(stretch.distance > 0))
      continue;
    const double share = stretch.parts.front().weight;
    out.bend = std::max(out.bend, share * (1 - share));
    out.over_contact = std::max(out.over_contact, here.length / stretch.distance);
    out.length = std::max(out.length, here.length);
  }
  return out;
}

/// Nothing bears where no file says how the rail yields.
void require_free_gaps(const SectionBlend& blend, const ContactGrid& grid, const ContactResult& result) {
  for (const SectionBlend::Stretch& stretch : blend.stretches)
    if (stretch.parts.empty() && extent_of(grid, result, stretch).last_row >= 0)
      throw OffStripError("The contact reaches the end of a strip of the influence files",
                          "on the side of a body, where a gap begins, a row bears that no file covers",
                          "Compute influence functions of longer strips, or choose solver.model = "
                          "\"halfspace\" or \"tangent_plane\".");
}

void require_correspondence(const SectionBlend& blend, const ContactCase& asked) {
  for (const SectionBlend::Stretch& stretch : blend.stretches)
    for (const SectionBlend::Part& part : stretch.parts)
      if (part.off > farthest_correspondence)
        throw OffStripError(
            fmt::format("{} is too unlike the rail where the wheel stands",
                        section_in_words(asked.setup.rail.sections[part.file])),
            fmt::format("on it, rows of the contact would lie up to {:.2f} mm beside the points that "
                        "correspond, {:g} mm are allowed",
                        part.off, double(farthest_correspondence)),
            "Give influence files of sections that are nearer to each other.");
}

void require_small_change(const SectionEnds& ends, const ContactResult& result, double length) {
  const auto change = [&](Measured ContactTotals::*number) {
    const double scale = std::abs(result.totals.*number);
    return scale > 0
               ? ends.over_contact *
                     std::abs(ends.solved[1].result.totals.*number - ends.solved[0].result.totals.*number) /
                     scale
               : 0;
  };
  for (const auto& [name, number] : {std::pair{"the largest pressure", &ContactTotals::pmax},
                                     {"the vertical force", &ContactTotals::Fz},
                                     {"the approach", &ContactTotals::approach}})
    if (const double by = change(number); by > largest_section_change)
      throw OffStripError(
          "The section of the rail changes too much within the contact for its influence functions",
          fmt::format("over the {:.1f} mm of its length {} would change by {:.1f} %, {:g} % are allowed",
                      length, name, 100 * by, 100 * double(largest_section_change)),
          "Choose solver.model = \"halfspace\" or \"tangent_plane\".");
}

void add(const SectionEnds& ends, Measured& to, const Measured& before, const Measured& after) {
  if (to.error > 0)
    to.error += ends.error(before, after);
}

template <class Numbers>
void add_to(const SectionEnds& ends, std::initializer_list<Measured Numbers::*> members, Numbers& to,
            const Numbers& before, const Numbers& after) {
  for (const auto member : members)
    add(ends, to.*member, before.*member, after.*member);
}

} // namespace

double SectionEnds::error(double before, double after) const {
  return (0.5 * over_contact + bend) * std::abs(after - before);
}

std::optional<SectionEnds> section_ends(const ContactCase& asked, const GridSolution& solved,
                                        const SolveResources& resources) {
  if (asked.setup.rail.sections.empty() || !solved.result.certified() || solved.result.patches.empty())
    return std::nullopt;
  const ContactOnGrid& contact = solved.contact;
  const SectionBlend blend =
      blend_on_strips(asked.setup, asked.files, {contact.problem.rows, contact.rail_s, contact.wheel_s},
                      contact.problem.grid.ds);
  require_free_gaps(blend, contact.problem.grid, solved.result);
  require_correspondence(blend, asked);
  const Change change = change_over(blend, solved.contact, solved.result);
  if (!(change.over_contact > 0))
    return std::nullopt;
  SectionEnds out{
      .asked = {asked, asked}, .solved = {}, .over_contact = change.over_contact, .bend = change.bend};
  const auto start = former_of(solved.model, solved.contact.problem, solved.result, *asked.estimate);
  for (const int end : {0, 1}) {
    out.asked[end].setup.rail.section_end = end == 0 ? SectionEnd::before : SectionEnd::after;
    WorkBudget work = resources.work.another();
    SolveResources tools = resources.with(work, start ? &*start : nullptr);
    tools.totals_only = true; // no errors of the elements
    require_strips(out.asked[end], solved.contact.plan);
    out.solved[end] = solve_on_grid(out.asked[end], solved.contact, {solved.model}, tools);
    if (!out.solved[end].result.certified())
      throw ConvergenceError(
          "The error of blended influence functions is not known",
          fmt::format("with those of the {} section alone the contact has no certified solution",
                      end == 0 ? "first" : "second"),
          "Change the elements a little, or choose solver.model = \"halfspace\".");
  }
  require_small_change(out, solved.result, change.length);
  return out;
}

std::optional<double> free_creepage_error(SectionEnds& ends, const SolveResources& resources) {
  std::array<std::optional<Measured>, 2> found;
  SolveResources tools = resources;
  tools.totals_only = true;
  for (const int end : {0, 1})
    found[end] = free_creepage_of(ends.asked[end], ends.solved[end], tools);
  return found[0] && found[1] ? std::optional(ends.error(*found[0], *found[1])) : std::nullopt;
}

void add_section_errors(const SectionEnds& ends, ContactResult& result) {
  const ContactResult &before = ends.solved[0].result, &after = ends.solved[1].result;
  using T = ContactTotals;
  add_to<T>(ends,
            {&T::Fx, &T::Fy, &T::Fz, &T::Fs, &T::approach, &T::creepage_x, &T::creepage_s, &T::pmax, &T::area,
             &T::adhesion_share, &T::T_gamma, &T::Tmax_rail, &T::Tmax_wheel},
            result.totals, before.totals, after.totals);
  using P = PatchSummary;
  const std::initializer_list<Measured P::*> of_patch = {
      &P::fn, &P::fx, &P::fs, &P::overlap, &P::pmax, &P::fy, &P::fz, &P::moment_n, &P::area, &P::T_gamma};
  const std::size_t count = result.patches.size();
  const bool same = before.patches.size() == count && after.patches.size() == count;
  for (std::size_t k = 0; k < count; ++k) {
    PatchSummary& patch = result.patches[k];
    if (same)
      add_to<P>(ends, of_patch, patch, before.patches[k], after.patches[k]);
    else // which is which is not known
      for (const auto member : of_patch)
        (patch.*member).error = unknown_error;
  }
}

void add_section_error(const SectionEnds& ends, const ReferencePoint& about, Measured& moment) {
  add(ends, moment, moment_about(about, ends.solved[0].result), moment_about(about, ends.solved[1].result));
}

} // namespace bem_contact
