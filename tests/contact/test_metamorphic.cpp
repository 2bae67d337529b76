#include "bem_contact/contact/normal/solve_normal.hpp"
#include "bem_contact/contact/tangential/solve_tangential.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

#include <random>

/// What must hold between solutions of related problems. Also: Normal.MirrorsInXAndInS, Rolling.MirrorsInS,
/// Rolling.ScalesWithLengthAndStiffness; rolling mirrored in x with chi = 180 is
/// tests/hard_cases/opposite_rolling.cpp.
namespace bem_contact {
namespace {

/// Gap a x^2 + b s^2 + c x s about (x, s), of unlike or equal bodies, rolling.
ContactProblem rolling(const Material& lower, const Material& upper, int mx, int ms, double x_at,
                       double s_at) {
  ContactProblem problem = scenes::flat(lower, upper, mx, ms, 0.4, 0.4, 0, 0);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double x = problem.grid.x(i % mx) - x_at, s = problem.rows[i / mx].s - s_at;
    problem.gap[i] = 1e-3 * x * x + 1.5e-3 * s * s + 3e-4 * x * s;
  }
  problem.force = 10000;
  return problem;
}

/// Rigid slip about (x, s): shifting the contact leaves it the same there.
void creep(ContactProblem& problem, double xi, double eta, double phi, double x_at, double s_at) {
  scenes::set_creepage(problem, 0.3, xi + phi * s_at, eta - phi * x_at, phi);
}

const Material soft{23000, 0.31};

TEST(Metamorphic, MetresAndPascals) {
  ContactProblem problem = rolling(soft, scenes::steel, 24, 24, 0, 0);
  creep(problem, 5e-4, 3e-4, 1e-4, 0, 0);
  ContactProblem si = rolling({soft.shear_modulus * 1e6, soft.poisson}, {82e9, 0.28}, 24, 24, 0, 0);
  si.grid = {24, 24, 0.4e-3, 0.4e-3, problem.grid.x0 * 1e-3};
  si.numbers = scenes::pair({soft.shear_modulus * 1e6, soft.poisson}, {82e9, 0.28}, si.grid);
  for (ContactRow& row : si.rows)
    row = {1e-3 * row.s, 1e-3 * row.position, row.delta};
  for (double& h : si.gap)
    h *= 1e-3;
  creep(si, 5e-4, 3e-4, 1e-1, 0, 0);
  const ContactResult mm = solve(problem), m = solve(si);
  ASSERT_TRUE(mm.certified() && m.certified()) << m.trust.solver_note;
  EXPECT_NEAR(m.totals.Fx, mm.totals.Fx, 1e-6 * mm.totals.Fx);
  EXPECT_NEAR(m.totals.Fy, mm.totals.Fy, 1e-6 * mm.totals.Fx);
  EXPECT_NEAR(m.totals.Mz * 1e3, mm.totals.Mz, 1e-6 * std::abs(mm.totals.Mz));
  EXPECT_NEAR(m.totals.approach * 1e3, mm.totals.approach, 1e-7 * mm.totals.approach);
  EXPECT_EQ(m.patches[0].adhesion, mm.patches[0].adhesion);
}

/// Linear systems are solved in single precision, whose numbers end at 1e-38.
TEST(Metamorphic, TractionsSmallerThanAnyFloat) {
  for (const int m : {10, 30}) { // dense systems, and GCR
    ContactProblem problem = rolling(soft, scenes::steel, m, m, 0, 0);
    problem.force = m * m;
    creep(problem, 5e-4, 3e-4, 1e-4, 0, 0);
    constexpr double small = 1e-60;
    ContactProblem tiny = problem;
    tiny.numbers = scenes::pair({small * soft.shear_modulus, soft.poisson},
                                {small * scenes::steel.shear_modulus, scenes::steel.poisson}, problem.grid);
    tiny.force *= small;
    const ContactResult a = solve(problem), b = solve(tiny);
    ASSERT_TRUE(a.certified() && b.certified()) << b.trust.solver_note;
    EXPECT_EQ(b.effort.tangential_solver, a.effort.tangential_solver);
    EXPECT_NEAR(b.totals.Fx / small, a.totals.Fx, 1e-6 * a.totals.Fx);
    EXPECT_NEAR(b.totals.Fy / small, a.totals.Fy, 1e-6 * a.totals.Fx);
  }
}

TEST(Metamorphic, ShiftByWholeElements) {
  ContactProblem here = rolling(soft, scenes::steel, 34, 34, 0, 0);
  creep(here, 5e-4, 3e-4, 1e-4, 0, 0);
  const int across = 2, along = -3;
  ContactProblem there = rolling(soft, scenes::steel, 34, 34, along * 0.4, across * 0.4);
  creep(there, 5e-4, 3e-4, 1e-4, along * 0.4, across * 0.4);
  const ContactResult a = solve(here), b = solve(there);
  ASSERT_TRUE(a.certified() && b.certified());
  ASSERT_FALSE(a.trust.touches_border || b.trust.touches_border);
  EXPECT_NEAR(b.totals.approach, a.totals.approach, 1e-7 * a.totals.approach);
  const double pmax = a.patches[0].pmax;
  for (int is = 4; is < 30; ++is)
    for (int ix = 4; ix < 30; ++ix) {
      const int i = is * 34 + ix, j = (is + across) * 34 + ix + along;
      EXPECT_NEAR(b.pn[j], a.pn[i], 1e-6 * pmax);
      EXPECT_NEAR(b.px[j], a.px[i], 1e-6 * pmax);
      EXPECT_NEAR(b.ps[j], a.ps[i], 1e-6 * pmax);
    }
}

/// Fractions of an element change the totals by no more than the two results say of themselves.
TEST(Metamorphic, ShiftByFractionsOfAnElement) {
  ContactProblem here = rolling(scenes::steel, scenes::steel, 34, 34, 0, 0);
  creep(here, 5e-4, 3e-4, 1e-4, 0, 0);
  const ContactResult a = solve(here);
  ASSERT_TRUE(a.certified() && a.trust.discretisation);
  for (const auto& [x, s] : {std::pair{0.2, 0.0}, std::pair{0.0, 0.2}, std::pair{0.12, -0.17}}) {
    ContactProblem there = rolling(scenes::steel, scenes::steel, 34, 34, x, s);
    creep(there, 5e-4, 3e-4, 1e-4, x, s);
    const ContactResult b = solve(there);
    ASSERT_TRUE(b.certified() && b.trust.discretisation);
    const double approach = a.trust.discretisation->approach + b.trust.discretisation->approach;
    const double tangential = a.trust.discretisation->tangential + b.trust.discretisation->tangential;
    EXPECT_LT(approach, 0.02);
    EXPECT_LT(tangential, 0.05);
    EXPECT_NEAR(b.totals.approach, a.totals.approach, approach * a.totals.approach);
    EXPECT_LT(std::hypot(b.totals.Fx - a.totals.Fx, b.totals.Fy - a.totals.Fy), tangential * 0.3 * 10000);
  }
}

/// The answer does not depend on where the solvers start.
TEST(Metamorphic, InitialGuessOfTheNormalProblem) {
  const ContactProblem problem = rolling(scenes::steel, scenes::steel, 24, 24, 0.1, 0.2);
  const int n = problem.grid.size();
  contact::NormalOperators operators;
  const contact::NormalSystem system(problem, operators);
  WorkBudget work;
  const Eigen::VectorXd gap = Eigen::Map<const Eigen::VectorXd>(problem.gap.data(), n);
  contact::NormalState from_nothing;
  solve_normal(system, gap, {LoadKind::force, 0, problem.force}, {}, work, from_nothing);
  ASSERT_TRUE(from_nothing.converged);
  std::mt19937 random(5);
  for (int guess = 0; guess < 4; ++guess) {
    contact::NormalState state;
    state.sides.assign(n, contact::NormalSide::apart);
    for (int i = 0; i < n; ++i) // everything, a corner, a chequerboard, anything
      if (guess == 0 ? true : guess == 1 ? i == 0 : guess == 2 ? (i + i / 24) % 2 == 1 : random() % 2 == 1)
        state.sides[i] = contact::NormalSide::touching;
    solve_normal(system, gap, {LoadKind::force, 0, problem.force}, {}, work, state);
    ASSERT_TRUE(state.converged) << guess << state.remark;
    EXPECT_NEAR(state.approach, from_nothing.approach, 1e-9 * state.approach) << guess;
    EXPECT_LT((state.p - from_nothing.p).cwiseAbs().maxCoeff(), 1e-7 * state.p.maxCoeff()) << guess;
  }
}

TEST(Metamorphic, InitialGuessOfTheTangentialProblem) {
  ContactProblem problem = rolling(scenes::steel, scenes::steel, 24, 24, 0.1, 0.2);
  creep(problem, 5e-4, 3e-4, 1e-4, 0, 0);
  const ContactResult expected = solve(problem);
  ASSERT_TRUE(expected.certified());
  const int n = problem.grid.size();
  contact::TangentialOperators operators;
  const contact::TangentialSystem system(problem, operators);
  WorkBudget work;
  contact::TangentialTask task;
  task.bound = 0.3 * Eigen::Map<const Eigen::VectorXd>(expected.pn.data(), n);
  task.rigid.resize(2 * n);
  for (int i = 0; i < n; ++i) {
    task.rigid[i] = problem.slip_x[i] * problem.grid.dx;
    task.rigid[n + i] = problem.slip_s[i] * problem.grid.dx;
    if (expected.pn[i] > 0)
      task.contact.push_back(i);
  }
  task.drive = task.rigid;
  std::mt19937 random(6);
  std::uniform_real_distribution<> any(-500, 500);
  for (int guess = 0; guess < 4; ++guess) {
    contact::TangentialState state;
    state.p.resize(2 * n);
    for (double& p : state.p)
      p = any(random);
    solve_tangential(system, task, {}, work, state);
    ASSERT_TRUE(state.converged) << state.remark;
    const double pmax = 0.3 * expected.patches[0].pmax;
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(state.p[i], expected.px[i], 1e-5 * pmax);
      EXPECT_NEAR(state.p[n + i], expected.ps[i], 1e-5 * pmax);
    }
  }
}

/// The bodies exchange places (a turn by pi about x): what acts on the one acts, reversed, on the other.
TEST(Metamorphic, ActionAndReaction) {
  const int m = 26;
  ContactProblem problem = rolling(soft, scenes::steel, m, m, 0.3, -0.5);
  ContactProblem turned = rolling(scenes::steel, soft, m, m, 0, 0);
  for (int is = 0; is < m; ++is)
    for (int ix = 0; ix < m; ++ix)
      turned.gap[is * m + ix] = problem.gap[(m - 1 - is) * m + ix];
  scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 1e-4);
  scenes::set_creepage(turned, 0.3, -5e-4, 3e-4, 1e-4);
  const ContactResult a = solve(problem), b = solve(turned);
  ASSERT_TRUE(a.certified() && b.certified());
  const double pmax = a.patches[0].pmax;
  EXPECT_NEAR(a.totals.approach, b.totals.approach, 1e-7 * a.totals.approach);
  for (int is = 0; is < m; ++is)
    for (int ix = 0; ix < m; ++ix) {
      const int i = is * m + ix, j = (m - 1 - is) * m + ix;
      EXPECT_NEAR(b.px[j], -a.px[i], 2e-6 * pmax);
      EXPECT_NEAR(b.ps[j], a.ps[i], 2e-6 * pmax);
      EXPECT_NEAR(b.pn[j], a.pn[i], 2e-6 * pmax);
    }
}

/// More approach, more force; and, for a gap without steps, ever more stiffly.
TEST(Metamorphic, ForceGrowsWithApproach) {
  ContactProblem problem = rolling(scenes::steel, scenes::steel, 24, 24, 0.1, 0.2);
  scenes::bend(problem, 12);
  problem.load = LoadKind::approach;
  std::mt19937 random(8);
  std::uniform_real_distribution<> height(0, 2e-3);
  for (const bool rough : {false, true}) {
    double before = 0, stiffness_before = 0;
    for (int step = 1; step <= 8; ++step) {
      problem.approach = 2e-3 * step;
      const ContactResult result = solve(problem, {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified());
      const double stiffness = result.totals.Fz - before;
      EXPECT_GT(stiffness, 0) << step;
      EXPECT_GE(stiffness, stiffness_before * (1 - 1e-9)) << step;
      before = result.totals.Fz;
      stiffness_before = stiffness;
    }
    if (!rough)
      for (double& h : problem.gap)
        h += height(random);
  }
}

} // namespace
} // namespace bem_contact
