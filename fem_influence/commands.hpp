#pragma once

#include "bem_contact/base/conventions.hpp"

#include <string>
#include <vector>

namespace bem_contact::fem {

/// `fem_influence BODY.toml MESH.msh -o OUT.h5`: the harmonic method, from files to a file. Called by all
/// processes together. Throws InputError for files or settings that do not fit.
void harmonic_command(const std::string& body_file, const std::string& mesh, const std::string& output);

/// Options of the solid method. Texts are empty where an option is not given.
struct SolidOptions {
  std::string output;             ///< influence file to write (.h5)
  std::string check;              ///< influence file of the same body to compare with (.h5)
  std::string vtu;                ///< displacement field to write (.vtu)
  std::vector<int> load_stations; ///< empty: the middle one
  int component = component_n;    ///< of the load whose field is written
};

/// `fem_influence BODY.toml MESH.msh --solid ...`: the solid method. Throws InputError for files or settings
/// that do not fit, and where nothing is asked for.
void solid_command(const std::string& body_file, const std::string& mesh, const SolidOptions& options);

/// What is asked of stress_command(). Texts are empty and the ellipse has no numbers where not given.
struct StressOptions {
  std::vector<std::string> outputs; ///< files to write: .csv, .vtu, else HDF5
  /// Files of bem_contact solve whose tractions load the body, one for each output; empty: the ellipse does.
  std::vector<std::string> results;
  std::string points;          ///< points of one's own (.csv)
  std::vector<double> ellipse; ///< arc length of its middle, semi-axes along x and s (mm), p0 (MPa), friction
};

/// `fem_influence BODY.toml MESH.msh --stresses OUT.h5 --result RESULT.h5`: stresses below a contact in the
/// body, and those of a half-space beside them. Matrices are factorized once for all results. Throws
/// InputError for files or numbers that do not fit.
void stress_command(const std::string& body_file, const std::string& mesh, const StressOptions& options);

} // namespace bem_contact::fem
