#include "fem_influence/harmonic/harmonic_solver.hpp"

#include "bem_contact/base/stopwatch.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace bem_contact::fem {

namespace {

/// 1. The smallest eigenvalue is only printed: inverse iterations at most, and the relative change that ends
/// them.
constexpr int eigenvalue_iterations = 100;
constexpr double eigenvalue_change = 1e-3;

} // namespace

double smallest_eigenvalue(std::span<const double> kernel) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(kernel.size()))));
  const Eigen::Map<const Matrix> matrix(kernel.data(), n, n);
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success)
    return 0;
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1, 1.7).array().cos(); // of no symmetry
  double value = 0;
  for (int iteration = 0; iteration < eigenvalue_iterations; ++iteration) {
    x.normalize();
    const Eigen::VectorXd y = factor.solve(x);
    const double next = 1 / x.dot(y);
    x = y;
    if (std::abs(next - value) < eigenvalue_change * next)
      break;
    value = next;
  }
  return value / matrix.diagonal().maxCoeff();
}

namespace {

HarmonicSystem ready_to_solve(HarmonicSystem system, std::span<const int> order) {
  append_reactions(system);
  if (order.empty())
    renumber(system, elimination_order(system));
  else
    renumber(system, order);
  return system;
}

} // namespace

HarmonicSolver::HarmonicSolver(HarmonicSystem system, std::span<const int> order)
    : system_(ready_to_solve(std::move(system), order)),
      solver_(static_cast<int>(system_.unknowns()), unknowns_of_cells(system_), system_.functionals) {}

void evaluate(const HarmonicSystem& system, double k, std::vector<double>& value) {
  const SectionOperator& op = system.op;
  value.resize(9 * op.block.size()); // at least
  double* to = value.data();
  std::size_t e = 0;
  std::vector<char> held;
  for (std::size_t c = 0; c < op.cells.count(); ++c) {
    held.clear();
    for (const int node : op.cells[c])
      held.push_back(system.held(node));
    auto left = 3 * static_cast<std::size_t>(std::count(held.begin(), held.end(), 0)); // rows of a column
    for (std::size_t a = 0; a < held.size(); ++a) {
      if (held[a]) {
        e += held.size() - a;
        continue;
      }
      // The columns of one node's components, each from its diagonal on.
      std::array<double*, 3> column{to, to + left, to + 2 * left - 1};
      to += 3 * left - 3;
      left -= 3;
      const auto diagonal = op.at(e++, k);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j)
          *column[i]++ = diagonal[3 * i + j];
      for (std::size_t b = a + 1; b < held.size(); ++b, ++e) {
        if (held[b])
          continue;
        const auto entry = op.at(e, k);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            *column[i]++ = entry[3 * i + j];
      }
    }
  }
  value.resize(static_cast<std::size_t>(to - value.data()));
}

WavenumberResult HarmonicSolver::at(double k) {
  const std::size_t n = 3 * system_.stations;
  evaluate(system_, k, value_);
  solver_.factorize(value_);
  const std::vector<double>& all = solver_.schur();
  const std::size_t size = system_.functionals.columns();
  WavenumberResult result;
  result.kernel.reserve(n * n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      result.kernel.push_back(all[a * size + b] / system_.width);
  for (std::size_t m = n; m < n + 6; ++m) {
    for (std::size_t b = 0; b < n; ++b)
      result.remote.push_back(all[m * size + b]);
    for (std::size_t b = n; b < n + 6; ++b)
      result.remote_self.push_back(system_.width * all[m * size + b]);
  }
  if (k == 0)
    for (std::size_t m = 0; n + 6 + m < size; ++m)
      for (std::size_t b = 0; b < n; ++b)
        result.reaction_error =
            std::max(result.reaction_error,
                     std::abs(all[(n + 6 + m) * size + b] + system_.load_work[m * n + b]) / system_.width);
  result.smallest_eigenvalue = smallest_eigenvalue(result.kernel);
  return result;
}

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
