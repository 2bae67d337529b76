#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/normal/conjugate_gradients.hpp"
#include "bem_contact/contact/operator/settings.hpp"
#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/contact/tangential/step_box.hpp"
#include "tests/contact/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>

// Every allocation of the program, of Eigen and the standard library alike, passes here; FFTW's own buffers
// do not. Sanitizers bring their own malloc.
#if defined(__GLIBC__) && !defined(CONFORMAL_SANITIZED)
#define COUNTS_ALLOCATIONS 1
namespace {
std::atomic<long> allocations{0};
}
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
#endif

namespace bem_contact {
namespace {

/// Rolling with unlike materials; the numbers of `bent` are full in s and couple by curvature as well.
ContactProblem rolling(bool bent, double force, double creepage) {
  const Material soft{40000, 0.2};
  ContactProblem problem =
      scenes::flat(scenes::steel, soft, 36, 32, 16.0 / 36, 12.0 / 32, 1 / 920.0, 1 / 600.0);
  if (bent) {
    scenes::bend(problem, 60);
    scenes::rotate_numbers(problem);
  }
  scenes::set_creepage(problem, 0.3, creepage, 5e-4, 1e-4);
  problem.force = force;
  return problem;
}

void expect_same(const ContactResult& a, const ContactResult& b) {
  ASSERT_TRUE(a.certified()) << a.trust.solver_note;
  ASSERT_TRUE(b.certified()) << b.trust.solver_note;
  const double pmax = *std::ranges::max_element(a.pn), share = 1e-6;
  for (std::size_t i = 0; i < a.pn.size(); ++i) {
    EXPECT_NEAR(a.pn[i], b.pn[i], share * pmax);
    EXPECT_NEAR(a.px[i], b.px[i], share * pmax);
    EXPECT_NEAR(a.ps[i], b.ps[i], share * pmax);
  }
  EXPECT_NEAR(a.totals.approach, b.totals.approach, share * a.totals.approach);
  ASSERT_EQ(a.trust.discretisation.has_value(), b.trust.discretisation.has_value());
  if (a.trust.discretisation) {
    EXPECT_NEAR(a.trust.discretisation->worst(), b.trust.discretisation->worst(), 1e-6);
  }
}

TEST(Workspace, ASequenceHasTheResultsOfItsCases) {
  for (const bool bent : {false, true}) {
    Workspace workspace;
    int cases = 0;
    for (const double force : {40000.0, 60000.0, 20000.0, 2000.0, 50000.0})
      for (const double creepage : {1e-4, 5e-3}) {
        const ContactProblem problem = rolling(bent, force, creepage);
        expect_same(solve(problem), solve(problem, {.workspace = &workspace}));
        ++cases;
      }
    EXPECT_EQ(workspace.prepared(), 1);
    EXPECT_EQ(workspace.kept(), cases - 1);
  }
}

/// Frictionless, shift and transient rolling take what they need from one workspace.
TEST(Workspace, ServesEveryKindOfProblem) {
  Workspace workspace;
  ContactProblem problem = rolling(true, 40000, 1e-3);
  for (int turn = 0; turn < 2; ++turn)
    for (const MotionKind motion : {MotionKind::steady, MotionKind::transient, MotionKind::shift})
      for (const bool tangential : {true, false}) {
        problem.motion = motion;
        problem.tangential = tangential;
        const double length = motion == MotionKind::shift ? problem.grid.dx : 1.0;
        ContactProblem moved = problem;
        for (auto* slip : {&moved.slip_x, &moved.slip_s})
          for (double& w : *slip)
            w *= length;
        expect_same(solve(moved), solve(moved, {.workspace = &workspace}));
      }
  EXPECT_EQ(workspace.prepared(), 1);
}

/// Threads share rows, frequencies and offsets, and each sum stays on one of them.
TEST(Workspace, TwoCoresGiveTheSameBits) {
  ContactProblem problem =
      scenes::flat(scenes::steel, Material{40000, 0.2}, 60, 100, 0.2, 0.12, 1 / 920.0, 1 / 600.0);
  scenes::bend(problem, 60);
  scenes::rotate_numbers(problem);
  scenes::set_creepage(problem, 0.3, 1e-3, 5e-4, 1e-4);
  problem.force = 20000;
  ASSERT_FALSE(problem.numbers.translational);
  ASSERT_GE(problem.grid.size(), contact::least_threaded);
  std::vector<ContactResult> results;
  for (const int threads : {1, 2}) {
    Workspace workspace(2, threads);
    EXPECT_EQ(workspace.threads(), threads);
    results.push_back(solve(problem, {.displacements = true, .workspace = &workspace}));
    ASSERT_TRUE(results.back().certified()) << results.back().trust.solver_note;
    ASSERT_TRUE(results.back().trust.discretisation);
  }
  EXPECT_GT(std::ranges::count_if(results[0].pn, [](double p) { return p > 0; }), 1000);
  EXPECT_EQ(results[0].pn, results[1].pn);
  EXPECT_EQ(results[0].px, results[1].px);
  EXPECT_EQ(results[0].ps, results[1].ps);
  EXPECT_EQ(results[0].displacements.us, results[1].displacements.us);
  EXPECT_EQ(results[0].trust.certificate.worst(), results[1].trust.certificate.worst());
  EXPECT_EQ(results[0].trust.discretisation->worst(), results[1].trust.discretisation->worst());
}

TEST(Workspace, OneOtherNumberIsNoticed) {
  Workspace workspace(1);
  ContactProblem problem = rolling(true, 40000, 1e-3);
  solve(problem, {.workspace = &workspace});
  const int middle = problem.grid.ms / 2;
  problem.numbers.at(0, middle, component_n, middle, component_n) *= 1.01;
  expect_same(solve(problem), solve(problem, {.workspace = &workspace}));
  EXPECT_EQ(workspace.prepared(), 2);
  EXPECT_EQ(workspace.kept(), 0);
}

/// A cold start may begin on larger elements: their steps are counted in the work alone.
TEST(Workspace, WarmStartNeedsFewerSteps) {
  const ContactProblem next = rolling(true, 40400, 1.01e-3);
  // Each with a workspace of its own: it keeps what the solution before found out.
  const auto solve_next = [&](bool from_first, bool coarse_start) {
    Workspace workspace;
    const ContactResult first = solve(rolling(true, 40000, 1e-3), {.workspace = &workspace});
    const StartingPoint start{{first.px, first.ps, first.pn}, first.totals.approach};
    return solve(
        next,
        {.coarse_start = coarse_start, .start = from_first ? &start : nullptr, .workspace = &workspace});
  };
  const ContactResult warm = solve_next(true, true), cold = solve_next(false, true),
                      bare = solve_next(false, false);
  expect_same(cold, warm);
  EXPECT_LT(warm.effort.work, cold.effort.work);
  EXPECT_LT(warm.effort.tangential_iterations, bare.effort.tangential_iterations);
}

#ifdef COUNTS_ALLOCATIONS
template <class Work> long allocations_of(const Work& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

TEST(Workspace, TheCounterCounts) {
  EXPECT_GE(allocations_of([] { Eigen::VectorXd::Zero(1000).eval(); }), 1);
  EXPECT_GE(allocations_of([] { std::vector<double>(1000).swap(*std::make_unique<std::vector<double>>()); }),
            1);
}

TEST(Workspace, ProductsAllocateNothing) {
  for (const bool bent : {false, true}) {
    const ContactProblem problem = rolling(bent, 40000, 1e-3);
    const contact::StepBox box(problem.numbers, {{{2, 3, 30, 24}}}, slip_step(problem).present);
    contact::StepBoxScratch scratch(box);
    std::ranges::fill(scratch.in, 1.0);
    std::ranges::fill(scratch.fast_in, 1.0f);
    std::ranges::fill(scratch.sticks, 1);
    EXPECT_EQ(allocations_of([&] {
                for (int k = 0; k < 3; ++k) {
                  box.step(scratch.in, scratch.out);
                  box.step(scratch.fast_in, scratch.fast_out);
                  box.invert(scratch.sticks, scratch.fast_in, scratch.fast_out);
                  scratch.damped.set(box, 1 + k, 1e5);
                  scratch.damped.apply(box, scratch.fast_in, scratch.fast_out);
                }
              }),
              0);
  }
}

TEST(Workspace, MoreIterationsAllocateNoMore) {
  const ContactProblem problem = rolling(true, 40000, 1e-3);
  const int n = problem.grid.size();
  // conjugate gradients
  contact::NormalOperators operators;
  const contact::NormalSystem normal(problem, operators);
  WorkBudget work;
  std::vector<int> list;
  for (int i = 0; i < n; ++i)
    if (std::abs(i % problem.grid.mx - 17.5) < 12 && std::abs(i / problem.grid.mx - 15.5) < 11)
      list.push_back(i);
  const Eigen::VectorXd rhs = Eigen::VectorXd::Ones(n);
  contact::Response response{Eigen::VectorXd(n), Eigen::VectorXd(n), {}};
  const auto solve_to = [&](double target) {
    response.p.setZero();
    response.products = 0;
    EXPECT_TRUE(conjugate_gradients(normal, list, rhs, target, work, response));
    return response.products;
  };
  const int many = solve_to(1e-12), few = solve_to(1e-2);
  EXPECT_GT(many, few + 5);
  EXPECT_EQ(allocations_of([&] { solve_to(1e-2); }), allocations_of([&] { solve_to(1e-12); }));
  // GCR
  contact::Gcr gcr{{contact::kept_solutions, contact::kept_directions}};
  const contact::StepBox box(problem.numbers, {{{0, 0, problem.grid.mx, problem.grid.ms}}},
                             slip_step(problem).present);
  contact::StepBoxScratch scratch(box);
  const auto product = [&](const auto& v, auto&& out) {
    std::copy_n(v.data(), 2 * n, scratch.fast_in.data());
    box.step(scratch.fast_in, scratch.fast_out);
    out = Eigen::Map<const Eigen::VectorXf>(scratch.fast_out.data(), 2 * n);
  };
  const auto image = [](const auto& v, const auto& bv, auto&& out) { out = v + 1e5f * bv; };
  const auto identity = [](const auto& v, auto&& out) { out = v; };
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(2 * n, -1, 2);
  Eigen::VectorXd x(2 * n);
  constexpr int most = 40;
  std::vector<int> elements{0};
  const auto iterate = [&](double tolerance) {
    ++elements[0]; // nothing that was kept serves
    gcr.use_elements(elements);
    gcr.solve(product, image, identity, right, {tolerance, most}, x);
  };
  iterate(1e-5);
  const int longest = gcr.products();
  iterate(1e-1);
  EXPECT_GT(longest, gcr.products() + 3);
  EXPECT_EQ(allocations_of([&] { iterate(1e-1); }), 0);
  EXPECT_EQ(allocations_of([&] { iterate(1e-5); }), 0);
}
#endif

/// One total bounds all loops; what is left over is not touched.
TEST(Workspace, ACaseIsRefusedWhereItsWorkIsUsedUp) {
  ContactProblem problem = scenes::flat({82000, 0.28}, {82000, 0.28}, 40, 40, 0.4, 0.4, 1 / 600.0, 1 / 600.0);
  scenes::set_creepage(problem, 0.3, 1e-3, 0, 0);
  problem.force = 5e4;
  WorkBudget enough;
  const ContactResult result = solve(problem, {}, enough);
  EXPECT_TRUE(result.certified());
  EXPECT_EQ(result.effort.work, enough.used());
  EXPECT_GT(result.effort.work, 10.0 * problem.grid.size());
  WorkBudget scarce(0.3 * result.effort.work);
  EXPECT_THROW(solve(problem, {.estimate_discretisation = false}, scarce), ConvergenceError);
  Workspace kept; // a refusal leaves nothing behind
  WorkBudget again(0.3 * result.effort.work);
  EXPECT_THROW(solve(problem, {.workspace = &kept}, again), ConvergenceError);
  EXPECT_NEAR(solve(problem, {.workspace = &kept}).totals.Fx, result.totals.Fx, 1e-6 * result.totals.Fx);
}

/// The same solution by numbers that are full in s: the same products, each of which costs more.
TEST(Workspace, ProductsWithFullNumbersCountForMore) {
  ContactProblem problem = rolling(false, 40000, 1e-3);
  const ContactResult translational = solve(problem);
  problem.numbers = with_every_pair_of_rows(problem.numbers);
  const ContactResult full = solve(problem);
  expect_same(translational, full);
  EXPECT_GT(full.effort.work, 1.2 * translational.effort.work);
  EXPECT_LT(full.effort.work, 1.1 * product_work(false, problem.grid.ms) * translational.effort.work);
}

} // namespace
} // namespace bem_contact
