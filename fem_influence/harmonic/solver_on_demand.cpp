#include "fem_influence/harmonic/solver_on_demand.hpp"

#include "bem_contact/base/stopwatch.hpp"

namespace bem_contact::fem {

SolverOnDemand::SolverOnDemand(std::function<AssembledSystem()> assemble, Timing& timing)
    : assemble_(std::move(assemble)), timing_(timing) {}

WavenumberResult SolverOnDemand::at(double wavenumber) {
  if (!solver_) {
    AssembledSystem assembled = assemble_();
    const TimedScope timer(timing_.analysis);
    solver_.emplace(std::move(assembled.system), assembled.order);
  }
  const TimedScope timer(timing_.factorization);
  return solver_->at(wavenumber);
}

} // namespace bem_contact::fem
