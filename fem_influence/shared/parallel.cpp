#include "fem_influence/shared/parallel.hpp"

#include <mpi.h>

namespace bem_contact::fem {

int process_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int process_count() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void together(const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
  } catch (...) {
    failure = std::current_exception();
  }
  const int none = process_count();
  int mine = failure ? process_rank() : none, lowest = none;
  MPI_Allreduce(&mine, &lowest, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (lowest == none)
    return;
  if (lowest == process_rank())
    std::rethrow_exception(failure);
  throw OtherProcessFailed();
}

double sum_of_all(double mine) {
  double all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

double largest_of_all(double mine) {
  double all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return all;
}

void broadcast_from_first(std::vector<char>& array) {
  MPI_Bcast(array.data(), static_cast<int>(array.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
}

} // namespace bem_contact::fem
