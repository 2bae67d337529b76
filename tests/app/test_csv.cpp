#include "bem_contact/app/output/csv.hpp"
#include "bem_contact/base/column.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vector>

namespace {

using namespace bem_contact;

struct Load {
  double moment, share;
};

TEST(Csv, HasUnitsInItsHeadAndAnEmptyCellForNan) {
  const std::vector<ColumnOf<Load>> columns{{"Mz", "N mm", "", [](const Load& load) { return load.moment; }},
                                            {"share", "1", "", [](const Load& load) { return load.share; }}};
  const std::vector<Load> rows{{1.5, 0.25}, {std::numeric_limits<double>::quiet_NaN(), 1.0 / 3}};
  std::ostringstream out;
  app::write_csv(out, columns, rows, 4);
  EXPECT_EQ(out.str(), "Mz_Nmm,share\n1.5,0.25\n,0.3333\n");
}

} // namespace
