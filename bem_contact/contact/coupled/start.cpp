#include "bem_contact/contact/coupled/start.hpp"

#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/coupled/solve_coupled.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/grid/larger_elements.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Newton steps on the larger elements of a start. Chosen: a start that takes more saves nothing.
constexpr int start_newton_steps = 30;

double limit_of(const ContactProblem& problem) {
  return problem.limit_pressure.value_or(std::numeric_limits<double>::infinity());
}

/// Sets what is guessed. False, and nothing is set, if the guess is of another grid or has no pressure.
bool start_from_guess(const StartingPoint& guess, const ContactProblem& problem, Solution& solution) {
  const Eigen::Index n = problem.grid.size();
  if (guess.pn.size() != static_cast<std::size_t>(n) ||
      std::ranges::none_of(guess.pn, [](double p) { return p > 0; }))
    return false;
  solution.normal.p = vector_of(guess.pn).cwiseMax(0.0).cwiseMin(limit_of(problem));
  solution.normal.approach = guess.approach;
  solution.normal.set_sides(limit_of(problem));
  if (problem.has_friction())
    solution.shear.p = joined(guess.px, guess.ps);
  return true;
}

/// Bilinear between the centres of the coarse elements.
void prolong(const ContactGrid& from, const double* coarse, const ContactGrid& to, double* fine) {
  struct Place {
    int low, high;
    double share; ///< of high
  };
  const auto place = [](int k, int count) {
    const double at = std::clamp(0.5 * k - 0.25, 0.0, count - 1.0);
    const int low = std::min(static_cast<int>(at), count - 2);
    return Place{low, low + 1, at - low};
  };
  for (int is = 0; is < to.ms; ++is) {
    const Place s = place(is, from.ms);
    for (int ix = 0; ix < to.mx; ++ix) {
      const Place x = place(ix, from.mx);
      const auto line = [&](int row) {
        const double* c = coarse + static_cast<std::ptrdiff_t>(row) * from.mx;
        return (1 - x.share) * c[x.low] + x.share * c[x.high];
      };
      fine[static_cast<std::ptrdiff_t>(is) * to.mx + ix] =
          (1 - s.share) * line(s.low) + s.share * line(s.high);
    }
  }
}

/// Sets pressures, states and (steady rolling) shear tractions of the same problem on elements twice as
/// large, which starts likewise. A small problem is quickly solved from anywhere and stays as it is.
void start_from_larger_elements(const ContactProblem& problem, const SolverOptions& options,
                                ContactOperators& operators, WorkBudget& work, Solution& solution) {
  const ContactGrid& grid = problem.grid;
  if (problem.plane_strain() || grid.size() < least_elements_for_rough_start ||
      std::min(grid.mx, grid.ms) < few_across)
    return;
  ContactProblem coarse = starting_problem(problem);
  const bool only_normal = !(coarse.tangential && problem.has_friction());
  StartingOperators& prepared =
      operators.start(problem.numbers, coarse.grid, starting_row(problem), only_normal);
  const LentNumbers lent(prepared.numbers, coarse);
  SolverOptions loose = options;
  loose.start = nullptr;
  loose.near = nullptr;
  loose.tolerance = std::max(options.tolerance, start_tolerance);
  loose.max_outer = 1; // a start need not know how shear acts on the pressure
  loose.max_tangential = std::min(options.max_tangential, start_newton_steps);
  loose.only_newton = true;
  const Solution known = solve_coupled(coarse, loose, prepared.operators, work);
  if (!known.normal.converged)
    return;
  const int n = grid.size(), n_coarse = coarse.grid.size();
  solution.normal.p.resize(n);
  prolong(coarse.grid, known.normal.p.data(), grid, solution.normal.p.data());
  if (known.normal.unit.size() == n_coarse) {
    solution.normal.unit.resize(n);
    prolong(coarse.grid, known.normal.unit.data(), grid, solution.normal.unit.data());
  }
  solution.normal.set_sides(limit_of(problem));
  solution.normal.approach = known.normal.approach;
  if (known.shear.p.allFinite())
    for (const int c : {0, 1})
      prolong(coarse.grid, known.shear.p.data() + c * n_coarse, grid, solution.shear.p.data() + c * n);
}

} // namespace

Solution start(const ContactProblem& problem, const SolverOptions& options, ContactOperators& operators,
               WorkBudget& work) {
  const int n = problem.grid.size();
  Solution solution;
  solution.from_shear = VectorXd::Zero(n);
  solution.shear.p = VectorXd::Zero(2 * n);
  solution.shear.slip = VectorXd::Zero(2 * n);
  solution.shear.solver = "none";
  solution.shear.converged = true;
  solution.pressed = problem.force;
  if (options.near) {
    start_from_guess(*options.near, problem, solution);
    solution.creepage.x = options.near->creepage_x;
    solution.creepage.s = options.near->creepage_s;
    solution.creepage.near = true;
    return solution;
  }
  if (options.start && start_from_guess(*options.start, problem, solution))
    return solution;
  if (options.coarse_start)
    start_from_larger_elements(problem, options, operators, work, solution);
  return solution;
}

} // namespace bem_contact::contact
