#include "bem_contact/contact/layer.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <random>

namespace bem_contact {
namespace {

constexpr double force = 1e4; // N

/// Undeformed distance a x^2 + b s^2 under `force`; the grid is a quarter larger than Hertz's ellipse, which
/// has so many elements across and `spare` elements beside it, and is shifted by parts of an element.
ContactProblem ellipse(double a, double b, int across, double shift_x, double shift_s, int spare = 2) {
  const double modulus = 82000 / (1 - 0.28);
  const reference::HertzContact exact = reference::hertz_by_force(a, b, modulus, force);
  const int count = across * 5 / 4 + spare;
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, count, count,
                                        2 * exact.semi_axis_x / across, 2 * exact.semi_axis_s / across, a, b);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double x = problem.grid.x(i % problem.grid.mx) + shift_x * problem.grid.dx;
    const double s = problem.rows[i / problem.grid.mx].s + shift_s * problem.grid.ds;
    problem.gap[i] = a * x * x + b * s * s;
  }
  problem.force = force;
  return problem;
}

struct Tally {
  int cases = 0, held = 0;
  std::vector<double> ratios;

  void add(const Measured& number, double exact) {
    const double true_error = std::abs(number - exact);
    ++cases;
    held += true_error <= number.error;
    ratios.push_back(number.error / true_error);
  }
  double share() const { return double(held) / cases; }
  double median() {
    std::ranges::nth_element(ratios, ratios.begin() + cases / 2);
    return ratios[static_cast<std::size_t>(cases / 2)];
  }
};

/// The power of friction does not depend on how many columns of the grid lie beside the contact: here one on
/// the side that it is shifted to.
TEST(Power, IsThatOfTheContactWhateverLiesBesideIt) {
  const auto power = [](double shift) {
    ContactProblem problem = ellipse(1e-3, 2e-3, 20, shift, 0);
    scenes::set_creepage(problem, 0.3, 4e-4, -3e-4, 0);
    const ContactResult result = solve(problem);
    EXPECT_TRUE(result.certified() && !result.trust.touches_border) << shift;
    return result.totals.T_gamma.value;
  };
  for (const double shift : {-2.0, 2.0})
    EXPECT_NEAR(power(shift) / power(0), 1, 1e-5) << shift;
}

/// Too few elements: nothing is estimated, and the result says why and what to do.
TEST(ErrorEstimates, SayWhyThereAreNone) {
  const ContactResult coarse = solve(ellipse(1e-3, 1e-3, 10, 0, 0));
  EXPECT_FALSE(coarse.trust.discretisation);
  EXPECT_NE(coarse.trust.why_no_errors.find("40 are needed. Give smaller elements"), std::string::npos)
      << coarse.trust.why_no_errors;
  EXPECT_EQ(solve(ellipse(1e-3, 1e-3, 20, 0, 0)).trust.why_no_errors, "");
  SolverOptions options;
  options.estimate_discretisation = false;
  EXPECT_NE(solve(ellipse(1e-3, 1e-3, 20, 0, 0), options).trust.why_no_errors, "");
}

/// In one row of elements there is no border that averages out: against Carter 1926.
TEST(ErrorEstimates, HoldOnRows) {
  const double radius = 500, mu = 0.3, length = 4e4;
  const double fn = std::numbers::pi * 82000 / (4 * radius * (1 - 0.28)); // N/mm, for a half width of 1 mm
  Tally fx, pmax, area;
  for (double across = 16.3; across <= 100; across += 2.61) // the ends of the contact lie within elements
    for (const double adhering : {0.2, 0.4, 0.6, 0.8}) {
      ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, static_cast<int>(1.2 * across), 1,
                                            2 / across, length, 0.5 / radius, 0);
      problem.force = fn * length;
      scenes::set_creepage(problem, mu, mu * (1 - adhering) / radius, 0, 0);
      const ContactResult result = solve(problem);
      ASSERT_TRUE(result.certified() && result.trust.discretisation) << across;
      const ContactTotals& totals = result.totals;
      fx.add(totals.Fx, (1 - adhering * adhering) * mu * fn * length);
      pmax.add(totals.pmax, 2 * fn / std::numbers::pi);
      area.add(totals.area, 2 * length);
    }
  for (Tally* tally : {&fx, &pmax, &area}) {
    EXPECT_GE(tally->share(), 0.95);
    EXPECT_LE(tally->median(), 5);
  }
}

/// What the numbers are said to mean, against Hertz (Johnson 1985, chapter 4).
TEST(ErrorEstimates, HoldOnHertzContacts) {
  NEEDS_NO_SANITIZER();
  const double modulus = 82000 / (1 - 0.28);
  Tally pmax, area, approach;
  for (const double b : {1e-3, 2e-3, 5e-3})
    for (int across = 16; across <= 30; across += 2)
      for (const double shift : {0.0, 0.3, 0.5}) {
        const ContactResult result = solve(ellipse(1e-3, b, across, shift, 0.7 * shift));
        ASSERT_TRUE(result.certified() && result.trust.discretisation) << across;
        ASSERT_TRUE(result.trust.discretisation->converges) << across;
        const reference::HertzContact exact = reference::hertz_by_force(1e-3, b, modulus, force);
        const ContactTotals& totals = result.totals;
        pmax.add(totals.pmax, exact.max_pressure);
        area.add(totals.area, std::numbers::pi * exact.semi_axis_x * exact.semi_axis_s);
        approach.add(totals.approach, exact.approach);
        EXPECT_EQ(totals.Fz.error, 0) << "prescribed";
        EXPECT_EQ(totals.Fx.error, 0) << "without friction";
        ASSERT_EQ(result.patches.size(), 1u);
        EXPECT_EQ(result.patches[0].fn.error, 0) << "prescribed, because the surface is flat";
        EXPECT_EQ(result.patches[0].pmax.error, totals.pmax.error);
        EXPECT_EQ(result.patches[0].area.error, totals.area.error);
      }
  for (Tally* tally : {&pmax, &area, &approach}) {
    EXPECT_GE(tally->share(), 0.95);
    EXPECT_LE(tally->median(), 5);
  }
}

/// The hottest point of a contact that slides as a whole, where elastic slip is nothing beside the creepage:
/// 0.6173 mu p0 v sqrt(a/V)/effusivity above the bulk on a line of Hertz's pressure
/// (theory/estimates_and_heat.md, section 3), and so on the centre line of an ellipse. A wheel that is hotter
/// than the contact stays so.
TEST(ErrorEstimates, HoldForTheHottestPoint) {
  NEEDS_NO_SANITIZER();
  const double modulus = 82000 / (1 - 0.28), creepage = 100, friction = 0.3;
  Tally hottest;
  for (const double b : {1e-3, 2e-3, 5e-3})
    for (int across = 16; across <= 30; across += 2)
      for (const double shift : {0.0, 0.3, 0.5}) {
        ContactProblem problem = ellipse(1e-3, b, across, shift, 0.7 * shift);
        scenes::set_creepage(problem, friction, creepage, 0, 0);
        problem.speed = 2e4;
        problem.heating = Heating{};
        const ContactResult result = solve(problem);
        ASSERT_TRUE(result.certified() && result.trust.discretisation && result.temperatures) << across;
        const reference::HertzContact exact = reference::hertz_by_force(1e-3, b, modulus, force);
        const double rise = 0.6173 * friction * exact.max_pressure * creepage *
                            std::sqrt(exact.semi_axis_x * problem.speed) / ThermalBody{}.effusivity();
        hottest.add(result.totals.Tmax_rail, rise);
      }
  fmt::print("hottest point: {:.0f} % held, median of stated over true {:.1f}\n", 100 * hottest.share(),
             hottest.median());
  EXPECT_GE(hottest.share(), 0.95);
  EXPECT_LE(hottest.median(), 5);
  ContactProblem problem = ellipse(1e-3, 1e-3, 20, 0, 0);
  scenes::set_creepage(problem, friction, creepage, 0, 0);
  problem.speed = 2e4;
  problem.heating = Heating{};
  problem.heating->wheel.temperature = 1e7;
  EXPECT_EQ(solve(problem).totals.Tmax_wheel.error, 0);
  problem.heating.reset();
  EXPECT_TRUE(std::isnan(solve(problem).totals.Tmax_rail.error));
}

/// The force at a given approach, against Hertz.
TEST(ErrorEstimates, HoldForAForceThatIsFound) {
  NEEDS_NO_SANITIZER();
  const double modulus = 82000 / (1 - 0.28);
  Tally fz, fn;
  for (const double b : {1e-3, 2e-3, 5e-3})
    for (int across = 16; across <= 30; across += 2)
      for (const double shift : {0.0, 0.3, 0.5}) {
        ContactProblem problem = ellipse(1e-3, b, across, shift, 0.7 * shift);
        problem.load = LoadKind::approach;
        problem.approach = reference::hertz_by_force(1e-3, b, modulus, force).approach;
        const ContactResult result = solve(problem);
        ASSERT_TRUE(result.certified() && result.trust.discretisation) << across;
        EXPECT_EQ(result.totals.approach.error, 0) << "prescribed";
        fz.add(result.totals.Fz, force);
        fn.add(result.patches[0].fn, force);
      }
  for (Tally* tally : {&fz, &fn}) {
    EXPECT_GE(tally->share(), 0.95);
    EXPECT_LE(tally->median(), 5);
  }
}

/// Rolling from nearly full adhesion to full slip, on `across` elements, on rows that are inclined by
/// `delta`.
ContactProblem rolling(int across, double xi, double phi, double delta) {
  ContactProblem problem = ellipse(1e-3, 2e-3, across, 0, 0);
  scenes::set_creepage(problem, 0.3, xi, 0.5 * xi, phi);
  for (ContactRow& row : problem.rows)
    row.delta = delta;
  return problem;
}

/// Shear against the same problem on elements a third as large. Of so few cases one may be
/// outside: the errors are meant for 95 in 100.
TEST(ErrorEstimates, HoldForShearForces) {
  NEEDS_NO_SANITIZER();
  Tally fx, fs, power;
  for (const double xi : {1e-4, 3e-4, 1e-3})
    for (const double phi : {0.0, 2e-4, 4e-4}) {
      const ContactProblem problem = rolling(16, xi, phi, 0), fine_problem = rolling(48, xi, phi, 0);
      const ContactResult result = solve(problem);
      const ContactResult fine = solve(fine_problem, {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified());
      fx.add(result.totals.Fx, fine.totals.Fx);
      fs.add(result.totals.Fs, fine.totals.Fs);
      power.add(result.totals.T_gamma, fine.totals.T_gamma);
      EXPECT_LE(std::abs(result.totals.Mz - fine.totals.Mz),
                result.trust.discretisation->moment_error(result.totals, 0, 0))
          << xi;
    }
  for (const Tally* tally : {&fx, &fs, &power})
    EXPECT_GE(tally->held + 1, tally->cases);
}

/// Where most elements stick, each is off by little of its traction along x: an error as large as that of Fs
/// would be stated ten times too large.
TEST(ErrorEstimates, OfFxAreNotTooLargeInAdhesion) {
  NEEDS_NO_SANITIZER();
  Tally fx;
  for (const double eta : {0.0, 1e-4})
    for (int across = 16; across <= 24; across += 2)
      for (const double shift : {0.1, 0.25, 0.4}) {
        const auto driven = [&](int finer) {
          ContactProblem problem = ellipse(1e-3, 2e-3, finer * across, 0.7 * shift * finer, shift * finer);
          scenes::set_creepage(problem, 0.3, 1e-4 + eta, eta, 0);
          return solve(problem, {.estimate_discretisation = finer == 1});
        };
        const ContactResult result = driven(1), fine = driven(3);
        ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified());
        fx.add(result.totals.Fx, fine.totals.Fx);
      }
  fmt::print("Fx in adhesion: {:.0f} % held, median of stated over true {:.1f}\n", 100 * fx.share(),
             fx.median());
  EXPECT_GE(fx.share(), 0.95);
  EXPECT_LE(fx.median(), 8);
}

/// On an inclined surface the pressure makes up for what the shear tractions bear of the vertical force, so
/// their error is also one of the normal force and, by 1 / cos(delta), of Fy.
TEST(ErrorEstimates, OfShearReachOtherForcesOnAnIncline) {
  NEEDS_NO_SANITIZER();
  constexpr double delta = 1;
  Tally fy, fn;
  for (const double xi : {1e-4, 3e-4, 1e-3})
    for (const double phi : {0.0, 2e-4, 4e-4}) {
      const ContactResult result = solve(rolling(16, xi, phi, delta));
      const ContactResult fine = solve(rolling(48, xi, phi, delta), {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified());
      const ContactTotals& totals = result.totals;
      fy.add(totals.Fy, fine.totals.Fy);
      fn.add(result.patches[0].fn, fine.patches[0].fn);
      EXPECT_EQ(totals.Fz.error, 0) << "prescribed";
      EXPECT_NEAR(totals.Fy.error, result.patches[0].fs.error / std::cos(delta), 0.02 * totals.Fy.error);
    }
  for (const Tally* tally : {&fy, &fn})
    EXPECT_GE(tally->held + 1, tally->cases);
}

/// A prescribed shear force has no error; that of the creepage found for it holds.
TEST(ErrorEstimates, HoldForCreepagesFound) {
  NEEDS_NO_SANITIZER();
  Tally xi;
  for (const double share : {-0.6, 0.2, 0.4, 0.6, 0.8})
    for (const double phi : {0.0, 2e-4}) {
      const auto pulled = [&](int across) {
        ContactProblem problem = rolling(across, 0, phi, 0);
        problem.force_x = share * 0.3 * force;
        return problem;
      };
      const ContactResult result = solve(pulled(16));
      const ContactResult fine = solve(pulled(48), {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified());
      EXPECT_EQ(result.totals.Fx.error, 0);
      EXPECT_EQ(result.patches[0].fx.error, 0);
      EXPECT_LT(result.totals.creepage_x.error, 0.1 * std::abs(result.totals.creepage_x));
      xi.add(result.totals.creepage_x, fine.totals.creepage_x);
    }
  EXPECT_GE(xi.held + 1, xi.cases);
}

/// Under spin most of the error is that the contact's front meets another w_s. The mean of a few cases.
TEST(ErrorEstimates, HoldForTheLateralCreepageFoundUnderSpin) {
  NEEDS_NO_SANITIZER();
  Tally eta;
  for (const double share : {-0.6, -0.2, 0.2, 0.4, 0.6})
    for (const double phi : {-4e-4, 2e-4, 4e-4}) {
      const auto pulled = [&](int across) {
        ContactProblem problem = rolling(across, 0, phi, 0);
        problem.force_s = share * 0.3 * force;
        return problem;
      };
      const ContactResult result = solve(pulled(18));
      const ContactResult fine = solve(pulled(72), {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified());
      eta.add(result.totals.creepage_s, fine.totals.creepage_s);
    }
  EXPECT_GE(eta.held + 1, eta.cases);
  EXPECT_LE(eta.median(), 10);
}

/// Where Fz and Fs are prescribed, Fy is known but for the direction of the pressure.
TEST(ErrorEstimates, OfFyUnderAPrescribedFsAreThoseOfTheDirection) {
  NEEDS_NO_SANITIZER();
  const auto pulled = [](int across, double turn) {
    ContactProblem problem = rolling(across, 1e-3, 2e-4, 0.6);
    for (ContactRow& row : problem.rows)
      row.delta += turn * row.s;
    problem.force_s = 0.1 * force;
    return problem;
  };
  const ContactResult flat = solve(pulled(20, 0));
  ASSERT_TRUE(flat.certified() && flat.trust.discretisation);
  EXPECT_LT(flat.totals.Fy.error, 1e-7 * force);
  const ContactResult turning = solve(pulled(20, 0.02));
  const ContactResult fine = solve(pulled(80, 0.02), {.estimate_discretisation = false});
  ASSERT_TRUE(turning.certified() && turning.trust.discretisation && fine.certified());
  EXPECT_LE(std::abs(turning.totals.Fy - fine.totals.Fy), turning.totals.Fy.error);
  EXPECT_LT(turning.totals.Fy.error, 2e-4 * force);
}

/// Two patches, between which larger elements close the gap: then nothing is known of each, and a prescribed
/// force, which is that of both, is not the force of the first.
TEST(ErrorEstimates, OfPatchesThatLargerElementsJoinAreUnknown) {
  ContactProblem problem = rolling(40, 0, 0, 0);
  const double half = 0.12 * problem.grid.ms * problem.grid.ds; // mm, from the middle to the lowest lines
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double s = problem.rows[i / problem.grid.mx].s, x = problem.grid.x(i % problem.grid.mx);
    problem.gap[i] = 1e-3 * x * x + 2e-3 * std::pow(std::abs(s) - half, 2);
  }
  problem.force = 0.1 * force;
  problem.force_x = 0.06 * problem.force;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified() && result.trust.discretisation && result.trust.discretisation->converges);
  ASSERT_EQ(result.patches.size(), 2u);
  for (const PatchSummary& patch : result.patches) {
    EXPECT_TRUE(std::isnan(patch.fn.error));
    EXPECT_TRUE(std::isnan(patch.fx.error));
  }
}

/// Free rolling beside lateral creepage at which nearly all elements slip, on a contact that is wider on one
/// side, at parts of an element. Spin gives each row another creepage: free rolling is where the centre of
/// pressure has none. There Fx hardly changes with the creepage, so that a small error of it is a large one.
TEST(ErrorEstimates, HoldForFreeRollingInFullSlip) {
  NEEDS_NO_SANITIZER();
  const auto free = [](int across, double shift, int finer, double eta) {
    ContactProblem problem = ellipse(1e-3, 2e-3, finer * across, 0.7 * shift * finer, shift * finer, 4);
    const double side = 0.2 / reference::hertz_by_force(1e-3, 2e-3, 82000 / (1 - 0.28), force).semi_axis_s;
    for (int i = 0; i < problem.grid.size(); ++i) {
      const double s = problem.rows[i / problem.grid.mx].s + shift * finer * problem.grid.ds;
      problem.gap[i] += 2e-3 * s * s * side * s;
    }
    scenes::set_creepage(problem, 0.3, 0, eta, 3e-4);
    problem.force_x = 0;
    return solve(problem, {.estimate_discretisation = finer == 1});
  };
  Tally xi;
  for (const double eta : {4e-3, 2e-2})
    for (int across = 16; across <= 24; across += 2)
      for (const double shift : {0.1, 0.25, 0.4}) {
        const ContactResult result = free(across, shift, 1, eta), fine = free(across, shift, 3, eta);
        ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified() &&
                    !fine.trust.touches_border);
        xi.add(result.totals.creepage_x, fine.totals.creepage_x);
      }
  fmt::print("free rolling in full slip: {:.0f} % held, median of stated over true {:.1f}\n",
             100 * xi.share(), xi.median());
  EXPECT_GE(xi.share(), 0.95);
  EXPECT_LE(xi.median(), 6);
}

/// Heat flows in where waves of the tractions end, too: with a layer the slip of large elements shows a part
/// of it.
TEST(ErrorEstimates, HoldForTemperaturesWithALayer) {
  NEEDS_NO_SANITIZER();
  Tally temperatures, powers;
  for (const double compliance : {0.0, 1e-5, 3e-5})
    for (const double xi : {5e-4, 1e-3, 3e-3})
      for (const double shift : {0.0, 0.1, 0.2, 0.3, 0.4}) {
        const auto solved = [&](int across) {
          const double moved = shift * across / 20; // elements: at the same place, about which it spins
          ContactProblem problem = ellipse(1e-3, 1.6e-3, across, moved, -moved);
          scenes::set_creepage(problem, 0.3, xi, 0.3 * xi, 2e-4);
          add_layer({{compliance}, 0}, problem.numbers);
          problem.speed = 3e4;
          problem.heating.emplace();
          return solve(problem);
        };
        const ContactResult coarse = solved(20), fine = solved(80);
        ASSERT_TRUE(coarse.certified() && fine.certified());
        powers.add(coarse.totals.T_gamma, fine.totals.T_gamma);
        if (std::isfinite(coarse.totals.Tmax_rail.error))
          temperatures.add(coarse.totals.Tmax_rail, fine.totals.Tmax_rail);
      }
  fmt::print("temperatures: {:.0f} % of {} held, median {:.1f}, least {:.2f}; powers: {:.0f} %, {:.1f}\n",
             100 * temperatures.share(), temperatures.cases, temperatures.median(),
             std::ranges::min(temperatures.ratios), 100 * powers.share(), powers.median());
  EXPECT_GE(temperatures.cases, 12);
  EXPECT_GE(temperatures.share(), 0.95);
  EXPECT_GE(powers.share(), 0.95);
}

/// With noise of some micrometres smaller elements show another pressure: no number may be stated.
TEST(ErrorEstimates, NoisySurfacesHaveNone) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 2e-3); // mm
  ContactProblem problem = ellipse(1e-3, 2e-3, 24, 0, 0);
  for (int is = 0; is < problem.grid.ms; ++is) {
    const double of_row = noise(random);
    for (int ix = 0; ix < problem.grid.mx; ++ix)
      problem.gap[is * problem.grid.mx + ix] += of_row;
  }
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified() && result.trust.discretisation);
  EXPECT_FALSE(result.trust.discretisation->converges);
  EXPECT_TRUE(std::isnan(result.totals.pmax.error));
  EXPECT_TRUE(std::isnan(result.totals.area.error));
  EXPECT_TRUE(std::isnan(result.trust.discretisation->moment_error(result.totals, 0, 0)));
  ASSERT_FALSE(result.patches.empty());
  EXPECT_TRUE(std::isnan(result.patches[0].fn.error));
}

} // namespace
} // namespace bem_contact
