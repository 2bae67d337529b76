#include "bem_contact/sequence/scene_growth.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_solve.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Sides of the grid that the contact touches.
struct Touched {
  bool first_row = false, last_row = false, columns = false;

  bool any() const { return first_row || last_row || columns; }
};

void add_touched(const ContactGrid& grid, const ContactResult& result, Touched& out) {
  for (int is = 0; is < grid.ms; ++is)
    for (int ix = 0; ix < grid.mx; ++ix) {
      if (result.state.empty() || result.state[is * grid.mx + ix] == ElementState::exterior)
        continue;
      out.first_row |= is == 0;
      out.last_row |= is == grid.ms - 1;
      out.columns |= ix == 0 || ix == grid.mx - 1;
    }
}

Touched touched_edges(const SceneResult& solved) {
  Touched out;
  add_touched(solved.problem.grid, solved.result, out);
  for (const ContactResult& step : solved.history)
    add_touched(solved.problem.grid, step, out);
  return out;
}

void grow(Stage& stage, const Touched& touched) {
  const Stopwatch watch;
  GridPlan& plan = stage.wheel_rail->plan;
  const int more_rows = std::max(4, plan.rows / 4);
  if (touched.first_row)
    plan.first -= more_rows;
  plan.rows += (touched.first_row ? more_rows : 0) + (touched.last_row ? more_rows : 0);
  if (touched.columns)
    plan.columns += 2 * std::max(2, plan.columns / 8);
  const ContactProblem before = std::move(stage.contact.problem);
  stage.contact = prepare_wheel_rail(*stage.wheel_rail, *stage.scene);
  if (stage.needs_strips) {
    // Up to the end of the strip; where it ends at the contact already, the scene is refused.
    const auto [first, last] = covered_rows(stage.files, stage.contact);
    const int after = plan.rows - 1 - last;
    if ((touched.first_row && first >= more_rows) || (touched.last_row && after >= more_rows))
      require_strips(stage.files, stage.contact);
    plan.first += first;
    plan.rows = last - first + 1;
    stage.contact = prepare_wheel_rail(*stage.wheel_rail, *stage.scene);
  }
  take_load(stage.contact.problem, before);
  stage.seconds.geometry += watch.seconds();
}

/// Nothing may touch where the influence files say nothing.
[[noreturn]] void refuse_second_area(const GridPlan& plan, const TouchPoint& touch, double approach) {
  throw InputError(
      "The bodies touch in a second area that the influence files do not cover",
      fmt::format("at the approach found, {:.4f} mm, they would overlap by {:.4f} mm at s = {:.2f} mm of the "
                  "rail; the rows solved are s = {:.2f} .. {:.2f} mm",
                  approach, approach - touch.distance, touch.rail_s, plan.s_from(), plan.s_to()),
      "Compute influence functions of a longer strip, choose tangent_plane or halfspace, or leave that area "
      "out with grid.s_from and grid.s_to.");
}

/// Widens the grid to places outside it where the rigid bodies would overlap at the approach that was found:
/// a second area that the estimate took for free. There is a warning instead where the scene itself says
/// which rows it wants, and where the model is of one area. Returns whether there is something to solve
/// again. Throws InputError where the strips of influence files end before.
bool add_areas(Stage& stage, SceneResult& out) {
  const SceneFile::Grid& asked = stage.scene->grid;
  if (!stage.wheel_rail)
    return false;
  const Stopwatch watch;
  GridPlan& plan = stage.wheel_rail->plan;
  const GridPlan before = plan;
  const double q = out.result.approach;
  const TouchPoint* second = nullptr;
  for (const PotentialArea& area : potential_areas(stage.wheel_rail->estimate, q))
    for (const TouchPoint& touch : stage.wheel_rail->touch) {
      const bool outside = touch.rail_s < before.s_from() || touch.rail_s > before.s_to();
      if (outside && touch.distance < q && area.s_from <= touch.rail_s && touch.rail_s <= area.s_to) {
        cover(plan, area);
        second = second && second->distance < touch.distance ? second : &touch;
      }
    }
  if (!second)
    return false;
  const bool rows_given = asked.ms || asked.rows;
  if (rows_given || out.model == Model::hertz) {
    plan = before;
    out.warnings.push_back(fmt::format(
        "the bodies come nearer than the approach at s = {:.2f} mm too, by {:.4f} mm, {}: what may touch "
        "there is left out",
        second->rail_s, q - second->distance,
        rows_given ? "off the rows that the scene asks for" : "and Hertz's closed form is of one area"));
    return false;
  }
  PreparedContact wider = prepare_wheel_rail(*stage.wheel_rail, *stage.scene);
  const auto [first, last] = covered_rows(stage.files, wider);
  if (stage.needs_strips && last - first + 1 < plan.rows)
    refuse_second_area(before, *second, q);
  take_load(wider.problem, stage.contact.problem);
  stage.contact = std::move(wider);
  stage.seconds.geometry += watch.seconds();
  return true;
}

std::string edge_warning(const Touched& touched) {
  return fmt::format(
      "the contact reaches the edge of the grid ({}{}{}): the area beyond it is taken as bodiless",
      touched.columns ? "along x" : "",
      touched.columns && (touched.first_row || touched.last_row) ? " and " : "",
      touched.first_row || touched.last_row ? "along s" : "");
}

} // namespace

SceneResult solve_grown(Stage& stage, Model model, bool tangential) {
  PhaseSeconds spent;
  for (int round = 0;; ++round) {
    SceneResult out = solve_once(stage, model, tangential);
    spent.numbers += out.seconds.numbers;
    spent.solve += out.seconds.solve;
    out.seconds = spent;
    const Touched touched = touched_edges(out);
    if (!touched.any()) {
      if (round < most_growths && add_areas(stage, out))
        continue;
      const SceneFile::Grid& asked = stage.scene->grid;
      if (stage.grown && (asked.mx || asked.ms || asked.rows))
        out.warnings.push_back(fmt::format("the contact did not fit on the grid asked for: it grew to {} x "
                                           "{} elements, s = {:.2f} .. {:.2f} mm",
                                           out.problem.grid.mx, out.problem.grid.ms,
                                           stage.wheel_rail->plan.s_from(), stage.wheel_rail->plan.s_to()));
      return out;
    }
    if (!stage.wheel_rail) {
      const bool along_x = touched.columns && out.problem.grid.mx > 1;
      const bool along_s = (touched.first_row || touched.last_row) && out.problem.grid.ms > 1;
      if (along_x || along_s)
        out.warnings.push_back(
            edge_warning({along_s && touched.first_row, along_s && touched.last_row, along_x}));
      return out;
    }
    if (round == most_growths)
      throw InputError("The contact does not fit on a potential contact of any reasonable size",
                       fmt::format("it still reaches the edge of {} x {} elements", out.problem.grid.mx,
                                   out.problem.grid.ms),
                       "Give a smaller force, larger elements (grid.dx, grid.ds), or rows around the contact "
                       "(grid.s_from, grid.s_to).");
    grow(stage, touched);
    stage.grown = true;
  }
}

} // namespace bem_contact
