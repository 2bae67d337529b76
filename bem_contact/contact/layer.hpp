#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <vector>

namespace bem_contact {

/// A thin compliant layer between the surfaces, as of oxides, wear debris or roughness. A traction p
/// displaces its two faces by compliance times p against each other, there and nowhere else. A compliance is
/// in mm^3/N: mm under 1 MPa. A sheet of thickness h and shear modulus G has h / G.
struct SurfaceLayer {
  std::vector<double> shear; ///< of shear tractions: one for all rows, or one for each; empty: none
  double normal = 0;         ///< of pressure; 0: none

  bool operator==(const SurfaceLayer&) const = default;
  bool is_none() const; ///< no compliance at all
  /// Says whether rows differ: influence numbers with the layer then depend on both rows.
  bool by_row() const;
  double shear_of(int row) const; ///< of this row
};

/// Influence numbers of bodies with the layer between them: its displacement, averaged over an element, is
/// that of the element's own traction alone. It stands on the diagonal of the self numbers, and so everything
/// that works on influence numbers knows it: slip takes its displacement over a step as it takes the bodies'
/// (slip_step.hpp). Numbers of translational form lose it where rows differ.
/// Throws InputError for a compliance that is negative or not finite, and for another number of rows.
void add_layer(const SurfaceLayer& layer, InfluenceNumbers& numbers);

} // namespace bem_contact
