#pragma once

#include "bem_contact/scene/sweep_file.hpp"

#include <filesystem>
#include <string>

namespace bem_contact {

/// What a replay takes besides its scene.
struct ReplayAsked {
  std::filesystem::path run; ///< CSV file: a line for each step of a vehicle program
  std::string wheel = {};    ///< one of replay.wheels; "": the scene names none
  double tolerance = 0.5;    ///< SweepFile::Replay::tolerance
};

/// Reads the steps of a run as the cases of a sweep. The scene says what is in the columns of the run:
///
///     [replay.columns]                 # key of the scene = column of the run
///     time = "t"                       # carried along; s
///     position.lateral = { column = "y_{wheel}", unit = "m" }
///     motion.xi = "xi_{wheel}"
///     [replay.compare]                 # quantity of a result = column with the run's own
///     Fy = { column = "Y_{wheel}", unit = "kN", factor = -1 }
///     [replay.wheels]                  # what {wheel} stands for, and on which side it is
///     "1R" = "right"
///     "1L" = "left"
///
/// Without a unit a column has that of its key or quantity. A number of the run is multiplied by its unit and
/// by `factor`. A run counts everything to the right, and so does the scene but for a left wheel's creepages
/// and forces: eta, phi, Fy, Fs, Mz and load.force_y of a wheel in [replay.wheels] that is "left" change
/// sign.
///
/// Throws InputError, naming file and line, for a scene without [replay.columns], an unknown key, quantity or
/// unit, a column that the run does not have, and a cell of a named column that is no finite number.
SweepFile parse_replay(SceneText scene, const ReplayAsked& asked);

} // namespace bem_contact
