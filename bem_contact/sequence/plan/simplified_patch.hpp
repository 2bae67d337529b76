#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/scene/contact_setup.hpp"

#include <vector>

namespace bem_contact {

/// One patch of the simplified theory: an ellipse about (x, s), its axes along x and s.
struct SimplifiedPatch {
  double x = 0, s = 0;                     ///< middle, mm
  double semi_axis_x = 0, semi_axis_s = 0; ///< mm
  double normal = 0;                       ///< force, N
  double pressure = 0, approach = 0;       ///< of Hertz, MPa, mm
  double curvature_x = 0, curvature_s = 0; ///< halves, of the undeformed distance, 1/mm
  double delta = 0;                        ///< inclination, rad
  /// Kalker's flexibilities of xi, eta and phi, mm^3/N, with the layer's compliance in each.
  double of_xi = 0, of_eta = 0, of_phi = 0;
};

/// The patches of the estimate of Kik and Piotrowski (contact_estimate.hpp) on the rows of a problem. Each is
/// made an ellipse of Hertz under the normal force that the estimate gives it: with the curvature along x of
/// its deepest row, and with that along s for which an ellipse has the area where the bodies overlap. One
/// that touches in an ellipse is Hertz's own.
std::vector<SimplifiedPatch> simplified_patches(const ContactSetup& setup, const ContactProblem& problem);

/// How far out a place lies, as a share of the ellipse's radius in that direction: 1 on its border.
double radius_in(const SimplifiedPatch& patch, double x, double s);

/// Elements whose middle lies in the ellipse and in no larger one, row by row, each row from its leading
/// edge.
std::vector<std::vector<int>> elements_of_patches(const ContactProblem& problem,
                                                  const std::vector<SimplifiedPatch>& patches);

/// Where the creepages of a patch are those at its middle: w = (xi - phi s, eta + phi x).
struct PatchCreepage {
  double xi = 0, eta = 0, phi = 0;
};

/// From the rigid slip of the elements: by least squares over those of the ellipse.
PatchCreepage patch_creepage(const ContactProblem& problem, const SimplifiedPatch& patch,
                             const std::vector<int>& elements);

} // namespace bem_contact
