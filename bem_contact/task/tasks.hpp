#pragma once

#include "bem_contact/task/engine.hpp"
#include "bem_contact/uses/conicity/conicity_map.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"
#include "bem_contact/uses/sweep/sweep_rows.hpp"
#include "bem_contact/uses/table/creep_table.hpp"
#include "bem_contact/uses/table/scene_table.hpp"
#include "bem_contact/uses/wear/study.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What is shared, each by any engine. All throw what the engine does.
namespace bem_contact::task {

/// Is told how many more items are done.
using Done = std::function<void(std::size_t more)>;

/// Points of creep curves of a scene.
CreepSolver creep_points_by(Engine engine, SceneText scene, std::vector<SceneChange> changes = {});

/// Points of a table of a scene, and of one of creep forces.
table::PointsSolver points_by(Engine engine, table::SceneTable order, Done done = nullptr);
table::PointsSolver points_by(Engine engine, table::CreepScale scale, int elements, Done done = nullptr);

/// Cases of a step of wear. `asked`: its law counts.
wear::CasesSolver wear_by(Engine engine, const SweepFile& collective, std::string model,
                          const wear::StudyOptions& asked);

/// Pairs of profiles of a map, which has one wheel and one rail at least. No scene: the changes say all.
ConicityMap conicity_map_by(const Engine& engine, const std::optional<SceneText>& scene,
                            const std::vector<SceneChange>& changes, const ConicityMapRange& range);

/// A sweep has at most so many portions, because each reads its files again. Chosen.
inline constexpr std::size_t most_portions = 1000;

/// A sweep with values that all its cases have.
struct SharedSweep {
  SceneText scene;
  std::vector<SceneChange> changes; ///< not of a key that it varies
  std::string model = {};           ///< instead of the scene's own; "": that
  /// Where each portion is kept in a file, by which it goes on after a stop; "": nowhere.
  std::filesystem::path folder = {};
  std::size_t portions = most_portions; ///< at most

  SweepFile sweep() const; ///< throws InputError for a change of a key that it varies
};
/// Its cases. Parts of another sweep in its folder are refused; one that is damaged is solved again.
AllSweepRows sweep_by(const Engine& engine, const SharedSweep& asked, const Done& done = nullptr);

} // namespace bem_contact::task
