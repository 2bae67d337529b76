#include "bem_contact/reference/creep_coefficients.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/reference/rolling.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

namespace bem_contact {
namespace {

/// Gap of an elliptic contact with semi-axes a (x) and b (s) and its force, Hertz by Johnson 1985, 4.2.
struct Ellipse {
  double gap_x, gap_s, force;
};

Ellipse ellipse(double a, double b, const Material& m) {
  const double young = m.shear_modulus / (1 - m.poisson); // of the pair of equal bodies
  const double large = std::max(a, b), k = std::min(a, b) / large, e = std::sqrt(1 - k * k);
  const double first = std::comp_ellint_1(e), second = std::comp_ellint_2(e);
  const double ratio = a == b ? 1 : (first - second) / (second / (k * k) - first);
  const double sum = 1e-3 * (1 + ratio) / ratio;
  const double force = large * large * large * 2 * std::numbers::pi * young * k * k * sum / (3 * second);
  return a >= b ? Ellipse{1e-3, 1e-3 / ratio, force} : Ellipse{1e-3 / ratio, 1e-3, force};
}

ContactProblem elliptic(double a, double b, const Material& m, int across) {
  const Ellipse e = ellipse(a, b, m);
  const int n = across * 11 / 10;
  ContactProblem problem = scenes::flat(m, m, n, n, 2 * a / across, 2 * b / across, e.gap_x, e.gap_s);
  problem.force = e.force;
  return problem;
}

/// Carter 1926: one row, so long that it is a plane problem.
TEST(Rolling, Carter) {
  const double radius = 500, mu = 0.3, adhering = 0.6;
  const double fn = std::numbers::pi * 82000 / (4 * radius * (1 - 0.28));
  double previous = 0;
  for (const int across : {10, 20, 40}) {
    const double length = 4000;
    ContactProblem problem =
        scenes::flat(scenes::steel, scenes::steel, across * 6 / 5, 1, 2.0 / across, length, 0.5 / radius, 0);
    problem.force = fn * length;
    scenes::set_creepage(problem, mu, mu * (1 - adhering) / radius, 0, 0);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    const double error = std::abs(result.totals.Fx / (mu * fn * length) - (1 - adhering * adhering)) / 0.64;
    if (previous > 0) {
      EXPECT_LT(error, 0.7 * previous) << across;
    }
    previous = error;
    if (across < 40)
      continue;
    EXPECT_LT(error, 0.004);
    ASSERT_TRUE(result.trust.discretisation);
    EXPECT_NEAR(result.trust.discretisation->extrapolated.Fx / (mu * fn * length), 0.64, error * 0.64);
    EXPECT_GT(result.trust.discretisation->tangential, 0.7 * error * 0.64);
    EXPECT_NEAR(result.patches[0].pmax, 2 * fn / std::numbers::pi, 0.01 * result.patches[0].pmax);
    // adhesion at the leading edge, x from 2 a' - a to a
    int first = -1, last = -1;
    for (int ix = 0; ix < problem.grid.mx; ++ix)
      if (result.state[ix] == ElementState::adhesion) {
        first = first < 0 ? ix : first;
        last = ix;
      }
    EXPECT_NEAR(problem.grid.x(last), 1, 0.06);
    EXPECT_NEAR(problem.grid.x(first), 1 - 2 * adhering, 0.06);
  }
}

/// Kalker 1967, linear theory: no slip anywhere.
struct KalkerCase {
  double a, b, poisson;
};

struct Kalker : testing::TestWithParam<KalkerCase> {};

/// C11, C22, C23 (from spin), C23 (from lateral creepage), C33 of three solutions, for c^2 = cc.
using Coefficients = std::array<double, 5>;

Coefficients coefficients(const std::array<ContactTotals, 3>& rolled, double creepage, double cc) {
  const auto& [along, lateral, spin] = rolled;
  const double c = std::sqrt(cc);
  return {along.Fx / (cc * creepage), lateral.Fy / (cc * creepage), spin.Fy / (cc * c * creepage),
          -lateral.Mz / (cc * c * creepage), spin.Mz / (cc * cc * creepage)};
}

/// The forces of adhesion go with the area in contact, and whole elements cover 0.6 to 1.2 % more than the
/// ellipse, not in step with h. Kalker's c^2 is the ellipse in contact, area / pi; with the Hertzian a b the
/// surplus of area stays: once in C11 and C22, 1.5 times in C23, twice in C33.
TEST_P(Kalker, CoefficientsOfSmallCreepage) {
  const KalkerCase& k = GetParam();
  const reference::CreepCoefficients exact = reference::creep_coefficients(k.a / k.b, k.poisson);
  const Coefficients expected{exact.c11, exact.c22, exact.c23, exact.c23, exact.c33};
  const double unit = 1e-4;
  ContactProblem problem = elliptic(k.a, k.b, {1.0, k.poisson}, 40);
  std::array<ContactTotals, 3> fine, coarse;
  double area = 0, coarse_area = 0;
  for (int i = 0; i < 3; ++i) {
    scenes::set_creepage(problem, 1e6, i == 0 ? unit : 0, i == 1 ? unit : 0, i == 2 ? unit : 0);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    ASSERT_TRUE(result.trust.discretisation);
    fine[i] = result.totals;
    coarse[i] = result.trust.discretisation->coarse;
    area = result.patches[0].area;
    coarse_area = 4 * result.trust.discretisation->contact * problem.element_area();
  }
  const Coefficients of_fine = coefficients(fine, unit, area / std::numbers::pi);
  const Coefficients of_coarse = coefficients(coarse, unit, coarse_area / std::numbers::pi);
  const Coefficients raw = coefficients(fine, unit, k.a * k.b);
  const Coefficients raw_coarse = coefficients(coarse, unit, k.a * k.b);
  const Coefficients surplus{0.01, 0.01, 0.014, 0.014, 0.037};
  double error = 0, coarse_error = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(of_fine[i], expected[i], 0.01 * expected[i]) << i;
    EXPECT_NEAR(raw[i], expected[i], surplus[i] * expected[i]) << i;
    error += std::abs(of_fine[i] / expected[i] - 1);
    coarse_error += std::abs(of_coarse[i] / expected[i] - 1);
    if (i < 4) { // C33 feels the area twice: the two grids agree in it by chance
      const double estimate = std::abs(raw[i] - raw_coarse[i]), true_error = std::abs(raw[i] - expected[i]);
      EXPECT_GT(estimate, 0.7 * true_error) << i;
      EXPECT_LT(estimate, 5 * true_error) << i;
    }
  }
  EXPECT_LT(error, 0.7 * coarse_error);
  EXPECT_NEAR(of_fine[2], of_fine[3], 1e-3 * of_fine[2])
      << "spin's lateral force and creepage's moment are one number";
}

INSTANTIATE_TEST_SUITE_P(References, Kalker,
                         testing::Values(KalkerCase{1, 1, 0.28}, KalkerCase{1, 1, 0.25},
                                         KalkerCase{1, 2, 0.25}, KalkerCase{2, 1, 0.25}),
                         [](const auto& test) { return "case" + std::to_string(test.index); });

TEST(Rolling, FullSpinOnACircle) {
  double previous = 0;
  for (const int across : {10, 20, 40}) {
    ContactProblem problem = elliptic(3, 3, scenes::steel, across);
    scenes::set_creepage(problem, 0.3, 0, 0, 1.0);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified());
    const double expected = reference::full_spin_moment(0.3, problem.force, 3);
    const double error = std::abs(result.totals.Mz / expected - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.5 * previous) << across;
    }
    previous = error;
    if (across < 40)
      continue;
    EXPECT_LT(error, 0.001);
    // of nearly second order: extrapolating goes too far, but stays within the estimate
    ASSERT_TRUE(result.trust.discretisation);
    const double share = result.trust.certificate.discretisation;
    EXPECT_LT(share, 2e-3);
    EXPECT_LT(error, share);
    EXPECT_LT(std::abs(result.trust.discretisation->extrapolated.Mz - expected), share * expected);
  }
}

/// Adhesion and slip: the estimate against the same problem on elements half as large, extrapolated.
TEST(Rolling, EstimateOfPartialSlip) {
  for (const double factor : {0.3, 1.0}) {
    ContactTotals limit;
    for (const int across : {60, 30}) {
      ContactProblem problem = elliptic(3, 2, scenes::steel, across);
      scenes::set_creepage(problem, 0.3, 8e-4 * factor, 6e-4 * factor, 5e-4 * factor);
      const ContactResult result = solve(problem);
      ASSERT_TRUE(result.certified() && result.trust.discretisation) << across;
      if (across == 60) {
        limit = result.trust.discretisation->extrapolated;
        continue;
      }
      const double error =
          std::hypot(result.totals.Fx - limit.Fx, result.totals.Fy - limit.Fy) / (0.3 * problem.force);
      EXPECT_GT(result.trust.discretisation->tangential, 0.5 * error) << factor;
      EXPECT_LT(result.trust.discretisation->tangential, 3 * error) << factor;
    }
  }
}

/// Pure spin turns the longitudinal slip around between two rows: adhesion reaches into one of them from the
/// leading edge, the farther in elements the smaller they are. Newton must not follow it element by element.
TEST(Rolling, NewtonNeedsHardlyMoreStepsOnAFinerGrid) {
  NEEDS_NO_SANITIZER();
  const auto steps = [](int ms) {
    const int mx = 2 * ms;
    ContactProblem problem =
        scenes::flat(scenes::steel, scenes::steel, mx, ms, 16.0 / mx, 8.0 / ms, 2e-4, 1e-3);
    scenes::set_creepage(problem, 0.3, 0, 0, 2e-3);
    std::ranges::fill(problem.slip_s, 0.0);
    problem.load = LoadKind::approach;
    problem.approach = 0.01;
    const ContactResult r =
        solve(problem, {.only_newton = true, .estimate_discretisation = false, .coarse_start = false});
    EXPECT_TRUE(r.certified()) << r.trust.solver_note;
    return r.effort.tangential_iterations;
  };
  EXPECT_LE(steps(160), 2 * steps(40));
}

TEST(Rolling, FullSlip) {
  ContactProblem problem = elliptic(3, 3, scenes::steel, 20);
  scenes::set_creepage(problem, 0.3, 0.03, 0.04, 0);
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified());
  EXPECT_NEAR(result.totals.Fx, 0.6 * 0.3 * problem.force, 1e-2 * problem.force * 0.3);
  EXPECT_NEAR(result.totals.Fy, 0.8 * 0.3 * problem.force, 1e-2 * problem.force * 0.3);
  EXPECT_EQ(result.patches[0].adhesion, 0);
  EXPECT_EQ(result.patches[0].slip, result.patches[0].contact);
}

TEST(Rolling, SignOfEachQuantity) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 20);
  scenes::set_creepage(problem, 0.3, 5e-4, 0, 0);
  const ContactResult along = solve(problem);
  EXPECT_GT(along.totals.Fx, 0) << "a wheel that runs ahead drags the rail forwards";
  EXPECT_NEAR(along.totals.Fy, 0, 1e-6 * along.totals.Fx);
  for (int ix = 0, middle = problem.grid.ms / 2 * problem.grid.mx; ix < problem.grid.mx; ++ix)
    if (along.state[middle + ix] == ElementState::slip) {
      EXPECT_GT(along.slip_x[middle + ix], 0);
      EXPECT_LT(problem.grid.x(ix), 0) << "slip at the trailing edge";
    }
  scenes::set_creepage(problem, 0.3, 0, 5e-4, 0);
  const ContactResult lateral = solve(problem);
  EXPECT_GT(lateral.totals.Fy, 0);
  EXPECT_LT(lateral.totals.Mz, 0);
  scenes::set_creepage(problem, 0.3, 0, 0, 2e-4);
  const ContactResult spin = solve(problem);
  EXPECT_GT(spin.totals.Fy, 0);
  EXPECT_GT(spin.totals.Mz, 0);
  EXPECT_TRUE(along.certified() && lateral.certified() && spin.certified());
}

TEST(Rolling, MomentIsAboutTheOriginOfTheTrackFrame) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 12);
  scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 0);
  const ContactResult here = solve(problem);
  for (ContactRow& row : problem.rows)
    row.position.y += 750;
  const ContactResult there = solve(problem);
  EXPECT_NEAR(there.totals.Mz, here.totals.Mz - 750 * here.totals.Fx, 1e-9 * std::abs(there.totals.Mz));
}

TEST(Rolling, MirrorsInS) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 20);
  const int mx = problem.grid.mx, ms = problem.grid.ms;
  for (int i = 0; i < problem.grid.size(); ++i)
    problem.gap[i] += 1e-4 * problem.rows[i / mx].s * problem.grid.x(i % mx);
  ContactProblem mirrored = problem;
  for (int i = 0; i < problem.grid.size(); ++i)
    mirrored.gap[(ms - 1 - i / mx) * mx + i % mx] = problem.gap[i];
  scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 2e-4);
  scenes::set_creepage(mirrored, 0.3, 5e-4, -3e-4, -2e-4);
  const ContactResult a = solve(problem), b = solve(mirrored);
  ASSERT_TRUE(a.certified() && b.certified());
  const double scale = 1e-6 * 0.3 * problem.force;
  EXPECT_NEAR(a.totals.Fx, b.totals.Fx, scale);
  EXPECT_NEAR(a.totals.Fy, -b.totals.Fy, scale);
  EXPECT_NEAR(a.totals.Mz, -b.totals.Mz, 3 * scale);
}

TEST(Rolling, ScalesWithLengthAndStiffness) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 16);
  scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 2e-4);
  const ContactResult here = solve(problem);
  // lengths times 2, moduli times 3: forces times 12, moments times 24
  ContactProblem scaled = problem;
  scaled.grid = {problem.grid.mx, problem.grid.ms, 2 * problem.grid.dx, 2 * problem.grid.ds,
                 2 * problem.grid.x0};
  for (ContactRow& row : scaled.rows)
    row = {2 * row.s, 2 * row.position, row.delta};
  for (double& h : scaled.gap)
    h *= 2;
  const Material stiff{3 * 82000, 0.28};
  scaled.numbers = scenes::pair(stiff, stiff, scaled.grid);
  scaled.force *= 12;
  scenes::set_creepage(scaled, 0.3, 5e-4, 3e-4, 1e-4);
  const ContactResult there = solve(scaled);
  ASSERT_TRUE(here.certified() && there.certified());
  EXPECT_NEAR(there.totals.Fx, 12 * here.totals.Fx, 1e-6 * there.totals.Fx);
  EXPECT_NEAR(there.totals.Fy, 12 * here.totals.Fy, 1e-6 * there.totals.Fy);
  EXPECT_NEAR(there.totals.Mz, 24 * here.totals.Mz, 1e-6 * there.totals.Mz);
  EXPECT_NEAR(there.totals.approach, 2 * here.totals.approach, 1e-9);
}

/// In a steady state the power of the creepages is what friction dissipates; the surfaces store none of it.
/// Discretised, p'B p is not zero (positive: artificial dissipation), and vanishes with a power of h above 1.
TEST(Rolling, PowerIsDissipatedBySlip) {
  double coarse = 0;
  for (const int across : {20, 40}) {
    ContactProblem problem = elliptic(3, 2, scenes::steel, across);
    const double xi = 8e-4, eta = 6e-4, phi = 5e-4;
    scenes::set_creepage(problem, 0.3, xi, eta, phi);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified());
    double dissipated = 0;
    for (int i = 0; i < problem.grid.size(); ++i) {
      const double power = result.px[i] * result.slip_x[i] + result.ps[i] * result.slip_s[i];
      EXPECT_GE(power, -1e-9) << "slip never feeds power in";
      dissipated += power * problem.element_area();
    }
    const double supplied = xi * result.totals.Fx + eta * result.totals.Fy + phi * result.totals.Mz;
    const double missing = (supplied - dissipated) / supplied;
    EXPECT_GT(missing, 0);
    if (across == 20)
      coarse = missing;
    else {
      EXPECT_LT(missing, 0.4 * coarse);
      EXPECT_LT(missing, 0.004);
    }
  }
}

TEST(Rolling, FrictionFromNoneToHuge) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 16);
  for (const double mu : {0.0, 1e-9, 1e-3, 0.3, 10.0, 1e9}) {
    scenes::set_creepage(problem, mu, 5e-4, 3e-4, 2e-4);
    const ContactResult result = solve(problem);
    EXPECT_TRUE(result.certified()) << mu << ' ' << result.trust.solver_note;
    const double shear = std::hypot(result.totals.Fx, result.totals.Fy);
    EXPECT_LE(shear, mu * problem.force * (1 + 1e-9));
    if (mu > 0 && mu < 0.01) {
      EXPECT_GT(shear, 0.8 * mu * problem.force);
    }
    if (mu == 1e9) {
      EXPECT_EQ(result.patches[0].slip, 0);
    }
  }
}

TEST(Rolling, ZeroAndTinyCreepage) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 16);
  scenes::set_creepage(problem, 0.3, 0, 0, 0);
  const ContactResult rest = solve(problem);
  EXPECT_TRUE(rest.certified());
  EXPECT_LT(std::abs(rest.totals.Fx), 1e-9 * problem.force);
  scenes::set_creepage(problem, 0.3, 1e-9, 0, 0);
  const ContactResult tiny = solve(problem);
  EXPECT_TRUE(tiny.certified()) << tiny.trust.solver_note;
  scenes::set_creepage(problem, 1e6, 1e-9, 0, 0);
  const ContactResult linear = solve(problem);
  EXPECT_NEAR(tiny.totals.Fx, linear.totals.Fx, 0.01 * linear.totals.Fx);
}

TEST(Rolling, TheChainFallsThroughAndSaysSo) {
  ContactProblem problem = elliptic(3, 2, scenes::steel, 20);
  scenes::set_creepage(problem, 0.3, 8e-4, 4e-4, 3e-4);
  const ContactResult expected = solve(problem);
  ASSERT_TRUE(expected.certified());
  EXPECT_THAT(expected.effort.tangential_solver, testing::HasSubstr("Newton"));
  SolverOptions options;
  options.max_tangential = 2;
  const ContactResult swept = solve(problem, options);
  EXPECT_TRUE(swept.certified()) << swept.trust.solver_note;
  EXPECT_EQ(swept.effort.tangential_solver, "sweeps");
  EXPECT_THAT(swept.trust.solver_note, testing::HasSubstr("Newton"));
  options.max_tangential = 0;
  options.max_sweeps = 40;
  options.tolerance = 3e-7;
  const ContactResult rolled = solve(problem, options);
  EXPECT_TRUE(rolled.certified()) << rolled.trust.solver_note;
  EXPECT_THAT(rolled.effort.tangential_solver, testing::HasSubstr("rolling on"));
  for (const ContactResult* result : {&swept, &rolled}) {
    EXPECT_NEAR(result->totals.Fx, expected.totals.Fx, 1e-4 * expected.totals.Fx);
    EXPECT_NEAR(result->totals.Fy, expected.totals.Fy, 1e-4 * expected.totals.Fy);
  }
}

/// Rows and columns just beyond the contact that have no opposite surface (their distance is a mark) change
/// nothing, nor what is estimated of the discretisation.
TEST(Discretisation, DoesNotMindElementsWithoutOppositeSurface) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 40, 40, 0.3, 0.3, 1e-3, 1.5e-3);
  scenes::set_creepage(problem, 0.3, 1e-3, 5e-4, 1e-4);
  problem.force = 15000;
  const ContactResult all = solve(problem);
  ASSERT_TRUE(all.certified() && all.trust.discretisation);
  int first = problem.grid.ms, last_column = 0;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (all.pn[i] > 0) {
      first = std::min(first, i / problem.grid.mx);
      last_column = std::max(last_column, i % problem.grid.mx);
    }
  ASSERT_GT(first, 2);
  for (int i = 0; i < problem.grid.size(); ++i)
    if (i / problem.grid.mx < first - 2 || i % problem.grid.mx > last_column + 2)
      problem.gap[i] = 100;
  const ContactResult some = solve(problem);
  ASSERT_TRUE(some.certified() && some.trust.discretisation);
  EXPECT_NEAR(some.totals.Fx, all.totals.Fx, 1e-6 * problem.force);
  EXPECT_EQ(some.trust.discretisation->contact, all.trust.discretisation->contact);
  EXPECT_NEAR(some.trust.discretisation->worst(), all.trust.discretisation->worst(),
              0.05 * all.trust.discretisation->worst());
}

} // namespace
} // namespace bem_contact
