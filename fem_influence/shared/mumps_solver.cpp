#include "fem_influence/shared/mumps_solver.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "fem_influence/shared/settings.hpp"

#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace bem_contact::fem {

namespace {

/// %. Work space that MUMPS gets on top of its own estimate, ICNTL(14). Not measured: a moderate start, for
/// a factorization that runs out of it is repeated with more.
constexpr int work_space_margin = 30;
/// 1. Factor by which the margin grows for each repetition, and how often the factorization is tried. Not
/// measured: three attempts reach 270 %.
constexpr int work_space_growth = 3;
constexpr int work_space_attempts = 3;

} // namespace

struct MumpsSolver::Impl {
  DMUMPS_STRUC_C id{};
  std::vector<MUMPS_INT> begin, unknown, position, schur_unknown;
  std::vector<double> border_value, schur;

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
                       "Check that the mesh's group 'held' holds the body and that no element is inverted.");
    if (id.infog[0] == -13 || id.infog[0] == -9 || id.infog[0] == -8)
      throw Error(std::string("MUMPS ran out of memory in the ") + what, codes,
                  "Use a coarser mesh, a lower degree or fewer processes.");
    throw Error(std::string("MUMPS failed in the ") + what, codes,
                "Look the code up in the MUMPS users' guide.");
  }
};

MumpsSolver::MumpsSolver(int size, Elements elements, const SparseColumns& border)
    : impl_(std::make_unique<Impl>()) {
  auto& [id, begin, unknown, position, schur_unknown, border_value, schur] = *impl_;
  id.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  id.par = 1;
  id.sym = 1;
  impl_->call(-1);
  impl_->check("start");
  for (const int stream : {1, 2, 3, 4})
    impl_->control(stream) = 0; // silent
  impl_->control(14) = work_space_margin;
  border_value = add_border(elements, size, border);
  for (const std::size_t e : elements.begin)
    begin.push_back(static_cast<MUMPS_INT>(e + 1));
  unknown = std::move(elements.member);
  for (MUMPS_INT& u : unknown)
    ++u;
  // The entries of an assembled matrix would be sorted anew for each of its values: a sixth of the time.
  impl_->control(5) = 1;
  id.nelt = static_cast<MUMPS_INT>(begin.size() - 1);
  id.eltptr = begin.data();
  id.eltvar = unknown.data();
  const auto bordered = static_cast<int>(border.columns());
  id.n = size + bordered;
  position.resize(static_cast<std::size_t>(id.n));
  std::iota(position.begin(), position.end(), 1);
  impl_->control(7) = 1; // the order is given: Debian's MUMPS has no METIS of its own
  id.perm_in = position.data();
  if (bordered > 0) {
    impl_->control(31) = 1; // no factors are kept, for nothing is solved
    impl_->control(19) = 1; // the Schur complement of the border, given back as one dense matrix
    schur_unknown.assign(position.end() - bordered, position.end());
    id.size_schur = bordered;
    id.listvar_schur = schur_unknown.data();
    schur.assign(static_cast<std::size_t>(bordered) * static_cast<std::size_t>(bordered), 0.0);
    id.schur = schur.data();
  }
  impl_->call(1);
  impl_->check("analysis");
}

MumpsSolver::~MumpsSolver() {
  impl_->call(-2);
}

double MumpsSolver::estimated_memory() const {
  return impl_->id.infog[15] * 1e6 / (1024.0 * 1024.0 * 1024.0);
}

void MumpsSolver::factorize(std::vector<double>& value) {
  const std::size_t own = value.size();
  value.insert(value.end(), impl_->border_value.begin(), impl_->border_value.end());
  impl_->id.a_elt = value.data();
  for (int attempt = 0; attempt < work_space_attempts; ++attempt) {
    impl_->call(2);
    if (impl_->id.infog[0] != -9 && impl_->id.infog[0] != -8)
      break;
    impl_->control(14) *= work_space_growth; // the estimate of the work space was too small
  }
  value.resize(own);
  impl_->check("factorization");
  // MUMPS gives one triangle of -B^T K^-1 B.
  auto& schur = impl_->schur;
  const std::size_t m = impl_->schur_unknown.size();
  for (std::size_t i = 0; i < m; ++i)
    schur[i * m + i] = -schur[i * m + i];
  for_each_below_diagonal(
      m, [&](std::size_t i, std::size_t j) { schur[j * m + i] = schur[i * m + j] = -schur[i * m + j]; });
}

const std::vector<double>& MumpsSolver::schur() const {
  return impl_->schur;
}

void MumpsSolver::solve(const SparseColumns& rhs,
                        const std::function<void(std::size_t, std::span<const double>)>& use) {
  auto& id = impl_->id;
  const auto n = static_cast<std::size_t>(id.n), block = static_cast<std::size_t>(settings::solve_block);
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
    impl_->control(20) = 3;                      // sparse right-hand sides, exploited
    impl_->control(27) = -settings::solve_block; // all of this block at once
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
