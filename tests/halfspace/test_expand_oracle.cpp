#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/rectangle.hpp"
#include "bem_contact/influence/expand.hpp"

#include "strip_kernel.hpp"

#include <gmock/gmock.h>

using namespace bem_contact;

namespace {

const Material steel{82000, 0.28};

/// Largest difference between expanded and closed-form numbers, relative to the self number u_n / p_n.
double expansion_error(const InfluenceFunction& f, double dx, int offsets) {
  ExpandOptions options;
  options.dx = dx;
  options.offsets = offsets;
  options.structural = StructuralCompliance::included;
  const InfluenceNumbers a = expand(f, options);
  const InfluenceNumbers b =
      spelled_out(halfspace::numbers(f.material, dx, f.station_width, offsets, a.rows));
  EXPECT_EQ(a.values.size(), b.values.size());
  double error = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    error = std::max(error, std::abs(a.values[i] - b.values[i]));
  return error / b.at(0, 0, 2, 0, 2);
}

} // namespace

TEST(ExpandOracle, HalfSpaceKernelGivesTheClosedForms) {
  const InfluenceFunction f = halfspace_function(steel, 12, 0.2, 0.2);
  for (const double dx : {0.2, 0.5, 1.0}) {
    RecordProperty("dx", std::to_string(dx));
    const double error = expansion_error(f, dx, 20);
    std::printf("expand against closed forms, dx %.1f: %.2e of self\n", dx, error);
    EXPECT_LT(error, 1e-4) << dx;
  }
}

TEST(ExpandOracle, MoreSamplesComeCloser) {
  const double coarse = expansion_error(halfspace_function(steel, 4, 0.2, 0.5, 600, 4), 1.0, 8);
  const double fine = expansion_error(halfspace_function(steel, 4, 0.2, 0.1, 600, 14), 1.0, 8);
  std::printf("4 samples a decade %.2e, 14: %.2e of self\n", coarse, fine);
  EXPECT_LT(fine, coarse / 4);
}

TEST(ExpandOracle, SignsOfTheCoupling) {
  const InfluenceFunction f = halfspace_function(steel, 3, 0.3, 0.3);
  ExpandOptions options;
  options.dx = 0.3;
  options.offsets = 5;
  const InfluenceNumbers a = expand(f, options);
  EXPECT_LT(a.at(2, 1, component_x, 1, component_n), 0);
  EXPECT_GT(a.at(2, 1, component_n, 1, component_x), 0);
  EXPECT_LT(a.at(0, 2, component_s, 0, component_n), 0);
  EXPECT_GT(a.at(0, 2, component_n, 0, component_s), 0);
  EXPECT_GT(a.at(2, 2, component_x, 0, component_s), 0);
}
