#pragma once

#include <exception>
#include <functional>
#include <vector>

/// The processes of a run: all of MPI_COMM_WORLD. MPI must be initialised. "Together" means that all
/// processes call a function, and that each waits for the others in it.
namespace bem_contact::fem {

int process_rank();
int process_count();

/// Thrown on the processes that did not fail themselves. The one that failed reports its error.
class OtherProcessFailed : public std::exception {
public:
  const char* what() const noexcept override { return "another process failed and says why"; }
};

/// Runs `work` on every process and waits for all of them. If it throws on some, the lowest of those rethrows
/// and all others throw OtherProcessFailed: no process is left waiting.
void together(const std::function<void()>& work);

double sum_of_all(double mine);     ///< together
double largest_of_all(double mine); ///< together
/// Together; the first process's values, as many on each.
void broadcast_from_first(std::vector<char>& array);

} // namespace bem_contact::fem
