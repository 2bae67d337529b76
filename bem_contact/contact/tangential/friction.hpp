#pragma once

#include "bem_contact/contact/grid/box.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/contact/tangential/gmres.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace bem_contact::contact {

/// The numbers B = sum_k step[k] A(x_I + k dx - x_J) (SlipStep::present), tangential components, unrolled for
/// dot products along x: for rows I, J and components c, d the 2 mx - 1 values of offset mx-1 .. -(mx-1).
class StepNumbers {
public:
  StepNumbers(const InfluenceNumbers& numbers, int mx, const std::array<double, 3>& step);

  /// Value at [ix'] is B_cd of the element (ix, row_i) under a load at (ix', row_j).
  const double* line(int ix, int row_i, int c, int row_j, int d) const {
    return &values_[(((static_cast<std::size_t>(row_i) * ms_ + row_j) * 2 + c) * 2 + d) * (2 * mx_ - 1) +
                    mx_ - 1 - ix];
  }

private:
  int mx_, ms_;
  std::vector<double> values_;
};

/// B on boxes around the contact and an approximate inverse of it; fields [2][box.rows()][box.mx()].
struct StepBox {
  StepBox(const InfluenceNumbers& numbers, const Parts& box, const SlipStep& rule,
          TransformPool* pool = nullptr);

  /// out = B in
  void step();
  /// fast_out = B fast_in
  void fast_step();
  /// fast_out = about B_SS^-1 fast_in, S the elements whose `sticks` is set; zero elsewhere, in `fast_in` as
  /// well.
  ///
  /// B = D A with D = sum_k step[k] (x + k dx), x and s apart. Where S ends ahead, at the leading edge, the
  /// inverse is nearly exact: A_behind^-1, then D^-1 from that edge on, then A_ahead^-1, each on S alone.
  void invert();
  /// What invert_damped() does from now on.
  void set_damping(double shift, double stiffness);
  /// fast_out = about (shift + stiffness B)^-1 fast_in, x and s apart: what slips obeys such a matrix along
  /// its own bound, where the shift damps so well that borders need no respect.
  void invert_damped();

  /// One element in contact of the linearisation at hand (newton.cpp).
  struct Element {
    Eigen::Matrix2f projection; ///< M
    float stiffness, m, scale;  ///< r; trace of M; of a slipping element, between it and the mean of all
  };

  Parts box;
  SlipStep rule;
  StripOperator tt;
  BasicStripOperator<float> fast;
  std::vector<BasicPlaneOperator<float>> behind, ahead, periodic, damped; ///< of A_xx, A_ss
  std::vector<char> sticks;
  std::vector<Element> elements;
  std::vector<double> in, out;
  std::vector<float> fast_in, fast_out;
  Gmres gmres;

private:
  /// Of x and of s, each box by itself.
  void apply_each(const std::vector<BasicPlaneOperator<float>>& of, std::vector<float>& from,
                  std::vector<float>& to);
};

/// B of the few elements that were last in contact, [x, s] of the first, of the second, ...
struct StepMatrix {
  std::vector<int> contact;
  std::array<double, 3> step{};
  Eigen::MatrixXd matrix;
};

struct Prepared;

/// One step of rolling or shift on a grid; vectors are fields of two components, [2][ms][mx].
class TangentialSystem {
public:
  /// Without `kept` all is prepared for this system alone.
  explicit TangentialSystem(const ContactProblem& problem, Prepared* kept = nullptr);
  TangentialSystem(TangentialSystem&&) noexcept;
  ~TangentialSystem();

  int size() const { return problem->grid.size(); }
  Eigen::VectorXd displacement(const Eigen::VectorXd& p,
                               int columns = 0) const;     ///< A_tt p at x + columns dx, mm
  Eigen::VectorXd step(const Eigen::VectorXd& p) const;    ///< B_tt p, mm
  const StepNumbers& step_numbers() const;                 ///< made when first asked for
  void spend(double elements) const;                       ///< work.hpp
  double product_work(int rows) const;                     ///< work.hpp
  StepBox& box_for(const std::vector<int>& contact) const; ///< the last one is kept while it serves
  const Eigen::MatrixXd& matrix_for(const std::vector<int>& contact) const; ///< likewise

  const ContactProblem* problem;
  SlipStep rule;
  Eigen::VectorXd stiffness; ///< 1 / mean of B_xx, B_ss of the element itself, MPa/mm; field of one component

private:
  const StripOperator& whole() const; ///< A_tt on the whole grid, made when first asked for

  std::unique_ptr<Prepared> own_;
  Prepared* kept_;
};

/// |p_t| <= bound; S = drive - B_tt p; stick or slip along S.
struct TangentialTask {
  Eigen::VectorXd bound;    ///< mu p_n, MPa; field
  Eigen::VectorXd rigid;    ///< w of the step, mm
  Eigen::VectorXd drive;    ///< rigid - (B p_n)_t + what former tractions left, mm
  std::vector<int> contact; ///< elements with p_n > 0
  double slip_floor = 0;    ///< mm: slip below this is rounding
};

struct TangentialState {
  Eigen::VectorXd p, slip; ///< p_t, MPa; S = drive - B p in contact, mm
  int iterations = 0;
  int products = 0; ///< of GMRES
  bool converged = false;
  double violation = 0;
  std::string solver, remark;
};

/// The largest rigid slip w or elastic slip S - w of the elements in contact, and at least `floor`; mm.
double largest_slip(const Eigen::VectorXd& rigid, const std::vector<int>& contact,
                    const Eigen::VectorXd& slip, double floor);

/// The largest violation of Coulomb's law: of the cone, and of the nearer of adhesion (|S| over the largest
/// slip) and slip (p_t against mu p_n S/|S|, over mu pmax).
double coulomb_violation(const TangentialSystem& system, const TangentialTask& task, const Eigen::VectorXd& p,
                         const Eigen::VectorXd& slip);

/// Newton on p = Proj(p + r S) (semi-smooth; Hueber, Stadler, Wohlmuth 2008, for given p_n).
void newton(const TangentialSystem&, const TangentialTask&, const SolverOptions&, TangentialState&);
/// Gauss-Seidel from the leading edge, element by element (after SteadyGS: Vollebregt 2010), damped.
void sweeps(const TangentialSystem&, const TangentialTask&, double tolerance, int most, TangentialState&);
/// Rolls on from the present tractions, `steps` columns with p_n held: each step is a convex problem. A
/// transient step or a shift is such a problem itself.
void roll_on(const TangentialSystem&, const TangentialTask&, const SolverOptions&, int steps,
             TangentialState&);
/// Newton; then sweeps; then rolling on and Newton again.
void solve_tangential(const TangentialSystem&, const TangentialTask&, const SolverOptions&, TangentialState&);

} // namespace bem_contact::contact
