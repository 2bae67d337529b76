#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Cases that one process solves one after the other, each from what it learnt of those before.
using Chunk = std::vector<std::size_t>;

/// All cases in chunks. They do not depend on the number of processes.
std::vector<Chunk> chunks_of(std::size_t cases);

/// Solves one case and returns what to keep of it. Each chunk gets a new solver, in its own process.
using CaseSolver = std::function<std::string(std::size_t index)>;

/// Why a case has no result: its solver threw an InputError, a ConvergenceError or anything else, or its
/// process ended.
enum class CaseFailure : std::uint64_t { refused = 1, not_converged, fault, died };

struct WorkerCalls {
  std::function<CaseSolver()> make_solver;                         ///< in a worker, for each chunk
  std::function<void(std::size_t index, std::string result)> done; ///< here, in any order
  std::function<void(std::size_t index, CaseFailure how, const std::string& reason)> failed; ///< here
};

/// Solves chunks in `jobs` processes side by side; 0: one for each core. We use processes, not threads,
/// because FFTW's planner and HDF5 are not safe with threads, and because a case that kills its process then
/// costs only itself. Workers end when this process ends. Throws Error if no process can be started.
void solve_in_processes(std::vector<Chunk> chunks, int jobs, const WorkerCalls& calls);

} // namespace bem_contact::app
