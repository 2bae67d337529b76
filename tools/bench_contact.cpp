// What one contact problem costs; tools/bench_contact runs this and turns it into a table and a plot.
//   ninja -C build bench_contact && build/bin/bench_contact --benchmark_filter=goal
// Half-space numbers are translational in s. "fem" stands for numbers of finite elements: a table full in s,
// normal and tangential coupled, here the tangent-plane numbers of a strip of changing curvature (so that any
// size can be had without an influence file).
#include "bem_contact/contact/coupling.hpp"
#include "bem_contact/halfspace/rectangle.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace bem_contact;

const Material steel{82000.0, 0.28};
constexpr double semi_x = 6, semi_s = 4.5; // mm, about

enum class Kind { partial_slip, full_slip, frictionless };

/// Elements of the grid and of the contact along x and s.
struct Size {
  int mx, ms;
  double across_x, across_s;
};

Size square(double contact, double ratio) {
  const double across = std::sqrt(contact * 4 / M_PI);
  const int m = static_cast<int>(std::lround(across * ratio));
  return {m, m, across, across};
}

/// lower + upper, whose frame is turned by pi about x and whose rows run backwards.
InfluenceNumbers pair(InfluenceNumbers lower, const InfluenceNumbers& upper) {
  const int last = lower.rows - 1;
  for (int m = 0; m < lower.offsets; ++m)
    for (const auto& [row_i, row_j] : lower.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          lower.at(m, row_i, i, row_j, j) += ((i == component_x) == (j == component_x) ? 1 : -1) *
                                             upper.at(m, last - row_i, i, last - row_j, j);
  return lower;
}

ContactProblem scene(const Size& size, bool fem, Kind kind) {
  ContactProblem problem;
  const double dx = 2 * semi_x / size.across_x, ds = 2 * semi_s / size.across_s;
  problem.grid = {size.mx, size.ms, dx, ds, -0.5 * (size.mx - 1) * dx};
  constexpr double a = 1 / 920.0, b = 1 / 600.0;
  Point2 position{};
  for (int is = 0; is < size.ms; ++is) {
    const double s = (is - 0.5 * (size.ms - 1)) * ds, delta = fem ? s / 200 + s * s / 2000 : 0;
    if (is > 0)
      position = position + ds * tangent_of(0.5 * (delta + problem.rows.back().delta));
    problem.rows.push_back({s, position, delta});
    for (int ix = 0; ix < size.mx; ++ix)
      problem.gap.push_back(a * problem.grid.x(ix) * problem.grid.x(ix) + b * s * s);
  }
  const Point2 middle = problem.rows[size.ms / 2].position;
  for (ContactRow& row : problem.rows)
    row.position = row.position - middle;
  if (fem) {
    std::vector<halfspace::StripRow> rail, wheel;
    for (const ContactRow& row : problem.rows) {
      rail.push_back({row.position, row.delta});
      wheel.insert(wheel.begin(), {{-row.position.y, -row.position.z}, row.delta});
    }
    const halfspace::StripGrid grid{dx, ds, size.mx + 2};
    problem.numbers = pair(spelled_out(halfspace::tangent_plane_numbers(steel, grid, rail)),
                           spelled_out(halfspace::tangent_plane_numbers(steel, grid, wheel)));
  } else {
    const InfluenceNumbers body = halfspace::numbers(steel, dx, ds, size.mx + 2, size.ms);
    problem.numbers = pair(body, body);
  }
  problem.load = LoadKind::approach;
  problem.approach = 1.9 * a * semi_x * semi_x;
  problem.force = 60000;
  problem.tangential = kind != Kind::frictionless;
  if (problem.tangential)
    for (const ContactRow& row : problem.rows)
      for (int ix = 0; ix < size.mx; ++ix) {
        const bool partial = kind == Kind::partial_slip;
        problem.slip_x.push_back(partial ? 1.5e-3 - 2e-4 * row.s : 1e-2);
        problem.slip_s.push_back(partial ? 1e-3 + 2e-4 * problem.grid.x(ix) : 0);
      }
  return problem;
}

/// The time is that of the solver alone, to 1e-5; the counters say what a certified solution has.
void solve_scene(benchmark::State& state, const ContactProblem& problem, bool coupled, bool estimate) {
  SolverOptions options;
  options.tolerance = coupled ? 1e-6 : 1e-5; // turns settle at ten times the tolerance
  options.estimate_discretisation = false;
  contact::Solution solution;
  for (auto _ : state) {
    solution = contact::solve_coupled(problem, options);
    benchmark::DoNotOptimize(solution.normal.p.data());
  }
  const auto contact = (solution.normal.p.array() > 0).count();
  state.counters["elements"] = problem.grid.size();
  state.counters["contact"] = static_cast<double>(contact);
  state.counters["products"] = solution.shear.products;
  state.counters["normal_products"] = solution.normal.products;
  state.counters["turns"] = solution.outer_iterations;
  if (!estimate)
    return;
  state.counters["residual"] = solve(problem, options).certificate.worst();
  options = {};
  options.estimate_discretisation = problem.grid.size() < 10000;
  const ContactResult certified = solve(problem, options);
  state.counters["certificate"] = certified.certificate.worst();
  state.counters["discretisation"] = certified.certificate.discretisation;
}

void add(const std::string& name, const Size& size, bool fem, Kind kind, bool by_force, bool estimate) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    ContactProblem problem = scene(size, fem, kind);
    if (by_force)
      problem.load = LoadKind::force;
    solve_scene(state, problem, fem, estimate);
  })->Unit(benchmark::kMillisecond);
}

void add_series(bool quick) {
  for (const bool fem : {false, true})
    for (const Kind kind : {Kind::frictionless, Kind::partial_slip}) {
      const std::string series = fmt::format("series/{}/{}", fem ? "fem" : "half-space",
                                             kind == Kind::frictionless ? "normal" : "steady");
      const double most = quick ? 3200 : fem ? 6400 : 51200;
      for (double contact = 200; contact <= most; contact *= fem || quick ? 2 : 4)
        add(fmt::format("{}/x and s/{}", series, contact), square(contact, 1.5), fem, kind, false, false);
      if (!fem)
        continue;
      for (int across = 16; across <= (quick ? 64 : 256); across *= 2)
        add(fmt::format("{}/x/{}", series, across), {across * 3 / 2, 24, across * 1.0, 16}, true, kind, false,
            false);
      for (int across = 16; across <= (quick ? 64 : 128); across *= 2)
        add(fmt::format("{}/s/{}", series, across), {24, across * 3 / 2, 16, across * 1.0}, true, kind, false,
            false);
    }
}

/// The goals of the project, sizes as given.
void add_goals(bool quick) {
  struct Goal {
    const char* name;
    int m;
    double across;
    Kind kind;
    bool by_force;
  };
  for (const Goal& g : {Goal{"partial slip, position", 46, 30.3, Kind::partial_slip, false},
                        Goal{"partial slip, force", 63, 40.5, Kind::partial_slip, true},
                        Goal{"partial slip, position", 89, 60.2, Kind::partial_slip, false},
                        Goal{"partial slip, position", 238, 160.8, Kind::partial_slip, false},
                        Goal{"full slip, position", 89, 60.2, Kind::full_slip, false},
                        Goal{"frictionless, position", 238, 160.8, Kind::frictionless, false}})
    for (const bool fem : {false, true})
      if (g.m < 200 || (!fem && !quick))
        add(fmt::format("goal/{}/{}/{}", g.name, g.m * g.m, fem ? "fem" : "half-space"),
            {g.m, g.m, g.across, g.across}, fem, g.kind, g.by_force, true);
}

/// A product with the normal numbers of 46 x 46 elements, a copy of as many bytes as it reads, and the dense
/// product.
void add_operator() {
  constexpr int m = 46, n = m * m;
  for (const bool fem : {false, true}) {
    const std::string name = fem ? "fem" : "half-space";
    const double bytes = fem ? 8.0 * (m + 3) * m * m : 16.0 * (m + 2) * 2 * m;
    benchmark::RegisterBenchmark(
        fmt::format("operator/{}/product", name).c_str(), [=](benchmark::State& state) {
          const ContactProblem problem = scene({m, m, 30, 30}, fem, Kind::frictionless);
          const contact::StripOperator a(problem.numbers, m, {component_n}, {component_n});
          std::vector<double> p(n, 1.0), u(n);
          for (auto _ : state) {
            a.apply(p, u);
            benchmark::ClobberMemory();
          }
          state.counters["bytes"] = bytes;
        });
    benchmark::RegisterBenchmark(fmt::format("operator/{}/copy", name).c_str(), [=](benchmark::State& state) {
      std::vector<char> from(static_cast<std::size_t>(bytes), 1), to(from.size());
      for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::ClobberMemory();
      }
    });
  }
  benchmark::RegisterBenchmark("operator/dense/product", [=](benchmark::State& state) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(n, n, 1e-6);
    Eigen::VectorXd p = Eigen::VectorXd::Ones(n), u(n);
    for (auto _ : state) {
      u.noalias() = a * p;
      benchmark::ClobberMemory();
    }
  });
}

} // namespace

int main(int argc, char** argv) {
  const auto quick = std::find(argv, argv + argc, std::string_view("--quick"));
  const bool is_quick = quick != argv + argc;
  if (is_quick) {
    std::rotate(quick, quick + 1, argv + argc);
    --argc;
  }
  add_goals(is_quick);
  add_series(is_quick);
  add_operator();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
