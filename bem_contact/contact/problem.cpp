#include "bem_contact/contact/problem.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <fmt/format.h>
#include <functional>
#include <string>

namespace bem_contact {
namespace {

void require(bool holds, const std::string& problem, const std::string& why, const std::string& what_to_do) {
  if (!holds)
    throw InputError(problem, why, what_to_do);
}

void require_field(const std::vector<double>& field, const ContactGrid& grid, const std::string& name) {
  require(field.size() == static_cast<std::size_t>(grid.size()), "The " + name + " does not fit the grid",
          fmt::format("{} values for {} x {} elements", field.size(), grid.mx, grid.ms),
          "Give one value for each element, x fastest.");
  const auto bad = std::find_if(field.begin(), field.end(), [](double v) { return !std::isfinite(v); });
  require(bad == field.end(), "The " + name + " is not a number everywhere",
          fmt::format("element {}", bad - field.begin()), "Give finite values.");
}

bool agree(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

void validate_numbers(const ContactProblem& problem) {
  const auto& [offsets, rows, dx, ds, values, translational] = problem.numbers;
  const ContactGrid& grid = problem.grid;
  require(rows == grid.ms, "The influence numbers do not fit the grid",
          fmt::format("{} rows of numbers for {} rows of elements", rows, grid.ms),
          "Compute them for the rows of the grid.");
  require(agree(ds, grid.ds), "The influence numbers do not fit the grid",
          fmt::format("their ds is {} mm, the grid's {}", ds, grid.ds),
          "Compute them for the elements of the grid.");
  if (problem.plane_strain()) {
    require(grid.mx == 1 && offsets == 1, "Plane strain has one element along x",
            "the influence numbers have dx = 0", "Set mx = 1 and offsets = 1.");
    require(!problem.has_friction(), "Rolling needs elements along x",
            "the influence numbers are of plane strain",
            "Set tangential = false, or use numbers with dx > 0.");
  } else {
    require(agree(dx, grid.dx), "The influence numbers do not fit the grid",
            fmt::format("their dx is {} mm, the grid's {}", dx, grid.dx),
            "Compute them for the elements of the grid.");
    require(offsets > grid.mx + 1, "The influence numbers do not reach across the grid",
            fmt::format("{} offsets for {} columns", offsets, grid.mx), "Compute mx + 2 offsets.");
  }
  require(values.size() == problem.numbers.expected_values(), "The influence numbers are incomplete",
          fmt::format("{} values", values.size()),
          translational ? "Give offsets x (2 rows - 1) x 9 of them."
                        : "Give offsets x (3 rows) x (3 rows) of them.");
  require(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
          "An influence number is not finite", "NaN or infinity among them",
          "Recompute the influence numbers.");
  // Positive definiteness itself is too dear to check; these two are what breaks it in practice.
  double largest = 0, asymmetry = 0;
  const InfluenceNumbers& numbers = problem.numbers;
  for (const auto& [row_i, row_j] : numbers.stored_rows())
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double value = numbers.at(0, row_i, i, row_j, j);
        if (row_i == row_j && i == j) {
          require(value > 0, "A self influence number is not positive",
                  fmt::format("row {}, component {}", row_i, i),
                  "Check the sign convention: u = -A p with A positive definite.");
          largest = std::max(largest, value);
        }
        asymmetry = std::max(asymmetry, std::abs(value - parity(i, j) * numbers.at(0, row_j, j, row_i, i)));
      }
  require(asymmetry <= 1e-6 * largest, "The influence numbers violate Maxwell-Betti",
          fmt::format("asymmetry {:.3g} of the largest influence number of an element on itself",
                      asymmetry / largest),
          "Use displacements averaged over the element.");
}

bool is_share(double v) {
  return v > 0 && v <= 1;
}

bool conducts(const ThermalBody& body) {
  return std::isfinite(body.effusivity()) && body.conductivity > 0 && body.heat_capacity > 0 &&
         body.density > 0 && std::isfinite(body.temperature);
}

void validate_heating(const ContactProblem& problem) {
  const Heating& heating = *problem.heating;
  require(problem.motion == MotionKind::steady, "Flash temperatures are those of steady rolling",
          "the heat of former steps is not known", "Set motion = steady, or leave out the heating.");
  require(conducts(heating.rail) && conducts(heating.wheel), "A body does not conduct heat",
          "conductivity, heat capacity and density must be above 0", "Give those of the material.");
  require(!heating.rail_share || (*heating.rail_share >= 0 && *heating.rail_share <= 1),
          "The rail's share of the heat is not between 0 and 1",
          fmt::to_string(heating.rail_share.value_or(0)), "Give a number from 0 to 1, or none.");
  require(!heating.friction ||
              (is_share(heating.friction->ratio) && heating.friction->from < heating.friction->to),
          "Friction does not fall with temperature",
          "its ratio must lie above 0 and at most at 1, its temperatures must ascend", "Correct them.");
}

/// Of mu over slip velocity and temperature.
void validate_friction_law(const ContactProblem& problem) {
  require(problem.falling.size() <= 1 || problem.falling.size() == static_cast<std::size_t>(problem.grid.ms),
          "The laws of friction do not fit the grid",
          fmt::format("{} for {} rows", problem.falling.size(), problem.grid.ms),
          "Give one for each row, or one for all.");
  for (const FallingFriction& law : problem.falling)
    require(is_share(law.ratio) && std::isfinite(law.scale) && law.scale > 0,
            "Friction does not fall with the slip velocity",
            fmt::format("its ratio is {}, its velocity {} mm/s", law.ratio, law.scale),
            "Give a ratio above 0 and at most 1, and a velocity above 0.");
  const bool needs_speed = problem.friction_falls() || problem.heating;
  require(!needs_speed || (std::isfinite(problem.speed) && problem.speed > 0), "The rolling speed is missing",
          "slip velocity and heat are proportional to it", "Give it in mm/s.");
  require(!problem.friction_falls() || problem.motion != MotionKind::shift, "A shift has no slip velocity",
          "friction falls with it", "Choose rolling, or leave out the law.");
  require(problem.kinetic == 1 || !problem.friction_varies(), "There are two laws of friction",
          "kinetic is below 1, and friction falls with slip velocity or temperature", "Leave out one.");
  if (problem.heating)
    validate_heating(problem);
  if (!problem.memory)
    return;
  require(problem.memory->distance > 0 && std::isfinite(problem.memory->distance) &&
              problem.memory->least_velocity > 0 && std::isfinite(problem.memory->least_velocity),
          "The memory of friction cannot be used",
          fmt::format("its distance is {:g} mm, its smallest velocity {:g} mm/s", problem.memory->distance,
                      problem.memory->least_velocity),
          "Give both above 0.");
  require(problem.friction_falls() && problem.motion == MotionKind::steady && !problem.yield,
          "Friction has nothing to remember",
          "its memory is that of friction that falls with the slip velocity, in steady rolling, without a "
          "layer that "
          "yields",
          "Leave it out.");
}

void validate_yield_by_heat(const ContactProblem& problem) {
  const YieldLimit& limit = *problem.yield;
  const std::vector<double>&at = limit.temperatures, &shears = limit.shears;
  const auto is_finite = [](double v) { return std::isfinite(v); };
  require(at.size() == shears.size() && std::ranges::all_of(at, is_finite) &&
              std::ranges::is_sorted(at, std::less_equal<>()),
          "The layer's limit over temperature cannot be used",
          fmt::format("it has {} temperatures and {} limits, or its temperatures do not rise", at.size(),
                      shears.size()),
          "Give one limit for each temperature, the coldest first.");
  require(
      std::ranges::all_of(shears, [](double v) { return std::isfinite(v) && v > 0; }) &&
          std::ranges::is_sorted(shears, std::greater<>()) && limit.shear == shears.front(),
      "The layer's limit over temperature cannot be used",
      "a layer that bears more the hotter it is heats itself further: there may be more than one solution",
      "Give limits above 0 that do not rise with temperature; `shear` is the first of them.");
  require(problem.heating.has_value(), "The layer's limit depends on the temperature of the surfaces",
          "temperatures are not asked for", "Give `heating`, or one limit.");
}

/// An element whose slip lowers what the layer bears by more than it lowers its traction would snap.
void validate_yield(const ContactProblem& problem) {
  const double shear = problem.yield->shear, hardening = problem.yield->hardening;
  require(std::isfinite(shear) && shear > 0 && std::isfinite(hardening),
          "The layer's yield limit cannot be used",
          fmt::format("it is {} MPa and hardens by {} MPa/mm", shear, hardening),
          "Give a limit above 0 and a finite hardening.");
  require(problem.kinetic == 1,
          "A layer that yields and a kinetic coefficient of friction are two laws of slip",
          "it is not known which of them what slips obeys", "Leave out one.");
  require(hardening == 0 || !problem.friction_varies(),
          "The layer's limit and friction both depend on the slip",
          "it hardens or softens, and friction falls with slip velocity or temperature",
          "Leave out one: a hardening of 0, or constant friction.");
  if (!problem.yield->temperatures.empty() || !problem.yield->shears.empty())
    validate_yield_by_heat(problem);
  if (hardening >= 0)
    return;
  const std::vector<double> stiffness = element_stiffness(problem);
  const double least = *std::min_element(stiffness.begin(), stiffness.end()) * slip_step(problem).present[0];
  require(
      hardening + least > 0, "The layer softens so steeply that its slip has more than one solution",
      fmt::format(
          "it loses {:g} MPa per mm of plastic slip, and an element of this grid gives way by {:g} MPa/mm",
          -hardening, least),
      "Give a hardening nearer to 0, or smaller elements (the compliance of the layer counts too).");
}

void validate_friction(const ContactProblem& problem) {
  const auto is_friction = [](double mu) { return std::isfinite(mu) && mu >= 0; };
  require(is_friction(problem.friction) &&
              std::all_of(problem.friction_rows.begin(), problem.friction_rows.end(), is_friction),
          "A friction coefficient is negative or not finite",
          fmt::format("that of the grid is {}", problem.friction), "Give mu >= 0, in each row too.");
  require(problem.friction_rows.empty() ||
              problem.friction_rows.size() == static_cast<std::size_t>(problem.grid.ms),
          "The friction coefficients do not fit the grid",
          fmt::format("{} for {} rows", problem.friction_rows.size(), problem.grid.ms),
          "Give one for each row.");
  require(problem.kinetic > 0 && problem.kinetic <= 1, "Friction in slip is not below that in adhesion",
          fmt::format("their ratio is {}", problem.kinetic), "Give a ratio above 0 and at most 1.");
  validate_friction_law(problem);
  if (problem.yield)
    validate_yield(problem);
  require_field(problem.slip_x, problem.grid, "rigid slip along x");
  require_field(problem.slip_s, problem.grid, "rigid slip along s");
  for (const Tractions& former : problem.previous)
    for (const std::vector<double>* field : {&former.px, &former.ps, &former.pn})
      require_field(*field, problem.grid, "traction of a former step");
  for (const Tractions& former : problem.previous)
    if (!former.plastic.empty())
      require_field(former.plastic, problem.grid, "plastic slip of a former step");
  for (const auto& force : {problem.force_x, problem.force_s}) {
    require(!force || std::isfinite(*force), "The shear force prescribed is not finite", "NaN or infinity",
            "Give it in N.");
    require(!force || problem.has_friction(), "No shear force can be carried", "there is no friction",
            "Give a friction coefficient, or no shear force.");
  }
}

} // namespace

double row_index(const ContactProblem& problem, double s) {
  const double last = static_cast<double>(problem.rows.size()) - 1;
  return std::clamp((s - problem.rows.front().s) / problem.grid.ds, 0.0, last);
}

ContactRow row_at(const ContactProblem& problem, double s) {
  const double index = row_index(problem, s);
  const auto below = static_cast<std::size_t>(index);
  const ContactRow& a = problem.rows[below];
  const ContactRow& b = problem.rows[std::min(below + 1, problem.rows.size() - 1)];
  const double share = index - static_cast<double>(below);
  return {s, (1 - share) * a.position + share * b.position, (1 - share) * a.delta + share * b.delta};
}

void validate(const ContactProblem& problem) {
  const ContactGrid& grid = problem.grid;
  require(grid.mx > 0 && grid.ms > 0, "The grid is empty", fmt::format("{} x {} elements", grid.mx, grid.ms),
          "Set mx and ms above 0.");
  require(std::isfinite(grid.ds) && grid.ds > 0 && std::isfinite(grid.dx) && std::isfinite(grid.x0) &&
              (grid.dx > 0 || problem.plane_strain()),
          "The elements have no size", "dx, ds must be above 0 and x0 finite", "Set dx and ds in mm.");
  require(problem.rows.size() == static_cast<std::size_t>(grid.ms), "The rows do not fit the grid",
          fmt::format("{} rows for ms = {}", problem.rows.size(), grid.ms), "Give the middle of each row.");
  for (const ContactRow& row : problem.rows)
    require(std::isfinite(row.s) && std::isfinite(row.position.y) && std::isfinite(row.position.z) &&
                std::isfinite(row.delta),
            "A row of the grid is not finite", fmt::format("row {}", &row - problem.rows.data()),
            "Give finite s, position and inclination.");
  validate_numbers(problem);
  require_field(problem.gap, grid, "undeformed distance");
  if (problem.limit_pressure)
    require(std::isfinite(*problem.limit_pressure) && *problem.limit_pressure > 0,
            "The limit of the pressure cannot be used",
            fmt::format("it is {:g} MPa", *problem.limit_pressure), "Give a pressure above 0, in MPa.");
  if (problem.load == LoadKind::approach)
    require(std::isfinite(problem.approach), "The approach is not finite", "NaN or infinity",
            "Give it in mm.");
  else {
    require(std::isfinite(problem.force) && problem.force >= 0, "The force is negative or not finite",
            fmt::format("{} N", problem.force), "Give a vertical force of 0 or more, in N.");
    require(std::any_of(problem.rows.begin(), problem.rows.end(),
                        [](const ContactRow& row) { return std::cos(row.delta) > 1e-6; }),
            "No row can carry a vertical force", "every row is inclined by 90 degrees or more",
            "Prescribe the approach, or turn the frame.");
  }
  if (problem.tangential)
    validate_friction(problem);
}

} // namespace bem_contact
