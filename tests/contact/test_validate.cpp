#include "bem_contact/base/error.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

namespace bem_contact {
namespace {

struct BadInput {
  const char* name;
  std::function<void(ContactProblem&)> spoil;
  const char* message;
};

struct Validate : testing::TestWithParam<BadInput> {};

ContactProblem sound() {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 6, 5, 0.5, 0.4, 1e-3, 1e-3);
  problem.force = 100;
  scenes::set_creepage(problem, 0.3, 1e-3, 0, 0);
  return problem;
}

TEST_P(Validate, IsRefusedWithItsMessage) {
  ContactProblem problem = sound();
  GetParam().spoil(problem);
  EXPECT_THAT(message_of([&] { solve(problem); }), testing::HasSubstr(GetParam().message));
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const BadInput bad_inputs[] = {
    {"EmptyGrid", [](ContactProblem& p) { p.grid.mx = 0; }, "The grid is empty"},
    {"NoSize", [](ContactProblem& p) { p.grid.dx = 0; }, "The elements have no size"},
    {"Rows", [](ContactProblem& p) { p.rows.pop_back(); }, "The rows do not fit the grid"},
    {"RowNaN", [](ContactProblem& p) { p.rows[2].delta = nan; }, "A row of the grid is not finite"},
    {"NumbersRows", [](ContactProblem& p) { p.numbers.rows = 4; }, "do not fit the grid"},
    {"NumbersDx", [](ContactProblem& p) { p.numbers.dx = 0.6; }, "their dx is"},
    {"Offsets", [](ContactProblem& p) { p.numbers.offsets = 6; }, "do not reach across the grid"},
    {"Truncated", [](ContactProblem& p) { p.numbers.values.pop_back(); }, "are incomplete"},
    {"NumberNaN", [](ContactProblem& p) { p.numbers.values[7] = nan; }, "is not finite"},
    {"NegativeSelf", [](ContactProblem& p) { p.numbers.at(0, 1, 2, 1, 2) *= -1; }, "is not positive"},
    {"Betti", [](ContactProblem& p) { p.numbers.at(0, 1, 2, 2, 2) *= 1.1; }, "violate Maxwell-Betti"},
    {"GapSize", [](ContactProblem& p) { p.gap.pop_back(); }, "The undeformed distance does not fit"},
    {"GapNaN", [](ContactProblem& p) { p.gap[3] = nan; }, "The undeformed distance is not a number"},
    {"ForceNaN", [](ContactProblem& p) { p.force = nan; }, "The force is negative or not finite"},
    {"ForceNegative", [](ContactProblem& p) { p.force = -1; }, "The force is negative or not finite"},
    {"Approach",
     [](ContactProblem& p) {
       p.load = LoadKind::approach;
       p.approach = nan;
     },
     "The approach is not finite"},
    {"AllVertical",
     [](ContactProblem& p) {
       for (auto& row : p.rows)
         row.delta = -std::numbers::pi / 2;
     },
     "No row can carry a vertical force"},
    {"Friction", [](ContactProblem& p) { p.friction = -0.1; },
     "A friction coefficient is negative or not finite"},
    {"SlipSize", [](ContactProblem& p) { p.slip_s.clear(); }, "The rigid slip along s does not fit"},
    {"PlaneStrainRolling",
     [](ContactProblem& p) {
       p = scenes::flat(scenes::steel, scenes::steel, 1, 5, 0.5, 0.4, 1e-3, 1e-3);
       p.numbers = halfspace::plane_strain_numbers(scenes::steel, 0.4, 5, 100);
       p.tangential = true;
     },
     "Rolling needs elements along x"}};

INSTANTIATE_TEST_SUITE_P(Inputs, Validate, testing::ValuesIn(bad_inputs),
                         [](const auto& test) { return test.param.name; });

TEST(Validate, AcceptsTheSoundProblem) {
  EXPECT_TRUE(solve(sound()).certified());
}

TEST(Validate, ResultOfAnotherProblemIsNotCertified) {
  const ContactProblem problem = sound();
  ContactResult result = solve(problem);
  result.pn.pop_back();
  EXPECT_THROW(certify(problem, result), InputError);
}

} // namespace
} // namespace bem_contact
