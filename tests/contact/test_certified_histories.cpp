#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/check/certificate.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/settings.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

/// Certificates of histories: contacts that grow, shrink and move, in transient rolling and in shifts.
namespace bem_contact {
namespace {

using testing::HasSubstr;
using testing::Not;

/// How the grid is filled. Displacements of `coarse` are summed directly, of the others by a transform.
enum class Filling { coarse, wide, fine };

/// A ball pressed on a plane in three steps.
struct History {
  ContactProblem problem; ///< its previous tractions are empty
  std::array<double, 3> force{};
  std::array<std::array<int, 2>, 3> centre{}; ///< where the ball stands, elements along x and s
  double curvature_x = 0, curvature_s = 0;    ///< of the undeformed distance, 1/mm

  void prescribe(int step, ContactProblem& p) const {
    p.force = force[step];
    for (int is = 0; is < p.grid.ms; ++is)
      for (int ix = 0; ix < p.grid.mx; ++ix) {
        const double x = p.grid.x(ix) - centre[step][0] * p.grid.dx,
                     s = p.rows[is].s - centre[step][1] * p.grid.ds;
        p.gap[is * p.grid.mx + ix] = curvature_x * x * x + curvature_s * s * s;
      }
  }
};

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

History random_history(std::mt19937& random, Filling filling) {
  const int across = filling == Filling::coarse ? std::uniform_int_distribution<int>(14, 24)(random)
                     : filling == Filling::wide ? 96
                                                : 64;
  const double radius = (filling == Filling::wide ? 0.1 : 0.32) * across; // of the largest contact, elements
  const double dx = between(random, 0.05, 0.4), ds = dx * between(random, 0.7, 1.4);
  const Material wheel = random() % 2 ? scenes::steel
                                      : Material{scenes::steel.shear_modulus * between(random, 0.05, 1),
                                                 between(random, 0.2, 0.4)};
  History h;
  h.curvature_x = between(random, 5e-4, 5e-3);
  h.curvature_s = h.curvature_x * dx * dx / (ds * ds); // as many elements along x as along s
  h.problem = scenes::flat(wheel, scenes::steel, across, across, dx, ds, h.curvature_x, h.curvature_s);
  const auto modulus = [](const Material& m) { return 2 * m.shear_modulus / (1 - m.poisson); };
  const double c = radius * std::sqrt(dx * ds), joint = 1 / (1 / modulus(wheel) + 1 / modulus(scenes::steel));
  const double approach = 2 * c * c * std::sqrt(h.curvature_x * h.curvature_s),
               largest = 4.0 / 3 * joint * c * approach;
  const double ratio = between(random, 0.6, 0.95);
  switch (random() % 3) {
  case 0: // it grows
    h.force = {largest * ratio * ratio, largest * ratio, largest};
    break;
  case 1: // it shrinks
    h.force = {largest, largest * ratio, largest * ratio * ratio};
    break;
  default: // it moves, and swells or falls a little
    h.force = {largest * ratio, largest, largest * between(random, 0.8, 1)};
    const int most = filling == Filling::coarse ? 1 : 3;
    for (int step = 1; step < 3; ++step)
      for (int k : {0, 1})
        h.centre[step][k] = h.centre[step - 1][k] + std::uniform_int_distribution<int>(-most, most)(random);
  }
  const double mu = between(random, 0.05, 0.6);
  h.problem.motion = random() % 2 ? MotionKind::shift : MotionKind::transient;
  const double slip =
      mu * approach * (h.problem.motion == MotionKind::shift ? 0.5 : 1 / c); // for partial slip
  scenes::set_creepage(h.problem, mu, slip * between(random, -1, 1), slip * between(random, -1, 1),
                       slip / c * between(random, -1, 1));
  if (random() % 5 == 0)
    h.problem.force_x = between(random, -0.7, 0.7) * mu * *std::ranges::min_element(h.force);
  return h;
}

/// The problem of the last step, as its result was certified.
ContactProblem last_step(const History& h, const std::vector<ContactResult>& results) {
  ContactProblem problem = h.problem;
  h.prescribe(2, problem);
  problem.previous = {tractions_of(results[1])};
  if (problem.motion == MotionKind::transient)
    problem.previous.push_back(tractions_of(results[0]));
  return problem;
}

std::array<double, 7> violations(const Certificate& c) {
  return {c.pressure, c.penetration,    c.complementarity, c.friction_cone,
          c.adhesion, c.slip_direction, c.force_balance};
}

/// Numbers of all pairs of rows written out are summed directly on any grid.
void expect_the_same_by_slow_sums(ContactProblem problem, const ContactResult& result) {
  problem.numbers = with_every_pair_of_rows(problem.numbers);
  const auto fast = violations(result.trust.certificate), slow = violations(certify(problem, result));
  for (std::size_t i = 0; i < fast.size(); ++i)
    EXPECT_NEAR(fast[i], slow[i], 1e-8 + 1e-6 * slow[i]) << "violation " << i;
}

/// Shear on an element that was loaded last, as if it slipped against the law.
void expect_a_fault_is_found(const ContactProblem& problem, ContactResult result) {
  for (std::size_t i = 0; i < result.pn.size(); ++i)
    if (result.pn[i] > 0 && problem.previous[0].pn[i] == 0) {
      result.px[i] =
          result.px[i] > 0 ? -0.9 * problem.friction * result.pn[i] : 0.9 * problem.friction * result.pn[i];
      EXPECT_GT(certify(problem, result).worst(), 1e-5);
      return;
    }
}

TEST(Certificate, OfRandomHistoriesHoldsOrTheReasonIsTrue) {
  std::mt19937 random(1);
  const int count = tests::alike(100);
  int certified = 0, transformed = 0;
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const Filling filling = k % 20 == 0 ? Filling::fine : k % 5 == 1 ? Filling::wide : Filling::coarse;
    const History h = random_history(random, filling);
    const auto results = solve_history(
        h.problem, 3, [&](int step, ContactProblem& p) { h.prescribe(step, p); }, scenes::without_estimate);
    for (const ContactResult& step : results)
      if (!step.certified()) {
        EXPECT_THAT(step.trust.solver_note, Not(testing::IsEmpty()));
        EXPECT_THAT(step.trust.solver_note, Not(HasSubstr("decades apart"))) << "they lie within five";
      }
    certified += std::ranges::all_of(results, &ContactResult::certified);
    const ContactProblem problem = last_step(h, results);
    transformed += 9.0 * problem.grid.size() * count_elements(results[1]).contact > contact::many_plane_terms;
    expect_the_same_by_slow_sums(problem, results[2]);
    expect_a_fault_is_found(problem, results[2]);
  }
  EXPECT_GE(certified, 0.98 * count);
  EXPECT_GE(transformed, 0.15 * count);
}

/// What is not certified although the solvers ended well says which condition fails. Digits are lost only
/// where lengths lie so far apart that rounding makes the violation.
TEST(Certificate, NamesWhatItFinds) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20, 20, 0.4, 0.4, 1e-3, 1e-3);
  problem.force = 1e4;
  scenes::set_creepage(problem, 0.3, 1e-3, 5e-4, 2e-4);
  SolverOptions rough = scenes::without_estimate;
  rough.tolerance = 1e-3;
  const ContactResult r = solve(problem, rough);
  ASSERT_FALSE(r.certified());
  EXPECT_GT(r.trust.certificate.worst(), r.trust.certificate.rounding);
  EXPECT_THAT(r.trust.solver_note,
              HasSubstr("the solvers reached their tolerance, 1e-03, but the certificate finds " +
                        std::string(r.trust.certificate.worst_name()) + " violated"));
  problem.tangential = false;
  problem.force = 1e-30;
  const ContactResult lost = solve(problem, scenes::without_estimate);
  ASSERT_FALSE(lost.certified());
  EXPECT_LE(lost.trust.certificate.worst(), lost.trust.certificate.rounding);
  EXPECT_EQ(lost.trust.solver_note, "digits were lost: lengths, forces or moduli lie too many decades apart");
}

} // namespace
} // namespace bem_contact
