#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <string>
#include <vector>

namespace bem_contact::fit {

/// Over which coordinate a line of pressures was measured: the largest pressure along the other one; or where
/// each was measured.
enum class PressureLine { over_s, over_x, places };

/// Pressures that were measured, as by ultrasound or film.
struct MeasuredPressures {
  PressureLine line = PressureLine::over_s;
  std::vector<double> x, s;     ///< where, as results have them, mm; the one not given is empty
  std::vector<double> measured; ///< MPa
  std::vector<double> scatter;  ///< standard deviation of each; empty: not given
  std::string source = {};      ///< name of its file
  std::vector<double> computed = {};
  bool certified = false; ///< `computed` is of a certified result
};

/// Whether a table of these columns holds pressures.
bool holds_pressures(const std::vector<std::string>& columns);

/// `rows` of the `columns` s,pn or x,pn or x,s,pn, and scatter where it is known. Throws InputError.
MeasuredPressures measured_pressures(const std::string& source, const std::vector<std::string>& columns,
                                     const std::vector<std::vector<double>>& rows);

/// Pressures of a result at these places, linear between the middles of its elements; 0 beside its grid.
std::vector<double> pressures_at(const MeasuredPressures& places, const SceneResult& result);

/// As record_of(MeasuredForces), with the coordinate in place of creepage and force: "over" is "s" or "x".
record::Record record_of(const MeasuredPressures& measured);

} // namespace bem_contact::fit
