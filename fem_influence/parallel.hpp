#pragma once

#include <exception>
#include <functional>

namespace bem_contact::fem {

/// This process among those of MPI_COMM_WORLD; MPI must be initialised.
int process_rank();
int process_count();

/// Thrown on the processes whose fellow failed; that one reports the error itself.
class FellowFailed : public std::exception {
public:
  const char* what() const noexcept override { return "another process failed and says why"; }
};

/// Runs `work` on every process and waits for all of them. Where it throws on some, the lowest of those
/// rethrows and all others throw FellowFailed: nobody is left waiting.
void together(const std::function<void()>& work);

} // namespace bem_contact::fem
