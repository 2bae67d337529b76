#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/work.hpp"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// A number that a problem depends on: the same problem, on the same elements, where it is `step` smaller and
/// larger. Their influence numbers are empty if they do not depend on it. What is asked of the problem
/// (ContactConditions) may differ too.
struct TangentInput {
  ContactProblem lower, upper;
  double step = 0; ///< in the unit of the number
};

/// What an element does at the end of the range of a tangent: it leaves the contact or comes into it, reaches
/// the limit of the pressure or falls below it, begins to slip or to stick.
enum class StateChange { none, leaves, touches, yields, recovers, slips, sticks };
template <> struct EnumNames<StateChange> {
  static constexpr std::array<std::string_view, 7> names{"none",     "leaves", "touches", "yields",
                                                         "recovers", "slips",  "sticks"};
};

/// A solution as its linearised equations continue it: elements keep the state that they have.
struct Tangent {
  /// The solution continued to TangentInput::lower and upper: fields, totals and patches (in the order of the
  /// solution's) without errors, certificate and displacements. A half of their difference over the step is a
  /// derivative.
  ContactResult lower, upper;
  /// By how much the number may become smaller or larger until, on the tangent, the first element changes its
  /// state, in its unit; infinite if none does. Beyond, the solution bends. If it is 0, the solution bends
  /// where it is, and the derivative is one of those on both sides or lies between.
  double below = std::numeric_limits<double>::infinity(), above = below;
  StateChange at_below = StateChange::none, at_above = StateChange::none;
};

/// The tangents of a certified solution with respect to `count` inputs, which are made one by one. `problem`
/// is the one solved, with its influence numbers, which it lends meanwhile. Throws InputError where the
/// tangent is not known (tangent_obstacle()), ConvergenceError where the solution has none.
std::vector<Tangent> tangents(ContactProblem& problem, const ContactResult& solved, int count,
                              const std::function<TangentInput(int)>& input, const SolverOptions& options,
                              WorkBudget& work);

/// Why solutions of this problem have no tangents, as a clause; "" if they have.
std::string tangent_obstacle(const ContactProblem& problem);

} // namespace bem_contact
