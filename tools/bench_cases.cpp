// What a sequence of cases costs, and how wrong it is. Seconds are CPU seconds of one thread, search
// included.
//     bench_cases ablation SWEEP.toml             the table of what each means of a sequence saves
//     bench_cases accuracy SWEEP.toml             one CSV line a case and accuracy: seconds, error, estimate
// tools/ablation and tools/accuracy run them on data/scenes/cases_*.toml. The error of a case is that against
// elements a quarter as long and wide as grid.accuracy = 2 % chooses: the largest of
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
  bool good = false;
  double Fx = 0, Fs = 0, Fy = 0, approach = 0, load = 0, friction = 0;
};

struct Tally {
  std::vector<double> seconds, error, estimate, contact;
  int iterations = 0, refused = 0, solves = 0;
};

double quantile(std::vector<double> v, double share) {
  if (v.empty())
    return std::nan("");
  std::ranges::sort(v);
  return v[static_cast<std::size_t>(share * double(v.size() - 1))];
}

/// On elements `finer` times as small as the grid's; longer ones where influence files have no numbers for
/// those.
Reference reference_of(SceneFile scene, SceneFile::Grid grid, int finer) {
  scene.grid = grid;
  scene.grid.ds /= finer;
  for (; finer > 0; finer /= 2)
    try {
      scene.grid.dx = grid.dx / finer;
      const SceneResult r = solve_scene(scene);
      return {r.result.converged, r.result.Fx, r.result.Fs,          r.result.Fy,
              r.result.approach,  r.result.Fz, scene.motion.friction};
    } catch (const Error&) {
    }
  return {};
}

std::vector<Reference> references(const SweepFile& sweep) {
  std::vector<Reference> exact;
  Progress progress("references", sweep.size());
  Sequence sequence;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    const SceneFile::Grid asked = scene.grid;
    scene.grid.accuracy = 0.02;
    Reference reference;
    try {
      const ContactGrid chosen = sequence.solve(scene).problem.grid;
      scene.grid = asked;
      scene.grid.dx = chosen.dx;
      scene.grid.ds = chosen.ds;
      reference = reference_of(scene, scene.grid, 4);
    } catch (const Error& error) {
      fmt::print(stderr, "case {} ({}): {}\n", i, sweep.describe(i), error.what());
    }
    exact.push_back(reference);
    progress.step();
  }
  progress.finish();
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
      else if (exact[i].good)
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

void accuracy(const SweepFile& sweep, const std::vector<Reference>& exact) {
  fmt::print("model,accuracy,case,cpu_seconds,error,estimate,contact,status\n");
  for (const double wanted : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
    Sequence sequence;
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      SceneFile scene = sweep.scene(i);
      scene.grid.accuracy = wanted;
      const std::clock_t start = std::clock();
      double error = std::nan(""), estimate = std::nan("");
      int contact = 0;
      std::string status = "refused";
      try {
        const SceneResult r = sequence.solve(scene);
        status = r.result.converged ? "certified" : "not certified";
        if (r.result.converged && exact[i].good)
          error = error_of(r.result, exact[i]);
        if (r.result.certificate.discretisation >= 0)
          estimate = r.result.certificate.discretisation;
        for (const PatchSummary& patch : r.result.patches)
          contact += patch.contact;
      } catch (const Error&) {
      }
      fmt::print("{},{},{},{:.5f},{:.3g},{:.3g},{},{}\n", scene.solver.model, wanted, i,
                 double(std::clock() - start) / CLOCKS_PER_SEC, error, estimate, contact, status);
    }
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (argc != 3 || (what != "ablation" && what != "accuracy")) {
    fmt::print(stderr, "usage: {} ablation|accuracy SWEEP.toml\n", argv[0]);
    return 2;
  }
  if (openblas_set_num_threads)
    openblas_set_num_threads(1);
  try {
    const SweepFile sweep = read_sweep_file(argv[2]);
    const std::vector<Reference> exact = references(sweep);
    (what == "ablation" ? ablation : accuracy)(sweep, exact);
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
