#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Cases that one process solves one after the other, so that it can use what the former ones taught.
using Chunk = std::vector<std::size_t>;

/// Solves one case after the other; made anew in its process for each chunk. Returns what to keep of a case.
using CaseSolver = std::function<std::string(std::size_t index)>;

struct WorkerCalls {
  std::function<CaseSolver()> make_solver;                                ///< in a worker, for each chunk
  std::function<void(std::size_t index, std::string result)> done;        ///< here, in any order
  std::function<void(std::size_t index, const std::string& reason)> died; ///< here
};

/// Solves chunks in `jobs` processes side by side. Processes, not threads: neither FFTW's planner nor HDF5
/// is made for threads, and a case that kills its process costs that case alone. Workers end with this one.
/// Throws Error where no process can be started.
void solve_in_processes(std::vector<Chunk> chunks, int jobs, const WorkerCalls& calls);

} // namespace bem_contact::app
