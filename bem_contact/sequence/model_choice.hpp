#pragma once

#include "bem_contact/contact/result.hpp"

#include <string>

namespace bem_contact {

struct HertzModel;

/// Predicted relative error of half-space theory in pmax for a patch within which the normal turns by `turn`
/// rad: 0.66 (turn/2)^2. Hertz against Persson (1964) is low by 0.39 (turn/2)^2, against the sphere in its
/// seat by 0.66 to 0.61 (turn/2)^2 (REFERENCES 3.1, 3.3): the larger of the two.
double predicted_halfspace_error(double turn);

/// The same for the tangent-plane model: 0.24 (turn/2)^2. Against the influence functions of a 60E1 rail and
/// an S1002 wheel, 11 to 42 degrees on the gauge corner, it is wrong by .04 to .22 (turn/2)^2 (half-space:
/// .18 to .44), for what it does not know of is the rest of the body. In plane strain, equal bodies on one
/// circle: it is exact, 0.
double predicted_tangent_plane_error(const ContactProblem& problem, double turn, bool equal_bodies);

/// Of Hertz's solution: 5 times what the undeformed distance departs from a quadratic, over the approach (a
/// waviness as long as the contact does not do more to the pressure), and what the turn does.
double predicted_error(const HertzModel& model);

/// The first in words.
std::string halfspace_text(double turn);

/// Largest turn of the normal within one connected run of rows in contact, rad.
double turn_of_contact(const ContactProblem& problem, const ContactResult& result);

/// The cheapest model whose predicted error of pmax is within the tolerance, and why.
struct ModelChoice {
  std::string model, reason;
  bool enough = true; ///< false: fem would be needed, and there are no influence files
};

/// `fem`: there are influence files of both bodies. hertz is offered where there is a model of it that
/// serves.
ModelChoice choose_hertz(const HertzModel& model, double tolerance);
ModelChoice choose_model(const ContactProblem& problem, const ContactResult& normal, bool equal_bodies,
                         bool fem, double tolerance);

} // namespace bem_contact
