#include "fem_influence/harmonic_solver.hpp"

#include "bem_contact/base/error.hpp"

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

double product(const SparseColumns& a, std::size_t column, std::span<const double> x) {
  double sum = 0;
  for (std::size_t e = a.column_begin[column]; e < a.column_begin[column + 1]; ++e)
    sum += a.value[e] * x[static_cast<std::size_t>(a.row[e])];
  return sum;
}

/// Replaces a square matrix by its symmetric part; returns the largest asymmetry over the diagonal.
double symmetrise(std::vector<double>& a, std::size_t n) {
  double error = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double &x = a[i * n + j], &y = a[j * n + i];
      error = std::max(error, std::abs(x - y) / std::sqrt(a[i * n + i] * a[j * n + j]));
      x = y = 0.5 * (x + y);
    }
  return error;
}

} // namespace

double reference_radius_of(const BodyFile& body) {
  if (body.body.kind == "outline")
    return body.body.reference_radius;
  return body.body.kind == "wheel" ? wheel_reference_radius : 0.0;
}

double half_period_of(const BodyFile& body) {
  const double radius = reference_radius_of(body);
  return radius > 0 ? std::numbers::pi * radius : body.harmonic.half_period;
}

Timing& Timing::operator+=(const Timing& other) {
  assembly += other.assembly;
  analysis += other.analysis;
  factorization += other.factorization;
  solve += other.solve;
  sampling += other.sampling;
  return *this;
}

HarmonicSolver::HarmonicSolver(const Section& section, const BodyFile& body, const ProfileCurve& curve)
    : reference_radius_(reference_radius_of(body)), width_(body.strip.station_width),
      stations_(make_stations(body.strip, curve)) {
  std::vector<int> row, column;
  {
    const Stopwatch watch(timing_.assembly);
    loads_ = station_functionals(section, curve, body.strip, stations_);
    const SparseColumns remote = remote_functionals(section, stations_, body.harmonic.remote_distance);
    operator_ = assemble(section, body.material, reference_radius_);

    unknown_.assign(3 * section.node_count(), -1);
    int next = 0;
    for (std::size_t d = 0; d < unknown_.size(); ++d)
      if (!section.held()[d / 3])
        unknown_[d] = next++;
    unknowns_ = static_cast<std::size_t>(next);
    append_unknowns(rhs_, loads_, unknown_);
    append_unknowns(rhs_, remote, unknown_);

    for (std::size_t a = 0; a < operator_.node_count(); ++a)
      for (std::size_t e = operator_.row_begin[a]; e < operator_.row_begin[a + 1]; ++e) {
        const auto b = static_cast<std::size_t>(operator_.column[e]);
        if (section.held()[a] || section.held()[b])
          continue;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = a == b ? i : 0; j < 3; ++j) {
            row.push_back(unknown_[3 * a + i]);
            column.push_back(unknown_[3 * b + j]);
            entry_.push_back(9 * e + 3 * i + j);
          }
      }

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
      rigid_reaction_.push_back(operator_.apply(0.0, held));
      rigid_.push_back(std::move(motion));
    }
  }
  const Stopwatch watch(timing_.analysis);
  solver_ = std::make_unique<MumpsSolver>(static_cast<int>(unknowns_), row, column);
}

WavenumberResult HarmonicSolver::at(double k) {
  const std::size_t n = 3 * stations_.size();
  {
    const Stopwatch watch(timing_.factorization);
    std::vector<double> value;
    value.reserve(entry_.size());
    for (const std::size_t e : entry_)
      value.push_back(operator_.value[0][e] + k * (operator_.value[1][e] + k * operator_.value[2][e]));
    solver_->factorize(value);
  }
  WavenumberResult result;
  result.kernel.assign(n * n, 0.0);
  result.remote.assign(6 * n, 0.0);
  result.remote_self.assign(36, 0.0);
  double sampling = 0;
  {
    const Stopwatch watch(timing_.solve);
    solver_->solve(rhs_, [&](std::size_t c, std::span<const double> x) {
      const Stopwatch inner(sampling);
      if (c >= n) {
        for (std::size_t m = 0; m < 6; ++m)
          result.remote_self[m * 6 + c - n] = width_ * product(rhs_, n + m, x);
        return;
      }
      for (std::size_t a = 0; a < n; ++a)
        result.kernel[a * n + c] = product(rhs_, a, x) / width_;
      for (std::size_t m = 0; m < 6; ++m)
        result.remote[m * n + c] = product(rhs_, n + m, x);
      if (k == 0)
        for (const double error : held_motion_reactions(c, x))
          result.reaction_error = std::max(result.reaction_error, error);
    });
  }
  timing_.solve -= sampling;
  timing_.sampling += sampling;
  result.betti_error = symmetrise(result.kernel, n);
  symmetrise(result.remote_self, 6);
  return result;
}

/// Virtual work over a rigid motion at k = 0: the supports' reaction K u - f on the held part and the load f
/// must balance. Relative to the load's size.
std::vector<double> HarmonicSolver::held_motion_reactions(std::size_t column,
                                                          std::span<const double> solution) const {
  std::vector<double> errors;
  for (std::size_t m = 0; m < rigid_.size(); ++m) {
    double balance = 0;
    for (std::size_t d = 0; d < unknown_.size(); ++d)
      if (unknown_[d] >= 0)
        balance += rigid_reaction_[m][d] * solution[static_cast<std::size_t>(unknown_[d])];
    for (std::size_t e = loads_.column_begin[column]; e < loads_.column_begin[column + 1]; ++e)
      if (const auto d = static_cast<std::size_t>(loads_.row[e]); unknown_[d] >= 0)
        balance += rigid_[m][d] * loads_.value[e];
    errors.push_back(std::abs(balance) / width_);
  }
  return errors;
}

} // namespace bem_contact::fem
