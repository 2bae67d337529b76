#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/scene/choices.hpp"

#include <string>

namespace bem_contact {

struct HertzModel;

/// Predicted relative error of half-space theory in pmax for a patch within which the normal turns by `turn`
/// rad: 0.66 (turn/2)^2 (halfspace_error).
double predicted_halfspace_error(double turn);

/// The same for the tangent-plane model: 0.24 (turn/2)^2 (tangent_plane_error). In plane strain with equal
/// bodies on one circle the model is exact: 0.
double predicted_tangent_plane_error(const ContactProblem& problem, double turn, bool equal_bodies);

/// Of Hertz's solution: what the undeformed distance departs from a quadratic (hertz_deviation_error), and
/// what the turn does.
double predicted_error(const HertzModel& model);

/// The first in words.
std::string halfspace_text(double turn);

/// Largest turn of the normal within one connected run of rows in contact, rad.
double turn_of_contact(const ContactProblem& problem, const ContactResult& result);

/// The cheapest model whose predicted error of pmax is within the tolerance, and why.
struct ModelChoice {
  Model model;
  std::string reason;
  bool enough = true; ///< false: fem would be needed, and there are no influence files
};

/// `fem`: there are influence files of both bodies. hertz is offered where there is a model of it that
/// serves.
ModelChoice choose_hertz(const HertzModel& model, double tolerance);
ModelChoice choose_model(const ContactProblem& problem, const ContactResult& normal, bool equal_bodies,
                         bool fem, double tolerance);

} // namespace bem_contact
