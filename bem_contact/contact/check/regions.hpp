#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <algorithm>
#include <span>
#include <vector>

/// Sums over elements in contact, from which errors are estimated (error_estimates.hpp).
namespace bem_contact::contact {

/// What an element contributes to a sum.
struct Part {
  double value = 0;
  double fn = 0; ///< p_n dS of the element, N
  bool adheres = false;
};

/// A sum over elements, and what of it is uncertain.
struct UncertainSum {
  double total = 0;
  double size = 0; ///< sum of the absolute values
  /// Sum of the absolute deviations from parts in proportion to fn. Nothing where all elements slip in one
  /// direction: then the normal force alone tells the sum.
  double deviation = 0;
  double adhering = 0; ///< sum of the squares of the elements in adhesion: each is off by chance
  /// This is the absolute sum of the elements in adhesion over the root of their number: as large as the root
  /// of `adhering` where they are all alike, and nothing where they cancel.
  double adhering_alike = 0;
};

UncertainSum sum_of(std::span<const Part> parts);

/// A set of elements in contact: all of them, or a patch.
struct Region {
  bool line = false;                     ///< the grid has one row or one column: the border is two elements
  int contact = 0, border = 0;           ///< elements; border: one beside it is exterior
  int rows = 0, longest = 0;             ///< rows with such elements; elements of the longest of these rows
  int adhesion = 0, adhesion_border = 0; ///< border: one beside it slips
  double fn = 0;                         ///< sum of p_n dS, N
  UncertainSum fx, fs;                   ///< of p_x dS, p_s dS, N
  UncertainSum moment;                   ///< of both about the centre of pressure, N mm
  double T_gamma = 0;                    ///< N (shift: N mm)
  double T_gamma_in_slip = 0;            ///< of it, what the slip of elements shows, N (shift: N mm)
  /// In steady rolling this is the power that drives the bodies, sum (p_t w + p_n dh/dx) dS; w includes the
  /// creepages found. By conservation of energy it is the power of friction on elements of vanishing size
  /// (theory/estimates_and_heat.md, section 2). In other motions it is the power of friction itself.
  UncertainSum driving_power;
  double pmax = 0;       ///< MPa
  bool at_limit = false; ///< pmax is the limit of the pressure, and known
  double curvature = 0;  ///< at the peak: how far p_n falls to its neighbours, twice the mean
                         ///< along x and twice that along s, MPa
  double overlap = 0;    ///< PatchSummary::overlap, mm
  double area = 0;       ///< mm^2
  double x = 0, s = 0;   ///< centre of pressure, mm

  /// How far the pressure falls from its peak to the next elements, relative to the peak.
  double relative_fall() const { return curvature / pmax; }
  double adhesion_share() const { return double(adhesion) / contact; }
  /// Elements across the region over those along it, at least 1: of two grids with as many elements in
  /// contact, the one with longer elements shows less along x. A line has one direction alone: 1.
  double elongation() const { return line ? 1.0 : std::max(1.0, double(rows) / longest); }
};

/// The patches, in the order of ContactResult::patches.
std::vector<Region> patches_of(const ContactProblem& problem, const ContactResult& result);
/// The whole contact, which must not be empty. `patches`: those of the result.
Region contact_of(const ContactProblem& problem, const ContactResult& result,
                  const std::vector<Region>& patches);
/// Coarse patches that lie where the fine ones do; empty where their numbers differ.
std::vector<Region> matched(const std::vector<Region>& fine, std::vector<Region> coarse);

/// The other results that an error in the shear tractions changes, besides Fx, Fs and the moment. If the
/// vertical force is prescribed, the pressure bears what the shear tractions do not bear of it.
struct ShearEffects {
  UncertainSum fy, fz; ///< N
  double slope = 0;    ///< what sum p_n dS falls by with Fs: tan of the pressure's mean direction
  UncertainSum fn;     ///< and what it falls by beside that, because normals turn within the contact, N
  double turned = 0;   ///< pressure beside its mean direction, sum of |p_n| sin dS over cos of that one, N
  double bent = 0;     ///< by how much sum p_n dS exceeds the resultant of the pressure, N
};

ShearEffects effects_of_shear(const ContactProblem& problem, const ContactResult& result);

} // namespace bem_contact::contact
