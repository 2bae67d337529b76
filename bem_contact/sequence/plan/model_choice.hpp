#pragma once

#include "bem_contact/sequence/plan/model_errors.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

struct HertzModel;

/// What is asked of a model.
struct ModelRequest {
  double tolerance = 0.01;                            ///< solver.model_tolerance
  std::vector<ErrorQuantity> of{ErrorQuantity::pmax}; ///< solver.model_tolerance_of; one at least
  bool fem = false;                                   ///< finite elements can be taken
  std::string without_fem = "the scene names no influence files of both bodies"; ///< why not, if they cannot
};
ModelRequest request_of(const ContactCase& asked);

/// Chooses the cheapest model that is predicted to be within the tolerance, among the models with influence
/// numbers.
ModelChoice choose_model(const ContactTraits& traits, const ModelRequest& request);
/// Chooses a closed form where one fits the problem and is within the tolerance, else another model.
ModelChoice choose_model(const ContactSetup& setup, const ContactProblem& problem,
                         const ContactTraits& traits, const ModelRequest& request);
/// The choice of a closed form.
ModelChoice choose_closed_form(Model model, const ClosedFormFit& fit, const ModelRequest& request);

/// The words for a closed form that the scene asks for: how well it fits, and all that it is predicted to
/// miss.
std::string asked_closed_form_text(Model model, const ClosedFormFit& fit);

/// Tells how well Hertz's solution fits. `traits`: for what half-space theory misses.
ClosedFormFit fit_of_hertz(const HertzModel& model, const ContactTraits& traits);
/// Does the same for a problem of this setup. Returns nothing where the contact is none of Hertz's.
std::optional<ClosedFormFit> fit_of_hertz(const ContactSetup& setup, const ContactProblem& problem,
                                          const ContactTraits& traits);

/// Predicted relative error of half-space theory in plane strain, and of stresses below a surface whose
/// normal turns by `turn` rad: 0.66 (turn/2)^2 (halfspace_error).
double predicted_halfspace_error(double turn);
/// Predicts the error of Hertz's solution in pmax: what the undeformed distance departs from a quadratic
/// (hertz_deviation_error), and what the turn does.
double predicted_error(const HertzModel& model);

} // namespace bem_contact
