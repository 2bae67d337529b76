#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"

#include <span>
#include <string>

namespace bem_contact {

/// What a model without the bodies' own influence functions is predicted to miss. Forces: shear over the
/// friction limit, others over the normal force; creepages: over least_creepage; pmax and power: relative.
struct ModelErrors {
  double forces = 0, pmax = 0, creepages = 0, friction_power = 0;

  /// One of predicted_quantities.
  double of(ErrorQuantity what) const;
  /// The quantity that is worst; of those named. At least one is.
  ErrorQuantity worst(std::span<const ErrorQuantity> named) const;
};

/// What a scene prescribes, where that decides how far models differ.
struct PrescribedMotion {
  bool place = false;      ///< the lateral displacement, and not the lateral force
  bool creepage = false;   ///< creepages that are not counted from free rolling
  bool force = false;      ///< a shear force whose creepage is found
  bool structures = false; ///< structural motion is to be included
};
PrescribedMotion prescribed_of(const ContactCase& asked);
/// Says whether the scene names influence files of both bodies.
bool has_influence_files_of_both(const ContactCase& asked);

/// What the predictions know of a contact.
struct ContactTraits {
  PrescribedMotion prescribed;
  double turn = 0;               ///< of the normal within the patch, rad
  double normal = 0;             ///< force, N
  double modulus = 0;            ///< E* of the pair, MPa
  double approach = 0;           ///< mm
  double inclination = 0;        ///< of the rail where the bodies are nearest, against the track plane, rad
  double size = 0;               ///< of the contact along x and s: geometric mean, mm
  double force_steepness = 0;    ///< change of lateral over normal force, per mm of lateral shift, 1/mm
  double pressure_steepness = 0; ///< relative change of the largest pressure, likewise, 1/mm
  double edge = 0; ///< from the middle of the contact to the nearest end of a profile, mm; 0: none is known
  double slip = 0; ///< rigid creepage in the middle, without spin
  double creep_stiffness = 0; ///< shear force over the friction limit, by creepage
  bool bodies = false; ///< the scene names influence files of both. If not, nothing tells how the real bodies
                       ///< roll freely, and the half-space's free rolling is taken for theirs
  bool on_rail = false;    ///< a wheel on a rail
  bool unlike = false;     ///< the bodies are of different materials
  bool line = false;       ///< plane strain
  bool one_circle = false; ///< of equal bodies in plane strain: tangent planes are exact
};

/// Returns the traits by the estimate of where and how far the bodies touch.
ContactTraits traits_of(const ContactCase& asked, const ContactEstimate& estimate);
/// Does the same, with the turn and the normal force of a solution.
ContactTraits traits_of(const ContactCase& asked, ContactTraits estimated, const ContactProblem& problem,
                        const ContactResult& result);

/// Predict the errors of halfspace and tangent_plane: bounds that held in 98 of 100 random scenes
/// (tools/BENCHMARKS.md). They grow with the turn, the force and the steepness.
ModelErrors halfspace_errors(const ContactTraits& traits);
ModelErrors tangent_plane_errors(const ContactTraits& traits);

/// How well a closed form fits a contact.
struct ClosedFormFit {
  ModelErrors errors; ///< that are predicted of it
  std::string why;    ///< what the prediction knows of the contact, in words
};

/// Largest turn of the normal within one connected run of rows in contact, rad.
double turn_of_contact(const ContactProblem& problem, const ContactResult& result);

} // namespace bem_contact
