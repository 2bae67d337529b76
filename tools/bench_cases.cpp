// What a sequence of cases costs, and how wrong it is. Seconds are CPU seconds of one thread, search
// included.
//     bench_cases ablation SWEEP.toml             the table of what each means of a sequence saves
//     bench_cases accuracy SWEEP.toml             one CSV line a case and accuracy: seconds, error, estimate
//     bench_cases areas SWEEP.toml                what contact in two areas costs beside each area alone
// tools/ablation and tools/accuracy run them on data/scenes/cases_*.toml. The error of a case is that against
// elements a quarter as long and wide as grid.accuracy = 2 % chooses (.2 and .1 %: an eighth): the largest of
// the approach (relative), of the shear force over mu Fz, and of Fy over Fz.
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/sweep_file.hpp"
#include "bem_contact/wheelset/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <vector>

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace {

using namespace bem_contact;

struct Reference {
  int finer = 0; ///< along x: how many times shorter its elements are; 0: there is none
  double Fx = 0, Fs = 0, Fy = 0, approach = 0, load = 0, friction = 0;
};

struct Tally {
  std::vector<double> seconds, error, estimate, contact;
  int iterations = 0, refused = 0, solves = 0;
};

/// 0 of nothing.
double quantile(std::vector<double> v, double share) {
  if (v.empty())
    return 0;
  std::ranges::sort(v);
  return v[static_cast<std::size_t>(share * double(v.size() - 1))];
}

/// On elements `finer` times as small as the grid's; longer ones where influence files have no numbers for
/// those.
Reference reference_of(SceneFile scene, const SceneFile::Grid& grid, int finer) {
  scene.grid = grid;
  scene.grid.ds /= finer;
  std::string reason;
  for (; finer > 0; finer /= 2)
    try {
      scene.grid.dx = grid.dx / finer;
      const SceneResult r = solve_scene(scene);
      return {r.result.converged ? finer : 0,
              r.result.Fx,
              r.result.Fs,
              r.result.Fy,
              r.result.approach,
              r.result.Fz,
              scene.motion.friction};
    } catch (const Error& error) {
      reason = error.what();
    }
  throw InputError("There is no reference", reason, "Its error is left out.");
}

/// Of every `every`th case, on elements `finer` times as small as those chosen for 2 %.
std::vector<Reference> references(const SweepFile& sweep, int finer = 4, std::size_t every = 1) {
  std::vector<Reference> exact(sweep.size());
  Progress progress("references", sweep.size());
  Sequence sequence;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    const SceneFile::Grid asked = scene.grid;
    scene.grid.accuracy = 0.02;
    if (i % every == 0)
      try {
        const ContactGrid chosen = sequence.solve(scene).problem.grid;
        scene.grid = asked;
        scene.grid.dx = chosen.dx;
        scene.grid.ds = chosen.ds;
        exact[i] = reference_of(scene, scene.grid, finer);
      } catch (const Error& error) {
        fmt::print(stderr, "case {} ({}): {}\n", i, sweep.describe(i), error.what());
      }
    progress.step();
  }
  progress.finish();
  for (int times = finer; times >= 0; times = times > 1 ? times / 2 : times - 1)
    if (const auto count = std::ranges::count(exact, times, &Reference::finer);
        count > 0 && (times > 0 || every == 1))
      fmt::print(stderr, "{} cases: {}\n", count,
                 times == 0
                     ? "no reference, no error"
                     : fmt::format("reference with elements 1/{} as long, 1/{} as wide", times, finer));
  return exact;
}

double error_of(const ContactResult& r, const Reference& exact) {
  return std::max({std::abs(r.approach / exact.approach - 1),
                   std::hypot(r.Fx - exact.Fx, r.Fs - exact.Fs) / (exact.friction * exact.load),
                   std::abs(r.Fy - exact.Fy) / exact.load});
}

using Change = std::function<void(SceneFile&)>;

Tally run(const SweepFile& sweep, const SequenceOptions& options, const std::vector<Reference>& exact,
          const Change& change) {
  Tally tally;
  Sequence sequence(options);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    change(scene);
    const std::clock_t start = std::clock();
    try {
      const SceneResult r = sequence.solve(scene);
      tally.seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
      tally.iterations += r.result.outer_iterations;
      double contact = 0;
      for (const PatchSummary& patch : r.result.patches)
        contact += patch.contact;
      tally.contact.push_back(contact);
      if (r.result.certificate.discretisation >= 0)
        tally.estimate.push_back(r.result.certificate.discretisation);
      if (!r.result.converged)
        ++tally.refused;
      else if (exact[i].finer > 0)
        tally.error.push_back(error_of(r.result, exact[i]));
    } catch (const Error&) {
      ++tally.refused;
    }
  }
  tally.solves = sequence.counts().solves;
  return tally;
}

void print_head() {
  fmt::print("{:<34} {:>24} {:>7} {:>6} {:>18} {:>20} {:>20} {:>5}\n", "", "ms: median   99 %    max",
             "solves", "outer", "elements: med  max", "error: median   max", "estimate: med   max", "fail");
}

void print_row(const std::string& name, const Tally& t) {
  fmt::print(
      "{:<34} {:>10.1f} {:>6.0f} {:>6.0f} {:>7} {:>6.2f} {:>13.0f} {:>4.0f} {:>12.2f} % {:>3.1f} % {:>12.2f} "
      "% "
      "{:>3.1f} % {:>4}\n",
      name, 1e3 * quantile(t.seconds, 0.5), 1e3 * quantile(t.seconds, 0.99), 1e3 * quantile(t.seconds, 1),
      t.solves, double(t.iterations) / double(std::max<std::size_t>(t.seconds.size(), 1)),
      quantile(t.contact, 0.5), quantile(t.contact, 1), 100 * quantile(t.error, 0.5),
      100 * quantile(t.error, 1), 100 * quantile(t.estimate, 0.5), 100 * quantile(t.estimate, 1), t.refused);
  std::fflush(stdout);
}

void ablation(const SweepFile& sweep, const std::vector<Reference>& exact) {
  const auto usual = [](SceneFile& s) { s.grid.accuracy = 0.02; };
  const auto elements = [](SceneFile& s) { s.grid.elements = 200; };
  print_head();
  const auto row = [&](const std::string& name, const SequenceOptions& options, const Change& change) {
    print_row(name, run(sweep, options, exact, change));
  };
  row("everything, accuracy 2 %", {}, usual);
  row("files read for each case", {.keep_files = false}, usual);
  row("numbers computed for each case", {.keep_numbers = false}, usual);
  row("no start from the former case", {.keep_start = false}, usual);
  row("nor from a coarse grid", {.keep_start = false, .coarse_start = false}, usual);
  row("area in contact not learnt", {.learn = false}, usual);
  row("shear's part of the load not foreseen", {.foresee_shear = false}, usual);
  row("potential contact three times as deep", {.potential_contact = false}, usual);
  row("nothing kept", {false, false, false, false}, usual);
  row("200 elements in each case", {}, elements);
  row("dx, ds of 1 x .5 mm in each case", {}, [](SceneFile& s) { s.grid.dx = 1.0, s.grid.ds = 0.5; });
}

void accuracy(const SweepFile& sweep, const std::vector<double>& asked, const std::vector<Reference>& exact,
              std::size_t every) {
  for (const double wanted : asked) {
    Sequence sequence;
    for (std::size_t i = 0; i < sweep.size(); i += every) {
      SceneFile scene = sweep.scene(i);
      scene.grid.accuracy = wanted;
      const std::clock_t start = std::clock();
      std::string error, estimate, status = "refused"; // empty: not known
      int contact = 0;
      try {
        const SceneResult r = sequence.solve(scene);
        status = r.result.converged ? "certified" : "not certified";
        if (r.result.converged && exact[i].finer > 0)
          error = fmt::format("{:.3g}", error_of(r.result, exact[i]));
        if (r.result.certificate.discretisation >= 0)
          estimate = fmt::format("{:.3g}", r.result.certificate.discretisation);
        for (const PatchSummary& patch : r.result.patches)
          contact += patch.contact;
      } catch (const Error&) {
      }
      fmt::print("{},{},{},{:.5f},{},{},{},{},{}\n", scene.solver.model, wanted, i,
                 double(std::clock() - start) / CLOCKS_PER_SEC, error, estimate, contact, status,
                 exact[i].finer);
    }
    std::fflush(stdout);
  }
}

/// For .2 and .1 % the references have elements an eighth as large, and of many cases every fourth is
/// solved.
void accuracy(const SweepFile& sweep) {
  constexpr std::size_t many = 40;
  const std::size_t every = sweep.size() > many ? 4 : 1;
  fmt::print("model,accuracy,case,cpu_seconds,error,estimate,contact,status,reference\n");
  accuracy(sweep, {0.1, 0.05, 0.02, 0.01, 0.005}, references(sweep), 1);
  accuracy(sweep, {0.002, 0.001}, references(sweep, 8, every), every);
}

struct Cost {
  double seconds = 1e30;
  SceneResult result;
};

/// The least CPU seconds of some solutions from nothing, on the grid given.
Cost cost_of(const SceneFile& scene) {
  Cost cost;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const std::clock_t start = std::clock();
    SceneResult r = solve_scene(scene);
    cost.seconds = std::min(cost.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
    cost.result = std::move(r);
  }
  return cost;
}

/// Rows s_from .. s_to of a result's grid that are in contact, and the vertical force on them.
struct Part {
  double s_from = 0, s_to = 0, force = 0;
};

/// Contact parted where at least `apart` mm are without.
std::vector<Part> parts_of(const SceneResult& r, double apart) {
  const ContactGrid& grid = r.problem.grid;
  std::vector<Part> parts;
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = r.problem.rows[is];
    double force = 0;
    bool touches = false;
    for (int i = is * grid.mx; i < (is + 1) * grid.mx; ++i) {
      touches = touches || r.result.pn[i] > 0;
      force +=
          (r.result.pn[i] * std::cos(row.delta) + r.result.ps[i] * std::sin(row.delta)) * grid.dx * grid.ds;
    }
    if (!touches)
      continue;
    if (parts.empty() || row.s - parts.back().s_to > apart)
      parts.push_back({row.s, row.s, 0});
    parts.back().s_to = row.s;
    parts.back().force += force;
  }
  return parts;
}

/// Each area alone: on the same elements, with the force that it bears and the same creepages.
void areas(const SweepFile& sweep) {
  constexpr double apart = 2; // mm
  fmt::print("{:>4} {:>10} {:>8} {:>12} {:>22} {:>8}\n", "case", "grid", "contact", "together ms", "alone ms",
             "ratio");
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    const ContactGrid chosen = Sequence().solve(scene).problem.grid;
    scene.grid.accuracy = 0;
    scene.grid.dx = chosen.dx;
    scene.grid.ds = chosen.ds;
    const Cost both = cost_of(scene);
    const std::vector<Part> parts = parts_of(both.result, apart);
    double sum = 0;
    std::string alone;
    for (const Part& part : parts) {
      SceneFile one = scene;
      one.load.force = part.force;
      one.grid.s_from = part.s_from - 4 * chosen.ds;
      one.grid.s_to = part.s_to + 4 * chosen.ds;
      const double seconds = cost_of(one).seconds;
      sum += seconds;
      alone += fmt::format("{:.1f} ", 1e3 * seconds);
    }
    const ContactGrid& grid = both.result.problem.grid;
    fmt::print("{:>4} {:>10} {:>8} {:>12.1f} {:>22} {:>8.2f}\n", i, fmt::format("{} x {}", grid.mx, grid.ms),
               std::ranges::count_if(both.result.result.pn, [](double p) { return p > 0; }),
               1e3 * both.seconds, alone, both.seconds / sum);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (argc != 3 || (what != "ablation" && what != "accuracy" && what != "areas")) {
    fmt::print(stderr, "usage: {} ablation|accuracy|areas SWEEP.toml\n", argv[0]);
    return 2;
  }
  if (openblas_set_num_threads)
    openblas_set_num_threads(1);
  try {
    const SweepFile sweep = read_sweep_file(argv[2]);
    if (what == "areas") {
      areas(sweep);
      return 0;
    }
    if (what == "accuracy")
      accuracy(sweep);
    else
      ablation(sweep, references(sweep));
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
