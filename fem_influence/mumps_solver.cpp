#include "fem_influence/mumps_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <string>

namespace bem_contact::fem {

namespace {
constexpr int block = 128; // right-hand sides solved at once: more costs memory and gains nothing
}

struct MumpsSolver::Impl {
  DMUMPS_STRUC_C id{};
  std::vector<MUMPS_INT> row, column;
  std::vector<double> value;

  // MUMPS counts from 1.
  MUMPS_INT& control(int n) { return id.icntl[n - 1]; }

  void call(int job) {
    id.job = job;
    dmumps_c(&id);
  }

  void check(const char* what) {
    if (id.infog[0] >= 0)
      return;
    const std::string codes =
        "INFOG(1) = " + std::to_string(id.infog[0]) + ", INFOG(2) = " + std::to_string(id.infog[1]);
    if (id.infog[0] == -10 || id.infog[0] == -40)
      throw InputError("The stiffness matrix is not positive definite",
                       "MUMPS found no Cholesky factors, " + codes,
                       "check that the mesh's group 'held' holds the body and that no element is inverted");
    if (id.infog[0] == -13 || id.infog[0] == -9 || id.infog[0] == -8)
      throw Error(std::string("MUMPS ran out of memory in the ") + what, codes,
                  "use a coarser mesh, a lower degree or fewer processes");
    throw Error(std::string("MUMPS failed in the ") + what, codes,
                "look the code up in the MUMPS users' guide");
  }
};

MumpsSolver::MumpsSolver(int size, std::span<const int> row, std::span<const int> column)
    : impl_(std::make_unique<Impl>()) {
  auto& id = impl_->id;
  id.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  id.par = 1;
  id.sym = 1;
  impl_->call(-1);
  impl_->check("start");
  for (const int stream : {1, 2, 3, 4})
    impl_->control(stream) = 0; // silent
  impl_->control(14) = 30;
  impl_->row.reserve(row.size());
  impl_->column.reserve(row.size());
  for (std::size_t e = 0; e < row.size(); ++e) {
    impl_->row.push_back(row[e] + 1);
    impl_->column.push_back(column[e] + 1);
  }
  id.n = size;
  id.nnz = static_cast<MUMPS_INT8>(row.size());
  id.irn = impl_->row.data();
  id.jcn = impl_->column.data();
  impl_->call(1);
  impl_->check("analysis");
}

MumpsSolver::~MumpsSolver() {
  impl_->call(-2);
}

void MumpsSolver::factorize(std::span<const double> value) {
  impl_->value.assign(value.begin(), value.end());
  impl_->id.a = impl_->value.data();
  for (int attempt = 0; attempt < 3; ++attempt) {
    impl_->call(2);
    if (impl_->id.infog[0] != -9 && impl_->id.infog[0] != -8)
      break;
    impl_->control(14) *= 3; // the estimate of the work space was too small
  }
  impl_->check("factorization");
}

void MumpsSolver::solve(const SparseColumns& rhs,
                        const std::function<void(std::size_t, std::span<const double>)>& use) {
  auto& id = impl_->id;
  const auto n = static_cast<std::size_t>(id.n);
  std::vector<double> solution;
  std::vector<MUMPS_INT> begin, row;
  std::vector<double> value;
  for (std::size_t first = 0; first < rhs.columns(); first += block) {
    const std::size_t last = std::min(first + block, rhs.columns());
    const std::size_t from = rhs.column_begin[first], to = rhs.column_begin[last];
    begin.clear();
    for (std::size_t c = first; c <= last; ++c)
      begin.push_back(static_cast<MUMPS_INT>(rhs.column_begin[c] - from + 1));
    row.clear();
    for (std::size_t e = from; e < to; ++e)
      row.push_back(rhs.row[e] + 1);
    value.assign(rhs.value.begin() + static_cast<std::ptrdiff_t>(from),
                 rhs.value.begin() + static_cast<std::ptrdiff_t>(to));
    solution.assign(n * (last - first), 0.0);
    impl_->control(20) = 3;      // sparse right-hand sides, exploited
    impl_->control(27) = -block; // all of this block at once
    id.nrhs = static_cast<MUMPS_INT>(last - first);
    id.lrhs = id.n;
    id.nz_rhs = static_cast<MUMPS_INT>(row.size());
    id.rhs_sparse = value.data();
    id.irhs_sparse = row.data();
    id.irhs_ptr = begin.data();
    id.rhs = solution.data();
    impl_->call(3);
    impl_->check("solve");
    for (std::size_t c = first; c < last; ++c)
      use(c, std::span<const double>(solution).subspan(n * (c - first), n));
  }
}

} // namespace bem_contact::fem
