#include "tests/hard_cases/hard_case.hpp"

#include "tests/hard_cases/moved_input.hpp"

#include <algorithm>
#include <cstdio>

namespace bem_contact::hard {

int contact_count(const ContactResult& result) {
  return static_cast<int>(std::count_if(result.pn.begin(), result.pn.end(), [](double p) { return p > 0; }));
}

void print_line(const std::string& name, const std::string& what, const ContactResult& result) {
  std::printf("| %s | %s | %d of %zu | %s; %s | %d / %d / %d | %.0e |\n", name.c_str(), what.c_str(),
              contact_count(result), result.pn.size(), result.effort.normal_solver.c_str(),
              result.effort.tangential_solver.c_str(), result.effort.outer_iterations,
              result.effort.normal_iterations, result.effort.tangential_iterations,
              result.trust.certificate.worst());
}

namespace {

void print_without_result(const std::string& name, const std::string& what, const std::string& outcome) {
  std::printf("| %s | %s | - | %s | - | - |\n", name.c_str(), what.c_str(), outcome.c_str());
}

} // namespace

void print_refusal(const std::string& name, const std::string& what, const std::string& reason) {
  print_without_result(name, what, "refused: " + reason);
}

ContactResult certified(const std::string& name, const std::string& what, const ContactProblem& problem,
                        const SolverOptions& options) {
  ContactResult result = solve(problem, options);
  print_line(name, what, result);
  print_moved(name, problem, options);
  EXPECT_TRUE(result.certified()) << name << ": " << result.trust.certificate.worst() << ' '
                                  << result.trust.solver_note;
  EXPECT_LE(result.trust.certificate.worst(), 1e-6) << name;
  if (problem.has_friction()) {
    double carried = 0;
    for (const double p : result.pn)
      carried += p * problem.element_area();
    EXPECT_LE(std::abs(result.totals.Fx), problem.friction * carried * (1 + 1e-6)) << name;
  }
  return result;
}

ContactResult certified_or_not_converged(const std::string& name, const std::string& what,
                                         const ContactProblem& problem, const SolverOptions& options) {
  ContactResult result = solve(problem, options);
  if (result.certified()) {
    print_line(name, what, result);
    print_moved(name, problem, options);
    EXPECT_LE(result.trust.certificate.worst(), 1e-6) << name;
  } else {
    print_without_result(name, what, "not converged: " + result.trust.solver_note);
    EXPECT_FALSE(result.trust.solver_note.empty()) << name << ": not converged, without a reason";
    EXPECT_GT(result.trust.certificate.worst(), 1e-6) << name;
  }
  return result;
}

ContactProblem rolling_contact(int across, const Material& lower, const Material& upper) {
  ContactProblem problem =
      scenes::flat(lower, upper, across, across, 12.0 / across, 9.0 / across, 1 / 920.0, 1 / 600.0);
  problem.force = 40000;
  return problem;
}

} // namespace bem_contact::hard
