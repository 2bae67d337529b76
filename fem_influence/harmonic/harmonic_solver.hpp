#pragma once

#include "bem_contact/base/stopwatch.hpp"
#include "fem_influence/harmonic/section_operator.hpp"
#include "fem_influence/shared/mumps_solver.hpp"
#include "fem_influence/shared/strip.hpp"

namespace bem_contact::fem {

/// Radius at which a wheel's angle is measured as a length: x = R_ref theta, r = R_ref + z, mm.
inline constexpr double wheel_reference_radius = 460.0;

double reference_radius_of(const BodyFile& body); ///< 0 for prismatic bodies
double half_period_of(const BodyFile& body);      ///< L, mm

struct Timing {
  double assembly = 0, analysis = 0, factorization = 0; ///< seconds; the factors bring the kernel with them
  friend Timing operator+(const Timing& a, const Timing& b) {
    return {a.assembly + b.assembly, a.analysis + b.analysis, a.factorization + b.factorization};
  }
};

/// What one wavenumber gives; layout as in InfluenceFunction.
struct WavenumberResult {
  std::vector<double> kernel;      ///< 3NS x 3NS, symmetric to the last bit
  std::vector<double> remote;      ///< 6 x 3NS
  std::vector<double> remote_self; ///< 6 x 6
  double betti_error = 0;          ///< largest |g_ab - g_ba| / sqrt(g_aa g_bb): the two are computed as one
  double smallest_eigenvalue = 0;  ///< of the kernel, over its largest diagonal entry
  double reaction_error = 0;       ///< at k = 0: largest |reaction + load| / load over the rigid motions
};

/// Of a symmetric matrix, over its largest diagonal entry: positive when every traction does positive work.
/// By Cholesky factors and inverse iteration; 0 where there are no such factors.
double smallest_eigenvalue(std::span<const double> kernel);

/// All that the problems of the section have in common.
struct HarmonicSystem {
  std::size_t cells = 0, stations = 0;
  double width = 0; ///< of a station, mm
  SectionOperator op;
  std::vector<int> unknown;      ///< of degree of freedom 3 node + component; -1: held
  SparseColumns functionals;     ///< of the unknowns: stations', remote
  SparseColumns held_motion;     ///< of the degrees of freedom: rigid motions of the held part
  std::vector<double> load_work; ///< [rigid motion][load]: work of the load on the unknowns
  std::size_t nodes() const { return unknown.size() / 3; }
  std::size_t unknowns() const;
  /// In all three components; the others are held in none.
  bool held(int node) const { return unknown[3 * static_cast<std::size_t>(node)] < 0; }
  /// use(array) and use(number) of everything above but op's blocks, always in the same order: to send it to
  /// others.
  template <class Use> void for_each_part(Use&& use) {
    use(cells), use(stations), use(width), use(op.mu), use(op.lambda);
    use(op.cells.begin), use(op.cells.member), use(unknown), use(load_work);
    for (SparseColumns* columns : {&functionals, &held_motion})
      use(columns->column_begin), use(columns->row), use(columns->value);
  }
};

HarmonicSystem assemble_system(const Section& section, const BodyFile& body, const ProfileCurve& curve);
/// The same without the blocks of its operator, which take most of the time: fill() gives them. `chosen`: of
/// these stations alone, in this order; none: of all.
HarmonicSystem lay_out_system(const Section& section, const BodyFile& body, const ProfileCurve& curve,
                              std::span<const std::size_t> chosen = {});
/// Place of each node in the elimination, the held ones last. Deterministic, so that who computes it does not
/// matter.
std::vector<int> elimination_order(const HarmonicSystem& system);
/// Numbers the unknowns by their nodes' places.
void renumber(HarmonicSystem& system, std::span<const int> place);

/// The section's problem for any wavenumber: with F the stations' functionals and r the remote ones,
///     kernel = F^T K^-1 F / ds, remote = r^T K^-1 F, remote_self = ds r^T K^-1 r.
/// The unit generalised load of remote_self is ds times a unit, as a unit traction on a station is: so
/// kernel - remote^T remote_self^-1 remote is the kernel with the six means of the remote section held at 0.
class HarmonicSolver {
public:
  /// `order`: of elimination; empty: elimination_order().
  explicit HarmonicSolver(HarmonicSystem system, std::vector<int> order = {});

  std::size_t unknowns() const { return system_.unknowns(); }
  WavenumberResult at(double wavenumber);
  const Timing& timing() const { return timing_; }

private:
  /// Orders the unknowns and lays out the factors, if that was not done.
  void analyse();
  /// K(k) as MumpsSolver takes it, in value_.
  void evaluate(double k);

  HarmonicSystem system_;
  std::vector<int> order_;
  std::unique_ptr<MumpsSolver> solver_;
  std::vector<double> value_;
  Timing timing_;
};

} // namespace bem_contact::fem
