#include "bem_contact/sequence/model_choice.hpp"

#include "bem_contact/sequence/hertz_model.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact {

namespace {

/// The rows lie on one circle, all of them.
bool on_a_circle(const ContactProblem& problem) {
  const std::vector<ContactRow>& rows = problem.rows;
  const double turn = rows.size() > 1 ? rows[1].delta - rows[0].delta : 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (std::abs(rows[i].delta - rows[i - 1].delta - turn) > equal_turn)
      return false;
  return true;
}

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

} // namespace

double predicted_halfspace_error(double turn) {
  return halfspace_error * 0.25 * turn * turn;
}

double predicted_tangent_plane_error(const ContactProblem& problem, double turn, bool equal_bodies) {
  if (problem.plane_strain() && equal_bodies && on_a_circle(problem))
    return 0;
  return tangent_plane_error * 0.25 * turn * turn;
}

double predicted_error(const HertzModel& model) {
  return hertz_deviation_error * model.deviation + predicted_halfspace_error(model.turn);
}

std::string halfspace_text(double turn) {
  return fmt::format("the normal turns by {:.1f} degrees within the patch, for which half-space theory is "
                     "predicted to miss the largest pressure by up to {:.1f} %",
                     degrees(turn), 100 * predicted_halfspace_error(turn));
}

double turn_of_contact(const ContactProblem& problem, const ContactResult& result) {
  const ContactGrid& grid = problem.grid;
  double largest = 0, lo = 0, hi = 0;
  bool inside = false;
  for (int is = 0; is < grid.ms; ++is) {
    bool contact = false;
    for (int ix = 0; ix < grid.mx && !result.state.empty(); ++ix)
      contact |= result.state[is * grid.mx + ix] != ElementState::exterior;
    const double delta = problem.rows[is].delta;
    lo = contact && inside ? std::min(lo, delta) : delta;
    hi = contact && inside ? std::max(hi, delta) : delta;
    inside = contact;
    if (contact)
      largest = std::max(largest, hi - lo);
  }
  return largest;
}

ModelChoice choose_hertz(const HertzModel& model, double tolerance) {
  const double error = predicted_error(model);
  return {
      Model::hertz,
      fmt::format("no friction, the undeformed distance is a quadratic within {:.1g} of the approach, the "
                  "normal turns by {:.1f} degrees: Hertz's closed form is predicted to miss the largest "
                  "pressure by up to {:.1f} %: within the {:g} % allowed",
                  model.deviation, degrees(model.turn), 100 * error, 100 * tolerance),
      error <= tolerance};
}

ModelChoice choose_model(const ContactProblem& problem, const ContactResult& normal, bool equal_bodies,
                         bool fem, double tolerance) {
  const double turn = turn_of_contact(problem, normal);
  const double halfspace = predicted_halfspace_error(turn);
  const double tangent_plane = predicted_tangent_plane_error(problem, turn, equal_bodies);
  std::string reason = halfspace_text(turn);
  const std::string within = fmt::format(": within the {:g} % allowed", 100 * tolerance);
  if (halfspace <= tolerance)
    return {Model::halfspace, reason + within};
  reason += fmt::format(", tangent planes by up to {:.1f} %", 100 * tangent_plane);
  if (tangent_plane <= tolerance)
    return {Model::tangent_plane, reason + within};
  reason += fmt::format(": more than the {:g} % allowed", 100 * tolerance);
  if (fem)
    return {Model::fem, reason};
  return {Model::tangent_plane, reason + ", but the scene names no influence files of both bodies", false};
}

} // namespace bem_contact
