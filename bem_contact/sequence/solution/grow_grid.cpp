#include "bem_contact/sequence/solution/grow_grid.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/plan_grid.hpp"
#include "bem_contact/sequence/solution/settings.hpp"
#include "bem_contact/sequence/solution/structural_motion.hpp"
#include "bem_contact/sequence/solution/trim_plan.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace bem_contact {

namespace {

/// 1. How often a grid may grow. It grows by a quarter in s, an eighth on either side in x.
constexpr int most_growths = 6;
/// 1. Columns by which it grows at least, on either side.
constexpr int fewest_more_columns = 2;

/// 1. After so many growths the grid follows the contact: it grows by as many rows as it has, and gives up
/// those that the contact has left. Structures that give way may carry a contact by many times its width.
constexpr int growths_in_place = 2;

/// Sides of the grid that the contact touches.
struct Touched {
  bool first_row = false, last_row = false, columns = false;
  int free_first = std::numeric_limits<int>::max(), free_last = free_first; ///< rows without contact

  bool any() const { return first_row || last_row || columns; }
};

void add_touched(const ContactGrid& grid, const ContactResult& result, Touched& out) {
  for (int is = 0; is < grid.ms; ++is)
    for (int ix = 0; ix < grid.mx; ++ix) {
      if (result.state.empty() || result.state[is * grid.mx + ix] == ElementState::exterior)
        continue;
      out.first_row |= is == 0;
      out.last_row |= is == grid.ms - 1;
      out.free_first = std::min(out.free_first, is);
      out.free_last = std::min(out.free_last, grid.ms - 1 - is);
      out.columns |= ix == 0 || ix == grid.mx - 1;
    }
}

Touched touched_edges(const GridSolution& solved) {
  const ContactGrid& grid = solved.contact.problem.grid;
  Touched out;
  add_touched(grid, solved.result, out);
  for (const ContactResult& step : solved.history)
    add_touched(grid, step, out);
  return out;
}

std::vector<std::string> strips_text(const ContactCase& contact, const GridPlan& plan) {
  std::vector<std::string> out;
  for (const RowsOnStrip& on :
       rows_on_files(contact.setup, contact.files, contact.setup.rows_on(plan), plan.ds)) {
    const auto [from, to] = on.file->strip().ends();
    out.push_back(fmt::format("s = {:.2f} .. {:.2f} mm of '{}'{}", from, to, on.file->strip().body,
                              on.section.empty() ? "" : fmt::format(" ({})", on.section)));
  }
  return out;
}

/// `plan`: the rows that were solved, as far as the strips reach.
[[noreturn]] void refuse_end_of_strip(const ContactCase& contact, const GridPlan& plan) {
  throw OffStripError(
      "The contact reaches the end of a strip of the influence files",
      fmt::format("they cover {}; the rows solved are s = {:.2f} .. {:.2f} mm of the rail",
                  fmt::join(strips_text(contact, plan), " and "), plan.s_from(), plan.s_to()),
      "Compute influence functions of longer strips (bem_contact check prints which), or choose "
      "tangent_plane or halfspace.");
}

/// Rows to give up at one end, of which the contact has left `free`.
int left_behind(int free) {
  return std::max(free - fewest_more_rows, 0);
}

/// Larger on the sides that the contact touches; up to the ends of the strips, where rows must lie on them.
/// `follows`: without what the contact has left. Throws InputError where a strip ends at the contact already.
GridPlan grown(const ContactCase& contact, GridPlan plan, const Touched& touched, bool follows,
               bool on_strips) {
  const GridPlan solved = plan;
  const int more_rows = follows ? plan.rows : std::max(int(fewest_more_rows), plan.rows / row_growth_share);
  if (follows) {
    plan.first += left_behind(touched.free_first);
    plan.rows -= left_behind(touched.free_first) + left_behind(touched.free_last);
  }
  if (touched.first_row)
    plan.first -= more_rows;
  plan.rows += (touched.first_row ? more_rows : 0) + (touched.last_row ? more_rows : 0);
  if (touched.columns)
    plan.columns += 2 * std::max(int(fewest_more_columns), plan.columns / column_growth_share);
  plan.grown = true;
  if (!on_strips)
    return plan;
  const auto [first, last] = rows_on_strips(contact, plan);
  const int after = plan.rows - 1 - last;
  if ((touched.first_row && first >= more_rows) || (touched.last_row && after >= more_rows))
    refuse_end_of_strip(contact, solved);
  plan.first += first;
  plan.rows = last - first + 1;
  return plan;
}

/// Nothing may touch where the influence files say nothing.
[[noreturn]] void refuse_second_area(const GridPlan& plan, const TouchPoint& touch, double approach) {
  throw OffStripError(
      "The bodies touch in a second area that the influence files do not cover",
      fmt::format("at the approach found, {:.4f} mm, they would overlap by {:.4f} mm at s = {:.2f} mm of the "
                  "rail; the rows solved are s = {:.2f} .. {:.2f} mm",
                  approach, approach - touch.distance, touch.rail_s, plan.s_from(), plan.s_to()),
      "Compute influence functions of a longer strip, choose tangent_plane or halfspace, or leave that area "
      "out with grid.s_from and grid.s_to.");
}

/// A place outside the grid where the rigid bodies would overlap at the approach that was found: a second
/// area that the estimate took for free. With a plan that covers all of them.
struct SecondArea {
  const TouchPoint* touch = nullptr; ///< the nearest; null: there is none
  GridPlan wider;
};
SecondArea second_area(const ContactCase& contact, const GridSolution& solved) {
  SecondArea out{nullptr, solved.contact.plan};
  if (!contact.estimate)
    return out;
  const double q = local_approach(contact, solved);
  for (const PotentialArea& area : potential_areas(*contact.estimate, q))
    for (const TouchPoint& touch : contact.setup.wheel_rail()->touch) {
      const bool outside =
          touch.rail_s < solved.contact.plan.s_from() || touch.rail_s > solved.contact.plan.s_to();
      if (outside && touch.distance < q && area.s_from <= touch.rail_s && touch.rail_s <= area.s_to) {
        cover(out.wider, area);
        out.touch = out.touch && out.touch->distance < touch.distance ? out.touch : &touch;
      }
    }
  return out;
}

std::string left_out_warning(const TouchPoint& touch, double approach, bool rows_given, Model model) {
  return fmt::format(
      "the bodies come nearer than the approach at s = {:.2f} mm too, by {:.4f} mm, {}: what may "
      "touch there is left out",
      touch.rail_s, approach - touch.distance,
      rows_given ? "off the rows that the scene asks for"
                 : fmt::format("and {} is of one area", elasticity_model(model).in_words));
}

std::string edge_warning(const Touched& touched) {
  return fmt::format(
      "the contact reaches the edge of the grid ({}{}{}): the area beyond it is taken as bodiless",
      touched.columns ? "along x" : "",
      touched.columns && (touched.first_row || touched.last_row) ? " and " : "",
      touched.first_row || touched.last_row ? "along s" : "");
}

std::string grown_warning(const GridPlan& plan) {
  return fmt::format("the contact did not fit on the grid asked for: it grew to {} x {} elements, s = {:.2f} "
                     ".. {:.2f} mm",
                     plan.columns, plan.rows, plan.s_from(), plan.s_to());
}

/// A patch cannot grow: its undeformed distance may end with it.
void warn_of_edge(const Touched& touched, GridSolution& out) {
  const ContactGrid& grid = out.contact.problem.grid;
  const bool along_x = touched.columns && grid.mx > 1;
  const bool along_s = (touched.first_row || touched.last_row) && grid.ms > 1;
  if (along_x || along_s)
    out.warnings.add(WarningKind::edge_of_grid,
                     edge_warning({along_s && touched.first_row, along_s && touched.last_row, along_x}));
}

/// The plan on which to solve again so that a second area lies on it; nothing where there is none. A warning
/// instead where the scene itself says which rows it wants, and where the model is of one area. Throws
/// InputError where the strips of influence files end before.
std::optional<GridPlan> plan_with_second_area(const ContactCase& contact, bool on_strips, GridSolution& out) {
  const SecondArea second = second_area(contact, out);
  if (!second.touch)
    return std::nullopt;
  const SceneFile::Grid& asked = contact.scene.grid;
  const bool rows_given = asked.ms || asked.rows;
  const double q = local_approach(contact, out);
  if (rows_given || is_closed_form(out.model)) {
    out.warnings.add(WarningKind::contact_left_out,
                     left_out_warning(*second.touch, q, rows_given, out.model));
    return std::nullopt;
  }
  if (on_strips) {
    const auto [first, last] = rows_on_strips(contact, second.wider);
    if (last - first + 1 < second.wider.rows)
      refuse_second_area(out.contact.plan, *second.touch, q);
  }
  return second.wider;
}

} // namespace

GridSolution solve_on_growing_grid(const ContactCase& asked, ContactOnGrid first, const SolveTask& task,
                                   const SolveResources& resources, bool on_strips) {
  const SceneFile::Grid& grid = asked.scene.grid;
  SolveResources tools = resources;
  std::optional<FormerSolution> smaller; // on the grid before
  PhaseSeconds spent;
  if (!first.plan.cropped && has_large_numbers(asked, first.plan, task.model)) {
    const TrimmedPlan needed = trimmed(asked, first.plan, task, resources, on_strips);
    first = asked.setup.on(needed.plan);
    spent = needed.seconds;
  }
  for (int round = 0;; ++round) {
    GridSolution out = solve_on_grid(asked, std::move(first), task, tools);
    spent += out.seconds;
    out.seconds = spent;
    const GridPlan& plan = out.contact.plan;
    const Touched touched = touched_edges(out);
    std::optional<GridPlan> next;
    if (touched.any()) {
      if (asked.setup.patch()) {
        warn_of_edge(touched, out);
        return out;
      }
      if (round == most_growths)
        throw InputError(
            "The contact does not fit on a potential contact of any reasonable size",
            fmt::format("it still reaches the edge of {} x {} elements", plan.columns, plan.rows),
            "Give a smaller force, larger elements (grid.dx, grid.ds), or rows around the contact "
            "(grid.s_from, grid.s_to).");
      const bool open = !grid.rows && !grid.ms;
      next = grown(asked, plan, touched, open && round >= growths_in_place, on_strips);
    } else if (round < most_growths) {
      next = plan_with_second_area(asked, on_strips, out);
    }
    if (!next) {
      if (plan.grown && (grid.mx || grid.ms || grid.rows))
        out.warnings.add(WarningKind::grown_grid, grown_warning(plan));
      return out;
    }
    if (asked.estimate && out.history.empty())
      smaller = former_of(out.model, out.contact.problem, out.result, *asked.estimate);
    if (smaller)
      tools.start = &*smaller;
    const Stopwatch geometry;
    first = asked.setup.on(*next);
    spent.geometry += geometry.seconds();
  }
}

} // namespace bem_contact
