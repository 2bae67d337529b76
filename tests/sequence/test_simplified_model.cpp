#include "bem_contact/sequence/plan/simplified_model.hpp"

#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <numbers>

/// The simplified theory: against its closed forms on an ellipse, and beside the half-space.
namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

constexpr double half_x = 8e-4, half_s = 1.6e-3, load = 5e4;
const Material steel{};

SceneFile ellipse(const std::string& motion, const std::string& more = "", const char* model = "simplified") {
  return parse_scene_file(fmt::format("kind = 'patch'\nload.force = {}\nsolver.model = "
                                      "'{}'\n{}\n[motion]\n{}\n[grid]\ndx = 0.25\nds = 0.2\nmx = 64\n"
                                      "ms = 56\n[gap]\na = {}\nb = {}\n",
                                      load, model, more, motion, half_x, half_s));
}

SceneResult solved_simply(const SceneFile& scene) {
  SceneResult r = Sequence().solve(scene);
  EXPECT_TRUE(certified(r)) << r.result.trust.solver_note;
  return r;
}

struct Exact {
  reference::HertzContact hertz =
      reference::hertz_by_force(half_x, half_s, reference::contact_modulus(steel, steel), load);
  double a = hertz.semi_axis_x, b = hertz.semi_axis_s;
  reference::CreepCoefficients c = reference::creep_coefficients(a / b, steel.poisson);
};

/// Without slip it has the forces of linear theory, which its flexibilities were made for.
TEST(SimplifiedModel, HasTheForcesOfLinearTheoryWithoutSlip) {
  const Exact e;
  const double xi = 1e-5, eta = -2e-5, phi = 4e-6, g = steel.shear_modulus, area = e.a * e.b;
  const SceneResult r =
      solved_simply(ellipse(fmt::format("friction = 0.9\nxi = {}\neta = {}\nphi = {}", xi, eta, phi)));
  EXPECT_NEAR(r.result.totals.Fx, area * g * e.c.c11 * xi, 0.02 * r.result.totals.Fx);
  const double fs = area * g * (e.c.c22 * eta + std::sqrt(area) * e.c.c23 * phi);
  EXPECT_NEAR(r.result.totals.Fs, fs, 0.02 * area * g * e.c.c22 * std::abs(eta));
  EXPECT_EQ(r.result.patches.size(), 1u);
  EXPECT_NEAR(r.result.totals.approach, e.hertz.approach, 0.02 * e.hertz.approach);
}

/// On a quadratic distance the pressure is Hertz's, however long the ellipse is along x or s, and though the
/// grid is hardly larger than the contact.
TEST(SimplifiedModel, HasHertzsPressureOnAnyEllipse) {
  for (const auto& [along, across] : {std::pair(1e-3, 1.1e-3), {2e-4, 3e-3}, {3e-3, 2e-4}, {1e-4, 3e-3}})
    for (const int count : {24, 60}) {
      const reference::HertzContact hertz =
          reference::hertz_by_force(along, across, reference::contact_modulus(steel, steel), 2e4);
      const SceneResult r = solved_simply(parse_scene_file(fmt::format(
          "kind = 'patch'\nload.force = 2e4\nsolver.model = 'simplified'\nmotion.friction = 0.3\n"
          "motion.xi = 1e-3\n[grid]\ndx = {}\nds = {}\nmx = {}\nms = {}\n[gap]\na = {}\nb = {}\n",
          2.3 * hertz.semi_axis_x / count, 2.3 * hertz.semi_axis_s / count, count, count, along, across)));
      EXPECT_NEAR(r.result.totals.pmax, hertz.max_pressure, 0.012 * hertz.max_pressure)
          << along << " " << across;
    }
}

/// Pure longitudinal creepage on a paraboloid of pressure 2 N / (pi a b): in a row of half length alpha a the
/// traction grows by xi / L from the leading edge until it meets the bound. With tau = xi a / (L mu p0) the
/// sum is, over mu p0 a b, 2 int (2 tau c^3 - tau^2 c^2 + tau^3 c / 6) dt up to cos t = tau / 2 and 2 int 4/3
/// c^4 dt beyond.
TEST(SimplifiedModel, SlipsAsTheClosedFormDoes) {
  const Exact e;
  const double flexibility = 8 * e.a / (3 * e.c.c11 * steel.shear_modulus), friction = 0.3,
               bound = friction * 2 * load / (std::numbers::pi * e.a * e.b);
  for (const double tau : {0.3, 0.8, 1.4, 3.0}) {
    const double t = std::acos(std::min(1.0, tau / 2));
    const auto power2 = [](double u) { return u / 2 + std::sin(2 * u) / 4; };
    const auto power3 = [](double u) { return std::sin(u) - std::pow(std::sin(u), 3) / 3; };
    const auto power4 = [](double u) { return 3 * u / 8 + std::sin(2 * u) / 4 + std::sin(4 * u) / 32; };
    const double exact = 2 * bound * e.a * e.b *
                         (2 * tau * power3(t) - tau * tau * power2(t) + tau * tau * tau / 6 * std::sin(t) +
                          4.0 / 3 * (power4(std::numbers::pi / 2) - power4(t)));
    const SceneResult r = solved_simply(
        ellipse(fmt::format("friction = {}\nxi = {:.12g}", friction, tau * flexibility * bound / e.a)));
    EXPECT_NEAR(r.result.totals.Fx, exact, 0.015 * exact) << tau;
  }
  EXPECT_NEAR(solved_simply(ellipse("friction = 0.3\nxi = 0.05")).result.totals.Fx, friction * load,
              1e-6 * load);
}

/// A layer is one more flexibility in series with each of the three.
TEST(SimplifiedModel, TakesALayer) {
  const Exact e;
  const double xi = 1e-5, compliance = 5e-5;
  const SceneResult r =
      solved_simply(ellipse("friction = 0.9\nxi = 1e-5", fmt::format("layer.compliance = {}", compliance)));
  const double flexibility = 8 * e.a / (3 * e.c.c11 * steel.shear_modulus) + compliance;
  EXPECT_NEAR(r.result.totals.Fx, 8 * e.a * e.a * e.b * xi / (3 * flexibility), 0.02 * r.result.totals.Fx);
  EXPECT_THAT(message_of([] { Sequence().solve(ellipse("xi = 1e-5", "layer.slope = 0.6")); }),
              HasSubstr("slope"));
}

TEST(SimplifiedModel, FindsCreepagesOfForces) {
  const SceneResult given = solved_simply(ellipse("friction = 0.3\nxi = 8e-4\neta = -4e-4\nphi = 1e-4"));
  const SceneResult found = solved_simply(ellipse(
      "friction = 0.3\nphi = 1e-4", fmt::format("load.force_x = {:.12g}\nload.force_s = {:.12g}",
                                                given.result.totals.Fx.value, given.result.totals.Fs.value)));
  EXPECT_NEAR(found.motion.xi, 8e-4, 1e-8);
  EXPECT_NEAR(found.motion.eta, -4e-4, 1e-8);
  EXPECT_THAT(message_of([] { Sequence().solve(ellipse("friction = 0.3", "load.force_x = 2e4")); }),
              HasSubstr("friction carries at most 15000 N"));
}

TEST(SimplifiedModel, RefusesWhatItIsNotFor) {
  const auto refusal = [](const std::string& motion) {
    return message_of([&] { Sequence().solve(ellipse(motion)); });
  };
  EXPECT_THAT(refusal("frictionless = true"), HasSubstr("it is about friction"));
  EXPECT_THAT(refusal("kind = 'transient'\nxi = 1e-3"), HasSubstr("steady rolling"));
  EXPECT_THAT(refusal("kind = 'shift'\nxi = 1e-3"), HasSubstr("steady rolling"));
  EXPECT_THAT(refusal("friction = 0.3\nkinetic_friction = 0.2\nxi = 1e-3"), HasSubstr("Coulomb"));
}

/// Friction that falls with slip: where everything slips, it is the law's at the creepage; before, it is
/// beside the half-space's as it is without a fall. On very small elements friction would jump.
TEST(SimplifiedModel, FrictionFallsWithSlip) {
  const double speed = 1e4, most = 0.33, least = 0.14, half = 1250;
  const auto law = [&](double xi) { return least + (most - least) * std::exp2(-xi * speed / half); };
  const std::string falling =
      fmt::format("friction = {}\nfalling_friction = {}\nhalf_slip_velocity = {}\nspeed = {}\n", most, least,
                  half, speed);
  for (const double xi : {0.06, 0.2})
    EXPECT_NEAR(solved_simply(ellipse(falling + fmt::format("xi = {}", xi))).result.totals.Fx, law(xi) * load,
                0.01 * law(xi) * load)
        << xi;
  for (const double xi : {1e-3, 3e-3, 0.01}) {
    const auto by = [&](const char* model) {
      return double(solved_simply(ellipse(falling + fmt::format("xi = {}", xi), "", model)).result.totals.Fx);
    };
    EXPECT_NEAR(by("simplified"), by("halfspace"), 0.035 * most * load) << xi;
  }
  const std::string constant =
      fmt::format("friction = {0}\nfalling_friction = {0}\nhalf_slip_velocity = {1}\nspeed = {2}\nxi = 2e-3",
                  most, half, speed);
  EXPECT_EQ(solved_simply(ellipse(constant)).result.totals.Fx,
            solved_simply(ellipse("friction = 0.33\nxi = 2e-3")).result.totals.Fx);
  const std::string steep = "friction = 0.33\nfalling_friction = 0.14\nhalf_slip_velocity = 1\nspeed = 1e4\n";
  EXPECT_THAT(message_of([&] { Sequence().solve(ellipse(steep + "xi = 0.01")); }),
              HasSubstr("too small for friction that falls"));
}

/// However large an error is allowed, nobody gets it without asking for it.
TEST(SimplifiedModel, IsTakenByNameAlone) {
  SceneFile scene = with_model(ellipse("friction = 0.3\nxi = 1e-3"), std::nullopt);
  scene.solver.model_tolerance = 10;
  EXPECT_EQ(Sequence().solve(scene).choice.model, Model::halfspace);
}

/// What it misses of the half-space, as the table of theory/contact.md says: on tread and flange, with and
/// without spin.
TEST(SimplifiedModel, BesideTheHalfSpace) {
  double worst_tread = 0, worst_flange = 0, least_predicted = 1, worst_predicted = 0;
  for (const char* lateral : {"0", "3", "5.5", "6.4", "7.2"})
    for (const char* creepage : {"xi = 3e-4", "xi = 1e-3", "xi = 5e-3", "eta = 1e-3", "eta = 4e-3",
                                 "xi = 1e-3\neta = 2e-3", "phi = 3e-4", "eta = 1e-3\nphi = 6e-4"}) {
      const auto solve_by = [&](const char* model) {
        return solved_simply(parse_scene_file(fmt::format(
            "rail.profile = '60E1'\nwheel.profile = 'S1002'\nposition.lateral = {}\nload.force = 8e4\n"
            "solver.model = '{}'\ngrid = {{ dx = 0.4, ds = 0.25 }}\n[motion]\nfree_rolling = false\n{}\n",
            lateral, model, creepage)));
      };
      const SceneResult simple = solve_by("simplified"), full = solve_by("halfspace");
      const double capacity = 0.3 * 8e4,
                   missed = std::hypot(simple.result.totals.Fx - full.result.totals.Fx,
                                       simple.result.totals.Fs - full.result.totals.Fs) /
                            capacity;
      double& worst = lateral < std::string("5") ? worst_tread : worst_flange;
      worst = std::max(worst, missed);
      // It says how much it is predicted to miss.
      const std::string why = simple.choice.why_this_model, forces = "simplified theory: forces ";
      const auto at = why.find(forces);
      ASSERT_NE(at, std::string::npos) << why;
      const double predicted = 0.01 * std::stod(why.substr(at + forces.size()));
      EXPECT_LE(missed, predicted) << lateral << " " << creepage;
      worst_predicted = std::max(worst_predicted, predicted);
      least_predicted = std::min(least_predicted, predicted);
    }
  EXPECT_LT(least_predicted, 0.09) << "on the tread";
  EXPECT_LT(worst_predicted, 0.6);
  EXPECT_LT(worst_tread, 0.045);
  EXPECT_LT(worst_flange, 0.28);
}

} // namespace
