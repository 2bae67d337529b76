#include "tools/benchmarks/cases/tables.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tools/benchmarks/cases/reference.hpp"

#include <ctime>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace cases {

using namespace bem_contact;

namespace {

void print_columns() {
  fmt::print("model,accuracy,case,cpu_seconds,error,estimate,contact,dx,ds,status,reference\n");
}

void rows(const SweepFile& sweep, const std::vector<double>& asked, const std::vector<Reference>& exact,
          std::size_t every) {
  for (const double wanted : asked) {
    Sequence sequence;
    for (std::size_t i = 0; i < sweep.size(); i += every) {
      SceneFile scene = sweep.scene(i);
      scene.grid.accuracy = wanted;
      scene.grid.accuracy_of = {ErrorQuantity::forces}; // error_of() knows nothing of pmax
      const std::clock_t start = std::clock();
      std::string error, estimate, elements = ",", status = "refused"; // empty: not known
      int contact = 0;
      try {
        const SceneResult r = sequence.solve(scene);
        status = r.result.certified() ? "certified" : "not certified";
        if (r.result.certified() && exact[i].finer > 0)
          error = fmt::format("{:.3g}", error_of(r.result, exact[i]));
        if (r.result.trust.certificate.discretisation >= 0)
          estimate = fmt::format("{:.3g}", r.result.trust.certificate.discretisation);
        elements = fmt::format("{:.4g},{:.4g}", r.problem.grid.dx, r.problem.grid.ds);
        contact = count_elements(r.result).contact;
      } catch (const Error&) {
      }
      fmt::print("{},{},{},{:.5f},{},{},{},{},{},{}\n", name_of(scene.solver.model), wanted, i,
                 double(std::clock() - start) / CLOCKS_PER_SEC, error, estimate, contact, elements, status,
                 exact[i].finer);
    }
    std::fflush(stdout);
  }
}

} // namespace

void files(const SweepFile& sweep, const SweepFile& by) {
  print_columns();
  rows(sweep, {0.02}, references(sweep, by, 1), 1);
}

void accuracy(const SweepFile& sweep, const SweepFile& by) {
  const bool halfspace = sweep.scene(0).solver.model == Model::halfspace;
  const std::size_t every = halfspace ? 4 : 3;
  print_columns();
  const std::vector<Reference> exact = references(sweep, by);
  rows(sweep, {0.1, 0.05, 0.02, 0.01, 0.005}, exact, 1);
  // Full numbers would fill the memory, and what their files are off by is far more.
  rows(sweep, {0.002, 0.001}, halfspace ? references(sweep, by, 8, every) : exact, every);
}

} // namespace cases
