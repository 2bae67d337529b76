#pragma once

#include "bem_contact/contact/history.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/scene/contact_setup.hpp"

#include <optional>

namespace bem_contact {

/// The undeformed distance of a problem near its least value, as a quadratic, and the contact that Hertz
/// makes of it. Principal axes: (x, s) turned by `angle` about the point of first contact.
struct HertzModel {
  double x = 0, s = 0;                     ///< first contact, mm
  double least = 0;                        ///< undeformed distance there, mm
  double angle = 0;                        ///< rad
  double curvature_x = 0, curvature_s = 0; ///< of the undeformed distance, along the principal axes, 1/mm
  double delta = 0;                        ///< inclination there, rad
  double modulus = 0;                      ///< E* of the pair, MPa
  reference::HertzContact contact;         ///< force 0: no contact
  double deviation = 0; ///< largest distance of the undeformed distance from the quadratic within the
                        ///< contact, over the approach
  double turn = 0;      ///< of the normal within the contact, rad

  /// Returns the coordinates of a point in the principal axes.
  std::pair<double, double> local(double x, double s) const;
};

/// Least squares over the elements in the contact (at least 5 x 5 around the least distance). Nothing where
/// the distance is not curved both ways, is not known all over the contact, or is given on fewer than 5 rows
/// or columns.
std::optional<HertzModel> fit_hertz(const ContactProblem& problem, const Material& lower,
                                    const Material& upper);

/// Does the same for a problem of this setup. Returns nothing where the contact is none of Hertz's: with
/// friction, in plane strain, or with a layer that yields to pressure.
std::optional<HertzModel> hertz_of(const ContactSetup& setup, const ContactProblem& problem);

/// Mean pressure of each element, totals of the closed form, displacements along n. Frictionless. The
/// certificate holds the closed form against the quadrature of its own pressure.
ContactResult solve_hertz(const ContactProblem& problem, const HertzModel& model);
/// Does the same for a problem of this setup. Throws InputError where the contact is none of Hertz's.
ContactResult solve_hertz(const ContactSetup& setup, const ContactProblem& problem);

} // namespace bem_contact
