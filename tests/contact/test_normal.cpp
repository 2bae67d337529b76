#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::DoubleNear;

/// Hertz 1882: given gap a x^2 + b s^2 and the answer (semi-axes along x and s).
struct HertzCase {
  const char* name;
  Material material;
  double a, b;  ///< gap, 1/mm
  double force; ///< N
  double semi_x, semi_s, pmax, approach;
};

constexpr Material with_young(double young, double poisson) {
  return {young / (2 * (1 + poisson)), poisson};
}

const HertzCase hertz_cases[] = {
    {"Rx460Ry300", with_young(210000, 0.3), 1 / 920.0, 1 / 600.0, 1e5, 7.161676, 5.387172, 1237.5588,
     0.10411895},
    {"Rx460Ry80", with_young(210000, 0.3), 1 / 920.0, 1 / 160.0, 82500, 8.011383, 2.533052, 1941.0811,
     0.10986554},
    {"SphereR50", with_young(210000, 0.3), 0.01, 0.01, 1000, 0.68753443, 0.68753443, 1010.07234,
     0.0094540719},
    {"G82000", {82000, 0.28}, 7.6859e-4, 9.8039e-4, 99986.51, 7.843619, 6.669087, 912.6409, 0.09089}};

ContactProblem hertz(const HertzCase& c, int across) {
  const int m = across * 6 / 5;
  return scenes::flat(c.material, c.material, m, m, 2 * c.semi_x / across, 2 * c.semi_s / across, c.a, c.b);
}

struct Hertz : testing::TestWithParam<HertzCase> {};

TEST_P(Hertz, ForceGivesApproachPressureAndSemiAxes) {
  const HertzCase& c = GetParam();
  ContactProblem problem = hertz(c, 40);
  problem.force = c.force;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified()) << result.trust.certificate.worst();
  ASSERT_EQ(result.patches.size(), 1u);
  const PatchSummary& patch = result.patches[0];
  EXPECT_NEAR(result.totals.approach, c.approach, 0.01 * c.approach);
  EXPECT_NEAR(patch.pmax, c.pmax, 0.01 * c.pmax);
  EXPECT_NEAR(patch.fn, c.force, 1e-9 * c.force);
  EXPECT_NEAR(patch.overlap, result.totals.approach, 0.01 * c.approach);
  // second moments of the elliptic pressure, <x^2> = a^2 / 5, give the semi-axes finer than counting elements
  double xx = 0, ss = 0, sum = 0;
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double x = problem.grid.x(i % problem.grid.mx), s = problem.rows[i / problem.grid.mx].s;
    sum += result.pn[i];
    xx += result.pn[i] * x * x;
    ss += result.pn[i] * s * s;
  }
  EXPECT_NEAR(std::sqrt(5 * xx / sum), c.semi_x, 0.01 * c.semi_x);
  EXPECT_NEAR(std::sqrt(5 * ss / sum), c.semi_s, 0.01 * c.semi_s);
  EXPECT_NEAR(patch.area, std::numbers::pi * c.semi_x * c.semi_s, 0.02 * patch.area);
  EXPECT_FALSE(result.trust.touches_border);
}

TEST_P(Hertz, ErrorHalvesWithTheElementAndIsEstimated) {
  const HertzCase& c = GetParam();
  double previous = 0;
  for (const int across : {10, 20, 40}) {
    ContactProblem problem = hertz(c, across);
    problem.load = LoadKind::approach;
    problem.approach = c.approach;
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified());
    const double error = std::abs(result.totals.Fz - c.force) / c.force;
    if (previous > 0) {
      EXPECT_LT(error, 0.5 * previous) << across;
    }
    previous = error;
    ASSERT_EQ(result.trust.discretisation.has_value(), across > 10) << "too few elements say nothing";
    if (across == 10) {
      EXPECT_EQ(result.trust.certificate.discretisation, -1);
      continue;
    }
    // second order: what is left is a small part
    EXPECT_NEAR(result.trust.discretisation->extrapolated.Fz, c.force, 0.1 * error * c.force) << across;
    EXPECT_EQ(result.trust.discretisation->extrapolated.approach, c.approach);
  }
  EXPECT_LT(previous, 0.01);
}

/// Sizes of every kind, also those whose halves do not line up with the ellipse.
TEST_P(Hertz, EstimateAgainstTheTrueError) {
  const HertzCase& c = GetParam();
  for (const int across : {15, 20, 25, 30})
    for (const LoadKind load : {LoadKind::approach, LoadKind::force}) {
      ContactProblem problem = hertz(c, across);
      problem.load = load;
      problem.approach = c.approach;
      problem.force = c.force;
      const ContactResult result = solve(problem);
      ASSERT_TRUE(result.trust.discretisation) << across;
      const double error = load == LoadKind::force
                               ? std::abs(result.totals.approach - c.approach) / c.approach
                               : std::abs(result.totals.Fz - c.force) / c.force;
      EXPECT_GT(result.trust.certificate.discretisation, 0.3 * error) << across;
      EXPECT_LT(result.trust.certificate.discretisation, 3 * error) << across;
    }
}

INSTANTIATE_TEST_SUITE_P(References, Hertz, testing::ValuesIn(hertz_cases),
                         [](const auto& test) { return test.param.name; });

TEST(Normal, NoContactIsZeroForceAndHolds) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 9, 7, 0.5, 0.5, 1e-3, 1e-3);
  problem.load = LoadKind::approach;
  problem.approach = -0.01;
  for (const bool rolling : {false, true}) {
    if (rolling)
      scenes::set_creepage(problem, 0.3, 1e-3, 0, 1e-4);
    const ContactResult result = solve(problem);
    EXPECT_TRUE(result.certified());
    EXPECT_EQ(result.totals.Fz, 0);
    EXPECT_EQ(result.totals.Mz, 0);
    EXPECT_TRUE(result.patches.empty());
    EXPECT_EQ(result.totals.approach, -0.01);
    EXPECT_NEAR(result.deformed_distance[31], 0.01, 1e-12);
  }
}

TEST(Normal, ZeroForceIsNoContact) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 9, 7, 0.5, 0.5, 1e-3, 1e-3);
  problem.force = 0;
  const ContactResult result = solve(problem);
  EXPECT_TRUE(result.certified());
  EXPECT_TRUE(result.patches.empty());
}

TEST(Normal, OneElementFollowsItsSelfNumber) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 5, 5, 1, 1, 1, 1);
  problem.load = LoadKind::approach;
  problem.approach = 1e-4;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified());
  ASSERT_EQ(result.patches.size(), 1u);
  EXPECT_EQ(result.patches[0].contact, 1);
  const double p = 1e-4 / problem.numbers.at(0, 2, component_n, 2, component_n);
  EXPECT_NEAR(result.pn[12], p, 1e-9 * p);
  EXPECT_NEAR(result.totals.Fz, p, 1e-9 * p);
}

TEST(Normal, TwoPatchesShareTheForce) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 30, 60, 0.4, 0.4, 1e-3, 0);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double s = problem.rows[i / 30].s;
    problem.gap[i] += s < 0 ? 2e-3 * (s + 6) * (s + 6) : 2e-3 * (s - 6) * (s - 6) + 0.005;
  }
  problem.force = 40000;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified());
  ASSERT_EQ(result.patches.size(), 2u);
  EXPECT_GT(result.patches[0].fn, result.patches[1].fn);
  EXPECT_NEAR(result.patches[0].fn + result.patches[1].fn, 40000, 1e-6);
  EXPECT_NEAR(result.patches[0].s, -6, 0.5);
  EXPECT_NEAR(result.patches[1].s, 6, 0.5);
  EXPECT_NEAR(result.patches[0].overlap - result.patches[1].overlap, 0.005, 1e-4);
}

TEST(Normal, MirrorsInXAndInS) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 24, 20, 0.5, 0.5, 1e-3, 1e-3);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double x = problem.grid.x(i % 24), s = problem.rows[i / 24].s;
    problem.gap[i] += 2e-4 * x * s + 5e-3 * x + 1e-3 * s;
  }
  problem.force = 5000;
  ContactProblem mirrored = problem;
  for (int is = 0; is < 20; ++is)
    for (int ix = 0; ix < 24; ++ix)
      mirrored.gap[is * 24 + ix] = problem.gap[(19 - is) * 24 + 23 - ix];
  const ContactResult a = solve(problem), b = solve(mirrored);
  ASSERT_TRUE(a.certified() && b.certified());
  EXPECT_NEAR(a.totals.approach, b.totals.approach, 1e-9 * a.totals.approach);
  const double pmax = a.patches[0].pmax;
  for (int is = 0; is < 20; ++is)
    for (int ix = 0; ix < 24; ++ix)
      EXPECT_NEAR(a.pn[is * 24 + ix], b.pn[(19 - is) * 24 + 23 - ix], 1e-7 * pmax);
  EXPECT_NEAR(a.patches[0].x, -b.patches[0].x, 1e-6);
}

TEST(Normal, InclinedRowsTakeTheVerticalForceAlongTheirNormals) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 24, 48, 0.3, 0.3, 2e-3, 2e-3);
  for (ContactRow& row : problem.rows)
    row.delta = -70 * std::numbers::pi / 180 + row.s / 20; // gauge corner: n points to +y
  problem.force = 3000;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified());
  EXPECT_NEAR(result.totals.Fz, 3000, 1e-6);
  EXPECT_GT(result.totals.Fy, 0) << "p_n > 0 pushes the rail along n";
  double fy = 0, fn = 0;
  for (int i = 0; i < problem.grid.size(); ++i) {
    fy -= result.pn[i] * std::sin(problem.rows[i / 24].delta) * 0.09;
    fn += result.pn[i] * 0.09;
  }
  EXPECT_NEAR(result.totals.Fy, fy, 1e-9 * fy);
  EXPECT_NEAR(result.patches[0].fn, fn, 1e-9 * fn);
}

/// Johnson 1985, eq. 4.43-4.45: line contact, gap s^2 / (2 R).
TEST(Normal, PlaneStrainIsHertzsLineContact) {
  const double radius = 500, semi = 1, effective = 82000 / (1 - 0.28);
  const double force = std::numbers::pi * semi * semi * effective / (4 * radius);
  ContactProblem problem;
  problem.grid = {1, 48, 0, 2 * semi / 40, 0};
  for (int is = 0; is < 48; ++is) {
    const double s = (is - 23.5) * problem.grid.ds;
    problem.rows.push_back({s, {s, 0}, 0});
    problem.gap.push_back(s * s / (2 * radius));
  }
  const InfluenceNumbers one = halfspace::plane_strain_numbers(scenes::steel, problem.grid.ds, 48, 100);
  problem.numbers = scenes::pair(one, one);
  problem.tangential = false;
  problem.force = force;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified());
  EXPECT_NEAR(result.patches[0].pmax, 2 * force / (std::numbers::pi * semi), 0.01 * result.patches[0].pmax);
  EXPECT_NEAR(result.patches[0].area, 2 * semi, 1.01 * problem.grid.ds);
  EXPECT_NEAR(result.totals.Fz, force, 1e-9 * force);
}

TEST(Normal, FallBackFindsTheSameAnswer) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 24, 24, 0.5, 0.5, 1e-3, 2e-3);
  SolverOptions hasty;
  hasty.max_normal = 1;
  for (const LoadKind load : {LoadKind::force, LoadKind::approach}) {
    problem.load = load;
    problem.force = 6000;
    problem.approach = 0.02;
    const ContactResult expected = solve(problem), result = solve(problem, hasty);
    ASSERT_TRUE(expected.certified());
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    EXPECT_EQ(result.effort.normal_solver, "MPRGP");
    EXPECT_THAT(result.trust.solver_note, testing::HasSubstr("active set"));
    EXPECT_NEAR(result.totals.approach, expected.totals.approach, 1e-7 * expected.totals.approach);
    for (int i = 0; i < problem.grid.size(); ++i)
      EXPECT_NEAR(result.pn[i], expected.pn[i], 1e-5 * expected.patches[0].pmax);
  }
}

TEST(Normal, ReportsContactAtTheBorder) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 6, 6, 0.5, 0.5, 1e-3, 1e-3);
  problem.force = 1e5;
  const ContactResult result = solve(problem);
  EXPECT_TRUE(result.certified());
  EXPECT_TRUE(result.trust.touches_border);
  EXPECT_FALSE(result.trust.discretisation);
  EXPECT_EQ(result.trust.certificate.discretisation, -1);
}

TEST(Normal, OddSizesLeaveOutAnExteriorRow) {
  for (const int ms : {23, 24}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 25, ms, 0.5, 0.5, 1e-3, 1e-3);
    problem.force = 20000;
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.trust.discretisation) << ms;
    const ContactTotals& coarse = result.trust.discretisation->coarse;
    EXPECT_NEAR(coarse.approach, result.totals.approach, 0.02 * result.totals.approach);
    EXPECT_NEAR(coarse.Fz, 20000, 1e-5);
    EXPECT_EQ(result.trust.discretisation->extrapolated.Fz, result.totals.Fz) << "what is prescribed stays";
    SolverOptions options;
    options.estimate_discretisation = false;
    EXPECT_FALSE(solve(problem, options).trust.discretisation);
  }
}

/// A falsified result must fail, quantity by quantity.
TEST(Certificate, SeesEachViolation) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 16, 16, 0.5, 0.5, 1e-3, 1e-3);
  problem.force = 2000;
  scenes::set_creepage(problem, 0.3, 2e-4, 0, 0);
  const ContactResult good = solve(problem);
  ASSERT_TRUE(good.certified());
  ASSERT_GT(good.patches[0].adhesion, 5);
  ASSERT_GT(good.patches[0].slip, 5);
  const int middle = 8 * 16 + 8;
  ContactResult bad = good;
  bad.pn[0] = -1;
  EXPECT_GT(certify(problem, bad).pressure, 1e-3);
  bad = good;
  bad.totals.approach.value *= 1.1;
  EXPECT_GT(certify(problem, bad).penetration, 1e-3);
  bad = good;
  bad.totals.approach.value *= 0.9;
  EXPECT_GT(certify(problem, bad).complementarity, 1e-3);
  bad = good;
  bad.px[middle] = 0.4 * bad.pn[middle];
  EXPECT_GT(certify(problem, bad).friction_cone, 1e-3);
  bad = good;
  for (double& p : bad.px)
    p *= 0.9;
  EXPECT_GT(certify(problem, bad).adhesion, 1e-3);
  bad = good;
  for (double& p : bad.px)
    p = -p;
  EXPECT_GT(certify(problem, bad).slip_direction, 1e-3);
  bad = good;
  for (double& p : bad.pn)
    p *= 1.01;
  EXPECT_NEAR(certify(problem, bad).force_balance, 0.01, 1e-6);
  bad = good;
  bad.pn[middle] = std::nan("");
  EXPECT_FALSE(certify(problem, bad).holds());
}

} // namespace
} // namespace bem_contact
