#include "fem_influence/mumps_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <dmumps_c.h>
#include <metis.h>
#include <mpi.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace bem_contact::fem {

namespace {
constexpr int block = 128; // right-hand sides solved at once: more costs memory and gains nothing

/// Of a matrix given by the entries of one triangle.
std::vector<int> place_of_rows(int size, std::span<const int> row, std::span<const int> column) {
  std::vector<std::size_t> begin(static_cast<std::size_t>(size) + 1, 0);
  for (const int i : row)
    ++begin[static_cast<std::size_t>(i) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> sorted(column.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t e = 0; e < row.size(); ++e)
    sorted[next[static_cast<std::size_t>(row[e])]++] = column[e];
  return nested_dissection(begin, sorted, std::vector<char>(static_cast<std::size_t>(size), 1));
}
} // namespace

std::vector<int> nested_dissection(std::span<const std::size_t> begin, std::span<const int> column,
                                   std::span<const char> used) {
  const std::size_t nodes = used.size();
  std::vector<int> vertex(nodes), place(nodes); // of METIS's graph; of a node
  int count = 0;
  for (std::size_t a = 0; a < nodes; ++a)
    vertex[a] = used[a] ? count++ : -1;
  const auto for_each_edge = [&](auto&& use) {
    for (std::size_t a = 0; a < nodes; ++a)
      for (std::size_t e = begin[a]; e < begin[a + 1]; ++e)
        if (const auto b = static_cast<std::size_t>(column[e]); a != b && used[a] && used[b])
          use(static_cast<std::size_t>(vertex[a]), static_cast<std::size_t>(vertex[b]));
  };
  std::vector<idx_t> first(static_cast<std::size_t>(count) + 1, 0);
  for_each_edge([&](std::size_t a, std::size_t b) {
    ++first[a + 1];
    ++first[b + 1];
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<idx_t> neighbour(static_cast<std::size_t>(first.back())), next(first.begin(), first.end() - 1);
  for_each_edge([&](std::size_t a, std::size_t b) {
    neighbour[static_cast<std::size_t>(next[a]++)] = static_cast<idx_t>(b);
    neighbour[static_cast<std::size_t>(next[b]++)] = static_cast<idx_t>(a);
  });
  idx_t vertices = count;
  std::vector<idx_t> order(static_cast<std::size_t>(count)), of_vertex(order);
  if (METIS_NodeND(&vertices, first.data(), neighbour.data(), nullptr, nullptr, order.data(),
                   of_vertex.data()) != METIS_OK)
    throw Error("The unknowns could not be ordered", "METIS refused the matrix's graph",
                "report this as a bug");
  for (std::size_t a = 0; a < nodes; ++a)
    place[a] = used[a] ? static_cast<int>(of_vertex[static_cast<std::size_t>(vertex[a])]) : count++;
  return place;
}

struct MumpsSolver::Impl {
  DMUMPS_STRUC_C id{};
  std::vector<MUMPS_INT> row, column;
  std::vector<double> value, border_value, schur;
  std::vector<MUMPS_INT> schur_variable, position;

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

void append_unknowns(SparseColumns& to, const SparseColumns& from, std::span<const int> unknown) {
  for (std::size_t c = 0; c < from.columns(); ++c) {
    for (std::size_t e = from.column_begin[c]; e < from.column_begin[c + 1]; ++e)
      if (const int row = unknown[static_cast<std::size_t>(from.row[e])]; row >= 0) {
        to.row.push_back(row);
        to.value.push_back(from.value[e]);
      }
    to.column_begin.push_back(to.row.size());
  }
}

MumpsSolver::MumpsSolver(int size, std::vector<int> row, std::vector<int> column, const SparseColumns& border,
                         std::span<const int> place)
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
  std::vector<int> found;
  if (place.empty()) // Debian's MUMPS has no METIS of its own
    place = found = place_of_rows(size, row, column);
  impl_->position.reserve(place.size() + border.columns());
  for (const int p : place)
    impl_->position.push_back(p + 1);
  impl_->row = std::move(row);
  impl_->column = std::move(column);
  for (auto* index : {&impl_->row, &impl_->column})
    for (MUMPS_INT& i : *index)
      ++i;
  const auto bordered = static_cast<int>(border.columns());
  for (int c = 0; c < bordered; ++c) {
    impl_->schur_variable.push_back(size + c + 1);
    for (std::size_t e = border.column_begin[static_cast<std::size_t>(c)];
         e < border.column_begin[static_cast<std::size_t>(c) + 1]; ++e) {
      impl_->row.push_back(border.row[e] + 1);
      impl_->column.push_back(size + c + 1);
    }
  }
  impl_->border_value = border.value;
  id.n = size + bordered;
  for (const int variable : impl_->schur_variable)
    impl_->position.push_back(variable);
  impl_->control(7) = 1;
  id.perm_in = impl_->position.data();
  if (bordered > 0) {
    impl_->control(19) = 1; // the Schur complement of the border, given back as one dense matrix
    id.size_schur = bordered;
    id.listvar_schur = impl_->schur_variable.data();
    impl_->schur.assign(static_cast<std::size_t>(bordered) * static_cast<std::size_t>(bordered), 0.0);
    id.schur = impl_->schur.data();
  }
  id.nnz = static_cast<MUMPS_INT8>(impl_->row.size());
  id.irn = impl_->row.data();
  id.jcn = impl_->column.data();
  impl_->call(1);
  impl_->check("analysis");
}

MumpsSolver::~MumpsSolver() {
  impl_->call(-2);
}

double MumpsSolver::estimated_memory() const {
  return impl_->id.infog[15] * 1e6 / (1024.0 * 1024.0 * 1024.0);
}

void MumpsSolver::factorize(std::vector<double> value) {
  impl_->value = std::move(value);
  impl_->value.insert(impl_->value.end(), impl_->border_value.begin(), impl_->border_value.end());
  impl_->id.a = impl_->value.data();
  for (int attempt = 0; attempt < 3; ++attempt) {
    impl_->call(2);
    if (impl_->id.infog[0] != -9 && impl_->id.infog[0] != -8)
      break;
    impl_->control(14) *= 3; // the estimate of the work space was too small
  }
  impl_->check("factorization");
  // MUMPS gives one triangle of -B^T K^-1 B.
  const std::size_t m = impl_->schur_variable.size();
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double& lower = impl_->schur[i * m + j];
      lower = -lower;
      impl_->schur[j * m + i] = lower;
    }
}

const std::vector<double>& MumpsSolver::schur() const {
  return impl_->schur;
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
