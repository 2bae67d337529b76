#include "tools/benchmarks/cases/tables.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tools/benchmarks/cases/reference.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <vector>

namespace cases {

using namespace bem_contact;

namespace {

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

using Change = std::function<void(SceneFile&)>;

Tally run(const SweepFile& sweep, const SequenceAblation& options, const std::vector<Reference>& exact,
          const Change& change) {
  Tally tally;
  Sequence sequence({.ablation = options});
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    SceneFile scene = sweep.scene(i);
    change(scene);
    const std::clock_t start = std::clock();
    try {
      const SceneResult r = sequence.solve(scene);
      tally.seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
      tally.iterations += r.result.effort.outer_iterations;
      tally.contact.push_back(count_elements(r.result).contact);
      if (r.result.trust.certificate.discretisation >= 0)
        tally.estimate.push_back(r.result.trust.certificate.discretisation);
      if (!r.result.certified())
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

} // namespace

void ablation(const SweepFile& sweep, const SweepFile& by) {
  const std::vector<Reference> exact = references(sweep, by);
  const auto usual = [](SceneFile& s) { s.grid.accuracy = 0.02; };
  const auto elements = [](SceneFile& s) { s.grid.elements = 200; };
  print_head();
  const auto row = [&](const std::string& name, const SequenceAblation& options, const Change& change) {
    print_row(name, run(sweep, options, exact, change));
  };
  row("everything, accuracy 2 %", {}, usual);
  row("files read for each case", {.keep_files = false}, usual);
  row("numbers computed for each case", {.keep_numbers = false}, usual);
  row("no start from the former case", {.keep_start = false}, usual);
  row("nor from a coarse grid", {.keep_start = false, .coarse_start = false}, usual);
  row("area in contact not learnt", {.learn = false}, usual);
  row("shear's part of the load not foreseen", {.foresee_shear = false}, usual);
  row("nothing kept", {false, false, false, false}, usual);
  row("200 elements in each case", {}, elements);
  row("dx, ds of 1 x .5 mm in each case", {}, [](SceneFile& s) { s.grid.dx = 1.0, s.grid.ds = 0.5; });
}

} // namespace cases
