#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/normal/solve_normal.hpp"
#include "bem_contact/contact/work.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

/// A pressure that is at most H: against a slow dense solution, and by forces.
namespace bem_contact {
namespace {

using testing::HasSubstr;

ContactResult limited(const ContactProblem& problem, SolverOptions options = scenes::without_estimate) {
  ContactResult result = solve(problem, options);
  EXPECT_TRUE(result.certified()) << result.trust.solver_note << ' ' << result.trust.certificate.worst();
  return result;
}

ContactProblem ellipse(int mx, int ms, double d, double force) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, mx, ms, d, d, 8e-4, 1.2e-3);
  problem.force = force;
  return problem;
}

TEST(LimitPressure, AboveThePressureChangesNothing) {
  for (const int across : {24, 60}) { // solved directly, and by conjugate gradients
    ContactProblem problem = ellipse(across, across, 20.0 / across, 8e4);
    SolverOptions precise = scenes::without_estimate; // rough iterations may reach the limit
    precise.tolerance = 1e-10;
    const ContactResult elastic = limited(problem, precise);
    problem.limit_pressure = 1.0001 * elastic.totals.pmax;
    const ContactResult r = limited(problem, precise);
    for (std::size_t i = 0; i < r.pn.size(); ++i)
      ASSERT_NEAR(r.pn[i], elastic.pn[i], 1e-9 * elastic.totals.pmax);
    EXPECT_NEAR(r.totals.approach, elastic.totals.approach, 1e-9 * elastic.totals.approach);
  }
}

/// Where the force is far above what the limit lets an elastic contact bear, nearly all of it is at the
/// limit.
TEST(LimitPressure, EverywhereMakesTheAreaForceOverLimit) {
  double before = 1;
  for (const double share : {0.3, 0.1, 0.03}) {
    ContactProblem problem = ellipse(60, 60, 0.5, 8e4);
    const double pmax = limited(problem).totals.pmax;
    problem.force = 3e4;
    const double limit = problem.limit_pressure.emplace(share * 3 * pmax);
    const ContactResult r = limited(problem);
    const double excess = double(r.totals.area) * limit / problem.force - 1;
    EXPECT_GE(excess, -1e-9);
    EXPECT_LT(excess, before) << share;
    EXPECT_LE(r.totals.pmax, limit * (1 + 1e-12));
    EXPECT_NEAR(r.totals.Fz, problem.force, 1e-7 * problem.force);
    before = excess;
  }
  EXPECT_LT(before, 0.02);
}

/// The slow way: all elements at once, one after the other of the many sets, by LU factors. The approach is
/// bisected where the force is given.
Eigen::VectorXd dense_pressure(const ContactProblem& problem, double approach) {
  const int n = problem.grid.size(), mx = problem.grid.mx;
  Eigen::MatrixXd a(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      a(i, j) = problem.numbers.at(std::abs(i % mx - j % mx), i / mx, component_n, j / mx, component_n);
  Eigen::VectorXd b(n), p = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; ++i)
    b[i] = approach - problem.gap[i];
  // Projected Gauss-Seidel, which cannot fail, until its sets are known; then these exactly.
  const double limit = *problem.limit_pressure;
  for (int sweep = 0; sweep < 3000; ++sweep)
    for (int i = 0; i < n; ++i)
      p[i] = std::clamp(p[i] + (b[i] - a.row(i).dot(p)) / a(i, i), 0.0, limit);
  std::vector<int> free;
  for (int i = 0; i < n; ++i)
    if (p[i] > 1e-9 * limit && p[i] < (1 - 1e-9) * limit)
      free.push_back(i);
  Eigen::VectorXd fixed = p;
  fixed(free).setZero();
  const Eigen::VectorXd rest = b - a * fixed;
  const Eigen::VectorXd exact = a(free, free).lu().solve(rest(free));
  p(free) = exact;
  return p;
}

TEST(LimitPressure, OfHertzIsTheDenseSolution) {
  NEEDS_NO_SANITIZER();
  for (const double share : {0.9, 0.6, 0.4}) {
    ContactProblem problem = ellipse(22, 20, 0.9, 8e4);
    problem.limit_pressure = share * limited(problem).totals.pmax;
    const ContactResult r = limited(problem);
    const Eigen::VectorXd exact = dense_pressure(problem, r.totals.approach);
    for (int i = 0; i < problem.grid.size(); ++i)
      ASSERT_NEAR(r.pn[i], exact[i], 1e-6 * *problem.limit_pressure) << share << ' ' << i;
    EXPECT_NEAR(exact.sum() * problem.element_area(), problem.force, 1e-6 * problem.force);
    int at_limit = 0;
    for (int i = 0; i < problem.grid.size(); ++i)
      if (r.pn[i] == *problem.limit_pressure) {
        ++at_limit;
        EXPECT_LT(r.deformed_distance[i], 1e-9); // indented for good
      }
    EXPECT_GT(at_limit, 3);
  }
}

/// Random contacts of one and of two patches, solved directly, by conjugate gradients and by MPRGP.
TEST(LimitPressure, RandomCasesAgreeBetweenSolvers) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int k = 0; k < 24; ++k) {
    const int across = k % 2 ? 18 : 36;
    ContactProblem problem = ellipse(across, across, 24.0 / across, 8e4 * between(0.3, 1.5));
    if (k % 3 == 0)
      for (int is = 0; is < across; ++is)
        for (int ix = 0; ix < across; ++ix) {
          const double s = std::abs(problem.rows[is].s) - 6, x = problem.grid.x(ix);
          problem.gap[is * across + ix] = 1e-3 * x * x + 2e-3 * s * s + (problem.rows[is].s > 0 ? 5e-3 : 0);
        }
    const ContactResult elastic = limited(problem);
    problem.limit_pressure = between(0.45, 1.05) * elastic.totals.pmax;
    const ContactResult r = limited(problem);
    EXPECT_EQ(r.effort.normal_solver, "active set") << k;
    contact::NormalOperators operators;
    const contact::NormalSystem system(problem, operators);
    contact::NormalState safe;
    WorkBudget work;
    solve_normal_safely(system, Eigen::Map<const Eigen::VectorXd>(problem.gap.data(), problem.grid.size()),
                        {LoadKind::force, 0, problem.force}, {}, work, safe);
    ASSERT_TRUE(safe.converged) << k;
    for (int i = 0; i < problem.grid.size(); ++i)
      ASSERT_NEAR(safe.p[i], r.pn[i], 1e-5 * *problem.limit_pressure) << k;
    EXPECT_LT(r.effort.work, 3 * elastic.effort.work) << k;
    if (*problem.limit_pressure < 0.95 * elastic.totals.pmax) {
      EXPECT_GE(r.totals.area, double(elastic.totals.area)) << k;
    }
  }
}

/// Friction is that of the limited pressure, on flat rows and inclined ones, and in histories.
TEST(LimitPressure, CarriesFriction) {
  ContactProblem problem = ellipse(28, 28, 0.75, 8e4);
  problem.limit_pressure = 0.7 * limited(problem).totals.pmax;
  scenes::set_creepage(problem, 0.3, 5e-2, 0, 0);
  const ContactResult sliding = limited(problem);
  EXPECT_NEAR(sliding.totals.Fx, 0.3 * problem.force, 1e-5 * problem.force);
  scenes::bend(problem, 40);
  scenes::set_creepage(problem, 0.3, 1e-3, 1e-3, 0);
  scenes::rotate_numbers(problem);
  const ContactResult bent = limited(problem);
  EXPECT_NEAR(bent.totals.Fz, problem.force, 1e-6 * problem.force);
  EXPECT_NEAR(bent.totals.pmax, *problem.limit_pressure, 1e-9 * *problem.limit_pressure);
  ContactProblem shift = ellipse(20, 20, 1, 8e4);
  shift.limit_pressure = problem.limit_pressure;
  scenes::set_creepage(shift, 0.3, 1e-3, 0, 0);
  shift.motion = MotionKind::shift;
  for (const ContactResult& step : solve_history(
           shift, 3, [](int k, ContactProblem&p) { p.force = 6e4 + 1e4 * k; }, scenes::without_estimate))
    EXPECT_TRUE(step.certified()) << step.trust.solver_note;
}

TEST(LimitPressure, ADamagedSolutionIsNotCertified) {
  ContactProblem problem = ellipse(22, 22, 0.9, 8e4);
  problem.limit_pressure = 0.6 * limited(problem).totals.pmax;
  const ContactResult r = limited(problem);
  const auto at = std::ranges::max_element(r.pn) - r.pn.begin();
  for (const double by : {1.001, 0.999}) {
    ContactResult damaged = r;
    damaged.pn[at] *= by;
    EXPECT_FALSE(certify(problem, damaged).holds()) << by;
  }
  ContactProblem other = problem;
  other.limit_pressure.reset();
  EXPECT_FALSE(certify(other, r).holds());
}

TEST(LimitPressure, ThatBearsLessThanTheForceOnAllOfTheGridIsNotCertified) {
  ContactProblem problem = ellipse(20, 20, 0.5, 8e4);
  problem.limit_pressure = 500;
  const ContactResult r = solve(problem);
  EXPECT_FALSE(r.certified());
  EXPECT_TRUE(r.trust.touches_border);
  EXPECT_THAT(r.trust.solver_note, HasSubstr("larger grid"));
  problem.limit_pressure = -1;
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("above 0"));
}

} // namespace
} // namespace bem_contact
