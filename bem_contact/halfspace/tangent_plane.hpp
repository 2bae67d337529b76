#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/halfspace/line_store.hpp"
#include "bem_contact/halfspace/settings.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <span>

namespace bem_contact::halfspace {

/// Grid of a curved strip; dx = 0: plane strain (offsets = 1).
struct StripGrid {
  double dx = 0, ds = 0; ///< mm
  int offsets = 1;
  double reference_distance = plane_strain_reference; ///< plane strain, mm: averaged_plane_strain()
};

/// Influence numbers of one body on a curved strip, without finite elements. The rows are in the body's own
/// frame (n into the body); their arc length is not used.
///
/// Each number is that of a half-space at the distance of the two rows along their chord |P_I - P_J| (not
/// along the arc), turned into the frames at both ends. Let H be the half-space's number and Q the turn from
/// the frame of J to that of I. Q H is the field of the loaded element in its own tangent plane; H Q is the
/// field in the plane of the displaced element. Neither is symmetric as Maxwell and Betti demand, but their
/// mean is. In plane strain the two are the same.
///
/// In plane strain on a circle, the half-space's field leaves tractions on the true surface: a uniform
/// tension P/(2 pi R) beside rigid parts (Flamant's stress on a circle; Michell 1899). Taking it off adds u_n
/// = -(1 - 2 nu)/(4 pi G) P on a convex and -1/(4 pi G) P on a concave body for a load P per length, whatever
/// R. With this term a pair of equal bodies is exact (Michell's pair, Persson's contact). Without it pmax
/// is 1.6 % too high at a half angle of 30 degrees and 5 % at 60. In three dimensions it is left out.
///
/// If each row lies to the next as the first to the second, the result is translational in s. Pairs whose
/// chords differ a little share a few half-space lines by interpolation (near_field.hpp), exact to
/// near_field_accuracy (settings.hpp); `known`: lines of earlier strips.
/// Source: theory/numbers.md, section 3. Throws InputError for an empty strip.
InfluenceNumbers tangent_plane_numbers(const Material& material, const StripGrid& grid,
                                       std::span<const ContactRow> rows, LineStore* known = nullptr);

} // namespace bem_contact::halfspace
