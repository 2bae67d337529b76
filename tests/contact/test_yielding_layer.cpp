#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/layer.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <random>

/// A layer between the surfaces that yields: against closed forms of one element, and against a slow dense
/// solution of one row in rolling.
namespace bem_contact {
namespace {

using testing::HasSubstr;

ContactResult solved(const ContactProblem& problem) {
  ContactResult result = solve(problem, scenes::without_estimate);
  EXPECT_TRUE(result.certified()) << result.trust.solver_note << ' ' << result.trust.certificate.worst();
  return result;
}

/// One element under a given pressure. Its rigid slip, mm, is set step by step.
struct OneElement {
  ContactProblem problem;
  double compliance; ///< of bodies and layer under shear, mm/MPa
  double friction;   ///< mu p_n, MPa

  OneElement(double layer, double mu, YieldLimit yield) {
    problem = scenes::flat(scenes::steel, scenes::steel, 1, 1, 0.5, 0.5, 0, 0);
    problem.force = 900 * 0.25;
    add_layer({{layer}, 0}, problem.numbers);
    scenes::set_creepage(problem, mu, 0, 0, 0);
    problem.motion = MotionKind::shift;
    problem.yield = yield;
    compliance = problem.numbers.at(0, 0, component_x, 0, component_x);
    friction = mu * 900;
  }

  /// Tractions after each of these shifts, one after the other.
  std::vector<ContactResult> history(const std::vector<double>& shifts) {
    return solve_history(
        problem, int(shifts.size()), [&](int k, ContactProblem& step) { step.slip_x = {shifts[k]}; },
        scenes::without_estimate);
  }
};

/// The closed form: elastic until the layer yields, then p and what it bears rise together until friction
/// bounds both.
struct ElasticPlastic {
  double p = 0, plastic = 0;

  void shift(double by, double compliance, double friction, const YieldLimit& limit) {
    const double trial = p + by / compliance, sign = trial < 0 ? -1 : 1,
                 borne = std::max(0.0, limit.shear + limit.hardening * plastic);
    if (std::abs(trial) <= std::min(borne, friction)) {
      p = trial;
      return;
    }
    if (friction <= borne) {
      p = sign * friction;
      return;
    }
    double more = (std::abs(trial) - borne) * compliance / (1 + limit.hardening * compliance);
    if (borne + limit.hardening * more > friction)
      more = (friction - borne) / limit.hardening;
    if (borne + limit.hardening * more < 0) // nothing is left of it: the rest slips without traction
      more = std::abs(trial) * compliance;
    plastic += more;
    p = sign * std::min(friction, std::max(0.0, limit.shear + limit.hardening * plastic));
  }
};

TEST(YieldingLayer, OneElementIsTheClosedForm) {
  const std::vector<double> shifts{0.02, 0.03, -0.01, -0.09, -0.03, 0.05, 0.06, 0.06, -0.2};
  for (const double layer : {0.0, 1.13e-4, 1.88e-4})
    for (const double mu : {0.7, 0.3})
      for (const YieldLimit& limit :
           {YieldLimit{200, 0}, {200, 435}, {200, 4e6}, {560, 0}, {200, -500}, {100, -2000}}) {
        SCOPED_TRACE(testing::Message()
                     << layer << ' ' << mu << ' ' << limit.shear << ' ' << limit.hardening);
        OneElement one(layer, mu, limit);
        ElasticPlastic exact;
        const std::vector<ContactResult> found = one.history(shifts);
        for (std::size_t k = 0; k < shifts.size(); ++k) {
          exact.shift(shifts[k], one.compliance, one.friction, limit);
          ASSERT_TRUE(found[k].certified()) << k << ' ' << found[k].trust.solver_note;
          EXPECT_NEAR(found[k].px[0], exact.p, 1e-9 * one.friction) << k;
          EXPECT_NEAR(found[k].plastic[0], exact.plastic, 1e-9 * 0.1 + 1e-9 * one.friction * one.compliance)
              << k;
        }
      }
}

ContactProblem yielding_contact(double compliance, double friction = 0.3, double scale = 1) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 28, 22, 0.5, 0.5, 8e-4, 1.2e-3);
  problem.force = 5e4;
  scenes::set_creepage(problem, friction, 6e-4 * scale, -3e-4 * scale, 8e-5 * scale);
  add_layer({{compliance}, 0}, problem.numbers);
  return problem;
}

TEST(YieldingLayer, ThatNeverYieldsIsThatWithoutLimit) {
  for (const double compliance : {0.0, 1e-4}) {
    ContactProblem problem = yielding_contact(compliance, 0.3, 3);
    const ContactResult without = solved(problem);
    for (const double hardening : {0.0, 1000.0, -1000.0}) {
      problem.yield = YieldLimit{1e6, hardening};
      const ContactResult with = solved(problem);
      for (std::size_t i = 0; i < with.px.size(); ++i) {
        ASSERT_NEAR(with.px[i], without.px[i], 1e-12 * 400) << hardening;
        ASSERT_NEAR(with.ps[i], without.ps[i], 1e-12 * 400) << hardening;
        ASSERT_EQ(with.plastic[i], 0) << hardening;
      }
    }
  }
}

/// A layer that bears little slips plastically everywhere, whatever friction would carry.
TEST(YieldingLayer, ThatBearsLittleBearsThatEverywhere) {
  for (const double friction : {0.2, 0.6}) {
    ContactProblem problem = yielding_contact(1e-4, friction, 20);
    problem.yield = YieldLimit{2, 0};
    const ContactResult r = solved(problem);
    double sum = 0;
    for (int i = 0; i < problem.grid.size(); ++i)
      sum += std::hypot(r.px[i], r.ps[i]) * problem.element_area();
    double bound = 0;
    for (int i = 0; i < problem.grid.size(); ++i)
      bound += std::min(2.0, friction * r.pn[i]) * problem.element_area();
    EXPECT_NEAR(sum, bound, 1e-3 * bound) << friction; // at the leading edge some adhere
    EXPECT_NEAR(friction_bound(problem, r), bound, 1e-12 * bound);
    EXPECT_NEAR(bound, 2 * double(r.totals.area), 0.01 * bound);
  }
}

/// One row of elements, 100 mm wide, and its numbers under shear.
ContactProblem one_row(double compliance, double xi) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 44, 1, 0.25, 100, 8e-4, 0);
  problem.force = 3e5;
  scenes::set_creepage(problem, 0.3, xi, 0, 0);
  add_layer({{compliance}, 0}, problem.numbers);
  return problem;
}

/// Tractions along x and plastic slips of a row in steady rolling, element by element until nothing changes.
struct DenseRow {
  std::vector<double> p, plastic;
  bool settled = false;
};
DenseRow dense_row(const ContactProblem& problem, const std::vector<double>& pn) {
  const int n = problem.grid.mx;
  const auto a = [&](int m) { return problem.numbers.at(std::abs(m), 0, component_x, 0, component_x); };
  const auto b = [&](int m) {
    return 1.5 * a(m) - 2 * a(m + 1) + 0.5 * a(m + 2);
  }; // place less that of the load
  DenseRow out{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  const double xi = problem.slip_x.front(), k = problem.yield->hardening, damping = 3;
  for (int sweep = 0; sweep < 20000 && !out.settled; ++sweep) {
    double change = 0;
    for (int i = n - 1; i >= 0; --i) {
      const auto ahead = [&](int by) { return i + by < n ? out.plastic[i + by] : 0.0; };
      const double before = std::max(0.0, (2 * ahead(1) - 0.5 * ahead(2)) / 1.5);
      if (!(pn[i] > 0)) {
        out.plastic[i] = before;
        continue;
      }
      double free = xi * problem.grid.dx; // slip if this element bore nothing
      for (int j = 0; j < n; ++j)
        if (j != i)
          free -= b(i - j) * out.p[j];
      free += damping * b(0) * out.p[i];
      const double friction = problem.friction * pn[i], self = (1 + damping) * b(0),
                   borne = std::max(0.0, problem.yield->shear + k * before), size = std::abs(free) / self;
      double next = std::min(size, friction), more = 0;
      if (size > borne && friction > borne) {
        more = (std::abs(free) - self * borne) / (1 + self * k / 1.5);
        next = borne + k * more / 1.5;
        if (next > friction) {
          more = (friction - borne) * 1.5 / k;
          next = friction;
        } else if (borne == 0 || next < 0) { // nothing is left of the layer
          more = std::abs(free);
          next = 0;
        }
      }
      next = std::copysign(next, free);
      change = std::max(
          {change, std::abs(next - out.p[i]), std::abs(k) * std::abs(before + more / 1.5 - out.plastic[i])});
      out.p[i] = next;
      out.plastic[i] = before + more / 1.5;
    }
    out.settled = change < 1e-9;
  }
  return out;
}

TEST(YieldingLayer, OneRowInRollingIsTheDenseSolution) {
  for (const double compliance : {0.0, 5e-5})
    for (const YieldLimit& limit :
         {YieldLimit{60, 0}, {60, 1e3}, {60, 2e4}, {60, 4e5}, {120, -500}, {60, -2e3}})
      for (const double xi : {5e-4, 2e-3, 2e-2}) {
        SCOPED_TRACE(testing::Message()
                     << compliance << ' ' << limit.shear << ' ' << limit.hardening << ' ' << xi);
        if (compliance > 0 && limit.hardening < -1e3)
          continue; // the slow way does not settle
        ContactProblem problem = one_row(compliance, xi);
        problem.yield = limit;
        const ContactResult r = solved(problem);
        const DenseRow exact = dense_row(problem, r.pn);
        ASSERT_TRUE(exact.settled);
        for (int i = 0; i < problem.grid.size(); ++i) {
          ASSERT_NEAR(r.px[i], exact.p[i], 1e-5) << i;
          ASSERT_NEAR(r.plastic[i], exact.plastic[i], 1e-9) << i;
        }
      }
}

TEST(YieldingLayer, TransientRollingTendsToSteadyRolling) {
  NEEDS_NO_SANITIZER();
  for (const double hardening : {0.0, 2e3, -500.0}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 14, 11, 1, 1, 8e-4, 1.2e-3);
    problem.force = 5e4;
    scenes::set_creepage(problem, 0.3, 2e-3, 1e-3, 1e-4);
    add_layer({{5e-5}, 0}, problem.numbers);
    problem.yield = YieldLimit{80, hardening};
    const ContactResult steady = solved(problem);
    problem.motion = MotionKind::transient;
    const ContactResult rolled = solve_history(
                                     problem, 60, [](int, ContactProblem&) {}, scenes::without_estimate)
                                     .back();
    ASSERT_TRUE(rolled.certified());
    EXPECT_NEAR(rolled.totals.Fx, steady.totals.Fx, 1e-5 * steady.totals.Fx) << hardening;
    for (std::size_t i = 0; i < steady.plastic.size(); ++i)
      ASSERT_NEAR(rolled.plastic[i], steady.plastic[i], 1e-5 * std::ranges::max(steady.plastic)) << hardening;
  }
}

/// Prescribed forces between what the layer bears at first and what friction carries: only with its hardening
/// does it bear them.
TEST(YieldingLayer, BearsPrescribedForcesOnceItHasHardened) {
  ContactProblem problem = yielding_contact(1e-4);
  problem.yield = YieldLimit{40, 5e3};
  const double first = 40 * double(solved(problem).totals.area);
  problem.force_x = 0.6 * 0.3 * 5e4;
  problem.force_s = 0.3 * 0.3 * 5e4;
  ASSERT_GT(std::hypot(*problem.force_x, *problem.force_s), 1.2 * first);
  const ContactResult r = solved(problem);
  EXPECT_NEAR(r.totals.Fx, *problem.force_x, 1e-6 * first);
  problem.yield = YieldLimit{40, 0};
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("cannot be carried"));
}

TEST(YieldingLayer, ThatSlidesWithFallingFrictionIsCertified) {
  ContactProblem problem = yielding_contact(1e-4, 0.3, 10);
  problem.speed = 2e4;
  problem.falling = {exponential_friction(0.2, 0.1, 1000)};
  double before = 1e9;
  for (const double shear : {1000.0, 150.0, 100.0, 40.0}) {
    problem.yield = YieldLimit{shear, 0};
    const ContactResult r = solved(problem);
    EXPECT_LT(r.totals.Fx, before) << shear;
    before = r.totals.Fx;
  }
}

TEST(YieldingLayer, ADamagedSolutionIsNotCertified) {
  for (const double hardening : {0.0, 2e3, -500.0}) {
    ContactProblem problem = yielding_contact(1e-4, 0.3, 5);
    problem.yield = YieldLimit{100, hardening};
    ContactResult r = solved(problem);
    std::size_t at = 0; // the element in contact with the largest plastic slip
    for (std::size_t i = 0; i < r.pn.size(); ++i)
      if (r.pn[i] > 0 && r.plastic[i] > r.plastic[at])
        at = i;
    for (const double by : {1.001, 0.999}) {
      ContactResult damaged = r;
      damaged.px[at] *= by;
      EXPECT_FALSE(certify(problem, damaged).holds()) << hardening << ' ' << by;
    }
    ContactProblem other = problem;
    other.yield->shear *= 1.001;
    EXPECT_FALSE(certify(other, r).holds()) << hardening;
  }
}

TEST(YieldingLayer, WhatCannotBeSolvedIsRefused) {
  ContactProblem problem = yielding_contact(1e-4);
  problem.yield = YieldLimit{100, -2e5};
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("more than one solution"));
  problem.yield = YieldLimit{0, 0};
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("yield limit"));
  problem.yield = YieldLimit{100, 0};
  problem.kinetic = 0.5;
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("Leave out one"));
  problem.kinetic = 1;
  problem.speed = 1e4;
  problem.falling = {exponential_friction(0.2, 0.1, 1000)};
  problem.yield = YieldLimit{100, 50};
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("Leave out one"));
}

/// 400 cases of one and two patches, some with a limit of pressure and some with a layer that softens by
/// heat: with a layer that yields each is certified or refused, and takes at most twice the work of all those
/// without.
TEST(YieldingLayer, RandomCasesAreCertifiedOrRefused) {
  std::mt19937 random(71);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto decades = [&](double low, double high) {
    return std::pow(10, between(std::log10(low), std::log10(high)));
  };
  double work = 0, work_without = 0;
  int refused = 0, softening = 0;
  for (int k = 0; k < tests::alike(400); ++k) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 24, 20, 0.6, 0.6, decades(4e-4, 3e-3),
                                          decades(4e-4, 3e-3));
    if (k % 4 == 0) // two patches, one beside the other
      for (int is = 0; is < problem.grid.ms; ++is)
        for (int ix = 0; ix < problem.grid.mx; ++ix) {
          const double s = std::abs(problem.rows[is].s) - 3.5, x = problem.grid.x(ix);
          problem.gap[is * problem.grid.mx + ix] = 2e-3 * x * x + 3e-3 * s * s;
        }
    problem.force = decades(2e3, 2e4);
    scenes::set_creepage(problem, between(0.1, 0.6), decades(1e-4, 3e-2) * (k % 2 ? 1 : -1),
                         between(-3e-3, 3e-3), between(-5e-4, 5e-4));
    if (k % 5 == 0)
      problem.force_x = between(-0.5, 0.5) * problem.friction * problem.force;
    add_layer({{k % 3 == 0 ? 0.0 : decades(1e-6, 5e-4)}, 0}, problem.numbers);
    const ContactResult without = solved(problem);
    problem.yield = YieldLimit{decades(10, 400), 0};
    if (k % 2 == 1)
      problem.yield->hardening = k % 8 == 1 ? -decades(10, 1e4) : decades(10, 1e6);
    softening += problem.yield->hardening < 0;
    if (k % 7 == 2)
      problem.limit_pressure = (0.5 + 0.1 * (k % 5)) * without.totals.pmax;
    if (k % 6 == 0) {
      problem.speed = 1e4 + 100 * k;
      problem.heating.emplace();
      const double cold = problem.yield->shear;
      problem.yield->temperatures = {20, 120, 400};
      problem.yield->shears = {cold, 0.7 * cold, 0.2 * cold};
    }
    try {
      const ContactResult with = solve(problem, scenes::without_estimate);
      work += with.effort.work;
      work_without += without.effort.work;
      refused += !with.certified();
      if (!with.certified())
        ADD_FAILURE() << k << ' ' << problem.yield->shear << ' ' << problem.yield->hardening << ' '
                      << with.trust.solver_note << ' ' << with.trust.certificate.worst();
    } catch (const InputError&) {
      ++refused;
      EXPECT_TRUE(problem.force_x || problem.yield->hardening < 0) << k;
    }
  }
  EXPECT_LT(refused, tests::alike(400) / 10);
  EXPECT_GT(softening, 0);
  EXPECT_LT(work, 2 * work_without);
  RecordProperty("work", std::to_string(work / work_without));
  std::printf("work %g refused %d\n", work / work_without, refused);
}

} // namespace
} // namespace bem_contact
