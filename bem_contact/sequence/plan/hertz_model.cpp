#include "bem_contact/sequence/plan/hertz_model.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/totals.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// 1. Rows and columns of the smallest window in which a quadratic is fitted.
constexpr int smallest_window = 5;
/// 1. Rounds of window and fit; the window stops to change after a few.
constexpr int fit_rounds = 10;
/// 1. Determinant of a quadratic over its squared trace, below which it is curved one way only.
constexpr double least_curvature_ratio = 1e-12;

/// Elements in the contact, or within two elements of `middle`.
std::vector<int> window_of(const ContactProblem& problem, const HertzModel& model, int middle) {
  const int mx = problem.grid.mx;
  std::vector<int> window;
  for (int i = 0; i < problem.grid.size(); ++i) {
    const bool near = std::abs(i % mx - middle % mx) <= smallest_window / 2 &&
                      std::abs(i / mx - middle / mx) <= smallest_window / 2;
    const auto [u, v] = model.local(problem.grid.x(i % mx), problem.rows[i / mx].s);
    const bool inside = model.contact.force > 0 &&
                        std::hypot(u / model.contact.semi_axis_x, v / model.contact.semi_axis_s) < 1;
    if (near || inside)
      window.push_back(i);
  }
  return window;
}

/// False where the distance is not curved both ways.
bool fit_quadratic(const ContactProblem& problem, const std::vector<int>& window, HertzModel& model) {
  const ContactGrid& grid = problem.grid;
  const double x0 = grid.x(window.front() % grid.mx), s0 = problem.rows[window.front() / grid.mx].s;
  Eigen::MatrixXd terms(window.size(), 6);
  Eigen::VectorXd gap(window.size());
  for (std::size_t k = 0; k < window.size(); ++k) {
    const double x = (grid.x(window[k] % grid.mx) - x0) / grid.dx;
    const double s = (problem.rows[window[k] / grid.mx].s - s0) / grid.ds;
    terms.row(k) << 1, x, s, x * x, s * s, x * s;
    gap[k] = problem.gap[window[k]];
  }
  const Eigen::VectorXd c = terms.colPivHouseholderQr().solve(gap);
  const double a = c[3] / (grid.dx * grid.dx), b = c[4] / (grid.ds * grid.ds),
               mixed = c[5] / (grid.dx * grid.ds);
  const double determinant = 4 * a * b - mixed * mixed;
  if (!(a > 0) || !(b > 0) || !(determinant > least_curvature_ratio * (a + b) * (a + b)))
    return false;
  const double slope_x = c[1] / grid.dx, slope_s = c[2] / grid.ds;
  const double x = (mixed * slope_s - 2 * b * slope_x) / determinant;
  const double s = (mixed * slope_x - 2 * a * slope_s) / determinant;
  model.x = x0 + x;
  model.s = s0 + s;
  model.least = c[0] + 0.5 * (slope_x * x + slope_s * s);
  model.angle = 0.5 * std::atan2(mixed, a - b);
  const double mean = 0.5 * (a + b), spread = 0.5 * std::hypot(a - b, mixed);
  model.curvature_x = mean + spread;
  model.curvature_s = mean - spread;
  return true;
}

void press(const ContactProblem& problem, HertzModel& model) {
  model.delta = row_at(problem, model.s).delta;
  const double cosine = std::cos(model.delta);
  model.contact = {};
  if (problem.load == LoadKind::force && problem.force > 0)
    model.contact = reference::hertz_by_force(model.curvature_x, model.curvature_s, model.modulus,
                                              problem.force / cosine);
  else if (problem.load == LoadKind::approach && problem.approach * cosine > model.least)
    model.contact = reference::hertz_by_approach(model.curvature_x, model.curvature_s, model.modulus,
                                                 problem.approach * cosine - model.least);
}

/// Over 4 x 4 points of an element.
double mean_pressure(const HertzModel& model, const ContactGrid& grid, double x, double s) {
  const reference::HertzContact& c = model.contact;
  double sum = 0;
  for (const double dx : {-0.375, -0.125, 0.125, 0.375})
    for (const double ds : {-0.375, -0.125, 0.125, 0.375}) {
      const auto [u, v] = model.local(x + dx * grid.dx, s + ds * grid.ds);
      sum += std::sqrt(std::max(0.0, 1 - std::pow(u / c.semi_axis_x, 2) - std::pow(v / c.semi_axis_s, 2)));
    }
  return c.max_pressure * sum / 16;
}

/// The distance has to be known all over the contact: the ellipse's box lies on the grid.
bool on_grid(const ContactProblem& problem, const HertzModel& model) {
  const ContactGrid& grid = problem.grid;
  const reference::HertzContact& c = model.contact;
  const double cosine = std::cos(model.angle), sine = std::sin(model.angle);
  const double reach_x = std::hypot(c.semi_axis_x * cosine, c.semi_axis_s * sine);
  const double reach_s = std::hypot(c.semi_axis_x * sine, c.semi_axis_s * cosine);
  return !(model.x - reach_x < grid.x(0) - 0.5 * grid.dx ||
           model.x + reach_x > grid.x(grid.mx - 1) + 0.5 * grid.dx ||
           model.s - reach_s < problem.rows.front().s - 0.5 * grid.ds ||
           model.s + reach_s > problem.rows.back().s + 0.5 * grid.ds);
}

/// Sets deviation and turn, from the elements of the window in the contact.
void look_inside(const ContactProblem& problem, const std::vector<int>& window, HertzModel& model) {
  const ContactGrid& grid = problem.grid;
  const reference::HertzContact& c = model.contact;
  double lowest = model.delta, highest = model.delta;
  for (const int i : window) {
    const ContactRow& row = problem.rows[i / grid.mx];
    const auto [u, v] = model.local(grid.x(i % grid.mx), row.s);
    if (!(c.force > 0) || std::hypot(u / c.semi_axis_x, v / c.semi_axis_s) >= 1)
      continue;
    const double fit = model.least + model.curvature_x * u * u + model.curvature_s * v * v;
    model.deviation = std::max(model.deviation, std::abs(problem.gap[i] - fit) / c.approach);
    lowest = std::min(lowest, row.delta);
    highest = std::max(highest, row.delta);
  }
  model.turn = highest - lowest;
}

ContactResult without_contact(const ContactProblem& problem) {
  const std::size_t n = problem.grid.size();
  ContactResult result;
  for (auto* field : {&result.px, &result.ps, &result.pn, &result.slip_x, &result.slip_s})
    field->assign(n, 0.0);
  result.deformed_distance = problem.gap;
  result.state.assign(n, ElementState::exterior);
  result.effort.normal_solver = "Hertz";
  result.effort.tangential_solver = "none";
  result.trust.certificate = Certificate::without_violation();
  result.trust.certificate.discretisation = 0;
  return result;
}

/// The axis nearest to x first, as PatchSummary has them.
void add_axes(const HertzModel& model, PatchSummary& patch) {
  const double quarter = std::numbers::pi / 2;
  const double turns = std::round(model.angle / quarter);
  const bool exchanged = std::fmod(std::abs(turns), 2) == 1;
  patch.semi_axis_a = exchanged ? model.contact.semi_axis_s : model.contact.semi_axis_x;
  patch.semi_axis_b = exchanged ? model.contact.semi_axis_x : model.contact.semi_axis_s;
  patch.axis_angle = model.angle - turns * quarter;
}

/// Forces and the one patch of the closed form, with `inside` elements. The pressure is symmetric about the
/// patch's centre and has no moments about it.
void add_totals(const ContactProblem& problem, const HertzModel& model, int inside, ContactResult& result) {
  const reference::HertzContact& c = model.contact;
  const double area = std::numbers::pi * c.semi_axis_x * c.semi_axis_s;
  result.trust.certificate.force_balance = std::abs(2.0 / 3 * area * c.max_pressure / c.force - 1);
  ContactTotals& totals = result.totals;
  totals.Fy = {0.0 - c.force * std::sin(model.delta)};
  totals.Fz = {c.force * std::cos(model.delta)};
  totals.Mz = model.x * totals.Fy;
  PatchSummary patch;
  patch.fn = {c.force};
  patch.overlap = {c.approach};
  patch.pmax = {c.max_pressure};
  patch.area = {area};
  patch.contact = patch.slip = inside;
  patch.x = model.x;
  patch.s = model.s;
  patch.position = row_at(problem, model.s).position;
  patch.delta = model.delta;
  patch.fy = totals.Fy;
  patch.fz = totals.Fz;
  add_axes(model, patch);
  result.patches = {patch};
  set_totals_of_patches(result);
}

} // namespace

std::pair<double, double> HertzModel::local(double at_x, double at_s) const {
  const double c = std::cos(angle), d = std::sin(angle);
  return {c * (at_x - x) + d * (at_s - s), -d * (at_x - x) + c * (at_s - s)};
}

std::optional<HertzModel> fit_hertz(const ContactProblem& problem, const Material& lower,
                                    const Material& upper) {
  const ContactGrid& grid = problem.grid;
  if (grid.mx < smallest_window || grid.ms < smallest_window)
    return std::nullopt;
  HertzModel model;
  model.modulus = reference::contact_modulus(lower, upper);
  const int middle = static_cast<int>(std::ranges::min_element(problem.gap) - problem.gap.begin());
  std::vector<int> window = window_of(problem, model, middle);
  for (int round = 0; round < fit_rounds; ++round) {
    if (std::ranges::any_of(window, [&](int i) { return problem.gap[i] >= excluded_gap; }) ||
        !fit_quadratic(problem, window, model))
      return std::nullopt;
    press(problem, model);
    std::vector<int> next = window_of(problem, model, middle);
    if (next == window)
      break;
    window = std::move(next);
  }
  if (!on_grid(problem, model))
    return std::nullopt;
  look_inside(problem, window, model);
  return model;
}

std::optional<HertzModel> hertz_of(const ContactSetup& setup, const ContactProblem& problem) {
  if (problem.tangential || problem.plane_strain() || setup.layer.normal > 0)
    return std::nullopt;
  std::optional<HertzModel> model = fit_hertz(problem, setup.rail.material, setup.wheel.material);
  if (model && problem.limit_pressure && model->contact.max_pressure > *problem.limit_pressure)
    return std::nullopt;
  return model;
}

ContactResult solve_hertz(const ContactProblem& problem, const HertzModel& model) {
  const ContactGrid& grid = problem.grid;
  const reference::HertzContact& c = model.contact;
  ContactResult result = without_contact(problem);
  result.displacements.un.assign(grid.size(), 0.0);
  const double cosine = std::cos(model.delta);
  const double approach = problem.load == LoadKind::approach ? problem.approach
                          : c.force > 0                      ? (c.approach + model.least) / cosine
                                                             : 0.0;
  result.totals.approach = {approach};
  int inside = 0;
  for (int i = 0; i < grid.size(); ++i) {
    const ContactRow& row = problem.rows[i / grid.mx];
    const auto [x, s] = model.local(grid.x(i % grid.mx), row.s);
    const double compression = c.force > 0 ? reference::hertz_compression(c, model.modulus, x, s) : 0.0;
    result.deformed_distance[i] += compression - approach * std::cos(row.delta);
    result.displacements.un[i] = -compression;
    if (!(c.force > 0))
      continue;
    result.pn[i] = mean_pressure(model, grid, grid.x(i % grid.mx), row.s);
    if (!(result.pn[i] > 0))
      continue;
    ++inside;
    result.state[i] = ElementState::slip;
    if (std::hypot(x / c.semi_axis_x, s / c.semi_axis_s) > 1)
      continue;
    const double exact = c.approach - model.curvature_x * x * x - model.curvature_s * s * s;
    result.trust.certificate.penetration =
        std::max(result.trust.certificate.penetration, std::abs(compression - exact) / c.approach);
  }
  if (c.force > 0)
    add_totals(problem, model, inside, result);
  result.trust.why_no_errors = "Hertz's closed form has no elements";
  return result;
}

ContactResult solve_hertz(const ContactSetup& setup, const ContactProblem& problem) {
  const std::optional<HertzModel> model = hertz_of(setup, problem);
  if (!model)
    throw InputError(
        "Hertz's closed form does not fit this contact",
        "it is for a frictionless contact in three dimensions whose undeformed distance is curved "
        "both ways and known all over the contact (on at least 5 x 5 elements)",
        "Set motion.frictionless = true, give a larger grid, or choose another model.");
  return solve_hertz(problem, *model);
}

} // namespace bem_contact
