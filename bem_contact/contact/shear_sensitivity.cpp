#include "bem_contact/contact/shear_sensitivity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/tangential/newton_matrix.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/Core>

namespace bem_contact {

namespace {

using Eigen::VectorXd;
using namespace contact;

/// 1. Precision of the linear system at a solution, and times it is solved for what is left of it: each takes
/// off four digits.
constexpr double sensitivity_precision = 1e-9;
constexpr int most_sensitivity_refinements = 12;

VectorXd joined(const std::vector<double>& x, const std::vector<double>& s) {
  VectorXd out(x.size() + s.size());
  out << VectorXd::Map(x.data(), x.size()), VectorXd::Map(s.data(), s.size());
  return out;
}

/// M v or, with `stiffness`, M r v; element by element.
VectorXd projected(const Linearisation& at, VectorXd v, const VectorXd* stiffness = nullptr) {
  for (std::size_t a = 0; a < at.projection.size(); ++a)
    v.segment<2>(2 * a) = ((stiffness ? (*stiffness)[a] : 1) * at.projection[a] * v.segment<2>(2 * a)).eval();
  return v;
}

/// J x = right with J = 1 - M (1 - r B). newton_step() is precise to finest_newton_forcing; the residual in
/// double precision is solved for again.
VectorXd solved(const NewtonMatrix& matrix, const Linearisation& at, const VectorXd& stiffness,
                const VectorXd& right, WorkBudget& work) {
  TangentialState state;
  VectorXd x = VectorXd::Zero(right.size()), product;
  Linearisation rest = at;
  for (int i = 0; i < most_sensitivity_refinements; ++i) {
    matrix.step(x, product);
    rest.residual = x - projected(at, x) + projected(at, product, &stiffness) - right; // J x - right
    if (rest.residual.norm() <= sensitivity_precision * right.norm())
      return x;
    x += matrix.newton_step(rest, {}, finest_newton_forcing, work, state).x;
    if (!x.allFinite())
      break;
  }
  throw ConvergenceError("The sensitivities of this contact cannot be found",
                         "the linear system at the solution is singular or too ill-conditioned",
                         "Change the creepages a little, or use differences of two solutions.");
}

} // namespace

std::vector<ShearChange> shear_sensitivities(const ContactProblem& problem, const ContactResult& result,
                                             std::span<const SlipChange> changes) {
  if (!problem.has_friction() || problem.motion != MotionKind::steady || !problem.is_coulomb())
    throw InputError("This contact has no sensitivities",
                     "they are for steady rolling with one coefficient of friction",
                     "Ask for such a contact.");
  WorkBudget work;
  TangentialOperators operators;
  const TangentialSystem system(problem, operators);
  TangentialTask task;
  task.bound = VectorXd::Map(result.pn.data(), system.size());
  for (int i = 0; i < system.size(); ++i) {
    task.bound[i] *= problem.friction_of(i / problem.grid.mx);
    if (result.pn[i] > 0)
      task.contact.push_back(i);
  }
  std::vector<ShearChange> out;
  if (task.contact.empty()) {
    const std::vector<double> none(system.size(), 0.0);
    out.assign(changes.size(), {none, none});
    return out;
  }
  const ContactElements elements(system, task);
  const NewtonMatrix matrix(system, elements, work);
  const double length = system.rule.length;
  const Linearisation at =
      linearise(elements.stiffness, elements.bound, elements.gather(joined(result.px, result.ps)),
                length * elements.gather(joined(result.slip_x, result.slip_s)));
  for (const SlipChange& change : changes) {
    const VectorXd right =
        projected(at, length * elements.gather(joined(change.x, change.s)), &elements.stiffness);
    const VectorXd field = elements.scatter(solved(matrix, at, elements.stiffness, right, work));
    const double* begin = field.data();
    out.push_back({{begin, begin + system.size()}, {begin + system.size(), begin + 2 * system.size()}});
  }
  return out;
}

} // namespace bem_contact
