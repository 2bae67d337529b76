// What whole answers cost: the cases of a sweep file, solved one after the other by one sequence.
//     bench_answers SWEEP.toml REPEATS      a CSV line a case; each repeat with a sequence of its own
// tools/benchmarks/bench_answers builds it for older commits too; this is why it asks what there is.
#include "bem_contact/base/error.hpp"
#if __has_include("bem_contact/base/program.hpp")
#include "bem_contact/base/program.hpp"
#elif __has_include("bem_contact/base/memory.hpp")
#include "bem_contact/base/memory.hpp"
#else
namespace bem_contact {
inline void keep_freed_memory() {} // the programs of older commits do not
} // namespace bem_contact
#endif
#if __has_include("bem_contact/scene/sweep_file.hpp")
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/sequence.hpp"
#else
#include "bem_contact/base/sweep_file.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/wheelset/sequence.hpp"
#endif

#include <ctime>
#include <fmt/format.h>
#include <string>
#include <sys/resource.h>
#include <utility>

using namespace bem_contact;

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace {

/// Pages that the process had to be given so far.
long page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Certificate and estimate; older commits have them within the solution.
template <class Seconds> std::pair<double, double> checks_of(const Seconds& seconds) {
  if constexpr (requires { seconds.estimate; })
    return {seconds.check, seconds.estimate};
  else
    return {0, 0};
}

void answer(const SweepFile& sweep, int repeat) {
  Sequence sequence;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SceneFile scene = sweep.scene(i);
    const long faults = page_faults();
    const std::clock_t start = std::clock();
    const SceneResult r = sequence.solve(scene);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    const auto [check, estimate] = checks_of(r.seconds);
    fmt::print("{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{},{},{},{},{}\n", repeat, i, seconds,
               r.seconds.geometry, r.seconds.numbers, r.seconds.solve, check, estimate,
               page_faults() - faults, r.problem.grid.size(), count_elements(r.result).contact,
               sequence.counts().solves, int(r.result.certified()));
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: {} SWEEP.toml REPEATS\n", argv[0]);
    return 2;
  }
  if (openblas_set_num_threads)
    openblas_set_num_threads(1);
  keep_freed_memory();
  try {
    const SweepFile sweep = read_sweep_file(argv[1]);
    fmt::print(
        "repeat,case,cpu_seconds,geometry,numbers,solve,check,estimate,page_faults,elements,contact,solves,"
        "certified\n");
    for (int repeat = 0; repeat < std::stoi(argv[2]); ++repeat)
      answer(sweep, repeat);
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
