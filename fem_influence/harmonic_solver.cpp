#include "fem_influence/harmonic_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace bem_contact::fem {

namespace {

class Stopwatch {
public:
  explicit Stopwatch(double& total) : total_(total) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  double& total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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
  for (int iteration = 0; iteration < 100; ++iteration) {
    x.normalize();
    const Eigen::VectorXd y = factor.solve(x);
    const double next = 1 / x.dot(y);
    x = y;
    if (std::abs(next - value) < 1e-3 * next)
      break;
    value = next;
  }
  return value / matrix.diagonal().maxCoeff();
}

double reference_radius_of(const BodyFile& body) {
  if (body.body.kind == "outline")
    return body.body.reference_radius;
  return body.body.kind == "wheel" ? wheel_reference_radius : 0.0;
}

double half_period_of(const BodyFile& body) {
  const double radius = reference_radius_of(body);
  return radius > 0 ? std::numbers::pi * radius : body.harmonic.half_period;
}

template <class Use> void HarmonicSolver::for_each_free_block(Use&& use) const {
  for (std::size_t a = 0; a < operator_.node_count(); ++a)
    if (unknown_[3 * a] >= 0)
      for (std::size_t e = operator_.row_begin[a]; e < operator_.row_begin[a + 1]; ++e)
        if (const auto b = static_cast<std::size_t>(operator_.column[e]); unknown_[3 * b] >= 0)
          use(a, b, e);
}

HarmonicSolver::HarmonicSolver(const Section& section, const BodyFile& body, const ProfileCurve& curve)
    : reference_radius_(reference_radius_of(body)), width_(body.strip.station_width),
      stations_(make_stations(body.strip, curve)) {
  const Stopwatch watch(timing_.assembly);
  const SparseColumns loads = station_functionals(section, curve, body.strip, stations_);
  const SparseColumns remote = remote_functionals(section, stations_, body.harmonic.remote_distance);
  operator_ = assemble(section, body.material, reference_radius_);

  unknown_.assign(3 * section.node_count(), -1);
  int next = 0;
  for (std::size_t d = 0; d < unknown_.size(); ++d)
    if (!section.held()[d / 3])
      unknown_[d] = next++;
  unknowns_ = static_cast<std::size_t>(next);
  append_unknowns(rhs_, loads, unknown_);
  append_unknowns(rhs_, remote, unknown_);

  // The support's reaction on a rigid motion m of the held part is a functional as well: (K m)^T u.
  for (auto& motion : rigid_motions(section.node_positions(), reference_radius_, 0)) {
    double largest = 0;
    for (const double u : motion)
      largest = std::max(largest, std::abs(u));
    for (double& u : motion)
      u /= largest;
    std::vector<double> held(motion.size(), 0.0);
    for (std::size_t d = 0; d < held.size(); ++d)
      if (unknown_[d] < 0)
        held[d] = motion[d];
    const std::vector<double> reaction = operator_.apply(0.0, held);
    for (std::size_t d = 0; d < reaction.size(); ++d)
      if (unknown_[d] >= 0 && reaction[d] != 0) {
        rhs_.row.push_back(unknown_[d]);
        rhs_.value.push_back(reaction[d]);
      }
    rhs_.column_begin.push_back(rhs_.row.size());
    auto& work = load_work_.emplace_back();
    for (std::size_t c = 0; c < loads.columns(); ++c) {
      work.push_back(0);
      for (std::size_t e = loads.column_begin[c]; e < loads.column_begin[c + 1]; ++e)
        if (const auto d = static_cast<std::size_t>(loads.row[e]); unknown_[d] >= 0)
          work.back() += motion[d] * loads.value[e];
    }
  }
}

void HarmonicSolver::analyse() {
  const Stopwatch watch(timing_.analysis);
  std::vector<int> row, column;
  for (auto* list : {&row, &column})
    list->reserve(9 * operator_.column.size());
  for_each_free_block([&](std::size_t a, std::size_t b, std::size_t) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = a == b ? i : 0; j < 3; ++j) {
        row.push_back(unknown_[3 * a + i]);
        column.push_back(unknown_[3 * b + j]);
      }
  });
  solver_ = std::make_unique<MumpsSolver>(static_cast<int>(unknowns_), std::move(row), std::move(column),
                                          rhs_, 3); // a node is held in all three components, or free in all
}

WavenumberResult HarmonicSolver::at(double k) {
  if (!solver_)
    analyse();
  const std::size_t n = 3 * stations_.size();
  {
    const Stopwatch watch(timing_.factorization);
    std::vector<double> value;
    value.reserve(9 * operator_.column.size());
    for_each_free_block([&](std::size_t a, std::size_t b, std::size_t e) {
      const auto entry = operator_.at(e, k);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = a == b ? i : 0; j < 3; ++j)
          value.push_back(entry[3 * i + j]);
    });
    solver_->factorize(std::move(value));
  }
  const std::vector<double>& all = solver_->schur();
  const std::size_t size = rhs_.columns();
  WavenumberResult result;
  result.kernel.reserve(n * n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      result.kernel.push_back(all[a * size + b] / width_);
  for (std::size_t m = n; m < n + 6; ++m) {
    for (std::size_t b = 0; b < n; ++b)
      result.remote.push_back(all[m * size + b]);
    for (std::size_t b = n; b < n + 6; ++b)
      result.remote_self.push_back(width_ * all[m * size + b]);
  }
  if (k == 0)
    for (std::size_t m = 0; m < load_work_.size(); ++m)
      for (std::size_t b = 0; b < n; ++b)
        result.reaction_error = std::max(result.reaction_error,
                                         std::abs(all[(n + 6 + m) * size + b] + load_work_[m][b]) / width_);
  result.smallest_eigenvalue = smallest_eigenvalue(result.kernel);
  return result;
}

} // namespace bem_contact::fem
