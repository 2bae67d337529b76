#pragma once

#include "bem_contact/sequence/element_count.hpp"
#include "bem_contact/sequence/scene_aids.hpp"
#include "bem_contact/sequence/scene_files.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace bem_contact {

/// What a sequence keeps of earlier cases. Each can be switched off; tools/benchmarks/ablation shows what
/// each saves.
struct SequenceOptions {
  bool keep_files = true; ///< profiles and influence files are read once
  /// Influence numbers of a grid met before are not computed again, nor what solving made of them.
  bool keep_numbers = true;
  /// A case starts from the former one's tractions, moved and scaled; from a coarse grid where the areas in
  /// which the bodies may touch are others (alike()).
  bool keep_start = true;
  bool learn = true;             ///< how large the area in contact is beside the estimate's
  bool coarse_start = true;      ///< a case without a former one starts from larger elements
  bool foresee_shear = true;     ///< the estimate knows what shear bears of the load
  bool potential_contact = true; ///< only where h < .9 of the approach; else three times as far
};

/// Solves `wheel_rail` scenes one after the other and uses what the former ones taught. Files must not
/// change meanwhile. Results lie within the certificate of those that solve_scene() finds on the same grid.
/// One object serves one thread.
class Sequence {
public:
  /// `files`: shared with other sequences of this thread; null: its own.
  explicit Sequence(SequenceOptions options = {}, std::shared_ptr<SceneFiles> files = nullptr)
      : options_(options), files_(std::move(files)) {}

  /// As solve_scene(). Where the scene asks for grid.elements or grid.accuracy, dx and ds are chosen: the
  /// case is solved again, at most `most_solves` times, until its estimated error is within the accuracy.
  /// Other kinds of scene are solved by themselves.
  SceneResult solve(const SceneFile& scene);

  /// As compare_scene(). Where the scene asks for grid.elements or grid.accuracy, dx and ds are those that
  /// solve() chooses for the influence files; both models are solved on them.
  Comparison compare(const SceneFile& scene);

  struct Counts {
    int cases = 0, solves = 0, numbers_kept = 0, starts = 0;
  };
  Counts counts() const;

  static constexpr int most_solves = 4;

private:
  void learn(const SceneResult& result, const ContactEstimate& estimate);

  SequenceOptions options_;
  std::shared_ptr<SceneFiles> files_;
  NumbersStore numbers_;
  Workspace workspace_{3};
  std::optional<FormerTractions> former_;
  std::vector<PotentialArea> former_areas_;
  std::optional<ElementCount> count_;
  std::optional<int> asked_elements_;
  std::optional<double> asked_accuracy_;
  double area_ratio_ = 1;
  Counts counts_;
};

} // namespace bem_contact
