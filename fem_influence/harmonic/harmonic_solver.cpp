#include "fem_influence/harmonic/harmonic_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::fem {

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
  if (body.body.kind == BodyKind::outline)
    return body.body.reference_radius;
  return body.body.kind == BodyKind::wheel ? wheel_reference_radius : 0.0;
}

double half_period_of(const BodyFile& body) {
  const double radius = reference_radius_of(body);
  return radius > 0 ? std::numbers::pi * radius : body.harmonic.half_period;
}

std::size_t HarmonicSystem::unknowns() const {
  return static_cast<std::size_t>(
      std::count_if(unknown.begin(), unknown.end(), [](int u) { return u >= 0; }));
}

namespace {

/// The three columns of each of these stations.
SparseColumns of_stations(const SparseColumns& loads, std::span<const std::size_t> stations) {
  SparseColumns some;
  for (const std::size_t J : stations)
    for (std::size_t c = 3 * J; c < 3 * J + 3; ++c) {
      for (std::size_t e = loads.column_begin[c]; e < loads.column_begin[c + 1]; ++e) {
        some.row.push_back(loads.row[e]);
        some.value.push_back(loads.value[e]);
      }
      some.column_begin.push_back(some.row.size());
    }
  return some;
}

} // namespace

HarmonicSystem lay_out_system(const Section& section, const BodyFile& body, const ProfileCurve& curve,
                              std::span<const std::size_t> chosen) {
  HarmonicSystem system;
  const double reference_radius = reference_radius_of(body);
  const std::vector<Station> stations = make_stations(body.strip, curve);
  system.cells = section.cell_count();
  system.stations = chosen.empty() ? stations.size() : chosen.size();
  system.width = body.strip.station_width;
  const SparseColumns all_loads = station_functionals(section, curve, body.strip, stations);
  const SparseColumns loads = chosen.empty() ? all_loads : of_stations(all_loads, chosen);
  const SparseColumns remote = remote_functionals(section, stations, body.harmonic.remote_distance);
  system.op = lay_out(section, body.material, reference_radius);

  auto& unknown = system.unknown;
  unknown.assign(3 * section.node_count(), -1);
  int next = 0;
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (!section.held()[d / 3])
      unknown[d] = next++;
  if (next == 0)
    throw InputError("The mesh has nothing that can move", "all its nodes lie on the group 'held'",
                     "hold a part of the body, or refine the mesh");
  append_unknowns(system.functionals, loads, unknown);
  append_unknowns(system.functionals, remote, unknown);

  for (auto& motion : rigid_motions(section.node_positions(), reference_radius, 0)) {
    double largest = 0;
    for (const double u : motion)
      largest = std::max(largest, std::abs(u));
    for (std::size_t d = 0; d < motion.size(); ++d) {
      motion[d] /= largest;
      if (unknown[d] < 0) {
        system.held_motion.row.push_back(static_cast<int>(d));
        system.held_motion.value.push_back(motion[d]);
      }
    }
    system.held_motion.column_begin.push_back(system.held_motion.row.size());
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

HarmonicSystem assemble_system(const Section& section, const BodyFile& body, const ProfileCurve& curve) {
  HarmonicSystem system = lay_out_system(section, body, curve);
  fill(system.op, section, reference_radius_of(body));
  return system;
}

namespace {

/// The support's reaction on a rigid motion m of the held part is a functional as well: (K m)^T u.
void append_reactions(HarmonicSystem& system) {
  const SparseColumns& held = system.held_motion;
  for (std::size_t c = 0; c < held.columns(); ++c) {
    std::vector<double> motion(system.unknown.size(), 0.0);
    for (std::size_t e = held.column_begin[c]; e < held.column_begin[c + 1]; ++e)
      motion[static_cast<std::size_t>(held.row[e])] = held.value[e];
    const std::vector<double> reaction = system.op.apply(0.0, motion);
    for (std::size_t d = 0; d < reaction.size(); ++d)
      if (system.unknown[d] >= 0 && reaction[d] != 0) {
        system.functionals.row.push_back(system.unknown[d]);
        system.functionals.value.push_back(reaction[d]);
      }
    system.functionals.column_begin.push_back(system.functionals.row.size());
  }
}

} // namespace

std::vector<int> elimination_order(const HarmonicSystem& system) {
  Elements free;
  std::vector<int> nodes;
  for (std::size_t c = 0; c < system.op.cells.count(); ++c) {
    nodes.clear();
    for (const int node : system.op.cells[c])
      if (!system.held(node))
        nodes.push_back(node);
    free.add(nodes);
  }
  return nested_dissection(system.nodes(), free);
}

void renumber(HarmonicSystem& system, std::span<const int> place) {
  std::vector<int> moved(system.unknowns());
  for (std::size_t d = 0; d < system.unknown.size(); ++d)
    if (int& u = system.unknown[d]; u >= 0)
      u = moved[static_cast<std::size_t>(u)] = 3 * place[d / 3] + static_cast<int>(d % 3);
  for (int& row : system.functionals.row)
    row = moved[static_cast<std::size_t>(row)];
}

HarmonicSolver::HarmonicSolver(HarmonicSystem system, std::vector<int> order)
    : system_(std::move(system)), order_(std::move(order)) {}

void HarmonicSolver::analyse() {
  if (solver_)
    return;
  const Stopwatch watch(timing_.analysis);
  append_reactions(system_);
  renumber(system_, order_.empty() ? elimination_order(system_) : order_);
  Elements elements;
  std::vector<int> members;
  for (std::size_t c = 0; c < system_.op.cells.count(); ++c) {
    members.clear();
    for (const int node : system_.op.cells[c])
      if (!system_.held(node))
        for (std::size_t i = 0; i < 3; ++i)
          members.push_back(system_.unknown[3 * static_cast<std::size_t>(node) + i]);
    if (!members.empty())
      elements.add(members);
  }
  solver_ =
      std::make_unique<MumpsSolver>(static_cast<int>(unknowns()), std::move(elements), system_.functionals);
}

void HarmonicSolver::evaluate(double k) {
  const SectionOperator& op = system_.op;
  value_.resize(9 * op.block.size()); // at least
  double* to = value_.data();
  std::size_t e = 0;
  std::vector<char> held;
  for (std::size_t c = 0; c < op.cells.count(); ++c) {
    held.clear();
    for (const int node : op.cells[c])
      held.push_back(system_.held(node));
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
  value_.resize(static_cast<std::size_t>(to - value_.data()));
}

WavenumberResult HarmonicSolver::at(double k) {
  analyse();
  const std::size_t n = 3 * system_.stations;
  {
    const Stopwatch watch(timing_.factorization);
    evaluate(k);
    solver_->factorize(value_);
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
