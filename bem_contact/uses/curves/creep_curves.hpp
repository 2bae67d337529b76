#pragma once

#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/curves/creep_state.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact {

/// Kalker's linear theory for the Hertz contact that is nearest to a solved one: what small creepages would
/// give on an ellipse between half-spaces, if nothing slipped.
struct LinearTheory {
  double semi_axis_x = 0, semi_axis_s = 0; ///< mm
  double tilt = 0;                         ///< of the ellipse out of the axes x and s, rad; taken as 0
  double deviation = 0;                    ///< of the undeformed distance from a quadratic, over the approach
  double shear_modulus = 0, poisson = 0;   ///< of the pair, MPa
  reference::CreepCoefficients coefficients; ///< Kalker's C11, C22, C23, C33
  CreepMatrix slopes{};                      ///< of the forces over the creepages, by them

  double c() const; ///< sqrt(a b), mm
};

/// Returns nothing where the contact has no ellipse: several patches, a distance that is not curved both
/// ways, or semi-axes beyond the table of coefficients.
std::optional<LinearTheory> linear_theory(const SceneResult& result, const Material& rail,
                                          const Material& wheel);

/// A curve that is wanted: one creepage is varied, the other two stay what the scene says.
struct CreepRange {
  CreepKind which = CreepKind::xi; ///< the one that varies
  /// These are values as motion.xi, eta, phi mean them, in the order in which they are solved. If there are
  /// none they are chosen, to full slip on both sides of free rolling (xi) or of zero.
  std::vector<double> values;
};

/// One solution.
struct CreepPoint {
  double creepage = 0;          ///< the one that varies
  MeasuredCreepForces forces{}; ///< with their stated errors
  CreepForceValues coarse{};    ///< coarse_forces_of() it
  double adhesion_share = 0;    ///< of the area in contact
  bool certified = false;       ///< the certificate holds
  /// What the forces change by per unit of each of the scene's `derivatives`, in its order; none where the
  /// solution bends, and there is another derivative to each side. Tasks keep none.
  std::vector<CreepForceValues> slopes = {};
};

/// Forces over one creepage.
struct CreepCurve {
  CreepKind which = CreepKind::xi; ///< the one that varies
  std::vector<CreepPoint> points;  ///< in the order of the range
};

/// Derivatives of a solution (key `derivatives`), or by central differences of others.
struct CreepDerivatives {
  CreepMatrix values{}; ///< of the forces by the creepages
  /// By the size of the elements: how far the derivatives on elements twice as large lie from these; of
  /// differences also by the size of their steps. nan where larger elements have no solution.
  CreepMatrix errors{};
  bool by_differences = false; ///< of solutions beside it: the solution has no derivatives, or bends there
};

/// The forces of a contact over its creepages.
struct CreepCurves {
  SceneResult solution; ///< of the scene as it is
  double bound = 0;     ///< sum of mu p_n dS, N
  double radius = 0;    ///< c = sqrt(a b) of the ellipse, or of the area in contact, mm
  /// These hold at the scene's own creepages: what a vehicle model linearises with.
  CreepDerivatives sensitivities;
  /// These hold at zero rigid slip: without any creepage and spin, not even those that the geometry makes.
  CreepDerivatives slopes;
  std::optional<LinearTheory> linear; ///< to compare the slopes with
  std::vector<CreepCurve> curves;     ///< one for each range
  int contact_problems = 0;           ///< solved, elements twice as large included
};

/// Whether the solution and every point are certified.
bool certified(const CreepCurves& all);

/// What the first solution of a scene finds, and all points keep: so they differ by nothing but their
/// creepages.
struct HeldContact {
  Model model{};                               ///< whose influence numbers
  double dx = 0, ds = 0;                       ///< size of the elements, mm
  std::optional<double> lateral = {};          ///< of a lateral force, mm
  std::optional<double> layer_compliance = {}; ///< of layer.slope, mm^3/N
  double offset = 0;                           ///< of free rolling, where motion.xi counts from there

  bool operator==(const HeldContact&) const = default;
};

/// What the curves of a scene hold, by its first solution.
HeldContact held_by(const SceneFile& scene, const SceneResult& first);

/// Solves a scene at its own creepages, with what is held. Throws as Sequence::solve() does.
SceneResult solve_held(const SceneFile& scene, const HeldContact& held,
                       const std::atomic<bool>* stop = nullptr);

/// Throws InputError for a scene without friction, one that is no steady rolling, one that prescribes shear
/// forces, and for ranges of too many points or of values that are not finite.
void require_creepages(const SceneFile& scene, std::span<const CreepRange> ranges);

/// Solves points of the same scene: what each has but its `creepage`.
using CreepSolver =
    std::function<std::vector<CreepPoint>(const HeldContact& held, std::span<const Creepages> points)>;

/// Solves points of a scene, each from the one before; the first from what `sequence` solved last, or cold.
/// Where the scene names derivatives, points have them. Throws as creep_curves() does.
std::vector<CreepPoint> creep_points(Sequence& sequence, const SceneFile& scene, const HeldContact& held,
                                     std::span<const Creepages> points,
                                     const std::atomic<bool>* stop = nullptr);
/// The same by a sequence of its own.
std::vector<CreepPoint> creep_points(const SceneFile& scene, const HeldContact& held,
                                     std::span<const Creepages> points,
                                     const std::atomic<bool>* stop = nullptr);

/// Solves one scene in steady rolling for all points of all curves, each from the one before, or by `solve`.
/// The wheelset stays where it is: the displacement of a lateral force (load.force_y), the creepage of free
/// rolling and the compliance of a layer's slope are found once and kept, and the elements keep their size.
/// Throws as require_creepages() does; ConvergenceError as Sequence::solve() does, and Stopped where another
/// thread sets `stop`.
CreepCurves creep_curves(const SceneFile& scene, std::span<const CreepRange> ranges,
                         const std::atomic<bool>* stop = nullptr, const CreepSolver& solve = nullptr);

} // namespace bem_contact
