#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/influence/expand.hpp"

#include "steel.hpp"
#include "strip_kernel.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>

using namespace bem_contact;

namespace {

/// Largest difference between expanded and closed-form numbers, relative to the self number u_n / p_n.
double expansion_error(const InfluenceFunction& f, double dx, int offsets) {
  ExpandOptions options;
  options.dx = dx;
  options.offsets = offsets;
  options.structural = StructuralCompliance::included;
  const InfluenceNumbers a = expand(f, options);
  const InfluenceNumbers b =
      with_every_pair_of_rows(halfspace::influence_numbers(f.material, dx, f.station_width, offsets, a.rows));
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

// --- a table of influence numbers --------------------------------------------------------------------

namespace {

/// The half-space as a table of elements 0.25 mm long at 24 offsets.
InfluenceFunction halfspace_table() {
  InfluenceFunction f = halfspace_function(steel, 5, 0.2, 0.2);
  f.wavenumber.clear();
  f.kernel.clear();
  f.remote.clear();
  f.remote_self.clear();
  f.table_dx = 0.25;
  const InfluenceNumbers numbers =
      with_every_pair_of_rows(halfspace::influence_numbers(steel, 0.25, 0.2, 24, 5));
  f.table.assign(numbers.values.begin(), numbers.values.end());
  return f;
}

std::string refusal(const InfluenceFunction& f, const ExpandOptions& options) {
  return message_of([&] { expand(f, options); });
}

} // namespace

TEST(ExpandTable, WholeMultiplesAreExactSums) {
  const InfluenceFunction f = halfspace_table();
  for (const auto& [dx, offsets] : {std::pair{0.25, 24}, {0.5, 12}, {0.75, 8}, {1.5, 4}})
    EXPECT_LT(expansion_error(f, dx, offsets), 1e-11) << dx;
}

TEST(ExpandTable, ServesARunOfStations) {
  const InfluenceNumbers all =
      expand(halfspace_table(), {.dx = 0.5, .offsets = 3, .structural = StructuralCompliance::included});
  const InfluenceNumbers some = expand(halfspace_table(), {.dx = 0.5,
                                                           .offsets = 3,
                                                           .structural = StructuralCompliance::included,
                                                           .first_station = 2,
                                                           .stations = 2});
  EXPECT_EQ(some.rows, 2);
  EXPECT_EQ(some.at(2, 1, component_x, 0, component_n), all.at(2, 3, component_x, 2, component_n));
}

TEST(ExpandTable, RefusesOtherLengthsAndWhatItDoesNotKnow) {
  using testing::HasSubstr;
  const InfluenceFunction f = halfspace_table();
  constexpr auto included = StructuralCompliance::included;
  for (const double dx : {0.3, 0.125, 0.0})
    EXPECT_THAT(refusal(f, {.dx = dx, .structural = included}), HasSubstr("a whole multiple of it")) << dx;
  EXPECT_THAT(refusal(f, {.dx = 0.5, .offsets = 13, .structural = included}),
              HasSubstr("The patch is longer than the table"));
  EXPECT_THAT(refusal(f, {.dx = 0.25}), HasSubstr("Use structural compliance 'included'"));
}
