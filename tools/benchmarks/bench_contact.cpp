// What one contact problem costs; tools/benchmarks/bench_contact runs this and turns it into a table and a
// plot.
//   ninja -C build bench_contact && build/bin/bench_contact --benchmark_filter=goal
// Half-space numbers are translational in s. "fem" stands for numbers of finite elements: a table full in s,
// normal and tangential coupled, here the tangent-plane numbers of a strip of changing curvature (so that any
// size can be had without an influence file). "file" are those of data/influence, both bodies' numbers on
// rows as narrow as the case wants.
#include "bem_contact/contact/coupled/solve_coupled.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "bem_contact/influence/influence_file.hpp"

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
enum class Numbers { halfspace, strip, file };

constexpr const char* name_of(Numbers numbers) {
  return numbers == Numbers::halfspace ? "half-space" : numbers == Numbers::strip ? "fem" : "file";
}

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

/// The small files of the gauge corner and the flange root, whose rows lie opposite each other.
InfluenceNumbers numbers_of_files(const ContactGrid& grid) {
  const std::string folder = CONFORMAL_SOURCE_DIR "/data/influence/";
  const InfluenceFunction rail = read_influence_file(folder + "small_rail.h5"),
                          wheel = read_influence_file(folder + "small_wheel.h5");
  const auto middle = [](const InfluenceFunction& f) {
    return 0.5 * (f.stations.front().s + f.stations.back().s);
  };
  std::vector<double> rail_s, wheel_s;
  for (int is = 0; is < grid.ms; ++is) {
    const double s = (is - 0.5 * (grid.ms - 1)) * grid.ds;
    rail_s.push_back(middle(rail) + s);
    wheel_s.push_back(middle(wheel) - s);
  }
  ExpandOptions options;
  options.dx = grid.dx;
  options.offsets = grid.mx + 2;
  return halfspace::combine(halfspace::resample(rail, options, rail_s, grid.ds),
                            halfspace::resample(wheel, options, wheel_s, grid.ds));
}

ContactProblem scene(const Size& size, Numbers numbers, Kind kind) {
  ContactProblem problem;
  double a = 1 / 920.0, b = 1 / 600.0, force = 60000;
  double dx = 2 * semi_x / size.across_x, ds = 2 * semi_s / size.across_s;
  if (numbers ==
      Numbers::file) { // as short as the files' wavenumbers allow; as long as their strips; as deep
    constexpr double shortest = 0.52, strip = 23.5;
    force *= std::sqrt(shortest * strip / size.ms / dx / ds);
    dx = shortest;
    ds = strip / size.ms;
    a *= std::pow(2 * semi_x / size.across_x / dx, 2);
    b *= std::pow(2 * semi_s / size.across_s / ds, 2);
  }
  const bool fem = numbers != Numbers::halfspace;
  problem.grid = {size.mx, size.ms, dx, ds, -0.5 * (size.mx - 1) * dx};
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
  if (numbers == Numbers::file) {
    problem.numbers = numbers_of_files(problem.grid);
  } else if (fem) {
    std::vector<ContactRow> wheel;
    for (const ContactRow& row : problem.rows)
      wheel.insert(wheel.begin(), {row.s, -1.0 * row.position, row.delta});
    const halfspace::StripGrid grid{dx, ds, size.mx + 2};
    problem.numbers =
        pair(with_every_pair_of_rows(halfspace::tangent_plane_numbers(steel, grid, problem.rows)),
             with_every_pair_of_rows(halfspace::tangent_plane_numbers(steel, grid, wheel)));
  } else {
    const InfluenceNumbers body = halfspace::influence_numbers(steel, dx, ds, size.mx + 2, size.ms);
    problem.numbers = pair(body, body);
  }
  problem.load = LoadKind::approach;
  problem.approach = (numbers == Numbers::file ? 1.54 : 1.9) / 920.0 * semi_x * semi_x; // as many in contact
  problem.force = force;
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

/// What is kept from solving the same problem before: nothing; what was prepared; and the solution of 1 %
/// less approach or force and rigid slip, from which it starts.
enum class Kept { nothing, workspace, solution };

SolverOptions options_for(const ContactProblem& problem) {
  SolverOptions options;
  options.tolerance = problem.numbers.translational ? 1e-5 : 1e-6; // outer iterations settle at ten times it
  options.estimate_discretisation = false;
  return options;
}

/// The time is that of the solver alone, to 1e-5; the counters say what a certified solution has.
void solve_scene(benchmark::State& state, const ContactProblem& problem, Kept kept, bool estimate) {
  SolverOptions options = options_for(problem);
  Workspace workspace;
  WorkBudget work;
  StartingPoint start;
  if (kept == Kept::solution) {
    ContactProblem before = problem;
    before.approach *= 0.99;
    before.force *= 0.99;
    for (auto* slip : {&before.slip_x, &before.slip_s})
      for (double& w : *slip)
        w *= 0.99;
    const ContactResult known = solve(before, options);
    start = {{known.px, known.ps, known.pn}, known.totals.approach};
    options.start = &start;
  }
  if (kept != Kept::nothing)
    contact::solve_coupled(problem, options, workspace.of(problem), work);
  contact::Solution solution;
  for (auto _ : state) {
    contact::ContactOperators only_now;
    WorkBudget of_this;
    solution = contact::solve_coupled(problem, options,
                                      kept == Kept::nothing ? only_now : workspace.of(problem), of_this);
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
  state.counters["residual"] = solve(problem, options).trust.certificate.worst();
  options = {};
  options.estimate_discretisation = problem.grid.size() < 10000;
  const ContactResult certified = solve(problem, options);
  state.counters["certificate"] = certified.trust.certificate.worst();
  state.counters["discretisation"] = certified.trust.certificate.discretisation;
}

void add(const std::string& name, const Size& size, Numbers numbers, Kind kind, bool by_force,
         Kept kept = Kept::nothing, bool estimate = false) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    ContactProblem problem = scene(size, numbers, kind);
    if (by_force)
      problem.load = LoadKind::force;
    solve_scene(state, problem, kept, estimate);
  })->Unit(benchmark::kMillisecond);
}

void add_series(bool quick) {
  for (const bool fem : {false, true})
    for (const Kind kind : {Kind::frictionless, Kind::partial_slip}) {
      const Numbers numbers = fem ? Numbers::strip : Numbers::halfspace;
      const std::string series =
          fmt::format("series/{}/{}", name_of(numbers), kind == Kind::frictionless ? "normal" : "steady");
      const double most = quick ? 3200 : fem ? 6400 : 51200;
      for (double contact = 200; contact <= most; contact *= fem || quick ? 2 : 4)
        add(fmt::format("{}/x and s/{}", series, contact), square(contact, 1.5), numbers, kind, false);
      if (!fem)
        continue;
      for (int across = 16; across <= (quick ? 64 : 256); across *= 2)
        add(fmt::format("{}/x/{}", series, across), {across * 3 / 2, 24, across * 1.0, 16}, numbers, kind,
            false);
      for (int across = 16; across <= (quick ? 64 : 128); across *= 2)
        add(fmt::format("{}/s/{}", series, across), {24, across * 3 / 2, 16, across * 1.0}, numbers, kind,
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
    for (const Numbers numbers : {Numbers::halfspace, Numbers::strip, Numbers::file})
      if (g.m < 200 || (numbers == Numbers::halfspace && !quick))
        for (const auto& [group, kept] :
             {std::pair{"goal", Kept::nothing}, {"kept", Kept::workspace}, {"warm", Kept::solution}})
          add(fmt::format("{}/{}/{}/{}", group, g.name, g.m * g.m, name_of(numbers)),
              {g.m, g.m, g.across, g.across}, numbers, g.kind, g.by_force, kept, kept == Kept::nothing);
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
          const ContactProblem problem =
              scene({m, m, 30, 30}, fem ? Numbers::strip : Numbers::halfspace, Kind::frictionless);
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
