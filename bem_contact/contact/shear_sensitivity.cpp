#include "bem_contact/contact/shear_sensitivity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/tangential/linear_solution.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/Core>

namespace bem_contact {

namespace {

using Eigen::VectorXd;
using namespace contact;

/// 1. Precision of the linear system at a solution.
constexpr double sensitivity_precision = 1e-9;

[[noreturn]] void refuse() {
  throw ConvergenceError("The sensitivities of this contact cannot be found",
                         "the linear system at the solution is singular or too ill-conditioned",
                         "Change the creepages a little, or use differences of two solutions.");
}

} // namespace

ShearChange shear_sensitivity(const ContactProblem& problem, const ContactResult& result,
                              const SlipChange& change) {
  if (!problem.has_friction() || problem.motion != MotionKind::steady || !problem.is_coulomb())
    throw InputError("This contact has no sensitivities",
                     "they are for steady rolling with one coefficient of friction",
                     "Ask for such a contact.");
  WorkBudget work;
  TangentialOperators operators;
  const TangentialSystem system(problem, operators);
  TangentialTask task;
  task.bound = vector_of(result.pn);
  for (int i = 0; i < system.size(); ++i) {
    task.bound[i] *= problem.friction_of(i / problem.grid.mx);
    if (result.pn[i] > 0)
      task.contact.push_back(i);
  }
  if (task.contact.empty()) {
    const std::vector<double> none(system.size(), 0.0);
    return {none, none};
  }
  const ContactElements elements(system, task);
  const NewtonMatrix matrix(system, elements, work);
  const double length = system.rule.length;
  const Linearisation at =
      linearise(elements.stiffness, elements.bound, elements.gather(joined(result.px, result.ps)),
                length * elements.gather(joined(result.slip_x, result.slip_s)));
  const VectorXd right =
      projected(at, length * elements.gather(joined(change.x, change.s)), &elements.stiffness);
  const auto found = linear_solution(matrix, at, elements.stiffness, right,
                                     {.wanted = sensitivity_precision,
                                      .accepted = sensitivity_precision,
                                      .correction = finest_newton_forcing},
                                     work);
  if (!found)
    refuse();
  const VectorXd field = elements.scatter(*found);
  const double* begin = field.data();
  return {{begin, begin + system.size()}, {begin + system.size(), begin + 2 * system.size()}};
}

} // namespace bem_contact
