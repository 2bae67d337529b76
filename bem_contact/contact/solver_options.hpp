#pragma once

#include "bem_contact/contact/problem.hpp"

#include <functional>

namespace bem_contact {

struct ContactResult;
class Workspace;

/// A guess at the solution, on the problem's grid.
struct StartingPoint : Tractions {
  double approach = 0; ///< mm
};

/// The solution of nearly the same problem: with other creepages or shear forces alone. Its pressure is held
/// in the first outer iteration, and only changes where what shear does to it calls for that.
struct NearSolution : StartingPoint {
  Tractions shear_guess;                 ///< px and ps to begin with
  double creepage_x = 0, creepage_s = 0; ///< and creepages, as ContactResult has them
};

/// Ends a solution early where it is only rough, but its estimated errors already say that smaller elements
/// are needed.
struct EarlyEnd {
  double change = 0; ///< relative; an outer iteration that changed less gave a rough solution
  /// Called with the first one, which is not certified, and with its estimated errors.
  std::function<bool(const ContactProblem&, const ContactResult&)> ends;
};

struct SolverOptions {
  double tolerance = 1e-8;  ///< of the solvers, relative; the certificate asks for 1e-6
  int max_outer = 50;       ///< outer (Panagiotopoulos) iterations between the normal and tangential problem
  int max_normal = 200;     ///< changes of the active set
  int max_tangential = 250; ///< Newton steps for given p_n
  int max_sweeps = 1000;    ///< Gauss-Seidel sweeps if Newton fails
  bool only_newton = false; ///< no other method if Newton fails
  /// Where friction falls with slip: begin with everything sliding, not with everything in adhesion.
  bool from_sliding = false;
  bool estimate_discretisation = true;
  bool displacements = false; ///< ContactResult::displacements is wanted
  bool coarse_start = true;   ///< without `start`, solve a large problem on larger elements first
  /// Starts from here instead of larger elements. A guess without pressure, or on another grid, is ignored.
  const StartingPoint* start = nullptr;
  const NearSolution* near = nullptr; ///< in place of `start`
  /// Creepages of prescribed forces are all that is asked for. Tractions are precise enough where what their
  /// equations miss adds up to no more force than may be missing.
  bool forces_alone = false;
  /// Go on from the factors and directions that the last solution left in the workspace. The result then
  /// depends on that one, as it does on `start`, within the certificate.
  bool continues = false;
  const EarlyEnd* early_end = nullptr; ///< null: every solution is precise
  Workspace* workspace = nullptr;      ///< prepared for earlier problems (solve.hpp); null: for this one only
};

} // namespace bem_contact
