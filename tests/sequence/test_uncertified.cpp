#include "bem_contact/sequence/uncertified.hpp"

#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Unlike bodies that may take one outer iteration only are no solution, and bodies apart always are one.
SceneResult of_steps(const std::string& loads) {
  const TemporaryFolder folder;
  folder.write("steps.csv", "load\n" + loads);
  return Sequence().solve(read_scene_file(folder.write(
      "s.toml", "kind = 'patch'\nload.approach = 0.01\n[motion]\nkind = 'shift'\nfriction = 0.3\nxi = 1e-3\n"
                "step_table = 'steps.csv'\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
                "[gap]\na = 1e-3\nb = 1e-3\n[wheel.material]\nshear_modulus = 800\npoisson = 0\n"
                "[solver]\nmodel = 'halfspace'\nmax_outer = 1\n")));
}

/// The last step starts from the tractions of the one that failed, however well it goes itself.
TEST(Uncertified, NamesTheStepThatFailed) {
  const SceneResult r = of_steps("-0.01\n0.01\n-0.01\n");
  ASSERT_FALSE(certified(r));
  ASSERT_TRUE(r.result.trust.certificate.holds());
  const double worst = r.history[1].trust.certificate.worst();
  ASSERT_GT(worst, 1e-6);
  EXPECT_THAT(why_not_certified(r),
              AllOf(HasSubstr("step 2 of 3 is not a solution"),
                    HasSubstr(fmt::format("its worst violation is {:.1e}, 1e-06", worst)),
                    HasSubstr(r.history[1].trust.solver_note)));
  EXPECT_THAT(uncertified_error(r).what(), HasSubstr("The halfspace result is not a solution (step 2 of 3"));
}

TEST(Uncertified, ACertifiedResultHasNoReason) {
  EXPECT_EQ(why_not_certified(of_steps("-0.01\n-0.02\n")), "");
}

} // namespace
} // namespace bem_contact
