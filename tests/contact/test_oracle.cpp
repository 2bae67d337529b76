#include "bem_contact/contact/normal/normal_lines.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/contact/textbook.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <span>

/// The slow obvious version: dense matrices and relaxation, against the solvers on random small problems.
namespace bem_contact {
namespace {

using textbook::number;
using textbook::step_number;

/// Numbers with the symmetries and nothing else, positive definite by their diagonal; signs at random.
ContactProblem random_problem(std::mt19937& random) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  ContactProblem problem;
  const int mx = std::uniform_int_distribution<>(2, 6)(random),
            ms = std::uniform_int_distribution<>(1, 5)(random);
  problem.grid = {mx, ms, 0.5, 0.4, 0};
  InfluenceNumbers& a = problem.numbers;
  a = {mx + 2, ms, 0.5, 0.4, LargeTable<double>(9 * (mx + 2) * ms * ms, 0.0)};
  for (int m = 0; m <= mx + 1; ++m)
    for (int row_i = 0; row_i < ms; ++row_i)
      for (int i = 0; i < 3; ++i) {
        for (int row_j = 0; row_j < ms; ++row_j)
          for (int j = 0; j < 3; ++j) {
            if (m == 0 && parity(i, j) < 0)
              continue;
            const double v = uniform(-0.5, 0.5) / (3.0 * ms * (1 + m * m));
            a.at(m, row_i, i, row_j, j) = v;
            a.at(m, row_j, j, row_i, i) = parity(i, j) * v;
          }
      }
  for (int row = 0; row < ms; ++row)
    for (int i = 0; i < 3; ++i)
      a.at(0, row, i, row, i) = uniform(2, 3);
  for (int is = 0; is < ms; ++is) {
    problem.rows.push_back({0.4 * is, {0.4 * is, 0}, uniform(-1.2, 1.2)});
    for (int ix = 0; ix < mx; ++ix) {
      problem.gap.push_back(uniform(-1, 1));
      problem.slip_x.push_back(uniform(-2, 2));
      problem.slip_s.push_back(uniform(-2, 2));
    }
  }
  problem.load = LoadKind::approach;
  problem.approach = uniform(0, 1);
  problem.friction = uniform(0.05, 0.5);
  return problem;
}

struct Tractions {
  std::vector<double> p[3];
};

/// Projected relaxation of all unknowns at once, small steps, until nothing moves.
Tractions relax(const ContactProblem& problem) {
  const int n = problem.grid.size();
  Tractions t;
  for (auto& p : t.p)
    p.assign(n, 0.0);
  for (int sweep = 0; sweep < 5000; ++sweep) {
    double moved = 0;
    for (int i = 0; i < n; ++i) {
      double e = problem.gap[i] - problem.approach * std::cos(problem.rows[i / problem.grid.mx].delta);
      double slip[2] = {problem.slip_x[i] * problem.grid.dx, problem.slip_s[i] * problem.grid.dx};
      for (int j = 0; j < n; ++j)
        for (int c = 0; c < 3; ++c) {
          e += number(problem, i, 2, j, c) * t.p[c][j];
          for (int k = 0; k < 2; ++k)
            slip[k] -= step_number(problem, i, k, j, c) * t.p[c][j];
        }
      const double pn = std::max(0.0, t.p[2][i] - 0.2 * e);
      double px = t.p[0][i] + 0.2 * slip[0], ps = t.p[1][i] + 0.2 * slip[1];
      const double length = std::hypot(px, ps), bound = problem.friction * pn;
      if (length > bound) {
        px *= bound / length;
        ps *= bound / length;
      }
      moved = std::max({moved, std::abs(pn - t.p[2][i]), std::abs(px - t.p[0][i]), std::abs(ps - t.p[1][i])});
      t.p[0][i] = px;
      t.p[1][i] = ps;
      t.p[2][i] = pn;
    }
    if (moved < 1e-13)
      return t;
  }
  ADD_FAILURE() << "the oracle did not converge";
  return t;
}

TEST(Oracle, NormalLinesAreTheDenseSum) {
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    const ContactProblem problem =
        k % 2 ? random_problem(random)
              : scenes::flat(scenes::steel, scenes::steel, 3 + k / 4, 2 + k / 3, 0.5, 0.4, 1, 1);
    const int n = problem.grid.size();
    Eigen::VectorXd p(n);
    std::vector<int> loaded; // some elements only
    for (int i = 0; i < n; ++i) {
      p[i] = i % 3 ? std::uniform_real_distribution<>(0, 1)(random) : 0;
      if (p[i] > 0)
        loaded.push_back(i);
    }
    const contact::NormalLines lines(problem.numbers, problem.grid.mx);
    const Eigen::VectorXd u = lines.apply(p);
    const Eigen::MatrixXd block = lines.block(loaded);
    const double self = number(problem, 0, 2, 0, 2);
    for (int i = 0; i < n; ++i) {
      double sum = 0;
      for (int j = 0; j < n; ++j)
        sum += number(problem, i, 2, j, 2) * p[j];
      EXPECT_NEAR(u[i], sum, 1e-13 * n * self);
    }
    for (std::size_t b = 0; b < loaded.size(); ++b)
      for (std::size_t a = b; a < loaded.size(); ++a)
        EXPECT_EQ(block(a, b), number(problem, loaded[a], 2, loaded[b], 2));
  }
}

TEST(Oracle, OperatorIsTheDenseSum) {
  std::mt19937 random(1);
  for (int k = 0; k < 20; ++k) {
    const ContactProblem problem = random_problem(random);
    const int n = problem.grid.size();
    std::vector<double> p(3 * n), u(3 * n), step(3 * n);
    for (double& v : p)
      v = std::uniform_real_distribution<>(-1, 1)(random);
    const contact::StripOperator whole(problem.numbers, problem.grid.mx, {0, 1, 2}, {0, 1, 2});
    whole.apply(p, u);
    whole.apply_step(p, step);
    double energy = 0;
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c) {
        double sum = 0, stepped = 0;
        for (int j = 0; j < n; ++j)
          for (int d = 0; d < 3; ++d) {
            sum += number(problem, i, c, j, d) * p[d * n + j];
            stepped += step_number(problem, i, c, j, d) * p[d * n + j];
          }
        EXPECT_NEAR(u[c * n + i], sum, 1e-12);
        EXPECT_NEAR(step[c * n + i], stepped, 1e-12);
        energy += p[c * n + i] * u[c * n + i];
      }
    EXPECT_GT(energy, 0);
    // blocks of it, in any order of the components
    std::vector<double> shear(p.begin(), p.begin() + 2 * n), normal(n), turned(2 * n);
    contact::StripOperator(problem.numbers, problem.grid.mx, {2}, {0, 1}).apply(shear, normal);
    contact::StripOperator(problem.numbers, problem.grid.mx, {1, 0}, {0, 1}).apply(shear, turned);
    for (int i = 0; i < n; ++i) {
      double sum = 0, along = 0;
      for (int j = 0; j < n; ++j)
        for (int d = 0; d < 2; ++d) {
          sum += number(problem, i, 2, j, d) * p[d * n + j];
          along += number(problem, i, 0, j, d) * p[d * n + j];
        }
      EXPECT_NEAR(normal[i], sum, 1e-12);
      EXPECT_NEAR(turned[n + i], along, 1e-12);
    }
  }
}

/// Numbers that are stored once for all rows equally far apart go another way (FFT in both directions), and
/// so do a few rows out of many.
TEST(Oracle, TranslationalNumbersGiveTheSameDisplacements) {
  std::mt19937 random(5);
  for (const auto& [mx, ms] : {std::pair{9, 7}, std::pair{1, 6}, std::pair{8, 1}, std::pair{16, 11}}) {
    ContactProblem problem = scenes::flat({23000, 0.31}, {82000, 0.0}, mx, ms, 0.5, 0.3, 1e-3, 1e-3);
    for (double& v : problem.numbers.values) // nothing but x and s may be assumed
      v *= std::uniform_real_distribution<>(0.9, 1.1)(random);
    ASSERT_TRUE(problem.numbers.translational);
    const InfluenceNumbers table = with_every_pair_of_rows(problem.numbers);
    const int n = mx * ms;
    std::vector<double> p(3 * n), once(3 * n), spelled(3 * n);
    for (double& v : p)
      v = std::uniform_real_distribution<>(-1, 1)(random);
    const contact::StripOperator a(problem.numbers, mx, {0, 1, 2}, {0, 1, 2}),
        b(table, mx, {0, 1, 2}, {0, 1, 2});
    const double scale = problem.numbers.at(0, 0, 2, 0, 2);
    for (const int columns : {0, 1, 2}) {
      a.apply(p, once, columns);
      b.apply(p, spelled, columns);
      for (int i = 0; i < 3 * n; ++i)
        EXPECT_NEAR(once[i], spelled[i], 1e-13 * scale) << columns;
    }
    a.apply_step(p, once);
    b.apply_step(p, spelled);
    for (int i = 0; i < 3 * n; ++i)
      EXPECT_NEAR(once[i], spelled[i], 1e-13 * scale);
    if (ms < 4)
      continue;
    const std::span<const double> part(p.data(), 3 * mx);
    std::vector<double> three(3 * mx), of_table(3 * mx);
    contact::StripOperator(problem.numbers, contact::Boxes{{{0, 2, mx, 3}}}, {2}, {1}).apply(part, three);
    contact::StripOperator(table, contact::Boxes{{{0, 2, mx, 3}}}, {2}, {1}).apply(part, of_table);
    for (int i = 0; i < 3 * mx; ++i)
      EXPECT_NEAR(three[i], of_table[i], 1e-13 * scale);
  }
}

/// Areas far apart get boxes of their own: what they do to each other is not lost.
TEST(Oracle, BoxesActOnEachOtherAsTheirElementsDo) {
  std::mt19937 random(6);
  const int mx = 30, ms = 40, n = mx * ms;
  ContactProblem problem = scenes::flat({23000, 0.31}, {82000, 0.0}, mx, ms, 0.5, 0.3, 1e-3, 1e-3);
  for (double& v : problem.numbers.values) // nothing but x and s may be assumed
    v *= std::uniform_real_distribution<>(0.9, 1.1)(random);
  std::vector<int> elements;
  for (int is = 0; is < ms; ++is)
    for (int ix = 0; ix < mx; ++ix)
      if ((is >= 3 && is < 9 && ix >= 2 && ix < 11) || (is >= 30 && is < 38 && ix >= 18 && ix < 25))
        elements.push_back(is * mx + ix);
  const InfluenceNumbers table = with_every_pair_of_rows(problem.numbers);
  for (const InfluenceNumbers* numbers :
       std::initializer_list<const InfluenceNumbers*>{&problem.numbers, &table}) {
    const contact::Boxes boxes = contact::boxes_around(elements, problem.grid, 1, !numbers->translational);
    ASSERT_EQ(boxes.count(), 2);
    EXPECT_TRUE(boxes.cover(elements, mx));
    EXPECT_LT(boxes.size(), 0.6 * n);
    const contact::StripOperator whole(*numbers, mx, {0, 1, 2}, {0, 1, 2}),
        some(*numbers, boxes, {0, 1, 2}, {0, 1, 2});
    std::vector<double> p(3 * n, 0.0), u(3 * n), step(3 * n);
    std::vector<double> p_some(3 * boxes.size(), 0.0), u_some(p_some), step_some(p_some);
    for (const int i : elements)
      for (int c = 0; c < 3; ++c)
        p_some[c * boxes.size() + boxes.local(i, mx)] = p[c * n + i] =
            std::uniform_real_distribution<>(-1, 1)(random);
    whole.apply(p, u);
    some.apply(p_some, u_some);
    whole.apply_step(p, step);
    some.apply_step(p_some, step_some);
    const double scale = numbers->at(0, 0, 2, 0, 2);
    for (int i = 0; i < n; ++i)
      if (const int l = boxes.local(i, mx); l >= 0)
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(u_some[c * boxes.size() + l], u[c * n + i], 1e-12 * scale) << i;
          EXPECT_NEAR(step_some[c * boxes.size() + l], step[c * n + i], 1e-12 * scale) << i;
        }
  }
}

/// Two balls side by side, far apart: each bears what it bears alone, less what the other presses down.
TEST(Oracle, TwoAreasFarApartAreSolvedAtOnce) {
  const int mx = 30, ms = 120;
  ContactProblem problem = scenes::flat({82000, 0.28}, {82000, 0.28}, mx, ms, 0.4, 0.4, 1 / 600.0, 1 / 600.0);
  const auto gap_about = [&](double s_centre, int is, int ix) {
    const double x = problem.grid.x(ix), s = problem.rows[is].s - s_centre;
    return (x * x + s * s) / 600;
  };
  const double from = problem.rows.front().s, apart = 36 * 0.4;
  const double first = 0.5 * (from + problem.rows.back().s) - apart, second = first + 2 * apart;
  std::vector<double> both(problem.gap), one(problem.gap);
  for (int is = 0; is < ms; ++is)
    for (int ix = 0; ix < mx; ++ix) {
      one[is * mx + ix] = gap_about(first, is, ix);
      both[is * mx + ix] = std::min(one[is * mx + ix], gap_about(second, is, ix));
    }
  scenes::set_creepage(problem, 0.3, 1e-3, 3e-4, 0);
  problem.gap = one;
  problem.force = 5e4;
  const ContactResult alone = solve(problem);
  problem.gap = both;
  problem.force = 1e5;
  const ContactResult two = solve(problem);
  ASSERT_TRUE(alone.certified() && two.certified()) << two.trust.solver_note;
  ASSERT_EQ(two.patches.size(), 2u);
  EXPECT_NEAR(two.patches[0].fn, two.patches[1].fn, 1e-4 * two.patches[0].fn);
  EXPECT_NEAR(two.patches[0].fn, alone.totals.Fz, 1e-4 * alone.totals.Fz);
  // (1 - nu) / (2 pi G r) of each body under the other's force
  const double pressed = 2 * (1 - 0.28) / (2 * std::numbers::pi * 82000 * 2 * apart) * 5e4;
  EXPECT_NEAR(two.totals.approach - alone.totals.approach, pressed, 0.03 * pressed);
  EXPECT_NEAR(two.totals.Fx, 2 * alone.totals.Fx, 0.01 * std::abs(two.totals.Fx));
}

/// The inverses of the two factors, one after the other, undo A, the better the farther away the border of
/// the grid, beyond which displacements are missed; the first acts on nothing that lies ahead.
TEST(Oracle, FactorsOfTheOperatorInvertIt) {
  double before = 1;
  for (const int half : {5, 10, 20, 40}) {
    const int m = 2 * half + 1, n = m * m, at = half * m + half;
    const ContactProblem problem = scenes::flat({23000, 0.31}, {23000, 0.31}, m, m, 0.5, 0.5, 1e-3, 1e-3);
    const contact::Boxes grid{{{0, 0, m, m}}};
    contact::PlaneOperator behind(problem.numbers, grid, {0}, {0});
    behind.invert_behind();
    contact::PlaneOperator ahead(behind);
    ahead.mirror();
    std::vector<double> p(n, 0.0), u(n), part(n), back(n);
    p[at] = 1;
    contact::StripOperator(problem.numbers, m, {0}, {0}).apply(p, u);
    behind.apply(u, part, 0);
    ahead.apply(part, back, 0);
    double error = 0;
    for (int i = 0; i < n; ++i)
      error = std::max(error, std::abs(back[i] - p[i]));
    EXPECT_LT(error, std::sqrt(0.5) * before) << m; // order 1/2 of that distance
    before = error;
    behind.apply(p, part, 0);
    for (int i = 0; i < n; ++i)
      if (i % m < half) {
        EXPECT_NEAR(part[i], 0, 0.02 * part[at]) << i;
      }
  }
}

TEST(Oracle, EnergyOfTheHalfSpaceIsPositive) {
  std::mt19937 random(2);
  const ContactProblem problem = scenes::flat({23000, 0.31}, {82000, 0.0}, 12, 10, 0.5, 0.3, 1e-3, 1e-3);
  const contact::StripOperator whole(problem.numbers, 12, {0, 1, 2}, {0, 1, 2});
  std::vector<double> p(360), u(360);
  for (int k = 0; k < 50; ++k) {
    for (double& v : p)
      v = std::uniform_real_distribution<>(-1, 1)(random);
    whole.apply(p, u);
    double energy = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      energy += p[i] * u[i];
    EXPECT_GT(energy, 0);
  }
}

TEST(Oracle, CoupledRollingOnRandomNumbers) {
  std::mt19937 random(3);
  int contacts = 0, adhering = 0, slipping = 0;
  for (int k = 0; k < 150; ++k) {
    const ContactProblem problem = random_problem(random);
    const Tractions expected = relax(problem);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << k << ' ' << result.trust.solver_note << ' '
                                    << result.trust.certificate.worst();
    for (int i = 0; i < problem.grid.size(); ++i) {
      EXPECT_NEAR(result.px[i], expected.p[0][i], 1e-5) << k;
      EXPECT_NEAR(result.ps[i], expected.p[1][i], 1e-5) << k;
      EXPECT_NEAR(result.pn[i], expected.p[2][i], 1e-5) << k;
      contacts += result.state[i] != ElementState::exterior;
      adhering += result.state[i] == ElementState::adhesion;
      slipping += result.state[i] == ElementState::slip;
    }
  }
  EXPECT_GT(contacts, 300);
  EXPECT_GT(adhering, 30);
  EXPECT_GT(slipping, 30);
}

TEST(Oracle, ForceIsTheInverseOfApproach) {
  std::mt19937 random(4);
  for (int k = 0; k < 60; ++k) {
    ContactProblem problem = random_problem(random);
    const ContactResult at_approach = solve(problem);
    ASSERT_TRUE(at_approach.certified()) << k;
    if (at_approach.totals.Fz <= 0.01)
      continue;
    problem.load = LoadKind::force;
    problem.force = at_approach.totals.Fz;
    const ContactResult at_force = solve(problem);
    ASSERT_TRUE(at_force.certified())
        << k << ' ' << at_force.trust.solver_note << ' ' << at_force.trust.certificate.worst();
    EXPECT_NEAR(at_force.totals.Fz, problem.force, 1e-6 * problem.force);
  }
}

} // namespace
} // namespace bem_contact
