#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/contact/textbook.hpp"
#include "tests/sanitized.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <random>

/// The solvers against Kalker's textbook algorithm with dense matrices, on random small problems: loads over
/// more than six decades, both kinds of load, adhesion everywhere to slip everywhere.
namespace bem_contact {
namespace {

constexpr int problem_count = tests::alike(500); // of each kind of numbers

/// The same problems every time; RC_PARAMS="seed=7 max_success=10000" in the environment asks for others.
const int parameters =
    setenv("RC_PARAMS", ("seed=17 max_success=" + std::to_string(problem_count)).c_str(), 0);

enum class Numbers { halfspace, tangent_plane, fem, disturbed };

int integer(int from, int to) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to + 1));
}
double uniform(double from, double to) {
  return from + (to - from) * integer(0, 1 << 20) / (1 << 20);
}
double decades(double from, double to) {
  return std::pow(10.0, uniform(from, to));
}

/// Symmetric as influence numbers are (Maxwell-Betti, parity), of both signs, no translation in s.
void disturb(InfluenceNumbers& a) {
  a = with_every_pair_of_rows(a);
  std::mt19937 engine(integer(0, 1 << 20));
  std::uniform_real_distribution<> noise(-0.01, 0.01);
  for (int m = 0; m < a.offsets; ++m)
    for (int row_i = 0; row_i < a.rows; ++row_i)
      for (int i = 0; i < 3; ++i)
        for (int row_j = 0; row_j < a.rows; ++row_j)
          for (int j = 0; j < 3; ++j) {
            if (3 * row_j + j > 3 * row_i + i || (m == 0 && parity(i, j) < 0))
              continue;
            const double scale = std::sqrt(a.at(0, row_i, i, row_i, i) * a.at(0, row_j, j, row_j, j));
            const bool self = m == 0 && row_i == row_j && i == j;
            const double v = a.at(m, row_i, i, row_j, j) + (self ? 0.2 : noise(engine) / (1 + m * m)) * scale;
            a.at(m, row_i, i, row_j, j) = v;
            a.at(m, row_j, j, row_i, i) = parity(i, j) * v;
          }
}

/// Rows on an arc whose curvature changes, and the numbers of its tangent planes.
void bend(ContactProblem& problem, const Material& lower, const Material& upper) {
  const ContactGrid& grid = problem.grid;
  const double turn = uniform(-0.3, 0.3), more = uniform(-0.1, 0.1); // rad a row
  std::vector<ContactRow> wheel;
  double delta = uniform(-0.5, 0.5);
  Point2 position{};
  for (int is = 0; is < grid.ms; ++is) {
    problem.rows[is].delta = delta;
    problem.rows[is].position = position;
    wheel.push_back({0, -1.0 * position, delta});
    const double next = delta + turn + more * is;
    position = position + grid.ds * tangent_of(0.5 * (delta + next));
    delta = next;
  }
  const halfspace::StripGrid strip{grid.dx, grid.ds, grid.mx + 2};
  problem.numbers = halfspace::combine(halfspace::tangent_plane_numbers(lower, strip, problem.rows),
                                       halfspace::tangent_plane_numbers(upper, strip, wheel));
}

/// Somewhere on the gauge corner and the flange root of the files that the project ships.
void use_files(ContactProblem& problem) {
  static const std::string folder = CONFORMAL_SOURCE_DIR "/data/influence/";
  static const InfluenceFunction rail = read_influence_file(folder + "small_rail.h5"),
                                 wheel = read_influence_file(folder + "small_wheel.h5");
  const ContactGrid& grid = problem.grid;
  const auto strip = [&](const InfluenceFunction& f) { // first row of those that fit
    const double first = f.stations.front().s + 0.5 * (grid.ds - f.station_width);
    const double last = f.stations.back().s - 0.5 * (grid.ds - f.station_width) - (grid.ms - 1) * grid.ds;
    return first + (last - first) * uniform(0, 1);
  };
  const double on_rail = strip(rail), on_wheel = strip(wheel);
  std::vector<double> rail_s, wheel_s;
  for (int is = 0; is < grid.ms; ++is) {
    rail_s.push_back(on_rail + is * grid.ds);
    wheel_s.push_back(on_wheel + (grid.ms - 1 - is) * grid.ds); // against the rail's s
    const auto k = static_cast<std::size_t>((rail_s[is] - rail.stations.front().s) / rail.station_width);
    problem.rows[is].delta = rail.stations[k].delta;
    problem.rows[is].position = rail.stations[k].position;
  }
  ExpandOptions options;
  options.dx = grid.dx;
  options.offsets = grid.mx + 2;
  problem.numbers = halfspace::combine(halfspace::resample(rail, options, rail_s, grid.ds),
                                       halfspace::resample(wheel, options, wheel_s, grid.ds));
}

/// mu tan(delta), at the steepest row: from 0.7 on friction alone could nearly carry a vertical force.
double wedging(const ContactProblem& problem) {
  double steepest = 0;
  for (const ContactRow& row : problem.rows)
    steepest = std::max(steepest, std::abs(std::tan(row.delta)));
  return problem.friction * steepest;
}
constexpr double much = 0.7;

ContactProblem random_problem(Numbers kind) {
  const int mx = integer(2, 6), ms = integer(1, 5);
  const bool files = kind == Numbers::fem;
  const double dx = files ? decades(-0.3, 0.5) : decades(-2, 0.5),
               ds = files ? uniform(0.5, 1.5) : dx * decades(-0.5, 0.5);
  const auto material = [&] { return Material{decades(3, 5), uniform(0, 0.45)}; };
  const Material lower = files ? scenes::steel : material(),
                 upper = files || integer(0, 1) == 0 ? lower : material();
  const double curvature = decades(-4, -1), ratio = decades(-1, 1);
  const double reach = dx * uniform(0.7, 0.7 * mx); // half the contact, about
  ContactProblem problem =
      scenes::flat(lower, upper, mx, ms, dx, ds, curvature, curvature * ratio * uniform(0.3, 1));
  const double tilt_x = uniform(-0.3, 0.3) * curvature * reach,
               tilt_s = uniform(-0.3, 0.3) * curvature * reach;
  for (int i = 0; i < problem.grid.size(); ++i)
    problem.gap[i] += tilt_x * problem.grid.x(i % mx) + tilt_s * problem.rows[i / mx].s;
  if (kind == Numbers::tangent_plane)
    bend(problem, lower, upper);
  else if (kind == Numbers::fem)
    use_files(problem);
  else if (kind == Numbers::disturbed)
    disturb(problem.numbers);

  const double mu = decades(-2, 0), unit = mu * curvature * reach;
  scenes::set_creepage(problem, mu, unit * decades(-2, 1) * uniform(-1, 1),
                       unit * decades(-2, 1) * uniform(-1, 1),
                       unit / reach * decades(-2, 1) * uniform(-1, 1));
  if (integer(0, 3) == 0) { // a shift by as much
    problem.motion = MotionKind::shift;
    for (std::vector<double>* slip : {&problem.slip_x, &problem.slip_s})
      for (double& w : *slip)
        w *= reach;
  }
  problem.load = integer(0, 1) && wedging(problem) < much ? LoadKind::force : LoadKind::approach;
  problem.approach = curvature * reach * reach * uniform(0.5, 2);
  problem.force = lower.shear_modulus * curvature * reach * reach * reach * decades(-1, 0.5);
  return problem;
}

struct Seen {
  int compared = 0, without_contact = 0, adhering = 0, slipping = 0;
  double least = 1e300, most = 0;
};

void compare(const ContactProblem& problem, Seen& seen) {
  SolverOptions options;
  options.tolerance = 1e-10;
  options.estimate_discretisation = false;
  const ContactResult result = solve(problem, options);
  if (!result.certified())
    RC_FAIL("not certified: " + result.trust.solver_note);
  const textbook::Solution expected = textbook::solve(problem);
  if (!expected.found)
    RC_FAIL("the textbook did not end");
  const int n = problem.grid.size();
  const double pmax = expected.pn.maxCoeff();
  ++seen.compared;
  if (pmax == 0) {
    ++seen.without_contact;
    RC_ASSERT(result.totals.Fz == 0);
    return;
  }
  if (result.totals.Fz > 0) // steep rows with friction: it may well point up
    seen.least = std::min(seen.least, result.totals.Fz.value);
  seen.most = std::max(seen.most, result.totals.Fz.value);
  double apart = 0;
  for (int i = 0; i < n; ++i) {
    apart = std::max({apart, std::abs(result.pn[i] - expected.pn[i]) / pmax,
                      std::abs(result.px[i] - expected.pt[i]) / (problem.friction * pmax),
                      std::abs(result.ps[i] - expected.pt[n + i]) / (problem.friction * pmax)});
    seen.adhering += result.state[i] == ElementState::adhesion;
    seen.slipping += result.state[i] == ElementState::slip;
  }
  if (!(apart < 1e-6))
    RC_FAIL(result.effort.tangential_solver + " is off by " + std::to_string(apart));
  RC_ASSERT(std::abs(result.totals.approach - expected.approach) < 1e-6 * std::abs(expected.approach));
}

void have_the_same_tractions(Numbers kind) {
  ASSERT_EQ(parameters, 0);
  Seen seen;
  ASSERT_TRUE(rc::check([&] { compare(random_problem(kind), seen); }));
  std::printf("%d compared, %d without contact, %d elements adhere, %d slip; %.1e to %.1e N\n", seen.compared,
              seen.without_contact, seen.adhering, seen.slipping, seen.least, seen.most);
  EXPECT_GE(seen.compared, problem_count);
  EXPECT_LT(seen.without_contact, 0.2 * seen.compared);
  EXPECT_GT(seen.adhering, seen.compared);
  EXPECT_GT(seen.slipping, seen.compared);
  EXPECT_GT(seen.most, 1e6 * seen.least);
}

/// Bodies that friction wedges under a vertical force have no solution, one, or several: certified, or
/// refused because there is none, or only one whose pressure bears more than largest_force_ratio times the
/// force.
struct Wedged {
  int certified = 0, balanced_apart = 0, refused = 0;
};

void solve_wedged(ContactProblem problem, Wedged& seen) {
  const double lean = uniform(-1, 1); // of all rows: the numbers know nothing of it
  for (ContactRow& row : problem.rows)
    row.delta += lean;
  problem.friction = uniform(0.1, 1);
  problem.load = LoadKind::force;
  if (wedging(problem) < much)
    return;
  SolverOptions options;
  options.tolerance = 1e-10;
  options.estimate_discretisation = false;
  try {
    const ContactResult result = solve(problem, options);
    if (!result.certified())
      RC_FAIL("not certified: " + result.trust.solver_note);
    ++seen.certified;
    seen.balanced_apart += result.effort.outer_iterations > options.max_outer;
  } catch (const InputError& error) {
    ++seen.refused;
    RC_ASSERT(std::string(error.what()).find("No pressure balances") == 0u);
    const textbook::Solution expected = textbook::solve(problem);
    double pressed = 0;
    for (int i = 0; i < problem.grid.size(); ++i)
      pressed += expected.pn[i] * std::cos(problem.rows[i / problem.grid.mx].delta) * problem.element_area();
    RC_ASSERT(!expected.found || pressed > contact::largest_force_ratio * problem.force);
  }
}

TEST(Textbook, WedgedBodiesAreCertifiedOrRefused) {
  ASSERT_EQ(parameters, 0);
  Wedged seen;
  EXPECT_TRUE(rc::check([&] {
    for (int k = 0; k < 10; ++k)
      solve_wedged(random_problem(Numbers::tangent_plane), seen);
  }));
  std::printf("%d certified, %d of them by one thing after the other, %d refused\n", seen.certified,
              seen.balanced_apart, seen.refused);
  EXPECT_GT(seen.certified, 2 * problem_count);
  EXPECT_GT(seen.balanced_apart, 0);
}

TEST(Textbook, HalfSpaceNumbers) {
  have_the_same_tractions(Numbers::halfspace);
}

TEST(Textbook, TangentPlaneNumbers) {
  have_the_same_tractions(Numbers::tangent_plane);
}

TEST(Textbook, NumbersOfFiniteElements) {
  have_the_same_tractions(Numbers::fem);
}

TEST(Textbook, NumbersFullInS) {
  have_the_same_tractions(Numbers::disturbed);
}

} // namespace
} // namespace bem_contact
