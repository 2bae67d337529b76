#include "bem_contact/base/progress.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace bem_contact {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Progress, writes_sparse_lines_where_there_is_no_terminal) {
  std::ostringstream out;
  Progress progress("wavenumbers", 1000, out, false);
  for (int i = 0; i < 1000; ++i)
    progress.step();
  progress.finish();
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, StartsWith("wavenumbers: 100/1000 "));
  EXPECT_THAT(text, HasSubstr("wavenumbers: 1000/1000 "));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(Progress, redraws_one_line_on_a_terminal) {
  std::ostringstream out;
  {
    Progress progress("wavenumbers", 4, out, true);
    progress.step(2);
    progress.step(2);
    progress.finish();
    progress.finish();
    progress.step();
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_THAT(text, StartsWith("\rwavenumbers [......"));
  EXPECT_THAT(text, HasSubstr("######] 4/4 "));
  EXPECT_THAT(text, EndsWith("\n"));
}

TEST(Progress, never_passes_its_total) {
  std::ostringstream out;
  Progress progress("none", 0, out, false);
  progress.step(5);
  progress.finish();
  EXPECT_THAT(out.str(), StartsWith("none: 1/1 "));
}

/// Work that turns out to be more, stage by stage, is one bar: a line for a tenth of what is known then.
TEST(Progress, grows_with_its_work) {
  std::ostringstream out;
  Progress progress("contacts", 10, out, false);
  for (int stage = 0; stage < 28; ++stage) {
    if (stage > 0)
      progress.extend(10);
    for (int i = 0; i < 10; ++i)
      progress.step();
  }
  progress.finish();
  const std::string text = out.str();
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 50); // of 280 steps
  EXPECT_THAT(text, HasSubstr("contacts: 280/280 "));
}

} // namespace
} // namespace bem_contact
