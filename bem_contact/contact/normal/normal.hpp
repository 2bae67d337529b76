#pragma once

#include "bem_contact/contact/grid/box.hpp"
#include "bem_contact/contact/normal/normal_lines.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "bem_contact/contact/solve.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace bem_contact::contact {

/// The operator on boxes around the active set, an approximate inverse of it, and the vectors of conjugate
/// gradients: in single precision, which corrects what is known in double precision.
struct NormalBox {
  NormalBox(const InfluenceNumbers& numbers, const Parts& box, TransformPool* pool = nullptr);

  Parts box;
  StripOperator nn;
  BasicStripOperator<float> fast;
  BasicPlaneOperator<float> inverse;
  std::vector<double> p, u;         ///< A p of the whole box
  std::vector<float> x, r, z, d, q; ///< x corrects p
  std::vector<int> local;           ///< the box's numbers of the active elements

  void invert();                                          ///< q = about A^-1 r, each box by itself
  void copy_u(int grid_mx, Eigen::VectorXd& field) const; ///< to the field of the grid
};

/// The Cholesky factor of A_nn of the elements that were last in contact: sets settle long before forces do.
struct NormalFactor {
  std::vector<int> list;
  Eigen::MatrixXd factor;
};

struct Prepared;

/// What stays the same over the outer iterations. Fields are [ms][mx].
struct NormalSystem {
  /// Without `kept` all is prepared for this system alone.
  NormalSystem(const ContactGrid& grid, const InfluenceNumbers& numbers, std::span<const ContactRow> rows,
               double element_area, Prepared* kept = nullptr);
  ~NormalSystem();

  Eigen::VectorXd apply(const Eigen::VectorXd& p) const;
  /// The same by direct sums: for a few hundred elements in contact.
  Eigen::VectorXd apply_directly(const Eigen::VectorXd& p) const;
  /// right := A_CC^-1 right on the elements of the list; false where A_CC is not positive definite.
  bool solve_dense(const std::vector<int>& list, Eigen::MatrixXd& right) const;
  /// Around these elements; the last one is kept while it serves.
  NormalBox& box_for(const std::vector<int>& elements) const;
  void spend(double elements) const; ///< work.hpp

  ContactGrid grid;
  const InfluenceNumbers* numbers; ///< of the problem, which outlives this
  Eigen::VectorXd cosine;          ///< cos(delta) of each element
  double element_area = 0;         ///< mm^2
  double self = 0;                 ///< largest self number, mm/MPa

private:
  const NormalLines& lines() const; ///< made when first asked for

  std::unique_ptr<Prepared> own_;
  Prepared* kept_;
};

/// A_CC y = rhs on the elements of the list, starting from y, by preconditioned conjugate gradients; fields.
/// The residual falls below `target` everywhere: single precision corrects until double precision agrees.
/// Afterwards u = A y inside the boxes that are returned; nothing when it fails.
const Parts* conjugate_gradients(const NormalSystem& system, const std::vector<int>& list,
                                 const Eigen::VectorXd& rhs, double target, Eigen::VectorXd& y,
                                 Eigen::VectorXd& u, int& products);

struct NormalLoad {
  LoadKind kind = LoadKind::force;
  double approach = 0; ///< q, mm
  double force = 0;    ///< sum p_n cos(delta) dS, N
};

struct NormalState {
  Eigen::VectorXd p; ///< MPa; zero outside the contact
  Eigen::VectorXd u; ///< (A p)_n, mm
  double approach = 0;
  std::vector<char> active;
  int iterations = 0;
  int products = 0; ///< of conjugate gradients
  bool converged = false;
  std::string solver, remark;
};

/// min 1/2 p'A p + (gap - q cos)'p over p >= 0; q is given, or the multiplier of the force balance.
/// `gap` contains all displacements but those of p_n.
///
/// Primal-dual active set (Hintermueller, Ito, Kunisch 2002); the linear systems by Cholesky or, as precisely
/// as the sets are known, by conjugate gradients with the FFT, preconditioned by the inverse of the periodic
/// operator (Vollebregt 2014). Starts from state.active, state.p and state.approach where active is not
/// empty. Where the sets cycle: MPRGP, inside a bracketing of q when the force is given.
void solve_normal(const NormalSystem& system, const Eigen::VectorXd& gap, const NormalLoad& load,
                  const SolverOptions& options, NormalState& state);

/// min 1/2 p'A p - b'p over p >= 0 by MPRGP (Dostal, Schoeberl 2005): converges for every positive definite
/// A. Returns the number of products; stops when the projected gradient is below tolerance * scale.
int solve_mprgp(const NormalSystem& system, const Eigen::VectorXd& b, double tolerance, int most,
                Eigen::VectorXd& p, bool& converged);

/// MPRGP, with the approach found by bracketing when the force is given.
void solve_normal_safely(const NormalSystem& system, const Eigen::VectorXd& gap, const NormalLoad& load,
                         const SolverOptions& options, NormalState& state);

} // namespace bem_contact::contact
