#pragma once

#include "bem_contact/profile/contact_row.hpp"

#include <cstddef>
#include <vector>

namespace bem_contact {

/// A matrix for each wavenumber and depth, which maps unit loads on the stations to stresses at the places of
/// the depth: left core right^T. A depth has the same few columns at all wavenumbers.
struct StressForm {
  std::vector<double> wavenumber;         ///< NQ, 1/mm, ascending, the first is 0
  std::vector<int> left_rank, right_rank; ///< columns of each depth
  std::vector<float> left;  ///< column after column [6 NP]: place, component xx, ss, nn, xs, xn, sn; length 1
  std::vector<float> right; ///< column after column [3 NS], length 1
  std::vector<float> core;  ///< of each wavenumber depth after depth [left column][right column]; MPa/MPa

  std::size_t left_columns() const;
  std::size_t right_columns() const;
  std::size_t core_size() const; ///< numbers of a wavenumber
  struct Place {
    std::size_t left = 0, right = 0, core = 0; ///< columns and numbers of the depths before
  };
  Place place_of(std::size_t depth) const;
};

/// What the inside of a body feels of unit loads on its stations more than a half-space would.
///
/// Loads are those of InfluenceFunction but for one along x, which varies as sin kx. Then xx, ss, nn and sn
/// vary as cos kx, xs and xn as sin kx. Subtracted are the amplitudes of halfspace::strip_wave_stresses() at
/// the distance along the arc, on a body of revolution those of the wavenumber k R_ref / R_J, over R_J /
/// R_ref with R_J the radius of the loaded station. Stresses are in the frame (x, s, n) of the surface above
/// the point.
struct StressKernel {
  std::vector<ContactRow>
      places;                 ///< NP points of the profile above those inside, equally spaced, ascending in s
  std::vector<double> depths; ///< ND, mm, ascending, above 0
  std::vector<char> there;    ///< [NP][ND]: whether the body is; numbers are 0 where it is not
  StressForm remainder;
  /// What elements of one degree less would have more, which tells how wrong the remainder is. Without
  /// wavenumbers: not estimated.
  StressForm error;

  bool empty() const { return depths.empty(); }
};

/// Throws InputError unless sizes agree, numbers are finite, and places, depths and wavenumbers ascend.
void validate(const StressKernel& kernel, std::size_t stations);

} // namespace bem_contact
