// What a sequence of cases costs, and how wrong it is. Seconds are CPU seconds of one thread, search
// included.
//     bench_cases ablation SWEEP.toml [MODEL]     the table of each switch of wheelset/sequence.hpp
//     bench_cases accuracy SWEEP.toml [MODEL]     seconds and error together, over accuracies of 10 % to .5 %
// The error of a case is that against elements a quarter as long and wide as the scene's own dx and ds: the
// largest of the approach (relative), of the shear force over mu Fz, and of Fy over Fz.
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

Reference reference_of(const SceneFile& scene, const std::string& model) {
  SceneFile fine = scene;
  fine.grid.dx /= 4;
  fine.grid.ds /= 4;
  try {
    const SceneResult r = solve_scene(fine, model);
    return {r.result.converged, r.result.Fx, r.result.Fs,          r.result.Fy,
            r.result.approach,  r.result.Fz, scene.motion.friction};
  } catch (const Error&) {
    return {};
  }
}

double error_of(const ContactResult& r, const Reference& exact) {
  return std::max({std::abs(r.approach / exact.approach - 1),
                   std::hypot(r.Fx - exact.Fx, r.Fs - exact.Fs) / (exact.friction * exact.load),
                   std::abs(r.Fy - exact.Fy) / exact.load});
}

Tally run(const SweepFile& sweep, const std::string& model, const SequenceOptions& options,
          const std::vector<Reference>& exact, const std::function<void(SceneFile&)>& change) {
  Tally tally;
  Sequence sequence(options);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    change(scene);
    const std::clock_t start = std::clock();
    try {
      const SceneResult r = sequence.solve(scene, model);
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

void ablation(const SweepFile& sweep, const std::string& model, const std::vector<Reference>& exact) {
  const auto same = [](SceneFile&) {};
  const SequenceOptions all, none{false, false, false, false};
  print_head();
  print_row("everything", run(sweep, model, all, exact, same));
  print_row("files read for each case", run(sweep, model, {.keep_files = false}, exact, same));
  print_row("numbers computed for each case", run(sweep, model, {.keep_numbers = false}, exact, same));
  print_row("no start from the former case", run(sweep, model, {.keep_start = false}, exact, same));
  print_row("area in contact not learnt", run(sweep, model, {.learn = false}, exact, same));
  print_row("nothing kept", run(sweep, model, none, exact, same));
  print_row("200 elements", run(sweep, model, all, exact, [](SceneFile& s) { s.grid.elements = 200; }));
  print_row("elements for 2 %", run(sweep, model, all, exact, [](SceneFile& s) { s.grid.accuracy = 0.02; }));
}

void accuracy(const SweepFile& sweep, const std::string& model, const std::vector<Reference>& exact) {
  print_head();
  for (const int wanted : {60, 100, 200, 400, 800})
    print_row(fmt::format("{} elements", wanted),
              run(sweep, model, {}, exact, [&](SceneFile& s) { s.grid.elements = wanted; }));
  for (const double wanted : {0.1, 0.05, 0.02, 0.01, 0.005})
    print_row(fmt::format("accuracy {:g} %", 100 * wanted),
              run(sweep, model, {}, exact, [&](SceneFile& s) { s.grid.accuracy = wanted; }));
}

} // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "", model = argc > 3 ? argv[3] : "";
  if (argc < 3 || argc > 4 || (what != "ablation" && what != "accuracy")) {
    fmt::print(stderr, "usage: {} ablation|accuracy SWEEP.toml [MODEL]\n", argv[0]);
    return 2;
  }
  if (openblas_set_num_threads)
    openblas_set_num_threads(1);
  try {
    const SweepFile sweep = read_sweep_file(argv[2]);
    std::vector<Reference> exact;
    Progress progress("references", sweep.size());
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      exact.push_back(reference_of(sweep.scene(i), model));
      progress.step();
    }
    progress.finish();
    (what == "ablation" ? ablation : accuracy)(sweep, model, exact);
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
