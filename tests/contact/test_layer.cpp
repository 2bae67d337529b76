#include "bem_contact/contact/layer.hpp"

#include "bem_contact/contact/history.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

/// A compliant layer between the surfaces: against the simplified theory in closed form, which is exact where
/// the bodies are stiff, and against a slow dense solution.
namespace bem_contact {
namespace {

using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

ContactResult certified(const ContactProblem& problem, SolverOptions options = scenes::without_estimate) {
  ContactResult result = solve(problem, options);
  EXPECT_TRUE(result.certified()) << result.trust.solver_note << ' ' << result.trust.certificate.worst();
  return result;
}

/// A layer of compliance 1e-4 mm^3/N under shear and pressure between bodies whose own self numbers are a
/// 1e9th of that. Where the layer alone yields, the pressure is p0 (1 - x^2/a^2 - s^2/b^2) and tractions of a
/// row know nothing of other rows: Kalker's simplified theory (1982) with all three flexibilities L.
struct StiffBodies {
  static constexpr double compliance = 1e-4, a = 4, b = 2, p0 = 500, friction = 0.3;
  ContactProblem problem;

  StiffBodies(int across, bool strip) {
    const double approach = p0 * compliance, dx = 2 * a / across;
    problem = scenes::flat(scenes::steel, scenes::steel, across + 2, strip ? 1 : across / 2 + 2, dx,
                           strip ? 1 : 4 * b / across, approach / (a * a), approach / (b * b));
    const double self = problem.numbers.at(0, 0, component_x, 0, component_x);
    for (double& number : problem.numbers.values)
      number *= 1e-9 * compliance / self;
    add_layer({{compliance}, compliance}, problem.numbers);
    problem.load = LoadKind::approach;
    problem.approach = approach;
  }
  /// tau = xi a / (L mu p0): what the traction would grow to in half the length, over the largest bound.
  static double creepage(double tau) { return tau * compliance * friction * p0 / a; }
};

/// Fx of a row of half length alpha a whose largest pressure is alpha^2 p0, over mu p0 a. It adheres from the
/// leading edge, where the traction grows by xi / L, to x = a (tau - alpha).
double row_force(double tau, double alpha) {
  return tau >= 2 * alpha ? 4.0 / 3 * alpha * alpha * alpha
                          : 2 * tau * alpha * alpha - tau * tau * alpha + tau * tau * tau / 6;
}

/// The same of all rows of an ellipse, over mu p0 a b: alpha = cos t, ds = b cos t dt.
double ellipse_force(double tau) {
  const double t = std::acos(std::min(1.0, tau / 2));
  const auto power2 = [](double u) { return u / 2 + std::sin(2 * u) / 4; };
  const auto power3 = [](double u) { return std::sin(u) - std::pow(std::sin(u), 3) / 3; };
  const auto power4 = [](double u) { return 3 * u / 8 + std::sin(2 * u) / 4 + std::sin(4 * u) / 32; };
  const double adhering = 2 * tau * power3(t) - tau * tau * power2(t) + tau * tau * tau / 6 * std::sin(t);
  return 2 * (adhering + 4.0 / 3 * (power4(pi / 2) - power4(t)));
}

/// The order of an error in the size of the elements, from halved elements. Where the ends of the contact are
/// edges of elements it is the second, as that of the rule for slip (slip_step.hpp); where the border of an
/// ellipse is one of steps it is the first.
double order_of(double coarse, double fine) {
  return std::log2(std::abs(coarse / fine));
}

TEST(Layer, OfStiffBodiesIsTheSimplifiedTheoryOfAStrip) {
  for (const double tau : {0.2, 0.6, 1.4, 2.5}) {
    double before = 0;
    for (const int across : {40, 80, 160}) {
      StiffBodies stiff(across, true);
      scenes::set_creepage(stiff.problem, stiff.friction, -stiff.creepage(tau), 0, 0);
      const ContactResult r = certified(stiff.problem);
      const double exact = row_force(tau, 1) * stiff.friction * stiff.p0 * stiff.a,
                   error = std::abs(r.totals.Fx) / exact - 1;
      EXPECT_LT(std::abs(error), 8.0 / (across * across)) << tau;
      if (before != 0) {
        EXPECT_GT(order_of(before, error), 1.9) << tau << ' ' << across;
      }
      before = error;
    }
  }
}

TEST(Layer, OfStiffBodiesIsTheSimplifiedTheoryOfAnEllipse) {
  NEEDS_NO_SANITIZER();
  for (const double tau : {0.02, 0.5, 1.0, 1.6, 3.0})
    for (const int across : {30, 60, 120}) {
      StiffBodies stiff(across, false);
      scenes::set_creepage(stiff.problem, stiff.friction, -stiff.creepage(tau), 0, 0);
      const ContactResult r = certified(stiff.problem);
      const double exact = ellipse_force(tau) * stiff.friction * stiff.p0 * stiff.a * stiff.b,
                   error = std::abs(r.totals.Fx) / exact - 1;
      EXPECT_LT(std::abs(error), 0.4 / across) << tau;
    }
}

/// Without slip: Fx = -8 a^2 b xi / (3 L), Fs = -8 a^2 b eta / (3 L) + pi a^3 b phi / (4 L) with the signs of
/// base/conventions.hpp (Kalker 1990, section 3.3: his L1, L2 and L3 are one L here).
TEST(Layer, OfStiffBodiesWithoutSlipHasKalkersForces) {
  for (const int across : {30, 60, 120}) {
    StiffBodies stiff(across, false);
    const double xi = 2e-4, eta = 1e-4, phi = 1e-4;
    scenes::set_creepage(stiff.problem, 1e4, xi, eta, phi);
    const ContactResult r = certified(stiff.problem);
    const double a = stiff.a, b = stiff.b, l = stiff.compliance, linear = 8 * a * a * b / (3 * l);
    const double fx = linear * xi, fs = linear * eta + pi * a * a * a * b * phi / (4 * l);
    EXPECT_NEAR(r.totals.Fx, fx, 0.6 / across * fx);
    EXPECT_NEAR(r.totals.Fs, fs, 0.8 / across * fs);
  }
}

/// Tractions of one row with spin: dp/dx = -w / L from 0 at the leading edge, and back onto the circle of
/// Coulomb's law where it leaves it, in many small steps.
struct SimplifiedRow {
  std::vector<double> x, px, ps;
};
SimplifiedRow simplified_row(double s, double xi, double eta, double phi, int steps) {
  using Stiff = StiffBodies;
  SimplifiedRow out;
  const double alpha2 = 1 - s * s / (Stiff::b * Stiff::b), reach = Stiff::a * std::sqrt(alpha2),
               h = 2 * reach / steps;
  double px = 0, ps = 0;
  for (int k = 1; k <= steps; ++k) {
    const double x = reach - k * h;
    px += h * (xi - phi * s) / Stiff::compliance;
    ps += h * (eta + phi * (x + 0.5 * h)) / Stiff::compliance;
    const double bound = Stiff::friction * Stiff::p0 * std::max(0.0, alpha2 - x * x / (Stiff::a * Stiff::a)),
                 length = std::hypot(px, ps);
    if (length > bound)
      px *= bound / length, ps *= bound / length;
    out.x.push_back(x), out.px.push_back(px), out.ps.push_back(ps);
  }
  return out;
}

TEST(Layer, OfStiffBodiesWithSpinAndSlipIsTheSimplifiedTheory) {
  NEEDS_NO_SANITIZER();
  const double unit = StiffBodies::creepage(1);
  for (const auto& [xi, eta, phi] : {std::array{0.5 * unit, 0.3 * unit, 0.2 * unit},
                                     {0.0, 0.0, 0.6 * unit},
                                     {0.4 * unit, -0.6 * unit, -0.4 * unit},
                                     {3 * unit, 2 * unit, 4 * unit}}) {
    double before = 0;
    for (const int across : {40, 80}) {
      StiffBodies stiff(across, false);
      scenes::set_creepage(stiff.problem, stiff.friction, xi, eta, phi);
      const ContactResult r = certified(stiff.problem);
      const ContactGrid& grid = stiff.problem.grid;
      double sum = 0;
      for (int is = 0; is < grid.ms; ++is) {
        const double s = stiff.problem.rows[is].s;
        if (std::abs(s) >= stiff.b)
          continue;
        const SimplifiedRow row = simplified_row(s, xi, eta, phi, 4000);
        for (std::size_t k = 0; k < row.x.size(); ++k) {
          const int ix = static_cast<int>(std::lround((row.x[k] - grid.x0) / grid.dx)), i = is * grid.mx + ix;
          sum += std::hypot(r.px[i] - row.px[k], r.ps[i] - row.ps[k]) * (row.x[0] - row.x[1]) * grid.ds;
        }
      }
      const double error = sum / (stiff.friction * stiff.p0 * stiff.a * stiff.b * pi / 2);
      EXPECT_LT(error, 1.5 / across) << xi << ' ' << eta << ' ' << phi;
      if (before > 0) {
        EXPECT_GT(order_of(before, error), 0.8) << xi << ' ' << eta << ' ' << phi;
      }
      before = error;
    }
  }
}

/// Steel on steel, with creepages and spin; L = 0: no layer.
ContactProblem layered(double compliance, double friction = 0.3, double scale = 1) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 28, 22, 0.5, 0.5, 8e-4, 1.2e-3);
  problem.force = 5e4;
  scenes::set_creepage(problem, friction, 6e-4 * scale, -3e-4 * scale, 8e-5 * scale);
  add_layer({{compliance}, 0}, problem.numbers);
  return problem;
}

TEST(Layer, IsLinearWhereItIsThin) {
  const ContactProblem clean = layered(0);
  const double self = std::min(clean.numbers.at(0, 0, component_x, 0, component_x),
                               clean.numbers.at(0, 0, component_s, 0, component_s));
  const auto forces = [&](double share) {
    const ContactResult r = certified(layered(share * self));
    return std::array<double, 3>{r.totals.Fx, r.totals.Fs, r.totals.Mz};
  };
  const auto none = forces(0), half = forces(0.05), whole = forces(0.1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(std::abs(whole[k] - none[k]), 1e-4 * std::abs(none[k])) << k;
    EXPECT_NEAR((half[k] - none[k]) / (whole[k] - none[k]), 0.5, 0.025) << k;
  }
}

/// By conservation of energy the power of friction is the power that drives the bodies; a layer stores energy
/// at the leading edge and gives it back before the trailing one. On finite elements this holds to their
/// order.
TEST(Layer, KeepsTheEnergyBalance) {
  double before = 0;
  for (const int fine : {1, 2, 4}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20 * fine, 16 * fine, 0.7 / fine,
                                          0.7 / fine, 8e-4, 1.2e-3);
    problem.force = 5e4;
    scenes::set_creepage(problem, 0.3, 2e-3, -1e-3, 3e-4);
    add_layer({{5e-5}, 0}, problem.numbers);
    const ContactResult r = certified(problem);
    double driving = 0, friction = 0;
    for (int i = 0; i < problem.grid.size(); ++i) {
      driving += r.px[i] * problem.slip_x[i] + r.ps[i] * problem.slip_s[i];
      friction += r.px[i] * r.slip_x[i] + r.ps[i] * r.slip_s[i];
    }
    const double missing = std::abs(driving / friction - 1);
    EXPECT_LT(missing, 0.07 / fine);
    if (before > 0) {
      EXPECT_LT(missing, 0.6 * before);
    }
    before = missing;
  }
}

/// The power that is stated is the driving one, and its parts on the elements add up to it, on large elements
/// too.
TEST(Layer, DoesNotTakePowerFromFriction) {
  for (const double compliance : {0.0, 5e-5, 2e-4}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20, 16, 0.7, 0.7, 8e-4, 1.2e-3);
    problem.force = 5e4;
    scenes::set_creepage(problem, 0.3, 1e-3, 0, 0);
    add_layer({{compliance}, 0}, problem.numbers);
    const ContactResult r = certified(problem);
    const double driving = 1e-3 * r.totals.Fx;
    EXPECT_NEAR(r.totals.T_gamma, driving, 1e-5 * driving) << compliance;
    double sum = 0;
    for (const double power : friction_work_density(r)) {
      EXPECT_GE(power, -1e-6 * driving / problem.element_area());
      sum += power * problem.element_area();
    }
    EXPECT_NEAR(sum, driving, 1e-5 * driving) << compliance;
    ASSERT_EQ(r.patches.size(), 1u);
    EXPECT_NEAR(r.patches.front().T_gamma, driving, 1e-5 * driving) << compliance;
  }
}

/// Influence number of a rectangle's centre under uniform traction along x, pair of equal half-spaces
/// (Kalker 1990, section 4.2.2: corner differences of J1 and J2).
double dense_number(double x, double y, double dx, double dy, double shear_modulus, double poisson) {
  double sum = 0;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1}) {
      const double X = x + 0.5 * i * dx, Y = y + 0.5 * j * dy;
      sum += i * j * (Y * std::asinh(X / std::abs(Y)) + (1 - poisson) * X * std::asinh(Y / std::abs(X)));
    }
  return sum / (pi * shear_modulus);
}

/// Fx / Fn of the locomotive Eurosprinter 127 001 (Engel, Beck, Alders 1998): 106.7 kN, a/b = 0.5, mu = 0.14
/// + 0.19 2^(-w / 1250 mm/s), 10 m/s. The slow way: Hertz's pressure, tractions along x alone, one element
/// after the other, on 40 x 20 elements.
double dense_locomotive(double xi, double compliance) {
  constexpr int mx = 40, ms = 20;
  constexpr double dx = 16.0 / mx, ds = 32.0 / ms;
  ContactProblem normal = scenes::flat(scenes::steel, scenes::steel, mx, ms, dx, ds, 8e-4, 2.814e-4);
  normal.force = 106700;
  const std::vector<double> pn = certified(normal).pn;
  std::vector<double> table((2 * mx + 2) * ms);
  for (int d = 0; d < ms; ++d)
    for (int m = -mx + 1; m < mx + 2; ++m)
      table[d * (2 * mx + 2) + m + mx] =
          dense_number(m * dx, d * ds, dx, ds, 82000, 0.28) + (d == 0 && m == 0 ? compliance : 0);
  const auto a = [&](int m, int d) { return table[std::abs(d) * (2 * mx + 2) + m + mx]; };
  // Displacement at a target that lies m columns ahead of the load: the step takes it 0, 1 and 2 further on.
  const auto b = [&](int m, int d) {
    return 1.5 * a(m, d) - (m + 1 < mx + 2 ? 2 * a(m + 1, d) : 0) + (m + 2 < mx + 2 ? 0.5 * a(m + 2, d) : 0);
  };
  std::vector<double> step((2 * mx + 2) * ms);
  for (int d = 0; d < ms; ++d)
    for (int m = -mx + 1; m < mx; ++m)
      step[d * (2 * mx + 2) + m + mx] = b(m, d);
  std::vector<double> p(mx * ms, 0.0);
  double fx = 0;
  for (int sweep = 0; sweep < 400; ++sweep) {
    double change = 0;
    for (int i = mx * ms - 1; i >= 0; --i) { // from the leading edge
      if (!(pn[i] > 0))
        continue;
      double slip = xi * dx;
      for (int j = 0; j < mx * ms; ++j)
        if (pn[j] > 0)
          slip -= step[std::abs(i / mx - j / mx) * (2 * mx + 2) + i % mx - j % mx + mx] * p[j];
      const double self = step[mx];
      const double free = slip + self * p[i]; // slip if this element had no traction
      double next = free / self;
      if (std::abs(next) > 0.33 * pn[i]) { // the law of its own slip
        double left = free - std::copysign(self * 0.33 * pn[i], free);
        for (int k = 0; k < 60; ++k) {
          const double mu = 0.14 + 0.19 * std::exp2(-std::abs(left) / dx * 10000 / 1250);
          left = free - std::copysign(self * mu * pn[i], free);
        }
        next = (free - left) / self;
      }
      change = std::max(change, std::abs(next - p[i]));
      p[i] = next;
    }
    if (change < 1e-7)
      break;
  }
  for (const double traction : p)
    fx += traction * dx * ds;
  return fx / 106700;
}

/// The first eight columns of the measurement, and what a dense prototype of others made of them with L =
/// 1.52e-4 mm^3/N.
TEST(Layer, OfTheLocomotiveIsTheDenseSolution) {
  NEEDS_NO_SANITIZER();
  const std::pair<double, double> prototype[] = {{.0053, .234}, {.0069, .265}, {.0088, .287}, {.0109, .299},
                                                 {.0148, .307}, {.0212, .307}, {.0291, .301}, {.0428, .290}};
  for (const auto& [xi, ratio] : prototype) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 40, 20, 0.4, 1.6, 8e-4, 2.814e-4);
    problem.force = 106700;
    problem.speed = 10000;
    scenes::set_creepage(problem, 0.33, xi, 0, 0);
    problem.falling = {exponential_friction(0.14, 0.19, 1250)};
    add_layer({{1.52e-4}, 0}, problem.numbers);
    const ContactResult r = certified(problem);
    EXPECT_NEAR(r.totals.Fx / 106700 / dense_locomotive(xi, 1.52e-4), 1, 0.01) << xi;
    EXPECT_NEAR(r.totals.Fx / 106700, ratio, 0.025 * ratio) << xi;
  }
}

/// The certificate takes its sums from the influence numbers, not from the solvers.
TEST(Layer, IsSeenByTheCertificate) {
  const ContactProblem problem = layered(1e-5), clean = layered(0), more = layered(1.0001e-5);
  const ContactResult r = certified(problem);
  EXPECT_TRUE(certify(problem, r).holds());
  EXPECT_FALSE(certify(clean, r).holds());
  EXPECT_FALSE(certify(more, r).holds());
  ContactProblem pressed = problem;
  add_layer({{}, 1e-5}, pressed.numbers);
  EXPECT_GT(certify(pressed, r).complementarity, 1e-6);
}

TEST(Layer, OfRowsIsOneOfAllRowsWhereTheyAreAlike) {
  ContactProblem rows = layered(0), one = layered(2e-5);
  add_layer({std::vector<double>(22, 2e-5), 0}, rows.numbers);
  EXPECT_TRUE(rows.numbers.translational);
  EXPECT_EQ(certified(rows).totals.Fx, certified(one).totals.Fx);
  ContactProblem uneven = layered(0);
  std::vector<double> compliances(22, 2e-5);
  compliances[3] *= 1 + 1e-9;
  add_layer({compliances, 0}, uneven.numbers);
  EXPECT_FALSE(uneven.numbers.translational);
  EXPECT_NEAR(certified(uneven).totals.Fx, certified(one).totals.Fx, 1e-5 * certified(one).totals.Fx);
}

TEST(Layer, IsRefusedWhereItIsNone) {
  InfluenceNumbers numbers = layered(0).numbers;
  const auto refusal = [&](const SurfaceLayer& layer) {
    return message_of([&] { add_layer(layer, numbers); });
  };
  EXPECT_THAT(refusal({{-1e-5}, 0}), HasSubstr("negative"));
  EXPECT_THAT(refusal({{}, std::numeric_limits<double>::quiet_NaN()}), HasSubstr("not finite"));
  EXPECT_THAT(refusal({{1e-5, 2e-5}, 0}), HasSubstr("2 rows"));
}

/// Random contacts with layers from a hundredth to a thousand self numbers: every motion, unlike materials,
/// one row, two areas, layers of rows, under pressure too. All of them are certified.
TEST(Layer, OfRandomContactsIsCertified) {
  std::mt19937 random(53);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  for (int k = 0; k < 60; ++k) {
    const bool line = k % 7 == 3, two = k % 5 == 2;
    const Material upper = k % 2 ? Material{uniform(5e3, 9e4), uniform(0, 0.45)} : scenes::steel;
    const int mx = 12 + k % 9, ms = line ? 1 : 10 + k % 7;
    ContactProblem problem = scenes::flat(scenes::steel, upper, mx, ms, 0.5, 0.4, 1e-3, 2e-3);
    for (int i = 0; two && i < problem.grid.size(); ++i) {
      const double s = problem.rows[i / mx].s, x = problem.grid.x(i % mx);
      problem.gap[i] = 1e-3 * x * x + 0.01 * std::pow(std::abs(s) - 0.25 * ms * 0.4, 2);
    }
    problem.force = line ? 500 : uniform(3e3, 1e4);
    const double size = std::pow(10, uniform(-4, -2));
    scenes::set_creepage(problem, uniform(0.1, 0.5), size * uniform(-1, 1), size * uniform(-1, 1),
                         0.2 * size * uniform(-1, 1));
    const double self = problem.numbers.at(0, 0, component_x, 0, component_x),
                 compliance = self * std::pow(10, uniform(-2, 3));
    SurfaceLayer layer{{compliance}, k % 4 == 1 ? self * std::pow(10, uniform(-2, 2)) : 0};
    if (k % 6 == 5) {
      layer.shear.clear();
      for (int row = 0; row < ms; ++row)
        layer.shear.push_back(compliance * uniform(0, 2));
    }
    add_layer(layer, problem.numbers);
    SCOPED_TRACE(k);
    if (k % 3 == 0) {
      certified(problem);
      continue;
    }
    problem.motion = k % 3 == 1 ? MotionKind::transient : MotionKind::shift;
    if (k % 3 == 2)
      for (auto* slip : {&problem.slip_x, &problem.slip_s})
        for (double& w : *slip)
          w *= 0.5; // mm
    for (const ContactResult& step : solve_history(
             problem, 4, [](int, ContactProblem&) {}, scenes::without_estimate))
      EXPECT_TRUE(step.certified()) << step.trust.solver_note << step.trust.certificate.worst();
  }
}

/// Rolling of a layer from rest becomes steady rolling.
TEST(Layer, TransientBecomesSteady) {
  NEEDS_NO_SANITIZER();
  ContactProblem problem = layered(5e-5);
  const double steady = certified(problem).totals.Fx;
  problem.motion = MotionKind::transient;
  const auto history = solve_history(
      problem, 150, [](int, ContactProblem&) {}, scenes::without_estimate);
  EXPECT_NEAR(history.back().totals.Fx, steady, 1e-5 * steady);
}

/// Iterations with a layer are about those without: the systems get better conditioned.
TEST(Layer, CostsNoMoreIterations) {
  const ContactResult clean = certified(layered(0));
  for (const double compliance : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    const ContactResult r = certified(layered(compliance, 0.3, 1 + 5e4 * compliance));
    EXPECT_LE(r.effort.work, 2.5 * clean.effort.work) << compliance;
  }
}

} // namespace
} // namespace bem_contact
