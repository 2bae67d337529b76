#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace bem_contact::fem {

/// What a computation of the solid method took.
struct SolidReport {
  std::size_t cells = 0, unknowns = 0; ///< of the largest refined mesh
  double seconds = 0, peak_memory = 0; ///< wall clock; GiB
  double betti_error = 0;              ///< largest asymmetry between loads of one mesh, of the self number
};

/// Displacements of all elements at x = 0, dx, .. under loads on some stations at x = 0.
struct SolidNumbers {
  double dx = 0, ds = 0; ///< mm
  int offsets = 0;
  std::vector<Station> stations;
  std::vector<int> loads; ///< loaded stations J, ascending
  std::vector<double>
      values; ///< [load][j][m][I][i], mm/MPa: as InfluenceNumbers' values[m][3 I + i][3 J + j]
  SolidReport report;

  double& at(std::size_t load, int j, int m, int row, int i) {
    return values[(((load * 3 + j) * offsets + m) * stations.size() + row) * 3 + i];
  }
  double at(std::size_t load, int j, int m, int row, int i) const {
    return const_cast<SolidNumbers*>(this)->at(load, j, m, row, i);
  }
};

/// One displacement field to look at.
struct FieldWanted {
  std::filesystem::path file; ///< .vtu; empty: none
  int station = 0, component = component_n;
};

/// What solid_numbers() is asked for.
struct SolidRequest {
  std::vector<int> loads; ///< stations, from 0
  FieldWanted field = {}; ///< of one of the loads
  std::function<void(std::size_t loads_done, std::size_t loads)> progress =
      {}; ///< at the start and after loads
};

/// The solid method (THEORY.md, 9): loads some stations of a 3-D body (half model, mirror plane x = 0) and
/// samples all of them. The body must be the same all along the loaded part, since x_I - x_J is all that
/// counts later. Throws InputError for a mesh, a strip or a load that does not fit, Error where memory is
/// short.
SolidNumbers solid_numbers(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                           SolidRequest request);

} // namespace bem_contact::fem
