#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"
#include "bem_contact/uses/curves/differences.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact {

/// Forces that were measured over one creepage, beside what is computed there.
struct MeasuredForces {
  CreepKind which = CreepKind::xi;       ///< the creepage over which it was measured
  CreepForce force = CreepForce::Fx;     ///< what was measured
  std::vector<double> creepage;          ///< as motion.xi, eta, phi mean it: 1, phi: 1/mm
  std::vector<double> measured;          ///< on the rail at each creepage: N, Mz: N mm
  std::vector<double> scatter;           ///< standard deviation of each; empty: not given
  std::string source = {};               ///< name of its file
  std::vector<CreepPoint> computed = {}; ///< at the same creepages
};

/// Whether every point that is computed is certified.
bool certified(const MeasuredForces& measured);

/// `rows` of the `columns` of a `source`, as read_measured_forces() says. Throws InputError.
MeasuredForces measured_forces(const std::string& source, const std::vector<std::string>& columns,
                               const std::vector<std::vector<double>>& rows);

/// Reads a CSV file whose columns are a creepage, a force and, where it is known, "scatter": "xi,Fx,scatter".
/// Throws InputError for other columns and what read_csv() refuses.
MeasuredForces read_measured_forces(const std::filesystem::path& file);

/// Of the force that was measured.
Differences differences_of(const MeasuredForces& measured);

/// creep_curves() with the points at which `measured` was measured, which get their `computed`.
CreepCurves creep_curves_beside(MeasuredForces& measured, const SceneFile& scene,
                                std::vector<CreepRange> ranges, const std::atomic<bool>* stop = nullptr,
                                const CreepSolver& solve = nullptr);

/// "measured" of creep curves: names of creepage and force, mean and largest difference, and a table.
record::Record record_of(const MeasuredForces& measured);

} // namespace bem_contact
