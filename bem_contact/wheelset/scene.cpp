#include "bem_contact/wheelset/scene.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/wheelset/hertz_model.hpp"
#include "bem_contact/wheelset/motion.hpp"
#include "bem_contact/wheelset/pair_numbers.hpp"
#include "bem_contact/wheelset/scene_aids.hpp"
#include "bem_contact/wheelset/wheel_rail_scene.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <numbers>

namespace bem_contact {

namespace {

constexpr int most_growths = 6;
constexpr double poor_discretisation = 0.2; // relative error that deserves a warning
constexpr int few_elements = 40;            // in contact
constexpr double largest_memory = 8.0;      // GB
constexpr std::size_t many_steps = 1000;    // from here on progress is said
constexpr double radius_tolerance = 0.01;   // of the wheel radius that an influence file was made for

class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The scene made ready: a contact that can be rebuilt on a larger grid (wheel_rail) or not (patch).
struct Stage {
  const SceneFile* scene = nullptr;
  PairFiles files;
  std::optional<WheelRailScene> wheel_rail;
  PreparedContact contact;
  PhaseSeconds seconds;
  bool needs_strips = false; ///< every row must lie on the strips of the influence files
  SceneAids aids;

  ReferencePoint reference() const {
    if (wheel_rail)
      return wheel_rail->reference;
    return {};
  }
};

void require_radius(const InfluenceFunction& wheel, double wheel_radius) {
  if (wheel.invariance == Invariance::revolution &&
      std::abs(wheel.reference_radius - wheel_radius) > radius_tolerance * wheel_radius)
    throw InputError(fmt::format("The influence functions of '{}' do not belong to this wheel", wheel.body),
                     fmt::format("they are for a nominal radius of {:g} mm, position.wheel_radius is {:g} mm",
                                 wheel.reference_radius, wheel_radius),
                     "Compute influence functions of this wheel, or correct the radius.");
}

/// Numbers of both bodies, of the pair, and the operator's spectra: four times one table.
void require_memory(const ContactGrid& grid) {
  const double gigabytes = 4 * 8e-9 * 9 * double(grid.ms) * grid.ms * (grid.mx + 2);
  if (gigabytes > largest_memory)
    throw InputError(fmt::format("A grid of {} x {} elements is too large", grid.mx, grid.ms),
                     fmt::format("its influence numbers need about {:.0f} GB, {:g} GB are allowed", gigabytes,
                                 largest_memory),
                     "Use larger elements or fewer of them, above all along s.");
}

/// The fields of every step are kept: tractions, slip, distance, states.
void require_memory(const ContactGrid& grid, std::size_t steps) {
  const double gigabytes = 1e-9 * (6 * sizeof(double) + 1) * double(grid.size()) * double(steps);
  if (gigabytes > largest_memory)
    throw InputError(
        fmt::format("A history of {} steps on {} x {} elements is too large", steps, grid.mx, grid.ms),
        fmt::format("the fields of all steps need about {:.0f} GB, {:g} GB are allowed", gigabytes,
                    largest_memory),
        "Take fewer steps (rolling is steady after about two lengths of contact), or elements.");
}

Stage prepare(const SceneFile& scene, bool needs_strips, const SceneAids& aids = {}) {
  const Stopwatch watch;
  Stage stage{&scene, {}, {}, {}, {}, needs_strips, aids};
  if (scene.kind == "wheel_rail") {
    stage.wheel_rail = aids.placed ? *aids.placed : place_wheel_rail(scene);
    stage.files = aids.files ? *aids.files : read_pair_files(scene);
    if (stage.files.rail)
      require_profile(*stage.files.rail, stage.wheel_rail->pair.rail.name(),
                      stage.wheel_rail->pair.rail.digest());
    if (stage.files.wheel)
      require_profile(*stage.files.wheel, stage.wheel_rail->pair.wheel.name(),
                      stage.wheel_rail->pair.wheel.digest());
    if (stage.files.wheel)
      require_radius(*stage.files.wheel, scene.position.wheel_radius);
    stage.wheel_rail->plan = plan_wheel_rail(*stage.wheel_rail, scene, stage.files);
    stage.contact = prepare_wheel_rail(*stage.wheel_rail, scene);
    // The estimate is generous: give up rows off the strips, as long as the contact does not need them.
    if (needs_strips && scene.grid.s_from == scene.grid.s_to && scene.grid.ms == 0) {
      const auto [first, last] = covered_rows(stage.files, stage.contact);
      GridPlan& plan = stage.wheel_rail->plan;
      const int deepest =
          static_cast<int>(std::lround((stage.wheel_rail->touch.front().rail_s - plan.s(0)) / plan.ds));
      if (first <= deepest && deepest <= last && (first > 0 || last + 1 < plan.rows)) {
        plan.first += first;
        plan.rows = last - first + 1;
        stage.contact = prepare_wheel_rail(*stage.wheel_rail, scene);
      }
    }
  } else {
    stage.files = read_pair_files(scene);
    stage.contact = prepare_patch(scene);
  }
  if (needs_strips)
    require_strips(stage.files, stage.contact);
  ContactProblem& problem = stage.contact.problem;
  problem.load = scene.load.has_force ? LoadKind::force : LoadKind::approach;
  problem.approach = scene.load.has_force ? 0.0
                     : stage.wheel_rail   ? stage.wheel_rail->approach
                                          : scene.load.approach;
  problem.force = scene.load.has_force ? scene.load.force : 0.0;
  stage.seconds.geometry = watch.seconds();
  return stage;
}

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
  stage.contact.problem.load = before.load;
  stage.contact.problem.approach = before.approach;
  stage.contact.problem.force = before.force;
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
  const bool rows_given = asked.ms > 0 || asked.s_from != asked.s_to;
  if (rows_given || out.model == "hertz") {
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
  wider.problem.load = stage.contact.problem.load;
  wider.problem.approach = stage.contact.problem.approach;
  wider.problem.force = stage.contact.problem.force;
  stage.contact = std::move(wider);
  stage.seconds.geometry += watch.seconds();
  return true;
}

InfluenceNumbers compute_numbers(const Stage& stage, const std::string& model) {
  return model == "fem"             ? fem_pair(*stage.scene, stage.files, stage.contact)
         : model == "tangent_plane" ? tangent_plane_pair(*stage.scene, stage.contact)
                                    : halfspace_pair(*stage.scene, stage.contact);
}

/// Nothing where the problem is not one of Hertz's.
std::optional<HertzModel> hertz_of(const Stage& stage) {
  const ContactProblem& problem = stage.contact.problem;
  if (problem.tangential || stage.contact.plane_strain)
    return std::nullopt;
  return fit_hertz(problem, stage.scene->rail.material, stage.scene->wheel.material);
}

SceneResult solve_by_hertz(const Stage& stage) {
  const std::optional<HertzModel> model = hertz_of(stage);
  if (!model)
    throw InputError(
        "Hertz's closed form does not fit this contact",
        "it is for a frictionless contact in three dimensions whose undeformed distance is curved "
        "both ways and known all over the contact (on at least 5 x 5 elements)",
        "Set motion.frictionless = true, give a larger grid, or choose another model.");
  SceneResult out;
  out.model = "hertz";
  out.problem = stage.contact.problem;
  out.problem.numbers.dx = out.problem.grid.dx; // not plane strain
  out.result = solve_hertz(out.problem, *model, out.displacements);
  return out;
}

InfluenceNumbers numbers_of(const Stage& stage, const std::string& model) {
  NumbersStore* store = stage.wheel_rail && model != "tangent_plane" ? stage.aids.numbers : nullptr;
  const auto compute = [&] { return compute_numbers(stage, model); };
  if (!store)
    return compute();
  // All that they depend on: half-space numbers on the grid's size alone.
  const ContactGrid& grid = stage.contact.problem.grid;
  const SceneFile& scene = *stage.scene;
  std::string key = fmt::format("{} {} {} {} {}", model, grid.mx, grid.ms, grid.dx, grid.ds);
  for (const SceneFile::Side* side : {&scene.rail, &scene.wheel})
    key += fmt::format(" {} {} {} {}", side->material.shear_modulus, side->material.poisson, side->influence,
                       side->structural);
  if (model == "fem")
    key += fmt::format(" {} {} {}", fmt::join(stage.contact.rail_s, " "),
                       fmt::join(stage.contact.wheel_s, " "), stage.contact.contact_radius);
  return store->get(key, compute);
}

/// Without `tangential` it is a look at the normal problem, for the choice of the model.
SceneResult solve_once(Stage& stage, const std::string& model, bool tangential) {
  if (model == "hertz")
    return solve_by_hertz(stage);
  SceneResult out;
  out.model = model;
  ContactProblem& problem = stage.contact.problem;
  require_memory(problem.grid);
  const Stopwatch numbers;
  problem.numbers = numbers_of(stage, model);
  out.seconds.numbers = numbers.seconds();
  const Stopwatch solving;
  std::optional<StartingPoint> start;
  if (stage.wheel_rail && stage.aids.start)
    start =
        start_from(*stage.aids.start, problem, potential_areas(stage.wheel_rail->estimate), problem.force);
  const SolverOptions options{.tolerance = stage.scene->solver.tolerance,
                              .max_outer = stage.scene->solver.max_outer,
                              .estimate_discretisation = tangential,
                              .coarse_start = stage.aids.coarse_start,
                              .start = start ? &*start : nullptr,
                              .workspace = stage.aids.workspace};
  if (!tangential) {
    ContactProblem normal = problem;
    normal.tangential = false;
    out.result = solve(normal, options);
  } else if (!problem.tangential || problem.motion == MotionKind::steady) {
    out.result = solve(problem, options);
    out.displacements = displacements(problem, out.result, stage.aids.workspace);
  } else {
    const std::vector<MotionStep> steps = read_steps(*stage.scene);
    require_memory(problem.grid, steps.size());
    std::optional<Progress> progress;
    if (steps.size() >= many_steps)
      progress.emplace("steps", steps.size());
    const auto prescribe = [&](int k, ContactProblem& p) {
      if (progress && k > 0)
        progress->step();
      prescribe_step(p, *stage.scene, stage.wheel_rail ? &*stage.wheel_rail : nullptr, steps[k]);
    };
    const int last = static_cast<int>(steps.size()) - 1;
    out.history = solve_history(problem, last + 1, prescribe, options);
    if (progress) {
      progress->step();
      progress->finish();
    }
    out.result = out.history.back();
    progress.reset();
    prescribe(last, problem);
    out.displacements = displacements(problem, out.result, stage.aids.workspace);
    for (int k = 0; k < last; ++k)
      if (!out.history[k].converged)
        out.warnings.push_back(
            fmt::format("step {} of {} is not a solution ({})", k + 1, last + 1, out.history[k].remark));
  }
  problem.numbers.values = {}; // its form stays: plane strain or not
  out.seconds.solve = solving.seconds();
  out.problem = problem;
  return out;
}

std::string edge_warning(const Touched& touched) {
  return fmt::format(
      "the contact reaches the edge of the grid ({}{}{}): the area beyond it is taken as bodiless",
      touched.columns ? "along x" : "",
      touched.columns && (touched.first_row || touched.last_row) ? " and " : "",
      touched.first_row || touched.last_row ? "along s" : "");
}

/// Solves on a grid that grows until the contact lies inside.
SceneResult solve_grown(Stage& stage, const std::string& model, bool tangential) {
  PhaseSeconds spent;
  bool grown = false;
  for (int round = 0;; ++round) {
    SceneResult out = solve_once(stage, model, tangential);
    spent.numbers += out.seconds.numbers;
    spent.solve += out.seconds.solve;
    out.seconds = spent;
    const Touched touched = touched_edges(out);
    if (!touched.any()) {
      if (round < most_growths && add_areas(stage, out))
        continue;
      if (grown && (stage.scene->grid.mx > 0 || stage.scene->grid.ms > 0))
        out.warnings.push_back(
            fmt::format("the contact did not fit on the grid asked for: it grew to {} x {} elements",
                        out.problem.grid.mx, out.problem.grid.ms));
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
    grown = true;
  }
}

void finish(SceneResult& out, const Stage& stage) {
  out.left = stage.scene->position.side == "left";
  out.reference = stage.reference();
  out.moment = out.result.Mz + out.reference.position.y * out.result.Fx - out.reference.x * out.result.Fy;
  if (stage.wheel_rail || stage.files.complete())
    out.wheel_s = stage.contact.wheel_s;
  if (stage.wheel_rail) {
    const ContactProblem& problem = out.problem;
    std::tie(out.rail_profile, out.wheel_profile) =
        profiles_near(*stage.wheel_rail, problem.rows.front().s, problem.rows.back().s);
  } else {
    for (const ContactRow& row : out.problem.rows) {
      const double gap =
          out.problem.gap[(&row - out.problem.rows.data()) * out.problem.grid.mx + out.problem.grid.mx / 2];
      out.rail_profile.push_back(row.position);
      if (gap < excluded_gap)
        out.wheel_profile.push_back(row.position - gap * normal_of(row.delta));
    }
  }
  out.seconds.geometry = stage.seconds.geometry;
  const double error = out.result.certificate.discretisation;
  const auto exterior = std::ranges::count(out.result.state, ElementState::exterior);
  const auto contact = static_cast<std::ptrdiff_t>(out.result.state.size()) - exterior;
  if (error > poor_discretisation)
    out.warnings.push_back(fmt::format(
        "the elements are too large for this contact: the estimated discretisation error is {:.0f} %",
        100 * error));
  else if (contact > 0 && contact < few_elements && error < 0 && !out.result.touches_border)
    out.warnings.push_back(fmt::format(
        "the elements are too large for this contact: {} of them touch, and no error can be estimated",
        contact));
}

/// Hertz where he serves; else by a look at the normal problem with half-space numbers.
ModelChoice choose(Stage& stage, PhaseSeconds& spent) {
  const double tolerance = stage.scene->solver.model_tolerance;
  if (const auto hertz = hertz_of(stage)) {
    ModelChoice choice = choose_hertz(*hertz, tolerance);
    if (choice.enough)
      return choice;
  }
  const SceneResult normal = solve_grown(stage, "halfspace", false);
  spent = normal.seconds;
  const bool equal = stage.scene->rail.material == stage.scene->wheel.material;
  return choose_model(normal.problem, normal.result, equal, stage.files.complete(), tolerance);
}

std::string motion_text(const SceneFile& scene) {
  const std::size_t steps = read_steps(scene).size();
  return scene.motion.kind == "steady"  ? std::string("steady rolling")
         : scene.motion.kind == "shift" ? fmt::format("shift in {} steps", steps)
                                        : fmt::format("transient rolling, {} steps of dx", steps);
}

void add_stresses(SceneResult& out, const SceneFile& scene) {
  if (scene.stresses.depths.empty() || !out.result.converged)
    return;
  out.stresses = stresses_below(scene.stresses, out.problem, out.result, scene.grid.plane_strain,
                                scene.rail.material.poisson, out.reference.s);
  const double turn = turn_of_contact(out.problem, out.result);
  if (predicted_halfspace_error(turn) > scene.solver.model_tolerance)
    out.warnings.push_back(fmt::format("the stresses below the surface are those of a half-space under these "
                                       "tractions: an approximation here, for {}",
                                       halfspace_text(turn)));
}

} // namespace

SceneResult solve_scene(const SceneFile& scene, const std::string& model) {
  return solve_scene(scene, model, {});
}

SceneResult solve_scene(const SceneFile& scene, const std::string& wanted, const SceneAids& aids) {
  const Stopwatch watch;
  const std::string model = wanted.empty() ? scene.solver.model : wanted;
  const auto known = {"auto", "hertz", "halfspace", "tangent_plane", "fem"};
  if (std::ranges::find(known, model) == known.end())
    throw InputError(fmt::format("There is no model '{}'", model),
                     fmt::format("the models are {}", fmt::join(known, ", ")), "Choose one of them.");
  Stage stage = prepare(scene, model == "fem", aids);
  SceneResult out;
  PhaseSeconds probe;
  ModelChoice choice{model, "asked for"};
  if (model == "auto") {
    choice = choose(stage, probe);
    if (choice.model == "fem")
      stage = prepare(scene, true, aids);
  }
  out = solve_grown(stage, choice.model, true);
  out.reason = choice.reason;
  if (!choice.enough)
    out.warnings.push_back("the finite-element model is needed here: " + out.reason);
  finish(out, stage);
  add_stresses(out, scene);
  out.seconds.numbers += probe.numbers;
  out.seconds.solve += probe.solve;
  out.seconds.total = watch.seconds();
  return out;
}

Comparison compare_scene(const SceneFile& scene) {
  const Stopwatch watch;
  if (!scene.load.has_force && scene.motion.kind != "steady")
    throw InputError("The models cannot be compared over these steps", "only the approach is given",
                     "Give load.force, at which they are compared, or solve the scene with either model.");
  Stage stage = prepare(scene, true);
  Comparison out;
  const ContactProblem asked = stage.contact.problem;
  for (int round = 0;; ++round) {
    // Both on one grid: where either grows, both are solved again.
    out.fem = solve_grown(stage, "fem", true);
    const int size = stage.contact.problem.grid.size();
    ContactProblem& problem = stage.contact.problem;
    if (asked.load == LoadKind::approach) {
      problem.load = LoadKind::force;
      problem.force = out.fem.result.Fz;
    }
    out.halfspace = solve_grown(stage, "halfspace", true);
    if (stage.contact.problem.grid.size() == size)
      break;
    stage.contact.problem.load = asked.load;
    stage.contact.problem.force = asked.force;
    if (round == most_growths)
      throw ConvergenceError("The two models found no common grid", "each needs another potential contact",
                             "Give grid.s_from and grid.s_to.");
  }
  finish(out.fem, stage);
  finish(out.halfspace, stage);
  add_stresses(out.fem, scene);
  add_stresses(out.halfspace, scene);
  out.fem.reason = out.halfspace.reason = "compared at equal vertical force";
  out.fem.seconds.total = out.halfspace.seconds.total = watch.seconds();
  return out;
}

std::vector<std::string> check_scene(const SceneFile& scene) {
  const Stage stage = prepare(scene, scene.solver.model == "fem");
  const ContactProblem& problem = stage.contact.problem;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("kind: {}", scene.kind));
  if (stage.wheel_rail)
    std::ranges::copy(describe(*stage.wheel_rail), std::back_inserter(lines));
  lines.push_back(problem.load == LoadKind::force ? fmt::format("load: vertical force {:g} N", problem.force)
                                                  : fmt::format("load: approach {:g} mm", problem.approach));
  lines.push_back(
      fmt::format("grid: {} x {} elements of {:g} x {:g} mm, s = {:.3f} .. {:.3f} mm, inclination "
                  "{:.2f} .. {:.2f} degrees",
                  problem.grid.mx, problem.grid.ms, problem.grid.dx, problem.grid.ds, problem.rows.front().s,
                  problem.rows.back().s, problem.rows.front().delta * 180 / std::numbers::pi,
                  problem.rows.back().delta * 180 / std::numbers::pi));
  lines.push_back(problem.tangential
                      ? fmt::format("friction: {:g}, {}", problem.largest_friction(), motion_text(scene))
                      : std::string("friction: none"));
  const auto side = [&](const char* name, const std::shared_ptr<const InfluenceFunction>& f,
                        const std::vector<double>& s) {
    if (!f) {
      lines.push_back(fmt::format("{}: no influence file", name));
      return;
    }
    const auto [lo, hi] = std::ranges::minmax(s);
    const double from = f->stations.front().s - f->station_width / 2,
                 to = f->stations.back().s + f->station_width / 2;
    const double off = std::max(from - (lo - problem.grid.ds / 2), hi + problem.grid.ds / 2 - to);
    lines.push_back(fmt::format(
        "{}: influence file of '{}', strip s = {:.2f} .. {:.2f} mm; rows need {:.2f} .. {:.2f} mm: {}", name,
        f->body, from, to, lo - problem.grid.ds / 2, hi + problem.grid.ds / 2,
        off <= 0.01 * problem.grid.ds
            ? "covered"
            : fmt::format("they leave the strip by {:.2f} mm, where fem serves no contact", off)));
  };
  side("rail", stage.files.rail, stage.contact.rail_s);
  side("wheel", stage.files.wheel, stage.contact.wheel_s);
  lines.push_back(fmt::format(
      "model: {}{}", scene.solver.model,
      stage.wheel_rail ? "; by the estimate " + halfspace_text(stage.wheel_rail->estimate.turn) : ""));
  return lines;
}

} // namespace bem_contact
