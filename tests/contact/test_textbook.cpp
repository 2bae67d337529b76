#include "bem_contact/halfspace/tangent_plane.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/contact/textbook.hpp"

#include <gtest/gtest.h>

#include <random>

/// The solvers against Kalker's textbook algorithm with dense matrices, on random small problems: loads over
/// more than six decades, both kinds of load, adhesion everywhere to slip everywhere.
namespace bem_contact {
namespace {

enum class Numbers { halfspace, tangent_plane, full };

struct Random {
  std::mt19937 engine;
  double uniform(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine); }
  double decades(double a, double b) { return std::pow(10.0, uniform(a, b)); }
  int integer(int a, int b) { return std::uniform_int_distribution<>(a, b)(engine); }
};

/// Symmetric as influence numbers are (Maxwell-Betti, parity), of both signs, no translation in s.
void disturb(InfluenceNumbers& a, Random& random) {
  a = spelled_out(a);
  for (int m = 0; m < a.offsets; ++m)
    for (int row_i = 0; row_i < a.rows; ++row_i)
      for (int i = 0; i < 3; ++i)
        for (int row_j = 0; row_j < a.rows; ++row_j)
          for (int j = 0; j < 3; ++j) {
            if (3 * row_j + j > 3 * row_i + i || (m == 0 && parity(i, j) < 0))
              continue;
            const double scale = std::sqrt(a.at(0, row_i, i, row_i, i) * a.at(0, row_j, j, row_j, j));
            const bool self = m == 0 && row_i == row_j && i == j;
            const double v = a.at(m, row_i, i, row_j, j) +
                             (self ? 0.2 : random.uniform(-0.01, 0.01) / (1 + m * m)) * scale;
            a.at(m, row_i, i, row_j, j) = v;
            a.at(m, row_j, j, row_i, i) = parity(i, j) * v;
          }
}

ContactProblem random_problem(Numbers kind, Random& random) {
  const int mx = random.integer(2, 6), ms = random.integer(1, 5);
  const double dx = random.decades(-2, 0.5), ds = dx * random.decades(-0.5, 0.5);
  const auto material = [&] { return Material{random.decades(3, 5), random.uniform(0, 0.45)}; };
  const Material lower = material(), upper = random.integer(0, 1) ? lower : material();
  const double curvature = random.decades(-4, -1), ratio = random.decades(-1, 1);
  const double reach = dx * random.uniform(0.7, 0.7 * mx); // half the contact, about
  ContactProblem problem =
      scenes::flat(lower, upper, mx, ms, dx, ds, curvature, curvature * ratio * random.uniform(0.3, 1));
  const double tilt_x = random.uniform(-0.3, 0.3) * curvature * reach,
               tilt_s = random.uniform(-0.3, 0.3) * curvature * reach;
  for (int i = 0; i < problem.grid.size(); ++i)
    problem.gap[i] += tilt_x * problem.grid.x(i % mx) + tilt_s * problem.rows[i / mx].s;
  if (kind == Numbers::tangent_plane) {
    const double turn = random.uniform(-0.3, 0.3), more = random.uniform(-0.1, 0.1); // rad a row
    std::vector<halfspace::StripRow> rail, wheel;
    double delta = random.uniform(-0.5, 0.5);
    Point2 position{};
    for (int is = 0; is < ms; ++is) {
      problem.rows[is].delta = delta;
      problem.rows[is].position = position;
      rail.push_back({position, delta});
      wheel.insert(wheel.begin(), {{-position.y, -position.z}, delta});
      const double next = delta + turn + more * is;
      position = position + ds * tangent_of(0.5 * (delta + next));
      delta = next;
    }
    const halfspace::StripGrid grid{dx, ds, mx + 2};
    InfluenceNumbers& a = problem.numbers;
    a = spelled_out(halfspace::tangent_plane_numbers(lower, grid, rail));
    const InfluenceNumbers b = spelled_out(halfspace::tangent_plane_numbers(upper, grid, wheel));
    for (int m = 0; m < a.offsets; ++m)
      for (const auto& [row_i, row_j] : a.stored_rows())
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            a.at(m, row_i, i, row_j, j) += ((i == component_x) == (j == component_x) ? 1 : -1) *
                                           b.at(m, ms - 1 - row_i, i, ms - 1 - row_j, j);
  } else if (kind == Numbers::full)
    disturb(problem.numbers, random);

  const double mu = random.decades(-2, 0), unit = mu * curvature * reach;
  scenes::set_creepage(problem, mu, unit * random.decades(-2, 1) * random.uniform(-1, 1),
                       unit * random.decades(-2, 1) * random.uniform(-1, 1),
                       unit / reach * random.decades(-2, 1) * random.uniform(-1, 1));
  problem.load = random.integer(0, 1) ? LoadKind::force : LoadKind::approach;
  problem.approach = curvature * reach * reach * random.uniform(0.5, 2);
  problem.force = lower.shear_modulus * curvature * reach * reach * reach * random.decades(-1, 0.5);
  return problem;
}

void compare(Numbers kind, int count) {
  Random random{std::mt19937(17 + static_cast<int>(kind))};
  int compared = 0, contacts = 0, slipping = 0, adhering = 0;
  double least = 1e300, most = 0;
  for (int k = 0; k < count; ++k) {
    const ContactProblem problem = random_problem(kind, random);
    const textbook::Solution expected = textbook::solve(problem);
    SolverOptions options;
    options.tolerance = 1e-10;
    options.estimate_discretisation = false;
    const ContactResult result = solve(problem, options);
    EXPECT_TRUE(result.converged) << k << ' ' << result.remark << ' ' << result.certificate.worst();
    if (!expected.found || !(result.Fz > 0))
      continue;
    ++compared;
    least = std::min(least, result.Fz);
    most = std::max(most, result.Fz);
    const double pmax = expected.pn.maxCoeff();
    const int n = problem.grid.size();
    double apart = 0;
    for (int i = 0; i < n; ++i) {
      apart = std::max({apart, std::abs(result.pn[i] - expected.pn[i]) / pmax,
                        std::abs(result.px[i] - expected.pt[i]) / (problem.friction * pmax),
                        std::abs(result.ps[i] - expected.pt[n + i]) / (problem.friction * pmax)});
      contacts += result.state[i] != ElementState::exterior;
      adhering += result.state[i] == ElementState::adhesion;
      slipping += result.state[i] == ElementState::slip;
    }
    EXPECT_LT(apart, 1e-6) << k << ' ' << result.tangential_solver;
    if (problem.load == LoadKind::force) {
      EXPECT_NEAR(result.approach, expected.approach, 1e-6 * std::abs(expected.approach)) << k;
    }
  }
  std::printf("%d of %d compared, %d elements in contact (%d adhering, %d slipping), %.1e to %.1e N\n",
              compared, count, contacts, adhering, slipping, least, most);
  EXPECT_GT(compared, 0.95 * count); // where the textbook itself ends
  EXPECT_GT(adhering, count);
  EXPECT_GT(slipping, count);
  EXPECT_GT(most, 1e6 * least);
}

TEST(Textbook, HalfSpaceNumbers) {
  compare(Numbers::halfspace, 700);
}

TEST(Textbook, TangentPlaneNumbers) {
  compare(Numbers::tangent_plane, 700);
}

TEST(Textbook, NumbersFullInS) {
  compare(Numbers::full, 600);
}

} // namespace
} // namespace bem_contact
