#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/uses/table/refine.hpp"

#include <string>
#include <vector>

namespace bem_contact::table {

/// A scene with a table [table]: lists or ranges of keys with numbers, from which the axes begin.
///
///     [table]
///     position.lateral = { from = -5, to = 5, count = 5 }
///     position.yaw = [ 0, 5e-3, 1e-2 ]
///     load.force = [ 4e4, 8e4 ]
///     hold = [ "Fx", "Fy", "Mz" ]      # whose error is kept within the tolerance; these if left out:
///                                      # Fx, Fy, Fz, Mz, approach, pmax, area, free_rolling_radius
struct SceneTable {
  /// What an axis begins with.
  struct KeyAxis {
    std::string key;            ///< of the scene
    std::vector<double> points; ///< rising, in the unit of the key
  };

  SceneText text;                  ///< with the table
  std::string model{};             ///< instead of the scene's own; "": that
  std::vector<KeyAxis> axes{};     ///< in the order of the table
  std::vector<std::string> hold{}; ///< columns; empty: the usual ones
};

/// Throws InputError for a scene without [table], with lists of texts, or with names that no column has.
SceneTable parse_scene_table(SceneText given);

/// The axes with their first points, the columns without values. Every end of an axis is tried as a scene:
/// throws InputError for values that no scene has.
ContactTable table_of(const SceneTable& described);

/// The scene of the first point.
SceneFile first_scene(const SceneTable& described);

/// Solves points of such a table; each call makes one that has a Sequence of its own. What it throws names
/// the point.
PointSolver scene_point_solver(const SceneTable& described);

/// What errors are relative to. Forces: the largest |Fz| of the table; moments: that times the radius of the
/// largest area; positions, angles and the rolling radius: their range, or shortest_range and smallest_turn
/// if that is larger; all else: the largest value.
void rescale(ContactTable& table);

} // namespace bem_contact::table
