#pragma once

#include "bem_contact/contact/check/certificate.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/work.hpp"

#include <list>
#include <memory>
#include <optional>

namespace bem_contact {

namespace contact {
class ContactOperators;
class TransformPool;
} // namespace contact

/// Keeps what solving prepares from influence numbers, for a sequence of problems: give it to every solve()
/// (SolverOptions::workspace). It reuses what it prepared only if the influence numbers are identical, bit by
/// bit, and the grid has as many elements. The results are those without it; where a solution goes on from
/// the one before (SolverOptions::start, continues), within the certificate. One workspace serves one thread
/// at a time.
///
/// This is all that lives longer than one call of solve() in this room (bem_contact/contact):
///   the workspace       sets of operators, the one used last in front; beyond `most` sets, the one that was
///                       not used for longest is discarded
///   a set               (contact::ContactOperators) for one set of influence numbers on one grid:
///     normal            A_nn on the grid and on boxes around the contact; the last Cholesky factor
///     tangential        A_tt on the grid; the operator B from shear tractions to the slip of one step, on
///                       boxes around the contact; of few elements the last dense B and LU factors
///     coupling          how shear and pressure act on each other, if they do
///     start             numbers of larger elements to start from, and a set of their own
///     companion         a set for the larger elements of the estimate of the discretisation
///     scratch           vectors of conjugate gradients and GCR, allocated once
///   the transform pool  Fourier transforms and their scratch, shared by all sets (plane_transforms.hpp)
/// Besides, FFTW remembers how it planned a length, for the whole program.
class Workspace {
public:
  /// `most`: how many sets are kept. `threads`: how many work on a product, a spectrum or a sum, if it is
  /// large enough (settings.hpp: least_threaded); results are the same to the last bit.
  explicit Workspace(int most = 2, int threads = 1);
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  /// Returns to the solvers what is prepared from the influence numbers of this problem.
  contact::ContactOperators& of(const ContactProblem& problem);

  int threads() const;
  int prepared() const { return prepared_; } ///< sets of numbers met for the first time
  int kept() const { return kept_; }         ///< how often a set was met again

private:
  int most_, prepared_ = 0, kept_ = 0;
  std::shared_ptr<contact::TransformPool> pool_;
  std::list<std::unique_ptr<contact::ContactOperators>> sets_; ///< used last: in front
};

/// Solves one contact problem: the normal problem alone, or with friction. Without contact the result has
/// zero force and no patches. If the solvers do not converge the result is not certified() and says why;
/// nothing is thrown. Throws InputError for a problem that is not valid or has no solution, ConvergenceError
/// if the work allowed is used up.
ContactResult solve(const ContactProblem& problem, const SolverOptions& options = {});

/// Does the same with a budget that all problems of one case (one scene) share.
ContactResult solve(const ContactProblem& problem, const SolverOptions& options, WorkBudget& work);

/// Finds the creepage along x at which a contact in steady rolling bears no longitudinal force (force_x = 0),
/// counted as ContactTotals::creepage_x: it is added to the problem's rigid slip. `near` is the certified
/// solution of nearly the same problem: with other tractions alone, as a prescribed creepage `creepage`
/// (counted alike) leaves them. Newton's method begins there, and it ends where what is left of the force is
/// worth a tenth of the stated error. That error is from larger elements, as that of a precise solution is.
/// Nothing is certified: what no method finds at once is nothing here, and a whole solution may find it.
/// Throws as solve() does.
std::optional<Measured> free_creepage(const ContactProblem& problem, const ContactResult& near,
                                      double creepage, const SolverOptions& options, WorkBudget& work);

/// The estimate of the discretisation joins pairs of rows: the first of them, of `rows` rows where those in
/// contact are lowest .. highest. Of an odd number one at an end is left out, the one farther from the
/// contact.
int first_joined_row(int rows, int lowest, int highest);

} // namespace bem_contact
