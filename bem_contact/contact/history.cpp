#include "bem_contact/contact/history.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/check/direct_sums.hpp"

#include <utility>

namespace bem_contact {

Tractions tractions_of(const ContactResult& result) {
  return {result.px, result.ps, result.pn};
}

std::vector<ContactResult> solve_history(ContactProblem problem, int steps,
                                         const std::function<void(int, ContactProblem&)>& prescribe,
                                         const SolverOptions& given) {
  Workspace own;
  SolverOptions options = given;
  if (!options.workspace)
    options.workspace = &own; // the numbers stay the same
  if (problem.motion == MotionKind::steady)
    throw InputError("steady rolling has no steps", "it is the state that steps lead to",
                     "solve it as one problem, or choose a shift or transient rolling");
  const std::size_t kept = problem.motion == MotionKind::transient ? 2 : 1;
  std::vector<ContactResult> results;
  for (int k = 0; k < steps; ++k) {
    prescribe(k, problem);
    results.push_back(solve(problem, options));
    problem.previous.insert(problem.previous.begin(), tractions_of(results.back()));
    if (problem.previous.size() > kept)
      problem.previous.resize(kept);
  }
  return results;
}

Displacements displacements(const ContactProblem& problem, const ContactResult& result) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  const contact::Fields u =
      contact::direct_displacements(problem, std::vector<char>(ms, 1), {&result.px, &result.ps, &result.pn});
  const std::size_t columns = u[component_n].size() / ms;
  Displacements out;
  for (const auto& [of, to] :
       {std::pair(component_x, &out.ux), {component_s, &out.us}, {component_n, &out.un}}) {
    to->resize(problem.grid.size());
    for (int is = 0; is < ms; ++is)
      for (int ix = 0; ix < mx; ++ix)
        (*to)[is * mx + ix] = -u[of][is * columns + ix];
  }
  return out;
}

std::vector<double> friction_power(const ContactResult& result) {
  std::vector<double> power(result.px.size());
  for (std::size_t i = 0; i < power.size(); ++i)
    power[i] = result.px[i] * result.slip_x[i] + result.ps[i] * result.slip_s[i];
  return power;
}

double friction_power(const ContactResult& result, double element_area) {
  double sum = 0;
  for (const double power : friction_power(result))
    sum += power * element_area;
  return sum;
}

double largest_pressure(const ContactResult& result) {
  double largest = 0;
  for (const PatchSummary& p : result.patches)
    largest = std::max(largest, p.pmax);
  return largest;
}

double contact_area(const ContactResult& result) {
  double area = 0;
  for (const PatchSummary& p : result.patches)
    area += p.area;
  return area;
}

ElementCounts count_elements(const ContactResult& result) {
  ElementCounts counts;
  for (const PatchSummary& p : result.patches) {
    counts.contact += p.contact;
    counts.adhesion += p.adhesion;
    counts.slip += p.slip;
  }
  return counts;
}

} // namespace bem_contact
