#include "tests/hard_cases/hard_case.hpp"

#include <fmt/format.h>

/// A patch one element wide, along x and along s.
namespace bem_contact {
namespace {

TEST(HardCases, OneElementWide) {
  for (const bool along_x : {true, false}) {
    ContactProblem problem = along_x ? scenes::flat(scenes::steel, scenes::steel, 40, 5, 0.2, 2, 1e-3, 0.5)
                                     : scenes::flat(scenes::steel, scenes::steel, 5, 40, 2, 0.2, 0.5, 1e-3);
    problem.force = 2000;
    for (const double size : {1.0, 10.0}) {
      scenes::set_creepage(problem, 0.3, 2e-4 * size, 1e-4 * size, 5e-5 * size);
      const ContactResult result = hard::certified(
          fmt::format("one element wide, along {}{}", along_x ? "x" : "s", size > 1 ? ", full slip" : ""),
          "a single line of elements in contact, others around it free", problem);
      ASSERT_EQ(result.patches.size(), 1u);
      int lines = 0;
      for (int line = 0; line < 5; ++line)
        for (int k = 0; k < 40; ++k)
          if (result.pn[along_x ? line * 40 + k : k * 5 + line] > 0) {
            ++lines;
            break;
          }
      EXPECT_EQ(lines, 1);
      EXPECT_GT(result.patches[0].contact, 10);
    }
  }
}

} // namespace
} // namespace bem_contact
