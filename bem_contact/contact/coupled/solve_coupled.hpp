#pragma once

#include "bem_contact/contact/normal/normal.hpp"
#include "bem_contact/contact/prepared.hpp"
#include "bem_contact/contact/tangential/creepage.hpp"

namespace bem_contact::contact {

struct Solution {
  NormalState normal;
  TangentialState shear;
  Eigen::VectorXd from_shear; ///< (A p_t)_n, mm; field
  Eigen::VectorXd distance;   ///< e, mm; field
  TangentialTask task;        ///< as solved: bounds, rigid slip
  Creepage creepage;
  double rate = 0; ///< of the outer iteration: mean factor by which a turn reduces the residual; 0: one turn
  int outer_iterations = 0;
  double pressed = 0, borne = 0; ///< vertical force of the pressure; of pressure and shear; N (load == force)
  bool unbalanced = false;       ///< no pressure bears the force prescribed, friction being what it is
  std::string remark;
};

/// Normal and tangential problem in turn (Panagiotopoulos 1975) until the displacement along n and the force
/// that the shear tractions contribute stand still. Once through where shear does not act on the normal
/// problem. Where it acts by its vertical force alone, the turns look for the pressure that balances the load
/// (force_balance.hpp); else they are accelerated after Anderson 1965, and the pressure is guessed from the
/// share that shear bears.
/// `kept` is of these numbers and this grid.
Solution solve_coupled(const ContactProblem& problem, const SolverOptions& options, Prepared& kept);

/// Pressures, states and (steady rolling) tractions of the same problem on elements twice as large, and of
/// that on larger ones: where to start from. Rows equally far apart have there the numbers of those in the
/// middle of the contact. Leaves a small problem as it is.
void start_from_coarse(const ContactProblem& problem, const SolverOptions& options, Prepared& kept,
                       Solution& start);

} // namespace bem_contact::contact
