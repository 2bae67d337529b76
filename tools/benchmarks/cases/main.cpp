// What a sequence of cases costs, and how wrong it is.
//     bench_cases ablation SWEEP.toml [BY.toml]   the table of what each means of a sequence saves
//     bench_cases accuracy SWEEP.toml [BY.toml]   one CSV line a case and accuracy: seconds, error, estimate
//     bench_cases files SWEEP.toml BY.toml        the same, of the influence files alone
//     bench_cases areas SWEEP.toml                what contact in two areas costs beside each area alone
//     bench_cases estimates SWEEP.toml            one CSV line a case and printed number: stated and true
//     error
// tools/benchmarks/ablation and tools/benchmarks/accuracy run them on data/scenes/cases_*.toml. BY.toml has
// the same cases with the influence files from which references are computed.
#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "tools/benchmarks/cases/tables.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <string>

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

int main(int argc, char** argv) {
  using namespace bem_contact;
  const std::string what = argc > 1 ? argv[1] : "";
  const bool with_reference = what == "ablation" || what == "accuracy" || what == "files";
  if (argc < 3 || argc > (with_reference ? 4 : 3) ||
      (!with_reference && what != "areas" && what != "estimates")) {
    fmt::print(
        stderr,
        "usage: {0} ablation|accuracy|files SWEEP.toml [BY.toml]\n       {0} areas|estimates SWEEP.toml\n",
        argv[0]);
    return 2;
  }
  if (openblas_set_num_threads)
    openblas_set_num_threads(1);
  spdlog::set_default_logger(spdlog::stderr_color_mt("bench_cases")); // tables go to standard output
  try {
    const SweepFile sweep = read_sweep_file(argv[2]), by = read_sweep_file(argv[argc - 1]);
    if (by.size() != sweep.size())
      throw InputError("the references are of other cases",
                       fmt::format("{} and {} cases", sweep.size(), by.size()),
                       "give a file with the same [sweep]");
    if (what == "areas")
      cases::areas(sweep);
    else if (what == "estimates")
      cases::estimates(sweep);
    else if (what == "accuracy")
      cases::accuracy(sweep, by);
    else if (what == "files")
      cases::files(sweep, by);
    else
      cases::ablation(sweep, by);
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
