#include "fem_influence/harmonic_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

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

std::size_t HarmonicSystem::unknowns() const {
  return static_cast<std::size_t>(
      std::count_if(unknown.begin(), unknown.end(), [](int u) { return u >= 0; }));
}

HarmonicSystem assemble_system(const Section& section, const BodyFile& body, const ProfileCurve& curve) {
  HarmonicSystem system;
  const double reference_radius = reference_radius_of(body);
  const std::vector<Station> stations = make_stations(body.strip, curve);
  system.cells = section.cell_count();
  system.stations = stations.size();
  system.width = body.strip.station_width;
  const SparseColumns loads = station_functionals(section, curve, body.strip, stations);
  const SparseColumns remote = remote_functionals(section, stations, body.harmonic.remote_distance);
  system.op = assemble(section, body.material, reference_radius);

  auto& unknown = system.unknown;
  unknown.assign(3 * section.node_count(), -1);
  int next = 0;
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (!section.held()[d / 3])
      unknown[d] = next++;
  append_unknowns(system.functionals, loads, unknown);
  append_unknowns(system.functionals, remote, unknown);

  // The support's reaction on a rigid motion m of the held part is a functional as well: (K m)^T u.
  for (auto& motion : rigid_motions(section.node_positions(), reference_radius, 0)) {
    double largest = 0;
    for (const double u : motion)
      largest = std::max(largest, std::abs(u));
    for (double& u : motion)
      u /= largest;
    std::vector<double> held(motion.size(), 0.0);
    for (std::size_t d = 0; d < held.size(); ++d)
      if (unknown[d] < 0)
        held[d] = motion[d];
    const std::vector<double> reaction = system.op.apply(0.0, held);
    for (std::size_t d = 0; d < reaction.size(); ++d)
      if (unknown[d] >= 0 && reaction[d] != 0) {
        system.functionals.row.push_back(unknown[d]);
        system.functionals.value.push_back(reaction[d]);
      }
    system.functionals.column_begin.push_back(system.functionals.row.size());
    for (std::size_t c = 0; c < loads.columns(); ++c) {
      double work = 0;
      for (std::size_t e = loads.column_begin[c]; e < loads.column_begin[c + 1]; ++e)
        if (const auto d = static_cast<std::size_t>(loads.row[e]); unknown[d] >= 0)
          work += motion[d] * loads.value[e];
      system.load_work.push_back(work);
    }
  }
  return system;
}

std::vector<int> elimination_order(const HarmonicSystem& system) {
  std::vector<char> used;
  for (std::size_t a = 0; a < system.op.node_count(); ++a)
    used.push_back(system.unknown[3 * a] >= 0); // a node is held in all three components, or free in all
  return nested_dissection(system.op.row_begin, system.op.column, used);
}

void renumber(HarmonicSystem& system, std::span<const int> place) {
  system.op = renumbered(system.op, place);
  std::vector<int> unknown(system.unknown.size(), -1), moved(system.unknowns());
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (system.unknown[d] >= 0) {
      const int to = 3 * place[d / 3] + static_cast<int>(d % 3);
      unknown[static_cast<std::size_t>(to)] = moved[static_cast<std::size_t>(system.unknown[d])] = to;
    }
  system.unknown = std::move(unknown);
  for (int& row : system.functionals.row)
    row = moved[static_cast<std::size_t>(row)];
}

HarmonicSolver::HarmonicSolver(HarmonicSystem system, std::function<std::vector<int>()> order)
    : system_(std::move(system)), order_(std::move(order)) {}

void HarmonicSolver::analyse() {
  if (solver_)
    return;
  const Stopwatch watch(timing_.analysis);
  renumber(system_, order_ ? order_() : elimination_order(system_));
  std::vector<int> row, column;
  for (auto* list : {&row, &column})
    list->reserve(9 * system_.op.column.size());
  system_.for_each_free_block([&](std::size_t a, std::size_t b, std::size_t) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = a == b ? i : 0; j < 3; ++j) {
        row.push_back(system_.unknown[3 * a + i]);
        column.push_back(system_.unknown[3 * b + j]);
      }
  });
  std::vector<int> place(unknowns());
  std::iota(place.begin(), place.end(), 0);
  solver_ = std::make_unique<MumpsSolver>(static_cast<int>(unknowns()), std::move(row), std::move(column),
                                          system_.functionals, place);
}

WavenumberResult HarmonicSolver::at(double k) {
  analyse();
  const std::size_t n = 3 * system_.stations;
  {
    const Stopwatch watch(timing_.factorization);
    std::vector<double> value;
    value.reserve(9 * system_.op.column.size());
    system_.for_each_free_block([&](std::size_t a, std::size_t b, std::size_t e) {
      const auto entry = system_.op.at(e, k);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = a == b ? i : 0; j < 3; ++j)
          value.push_back(entry[3 * i + j]);
    });
    solver_->factorize(std::move(value));
  }
  const std::vector<double>& all = solver_->schur();
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

} // namespace bem_contact::fem
