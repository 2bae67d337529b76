#include "bem_contact/contact/history.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/prepared.hpp"

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

Displacements displacements(const ContactProblem& problem, const ContactResult& result,
                            Workspace* workspace) {
  const std::size_t n = problem.grid.size();
  contact::Prepared only_now;
  contact::Prepared& kept = workspace ? workspace->of(problem) : only_now;
  const std::vector<int> all{component_x, component_s, component_n};
  if (!kept.all)
    kept.all.emplace(problem.numbers, problem.grid.mx, all, all, contact::RowRange{}, kept.pool.get());
  std::vector<double> p(result.px), u(3 * n);
  p.insert(p.end(), result.ps.begin(), result.ps.end());
  p.insert(p.end(), result.pn.begin(), result.pn.end());
  kept.all->apply(p, u);
  for (double& v : u)
    v = -v;
  const auto component = [&](int c) {
    return std::vector<double>(u.begin() + c * n, u.begin() + (c + 1) * n);
  };
  return {component(0), component(1), component(2)};
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

} // namespace bem_contact
