#include "bem_contact/contact/tangential/step_box.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

/// One row of hundreds of elements: rollers on each other.
namespace bem_contact {
namespace {

double drawn(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Rollers of unlike materials, which a share of the friction limit is prescribed for. Their contact fills 60
/// to 97 % of the grid.
ContactProblem random_rollers(std::mt19937& random) {
  const double mu = std::exp(drawn(random, std::log(0.02), std::log(0.5)));
  const Material wheel{std::exp(drawn(random, std::log(5e3), std::log(8e4))), drawn(random, 0.25, 0.35)};
  const int mx = std::uniform_int_distribution<int>(100, 800)(random);
  const double force = std::exp(drawn(random, std::log(1e3), std::log(4e4))), length = 1000;
  const double gap = std::exp(drawn(random, std::log(1e-3), std::log(0.03)));
  const auto compliance = [](const Material& m) { return (1 - m.poisson) / (2 * m.shear_modulus); };
  const double half = std::sqrt(2 * force / length * (compliance(wheel) + compliance(scenes::steel)) /
                                (std::numbers::pi * gap));
  const double dx = 2 * half / (mx * drawn(random, 0.6, 0.97));
  ContactProblem problem = scenes::flat(scenes::steel, wheel, mx, 1, dx, length, gap, 0);
  problem.force = force;
  scenes::set_creepage(problem, mu, 0, 0, 0);
  problem.force_x = random() % 3 == 0 ? mu * force * drawn(random, -0.8, 0.8) : 0.0;
  return problem;
}

/// The step's sum is small against its terms, the displacements of a whole line.
TEST(Lines, StepsInSinglePrecisionHaveFiveDigits) {
  ContactProblem problem = scenes::flat(scenes::steel, {23000, 0.31}, 800, 1, 0.001, 1000, 1e-3, 0);
  scenes::set_creepage(problem, 0.3, 0, 0, 0);
  const contact::StepBox box(problem.numbers, contact::Boxes{{{0, 0, 800, 1}}}, slip_step(problem).present);
  std::vector<double> p(1600), exact(1600);
  for (int i = 0; i < 800; ++i)
    p[i] = p[800 + i] = std::sin(std::numbers::pi * (i + 0.5) / 800);
  box.step(p, exact);
  const std::vector<float> rough_p(p.begin(), p.end());
  std::vector<float> rough(1600);
  box.step(rough_p, rough);
  const double scale = std::abs(*std::ranges::max_element(exact, {}, [](double v) { return std::abs(v); }));
  for (int i = 0; i < 1600; ++i)
    ASSERT_NEAR(rough[i], exact[i], 1e-5 * scale) << i;
}

/// None takes much longer than the others.
TEST(Lines, OfUnlikeRollersWithAForceTakeTheirTime) {
  NEEDS_NO_SANITIZER();
  std::mt19937 random(1);
  std::vector<double> work;
  for (int k = 0; k < tests::alike(40); ++k) {
    const ContactProblem problem = random_rollers(random);
    const ContactResult r = solve(problem, scenes::without_estimate);
    ASSERT_TRUE(r.certified()) << k << ' ' << r.trust.solver_note << r.trust.certificate.worst();
    work.push_back(r.effort.work);
  }
  std::ranges::sort(work);
  EXPECT_LT(work.back(), 10 * work[work.size() / 2]);
}

} // namespace
} // namespace bem_contact
