#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/uses/wear/kept_influence.hpp"
#include "bem_contact/uses/wear/settings.hpp"
#include "bem_contact/uses/wear/stretch.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {
class SequenceFiles;
}

namespace bem_contact::wear {

/// One member of a load collective: a scene, and how often it occurs compared with the others.
struct CollectiveCase {
  SceneFile scene;         ///< with the unworn profiles
  double weight = 1;       ///< > 0
  std::size_t passage = 0; ///< on a rail of sections: number of the passage of which it is a place
};

/// What one case takes off both bodies, mm: off the rail in a passage, off the wheel in a revolution.
struct CaseWear {
  DepthOverS rail;                 ///< in a passage
  DepthOverS wheel;                ///< in a revolution
  RowsOnSections on_sections = {}; ///< of a rail of sections: where these rows lie
};

struct WornPair;
/// Solves all cases of a step with these profiles, and returns what each takes off.
using CasesSolver = std::function<std::vector<CaseWear>(const WornPair& now, const KeptPair& influence)>;

/// How profiles wear under a collective.
struct EvolutionOptions {
  Law law = EnergyLaw{};          ///< of both bodies
  bool rail = true, wheel = true; ///< which bodies wear
  double cap = 0.02;              ///< largest depth of one step, mm
  double smoothing = 3;           ///< of the wear of each step: shortest wavelength, mm
  /// How many wheels pass a place of the rail while one wheel turns once. 1: roller and disc of equal size.
  double passages = 1;
  double kept_turn = usual_kept_turn; ///< influence functions are kept up to this turn_between(), rad
  /// A step ends with Stopped soon after another thread sets it. Null: nobody does.
  const std::atomic<bool>* stop = nullptr;
  /// Has others share the cases of a step. Null: each is solved here, from the one before.
  CasesSolver solve = nullptr;
};

/// The state between two steps.
struct WornPair {
  /// The bodies. Of a rail of sections the area alone: mean along its passages.
  WornBody rail, wheel;
  double revolutions = 0; ///< of the wheel
  /// How the step that led here was smoothed: the wavelength, mm, and how much it took of the deepest place
  /// of either body, over its depth.
  double smoothing = 0, smoothed_off = 0;
  std::vector<WornSection> sections =
      {}; ///< of a rail that changes along the track; none: it has one profile

  double rail_depth() const;                                                 ///< largest of all sections, mm
  double largest() const { return std::max(rail_depth(), wheel.largest()); } ///< depth of both, mm
};

/// Some cases of a sweep with their weights; `model`: instead of the scenes' own, "": none.
std::vector<CollectiveCase> collective_of(const SweepFile& sweep, CaseRange cases, const std::string& model);

/// The cases as places of passages along the track.
std::vector<CaseOnTrack> on_track(const std::vector<CollectiveCase>& cases);

/// The unworn bodies of a scene.
WornPair unworn(const SceneFile& scene);

/// The influence files that a scene names, as those of its unworn bodies. Throws InputError where they are
/// not of the scene's profiles.
KeptPair unworn_influence(const SceneFile& scene, const WornPair& unworn);

/// Writes the profiles of `now` into `folder`, where wear_of_cases() reads them.
void write_profiles(const WornPair& now, const std::filesystem::path& folder);

/// A scene with the profiles of `now` that are in `folder`.
SceneFile with_profiles(SceneFile scene, const WornPair& now, const std::filesystem::path& folder,
                        const KeptPair& influence = {});

/// The profiles in `folder`, read for several wear_of_cases(). `scene`: any of the cases.
std::shared_ptr<SequenceFiles> read_profiles_of_step(const SceneFile& scene, const WornPair& now,
                                                     const std::filesystem::path& folder);
/// Solves some cases of a step, each from the one before, with the profiles of `now` that are in `folder`.
/// `files`: what is read of them already; null: nothing. Throws as wear_step() does.
std::vector<CaseWear> wear_of_cases(const WornPair& now, std::span<const CollectiveCase> cases,
                                    const EvolutionOptions& options, const std::filesystem::path& folder,
                                    const KeptPair& influence,
                                    std::shared_ptr<SequenceFiles> files = nullptr);

/// Solves every case with the profiles of `now`, which are written into `folder`.
/// Then moves the profiles of the bodies that wear (explicit Euler, first order in the length of the step).
/// The step takes off `cap` at the deepest place, or less if the largest depth reaches `until`, mm. Throws
/// InputError for wrong scenes, and for influence functions that the shape has outgrown; ConvergenceError
/// where a case has no certified result. `influence`: taken instead of the files that the scenes name, by the
/// cases whose model may need them.
WornPair wear_step(const WornPair& now, const std::vector<CollectiveCase>& cases,
                   const EvolutionOptions& options, double until, const std::filesystem::path& folder,
                   const KeptPair& influence = {});

/// Whether a case may be solved with the influence files that it names.
bool needs_influence(const SceneFile& scene);

/// The wear map that a scene gives; none: that of KTH Stockholm is meant. validate() sees what is wrong.
std::optional<WearMap> wear_map_of(const SceneFile& scene);

/// Throws InputError for an empty collective, weights that are not positive, other bodies or another wear map
/// from case to case, options out of range, and a depth to end at (mm) that is not positive.
void validate(const std::vector<CollectiveCase>& cases, const EvolutionOptions& options, double depth);

/// What has become of both bodies after a step.
struct WearRow {
  double step = 0, revolutions = 0, mileage = 0; ///< 1, 1, km
  double rail_depth = 0, wheel_depth = 0;        ///< largest depth of each body, mm
  double rail_area = 0, wheel_area = 0;          ///< gone from each section, mm^2
  double smoothing = 0, smoothed_off = 0;        ///< mm, 1; as WornPair
};

/// The columns of wear.csv, the datasets of wear.h5, the arrays of Python's wear(), in this order.
std::span<const ColumnOf<WearRow>> wear_columns();
/// The row with these values of the columns.
WearRow wear_row(std::span<const double> values);

/// The row of a state after so many steps; the mileage is that of a wheel of this radius, mm.
WearRow history_row(int step, const WornPair& pair, double wheel_radius);

} // namespace bem_contact::wear
