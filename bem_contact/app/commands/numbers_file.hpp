#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::app {

/// Influence numbers and all that a reader needs to use them elsewhere. The layouts of the three files are
/// described in data/INFLUENCE_FORMAT.md, "Plain influence numbers".
struct PlainNumbers {
  InfluenceNumbers numbers;
  std::vector<std::pair<std::string, std::string>> remarks;      ///< name and text: bodies, frame, signs, ...
  std::vector<std::pair<std::string, std::vector<double>>> rows; ///< e.g. "s_rail", mm, one value a row
  double shear_modulus = 0; ///< G of the text format: 1/G is the mean of both bodies' 1/G; 0 for one body
};

void write_numbers_h5(const std::filesystem::path& file, const PlainNumbers& plain);
void write_numbers_csv(const std::filesystem::path& file, const PlainNumbers& plain);

/// One matrix for all rows, or one for each loaded row (nmatrix = my).
enum class Matrices { one, each };

/// The text format of numerical influence coefficients of the program CONTACT (option C3 = 9): u = (1/G) C p,
/// rail the upper body (1), z into the rail, p on the rail, u = u_rail - u_wheel. That is the contact frame
/// of this project, and C = G A without any change of sign.
/// `one`: the mean over all pairs of rows equally far apart. Throws InputError where these differ by more
/// than `largest_variation` of the self number (the curvature is not constant).
void write_numbers_contact(const std::filesystem::path& file, const PlainNumbers& plain, Matrices matrices);

/// How much the numbers of equal distance differ along the strip, largest, as a part of A_nn of the middle.
double variation_along_the_strip(const InfluenceNumbers& numbers);

} // namespace bem_contact::app
