#include "bem_contact/uses/table/creep_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact::table {

namespace {

/// 1. Rings and angles over which the forces of full slip are summed. With four times as many, the sums of
/// 750 poles in and around ellipses of a/b from 0.1 to 10 differ by 3e-5 in the median and 1.2e-3 at most.
constexpr int full_slip_rings = 60;
constexpr int full_slip_angles = 120;
/// 1, over the tolerance. w of the first point above zero: a Hertz contact loses the share w of its slope
/// (Vermeulen and Johnson 1964: F = 1 - (1 - w)^3 = 3 w (1 - w + ...)), so that slopes keep the tolerance.
constexpr double first_creepage = 1.0;
/// 1. Coefficients of linear theory in a creep table: 20 a decade of a/b. Readers take them from the file.
constexpr int coefficients_in_a_decade = 20;
/// 1. Elements at each side of the contact in a creep table: as large as the ellipse, and one more.
constexpr int border_elements = 1;

constexpr double half_pi = 0.5 * std::numbers::pi;
// The contact that is solved: results do not depend on these numbers.
constexpr double modulus = 8e4;    // G, MPa
constexpr double friction = 0.3;   // mu
constexpr double curvature = 1e-3; // the sum of both, 1/mm

/// The axes after log10(a/b). Numbers change most along the last ones, where refining adds fewest points.
enum CreepAxis : std::size_t { along_t = 1, along_alpha, along_beta };

/// R over c: the mean radius of the ellipse, R^2 = (a^2 + b^2)/2, and a/b + b/a = 2 cosh(log(a/b)).
double mean_radius(double log10_ratio) {
  return std::sqrt(std::cosh(std::numbers::ln10 * log10_ratio));
}

/// xi', eta' and phi' over G c^2 xi / (3 mu N), G c^2 eta / (3 mu N) and G c^3 phi / (3 mu N).
struct ScalesOfCreepage {
  double xi = 0, eta = 0, phi = 0;

  ScalesOfCreepage(const CreepScale& scale, double log_ratio)
      : xi(interpolate(scale.log10_a_over_b, scale.c11, log_ratio)),
        eta(interpolate(scale.log10_a_over_b, scale.c22, log_ratio)),
        phi(std::sqrt(xi * eta) * mean_radius(log_ratio)) {}
};

CreepScale scale_of(const CreepTableOptions& options) {
  CreepScale scale{.poisson = options.poisson};
  const double from = std::log10(options.from), to = std::log10(options.to);
  const int intervals = std::max(1, static_cast<int>(std::ceil((to - from) * coefficients_in_a_decade)));
  for (int i = 0; i <= intervals; ++i) {
    const double log_ratio = from + (to - from) * i / intervals;
    const reference::CreepCoefficients k = reference::creep_coefficients(
        std::clamp(std::pow(10, log_ratio), options.from, options.to), options.poisson);
    scale.log10_a_over_b.push_back(log_ratio);
    scale.c11.push_back(k.c11);
    scale.c22.push_back(k.c22);
  }
  return scale;
}

/// Undeformed distance and force of the contact with that a/b and c = 1 mm.
struct EllipticContact {
  double curvature_x = 0, curvature_s = 0, force = 0;
};

EllipticContact elliptic_contact(double a_over_b, const Material& material) {
  const double ratio = reference::hertz_curvature_ratio(a_over_b), share = ratio / (1 + ratio);
  const reference::HertzContact unit = reference::hertz_by_force(
      share * curvature, (1 - share) * curvature, reference::contact_modulus(material, material), 1);
  // c grows with the cube root of the force.
  return {share * curvature, (1 - share) * curvature, std::pow(unit.semi_axis_x * unit.semi_axis_s, -1.5)};
}

/// Of one axis that is `ratio` times as long as the other. Where elements are as long as the ellipse, a whole
/// row of them changes its direction of slip at once as the pole of the motion passes, and forces jump.
int elements_across(int elements, double ratio) {
  return 2 * static_cast<int>(std::lround(0.5 * elements * std::pow(ratio, 0.25)));
}

SceneFile scene_of(double a_over_b, const CreepScale& scale, int elements) {
  const Material material{.shear_modulus = modulus, .poisson = scale.poisson};
  const EllipticContact contact = elliptic_contact(a_over_b, material);
  SceneFile scene;
  scene.kind = SceneKind::patch;
  scene.solver.model = Model::halfspace;
  scene.rail.material = scene.wheel.material = material;
  scene.load.force = contact.force;
  scene.motion.friction = friction;
  scene.gap.a = contact.curvature_x;
  scene.gap.b = contact.curvature_s;
  const int along_x = elements_across(elements, a_over_b), along_s = elements_across(elements, 1 / a_over_b);
  scene.grid.dx = 2 * std::sqrt(a_over_b) / along_x;
  scene.grid.ds = 2 / std::sqrt(a_over_b) / along_s;
  scene.grid.mx = along_x + 2 * border_elements;
  scene.grid.ms = along_s + 2 * border_elements;
  return scene;
}

/// xi', eta', phi'.
std::array<double, 3> scaled_creepages(const Point& point) {
  const double w = point[along_t] < 1 ? point[along_t] / (1 - point[along_t]) : 1; // a direction
  return {w * std::cos(point[along_alpha]), w * std::sin(point[along_alpha]) * std::cos(point[along_beta]),
          w * std::sin(point[along_alpha]) * std::sin(point[along_beta])};
}

/// In full slip the elastic part of the slip is nothing beside the rigid one: the traction is mu p along
/// that. By the midpoint rule over the pressure of Hertz, for c = 1; xi, eta and phi up to a common factor.
std::array<double, 3> full_slip(double a_over_b, double xi, double eta, double phi) {
  const double a = std::sqrt(a_over_b), b = 1 / a;
  const auto beyond = [](int ring) { // share of the normal force
    const double r = static_cast<double>(ring) / full_slip_rings;
    return std::pow(1 - r * r, 1.5);
  };
  double fx = 0, fy = 0, mz = 0;
  for (int i = 0; i < full_slip_rings; ++i) {
    const double r = (i + 0.5) / full_slip_rings;
    const double share = (beyond(i) - beyond(i + 1)) / full_slip_angles;
    for (int k = 0; k < full_slip_angles; ++k) {
      const double angle = 4 * half_pi * (k + 0.5) / full_slip_angles;
      const double x = a * r * std::cos(angle), y = b * r * std::sin(angle);
      const double slip_x = xi - phi * y, slip_y = eta + phi * x, slip = std::hypot(slip_x, slip_y);
      if (slip == 0)
        continue;
      fx += share * slip_x / slip;
      fy += share * slip_y / slip;
      mz += share * (x * slip_y - y * slip_x) / slip;
    }
  }
  return {fx, fy, mz};
}

void require(const CreepTableOptions& o) {
  const auto refuse = [](const std::string& problem, const char* why, const char* what_to_do) {
    throw InputError(problem, why, what_to_do);
  };
  if (!(o.from >= 0.1 && o.to <= 10 && o.from < o.to))
    refuse(fmt::format("A creep table for a/b of {:g} to {:g} is not possible", o.from, o.to),
           "it needs two ends that grow, within 0.1 to 10, where the coefficients of linear theory are known",
           "Give FROM:TO, as 0.1:10.");
  if (!(o.poisson >= 0 && o.poisson <= 0.5))
    refuse(fmt::format("A creep table for Poisson's ratio {:g} is not possible", o.poisson),
           "elastic bodies have one of 0 to 0.5", "Give 0.28 for steel.");
  if (!(o.tolerance > 0 && o.tolerance < 0.3))
    refuse(fmt::format("A creep table within {:g} is not possible", o.tolerance),
           "the tolerance, over the friction bound, is a number between 0 and 0.3",
           "Give one, such as 0.01.");
  if (o.elements < 4 || o.elements > 200)
    refuse(fmt::format("A creep table with {} elements across the contact is not possible", o.elements),
           "4 to 200 are", "Give 20, and look at the error by the size of the elements.");
}

/// Adds a nested axis. Angles mean nothing at zero creepage, nor beta on the axis of xi': there is one point.
void add_axis(ContactTable& table, Axis axis, const std::vector<double>& points) {
  axis.first = {0};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Point before = table.point(i);
    const bool means_nothing = before.size() > along_t && (before[along_t] == 0 || before.back() == 0);
    if (means_nothing)
      axis.points.push_back(0);
    else
      axis.points.insert(axis.points.end(), points.begin(), points.end());
    axis.first.push_back(axis.points.size());
  }
  table.axes.push_back(std::move(axis));
}

} // namespace

ContactTable creep_table(const CreepTableOptions& options) {
  require(options);
  ContactTable table;
  table.scale = scale_of(options);
  const double from = std::log10(options.from), to = std::log10(options.to);
  const double first = first_creepage * options.tolerance;
  table.axes = {{"log10_a_over_b", "1", "semi-axis along x over the one across it", {}}};
  for (int i = 0; i < 3; ++i)
    table.axes[0].points.push_back(from + (to - from) * i / 2);
  add_axis(table, {"t", "1", "w/(1 + w) of the length w of (xi', eta', phi'); 1: full slip", {}},
           {0, first / (1 + first), 0.25, 0.5, 0.75, 1});
  add_axis(table, {"alpha", "rad", "angle from xi' to the plane of eta' and phi'", {}},
           {0, 0.5 * half_pi, half_pi});
  add_axis(table, {"beta", "rad", "angle from eta' to phi'", {}},
           {-half_pi, -0.5 * half_pi, 0, 0.5 * half_pi, half_pi});
  table.columns = {{.name = "Fx", .unit = "mu N", .description = "on the rail, over the friction bound"},
                   {.name = "Fy", .unit = "mu N", .description = "on the rail, over the friction bound"},
                   {.name = "Mz", .unit = "mu N R", .description = "on the rail, R = sqrt((a^2 + b^2)/2)"}};
  return table;
}

PointSolver creep_point_solver(const CreepScale& scale, int elements) {
  struct Solver {
    Sequence sequence{{.displacements = false}};
    std::optional<SceneFile> scene;
    double log_ratio = 0; ///< that `scene` has
  };
  return [=, solver = std::make_shared<Solver>()](const Point& point) {
    if (point[along_t] == 0)
      return PointValues{{0, 0, 0}, {unknown_error, unknown_error, unknown_error}};
    const auto [xi, eta, phi] = scaled_creepages(point);
    const ScalesOfCreepage k(scale, point[0]);
    const double radius = mean_radius(point[0]);
    if (point[along_t] == 1) {
      const auto [fx, fy, mz] = full_slip(std::pow(10, point[0]), xi / k.xi, eta / k.eta, phi / k.phi);
      return PointValues{{fx, fy, mz / radius}, std::vector<double>(3, unknown_error)};
    }
    if (!solver->scene || solver->log_ratio != point[0]) {
      solver->scene = scene_of(std::pow(10, point[0]), scale, elements);
      solver->log_ratio = point[0];
    }
    SceneFile& scene = *solver->scene;
    const double bound = friction * *scene.load.force, unit = 3 * bound / modulus; // c = 1 mm
    scene.motion.xi = unit / k.xi * xi;
    scene.motion.eta = unit / k.eta * eta;
    scene.motion.phi = unit / k.phi * phi;
    const SceneResult result = solver->sequence.solve(scene);
    if (!certified(result))
      throw ConvergenceError("A point of the creep table has no certified result",
                             fmt::format("a/b {:.4g}, xi' {:.4g}, eta' {:.4g}, phi' {:.4g}",
                                         std::pow(10, point[0]), xi, eta, phi),
                             "Choose another number of --elements.");
    PointValues out;
    for (const char* name : {"Fx", "Fy", "Mz"}) {
      const double unit_of_column = std::string_view(name) == "Mz" ? bound * radius : bound;
      out.values.push_back(quantity(name).value(result) / unit_of_column);
      out.element_errors.push_back(quantity(name).error(result) / unit_of_column);
    }
    return out;
  };
}

TabulatedForces creep_forces(const ContactTable& table, const CreepContact& contact, double xi, double eta,
                             double phi) {
  if (!table.scale)
    throw InputError("Forces over creepages cannot be looked up", "the table is one of a scene",
                     "Make one with bem_contact table --creep-forces.");
  const auto require_contact = [](bool fine, const char* why) {
    if (!fine)
      throw InputError("Forces of this contact cannot be looked up", why,
                       "Give mm, MPa, N; creepages without unit, spin in 1/mm.");
  };
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  require_contact(positive(contact.a) && positive(contact.b) && positive(contact.shear_modulus) &&
                      positive(contact.bound) && std::isfinite(xi + eta + phi),
                  "a, b, G and mu N must be positive and finite, and creepages finite");
  const double log_ratio = std::log10(contact.a / contact.b), c = std::sqrt(contact.a * contact.b);
  require_inside(table.axes[0], log_ratio);
  const ScalesOfCreepage k(*table.scale, log_ratio);
  const double radius = c * mean_radius(log_ratio);
  const double unit = contact.shear_modulus * c * c / (3 * contact.bound);
  const double x = unit * k.xi * std::abs(xi);
  // The signs of eta and phi turn together.
  const double sign = eta < 0 ? -1 : 1;
  const double y = unit * k.eta * sign * eta, z = unit * c * k.phi * sign * phi;
  const double w = std::hypot(x, y, z);
  require_contact(std::isfinite(w) && std::isfinite(contact.bound * radius),
                  "a product of these numbers is larger than the largest number");
  double at[4] = {log_ratio};
  at[along_alpha] = std::atan2(std::hypot(y, z), x), at[along_beta] = std::atan2(z, y),
  at[along_t] = w / (1 + w);
  const std::vector<PointWeight> weights = weights_at(table, at);
  const Column &fx = table.column("Fx"), &fy = table.column("Fy"), &mz = table.column("Mz");
  // Friction bears no more than mu N. What is beyond comes closer to every force that there can be, so the
  // stated errors hold.
  const double ahead = interpolate(fx, weights), across = interpolate(fy, weights);
  const double within = contact.bound / std::max(1.0, std::hypot(ahead, across));
  return {std::copysign(within, xi) * ahead,
          sign * within * across,
          sign * contact.bound * radius * interpolate(mz, weights),
          contact.bound * fx.error(),
          contact.bound * fy.error(),
          contact.bound * radius * mz.error()};
}

} // namespace bem_contact::table
