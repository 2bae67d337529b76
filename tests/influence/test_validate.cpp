#include "bem_contact/influence/requirements.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

using namespace bem_contact;

TEST(Validate, AcceptsASoundFunction) {
  EXPECT_NO_THROW(validate(sample_function()));
}

TEST(Validate, NamesWhatIsWrong) {
  const auto refusal = [](const std::function<void(InfluenceFunction&)>& spoil) {
    InfluenceFunction f = sample_function();
    spoil(f);
    return message_of([&] { validate(f); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using testing::HasSubstr;
  EXPECT_THAT(refusal([&](auto& f) { f.kernel.pop_back(); }), HasSubstr("kernel has the wrong size"));
  EXPECT_THAT(refusal([&](auto& f) { f.kernel[200] = nan; }), HasSubstr("kernel is not finite"));
  EXPECT_THAT(refusal([&](auto& f) { f.kernel[0] = -1e-6; }), HasSubstr("diagonal is not positive"));
  EXPECT_THAT(refusal([&](auto& f) { f.remote.clear(); }), HasSubstr("remote motions has the wrong size"));
  EXPECT_THAT(refusal([&](auto& f) { f.remote_self[3] = nan; }), HasSubstr("own compliance is not finite"));
  EXPECT_THAT(refusal([&](auto& f) { f.stations.clear(); }), HasSubstr("no stations"));
  EXPECT_THAT(refusal([&](auto& f) { f.stations[2].s += 0.01; }), HasSubstr("not equally spaced"));
  EXPECT_THAT(refusal([&](auto& f) { std::swap(f.stations[1], f.stations[2]); }),
              HasSubstr("not equally spaced"));
  EXPECT_THAT(refusal([&](auto& f) { f.stations[1].delta = nan; }), HasSubstr("station 1 is not finite"));
  EXPECT_THAT(refusal([&](auto& f) { f.station_width = 0; }), HasSubstr("station width is not positive"));
  EXPECT_THAT(refusal([&](auto& f) { f.wavenumber.clear(); }), HasSubstr("no wavenumbers"));
  EXPECT_THAT(refusal([&](auto& f) { f.wavenumber[0] = 0.1; }), HasSubstr("first wavenumber is not 0"));
  EXPECT_THAT(refusal([&](auto& f) { f.wavenumber[3] = f.wavenumber[2]; }), HasSubstr("do not ascend"));
  EXPECT_THAT(refusal([&](auto& f) { f.material.shear_modulus = 0; }), HasSubstr("shear modulus"));
  EXPECT_THAT(refusal([&](auto& f) { f.material.poisson = 0.5; }), HasSubstr("Poisson"));
  EXPECT_THAT(refusal([&](auto& f) { f.half_period = nan; }), HasSubstr("half period"));
  EXPECT_THAT(refusal([&](auto& f) { f.invariance = Invariance::revolution; }),
              HasSubstr("reference radius"));
  EXPECT_THAT(refusal([&](auto& f) {
                f.invariance = Invariance::revolution;
                f.reference_radius = 460;
              }),
              HasSubstr("not half a turn"));
  EXPECT_THAT(refusal([&](auto& f) { f.estimated_error = nan; }), HasSubstr("error estimates"));
}

TEST(RequireOrder, ALowerBodyIsTheRail) {
  const InfluenceFunction rail = sample_function();
  InfluenceFunction wheel = rail;
  wheel.body = "a wheel";
  for (Station& station : wheel.stations)
    station.delta += 3.1;
  EXPECT_NO_THROW(require_order(rail, wheel));
  EXPECT_NO_THROW(require_order(rail, rail)) << "one block serves as both";
  EXPECT_THAT(message_of([&] { require_order(wheel, rail); }),
              testing::AllOf(testing::HasSubstr("The two influence files are exchanged"),
                             testing::HasSubstr("'a wheel', which is given as the rail, lies above")));
}
