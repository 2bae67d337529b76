#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/comparison.hpp"
#include "bem_contact/sequence/scene_description.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <atomic>
#include <memory>
#include <vector>

namespace bem_contact {

class SequenceFiles; // shared_files.hpp

/// Serves benchmarks alone: switches off what saves time (tools/benchmarks/ablation shows what each saves).
struct SequenceAblation {
  bool keep_files = true; ///< profiles and influence files are kept (SequenceFiles)
  /// Influence numbers of a known grid are not computed again, nor what the solver prepares from them.
  bool keep_numbers = true;
  /// A case starts from the tractions of the case before, moved and scaled. If the bodies may now touch in
  /// other areas than in that case (alike()), it starts from larger elements instead.
  bool keep_start = true;
  bool learn = true;        ///< learn the ratio of the area in contact to the predicted one (ContactEstimate)
  bool coarse_start = true; ///< a case without one before it starts from larger elements
  bool foresee_shear = true; ///< the estimate counts the part of the load that shear bears
};

/// How a sequence works.
struct SequenceOptions {
  bool displacements = true; ///< results hold them; not needed where no fields are written
  /// Influence files must be of the scenes' own profiles. False: profiles that wear keep the files of a shape
  /// from which they hardly differ.
  bool own_shape = true;
  /// Work on one case, where it is large (contact/operator/settings.hpp: least_threaded). Results are the
  /// same to the last bit. Two sequences on a thread each serve many small cases better.
  int threads = 1;
  SequenceAblation ablation = {}; ///< leave it as it is
};

/// Answers scenes. This is the one way in: the program, sweeps and Python all use it, and one scene is a
/// sequence of one.
///
/// Scenes of a wheel on a rail in steady rolling profit from the cases before. A case starts from the
/// tractions of the case before it. Earlier cases also teach how many elements grid.elements or grid.accuracy
/// need. On the same grid, a scene has the same result as when it is solved alone, within the certificate's
/// tolerance. Files must not change meanwhile.
///
/// Several threads may call one object: each call waits for the one before. Several objects run side by side,
/// if they share no files.
class Sequence {
public:
  /// `files`: shared with other sequences of this thread; null: its own.
  explicit Sequence(SequenceOptions options = {}, std::shared_ptr<SequenceFiles> files = nullptr);
  Sequence(Sequence&&) noexcept;            ///< the other one may only be destroyed or assigned to
  Sequence& operator=(Sequence&&) noexcept; ///< as above
  ~Sequence();

  /// Solves a scene with the model that it asks for (solve_case.hpp). If load.force_y is given, the lateral
  /// displacement with this force is found, the nearest to position.lateral (lateral_search.hpp). If the
  /// scene asks for grid.elements or grid.accuracy, dx and ds are chosen: the case is solved again, at most
  /// most_solves times, until its estimated error is within the accuracy. The grid of a wheel on a rail grows
  /// until the contact lies inside. Throws InputError for wrong input, ConvergenceError if the work budget is
  /// used up; any other lack of convergence is in the result. If another thread sets `stop`, the solution
  /// ends with Stopped (base/stopped.hpp) at the next product with influence numbers.
  SceneResult solve(const SceneFile& scene, const std::atomic<bool>* stop = nullptr);

  /// Solves a scene with each model, at equal forces and at equal position. All models have elements of the
  /// same size: if the scene asks for grid.elements or grid.accuracy, those that solve() chooses for the
  /// reference model (Comparison::reference). A prescribed approach is replaced by the force that the
  /// reference finds for it. Results have no derivatives. Throws what solve() throws, and InputError for
  /// fewer than two models. `stop`: as in solve().
  Comparison compare(const SceneFile& scene, std::vector<Model> models = models_to_compare(),
                     const std::atomic<bool>* stop = nullptr);

  /// What would be solved, after everything short of the solve has been checked. Throws what solve() would
  /// throw before it solves.
  SceneDescription check(const SceneFile& scene);

  /// Counts since the object was made: scenes solved, solutions (several for a scene if an accuracy is asked
  /// for), how often influence numbers were there already, and solutions that started from an earlier case.
  struct Counts {
    int cases = 0, solves = 0, numbers_kept = 0, starts = 0; ///< how many
    int rough = 0; ///< rough solutions for lateral forces, which are not among the others
  };
  Counts counts() const; ///< so far

private:
  class Impl; // headers of what a sequence keeps are not for callers
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact
