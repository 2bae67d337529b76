#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/machine_system.hpp"
#include "fem_influence/harmonic/run_plan.hpp"
#include "fem_influence/harmonic/task_distribution.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace bem_contact::fem::test {
namespace {

// One process runs these tests. test_run.cpp runs the program on two and four.

BodyFile small_block(int degree = 2) {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.body.size = 40;
  body.strip = {-2, 2, 0.5};
  body.harmonic.degree = degree;
  body.harmonic.border_levels = 1;
  body.harmonic.half_period = 120;
  body.harmonic.shortest_dx = 0.5;
  body.harmonic.remote_distance = 20;
  return body;
}

class Mesh : public ::testing::Test {
protected:
  void SetUp() override { write_block_mesh(folder_ / "block.msh", 0.5, 2, 40); }
  MeshedSystem meshed() { return {small_block(), straight_line(40), folder_ / "block.msh", {}, timing_}; }
  Folder folder_;
  Timing timing_;
};
using MachineSystemTest = Mesh;
using SolverOnDemandTest = Mesh;

TEST(MachineGroup, has_memory_of_the_machine_only_where_there_is_room) {
  MachineGroup group; // alone here
  EXPECT_TRUE(group.memory(std::size_t{1} << 60).empty());
  const auto memory = group.memory(1000);
  ASSERT_GE(memory.size(), 1000u);
  memory.front() = memory[999] = std::byte{7};
  group.announce(true);
  EXPECT_TRUE(group.wait());
}

TEST(Distribute, does_every_task_once_and_those_of_the_preferred_kind_first) {
  for (const bool second : {false, true}) {
    SharedCounters counters;
    std::vector<std::size_t> begun;
    std::vector<double> collected(5, 0.0);
    distribute(
        counters, {.count = 5, .second = 3, .begins_with_second = second},
        [&](std::size_t task) {
          begun.push_back(task);
          return std::vector{10.0 + static_cast<double>(task)};
        },
        [&](std::size_t task, std::vector<double> result) { collected.at(task) += result.at(0); });
    EXPECT_EQ(begun,
              second ? (std::vector<std::size_t>{3, 4, 0, 1, 2}) : (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(collected, (std::vector<double>{10, 11, 12, 13, 14}));
  }
}

TEST(Distribute, begins_no_task_after_one_that_failed) {
  SharedCounters counters;
  std::size_t begun = 0;
  const auto work = [&](std::size_t task) -> std::vector<double> {
    ++begun;
    if (task == 1)
      throw InputError("A task failed", "the test wants it", "look elsewhere");
    return {};
  };
  EXPECT_THROW(distribute(counters, {.count = 5, .second = 5}, work, [](std::size_t, std::vector<double>) {}),
               InputError);
  EXPECT_EQ(begun, 2u);
}

TEST(RunPlan, has_the_wavenumbers_of_the_run_then_those_of_its_companion) {
  const RunPlan plan = plan_run(small_block(), straight_line(40));
  ASSERT_TRUE(plan.companion);
  EXPECT_EQ(plan.companion->body.harmonic.degree, 1);
  EXPECT_EQ(plan.companion->body.harmonic.border_levels, 0);
  const std::size_t own = plan.function.wavenumber_count(),
                    coarse = plan.companion->function.wavenumber_count();
  EXPECT_LT(coarse, own);
  ASSERT_EQ(plan.tasks.size(), own + coarse);
  EXPECT_FALSE(plan.tasks[own - 1].companion);
  EXPECT_TRUE(plan.tasks[own].companion);
  EXPECT_EQ(plan.wavenumber(plan.tasks[own - 1]), plan.wavenumber(plan.tasks.back())); // the largest of both
  EXPECT_FALSE(plan_run(small_block(1), straight_line(40)).companion);
}

TEST_F(MachineSystemTest, hands_its_matrices_out_once) {
  MachineGroup group;
  MachineSystem machine(group, meshed(), timing_);
  machine.require_matrices();
  const auto assembled = machine.take();
  ASSERT_TRUE(assembled);
  EXPECT_EQ(assembled->order, elimination_order(assembled->system));
  EXPECT_EQ(assembled->system.op.block.size(), assembled->system.op.block_count());
  EXPECT_FALSE(machine.take());
}

TEST_F(SolverOnDemandTest, assembles_when_it_is_first_used_and_again_after_it_was_released) {
  int assembled = 0;
  SolverOnDemand solver(
      [&] {
        ++assembled;
        return add_matrices(meshed(), timing_);
      },
      timing_);
  EXPECT_EQ(assembled, 0);
  const WavenumberResult first = solver.at(0.3);
  solver.at(0.5);
  EXPECT_EQ(assembled, 1);
  solver.release();
  EXPECT_EQ(solver.at(0.3).kernel, first.kernel);
  EXPECT_EQ(assembled, 2);
  EXPECT_GT(timing_.assembly, 0);
  EXPECT_GT(timing_.analysis, 0);
  EXPECT_GT(timing_.factorization, 0);
}

} // namespace
} // namespace bem_contact::fem::test
