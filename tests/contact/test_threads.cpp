#include "tests/contact/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

extern "C" void openblas_set_num_threads(int);
extern "C" int openblas_get_num_threads();

namespace bem_contact {
namespace {

/// Small enough for Cholesky and LU; large enough for GMRES.
std::vector<ContactProblem> problems() {
  std::vector<ContactProblem> list;
  for (const int across : {10, 22}) {
    const Material soft{40000, 0.2};
    list.push_back(scenes::flat(scenes::steel, soft, across, across, 16.0 / across, 12.0 / across, 1 / 920.0,
                                1 / 600.0));
    scenes::bend(list.back(), 60);
    scenes::rotate_numbers(list.back());
    scenes::set_creepage(list.back(), 0.3, 1e-3, 5e-4, 1e-4);
    list.back().force = 40000;
  }
  return list;
}

void expect_equal(const ContactResult& a, const ContactResult& b, double share) {
  const double pmax = *std::max_element(a.pn.begin(), a.pn.end());
  for (std::size_t i = 0; i < a.pn.size(); ++i) {
    EXPECT_NEAR(a.pn[i], b.pn[i], share * pmax);
    EXPECT_NEAR(a.px[i], b.px[i], share * pmax);
    EXPECT_NEAR(a.ps[i], b.ps[i], share * pmax);
  }
  EXPECT_NEAR(a.totals.approach, b.totals.approach, share * a.totals.approach);
  EXPECT_EQ(a.state, b.state);
}

TEST(Threads, OpenBlasComputesOnOneAndIsLeftAsItWas) {
  const int before = openblas_get_num_threads();
  const ContactProblem problem = problems().front();
  openblas_set_num_threads(1);
  const ContactResult one = solve(problem);
  openblas_set_num_threads(2);
  const ContactResult two = solve(problem);
  EXPECT_EQ(openblas_get_num_threads(), 2);
  EXPECT_TRUE(one.certified());
  EXPECT_EQ(one.pn, two.pn); // two threads add in another order
  openblas_set_num_threads(before);
}

TEST(Threads, CasesSideBySideAreTheSame) {
  const int before = openblas_get_num_threads();
  const std::vector<ContactProblem> list = problems();
  std::vector<ContactResult> alone, together(2 * list.size());
  for (const ContactProblem& problem : list)
    alone.push_back(solve(problem));
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < together.size(); ++k)
    threads.emplace_back([&, k] { together[k] = solve(list[k % list.size()]); });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(openblas_get_num_threads(), before);
  for (std::size_t k = 0; k < together.size(); ++k)
    expect_equal(alone[k % list.size()], together[k], 1e-12);
}

} // namespace
} // namespace bem_contact
