#pragma once

#include "bem_contact/profile/worn/nominal_place.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace bem_contact {

/// A measured profile as its nominal one, worn: the nominal profile at its place, less a smooth depth along
/// its normal. Only the depth is smoothed; the curvature of the nominal profile jumps where it did.
struct WornNominal {
  ProfileCurve curve;
  std::string nominal;      ///< name of the nominal profile
  std::size_t points = 0;   ///< measured ones that it is made from
  std::size_t beyond = 0;   ///< measured points beyond the ends of the nominal profile: left out
  NominalPlace place;       ///< of the nominal profile, in the measured frame
  double least_depth = 0;   ///< mm; below 0 where the measured profile lies outside the nominal one
  double largest_depth = 0; ///< mm
  double rms_depth = 0;     ///< root mean square, mm
  double shortest_wave = 0, longest_wave = 0; ///< range of the shortest wavelength kept, mm
  double removed_rms = 0, removed_most = 0;   ///< of the measured depths by smoothing, mm
  std::string doubt = {}; ///< why that profile does not fit (not_worn_from()); "": it does
};

/// Points are in the frame and order of ProfileCurve. `smoothing` is the shortest wavelength of the depth
/// that is kept, mm; 0: found from the points and their `scatter`, mm (wear_depth.hpp). Throws InputError
/// with the figures if the points do not lie near the nominal profile. `source` names them.
WornNominal worn_from_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter,
                              double smoothing, const std::string& source);

/// How much was worn off, and where the nominal profile lies; without a full stop.
std::string worn_text(const WornNominal& worn);

/// The depths of the points at the best place of a nominal profile, before any smoothing.
struct NominalFit {
  NominalPlace place;
  double least = 0, largest = 0, rms = 0; ///< depths of the points on it, mm
  double added_rms = 0;                   ///< root mean square of the depths below 0: of steel outside it, mm
  double share = 0;                       ///< of the points that lie on it but for their scatter
  double outside = 0;                     ///< share of the points that lie outside it by more than that
  double flanks = 0;      ///< share of those on its steep parts that lie on it, on the side where it is less
  std::size_t beyond = 0; ///< points beyond its ends
  /// The points may be those of this profile, worn: they lie near it, and most of them not beyond its ends.
  bool near = false;
};

/// Why points that lie so on a nominal profile can hardly be worn from it: too many of them lie outside, or a
/// wheel is turned; "": they may be.
std::string not_worn_from(const ProfileCurve& nominal, const NominalFit& fit);

NominalFit fit_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter);
/// Does the same at a given place.
NominalFit fit_at(const NominalPlace& place, const ProfileCurve& nominal, std::span<const Point2> points,
                  double scatter);

} // namespace bem_contact
