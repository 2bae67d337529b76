#include "bem_contact/sequence/plan/model_choice.hpp"

#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace bem_contact {

namespace {

double largest(const ModelErrors& errors, const ModelRequest& request) {
  return errors.of(errors.worst(request.of));
}

/// "half-space theory is predicted to miss pmax by up to 0.2 %"
std::string miss_text(const char* model, const ModelErrors& errors, const ModelRequest& request) {
  return fmt::format("{} predicted to miss {} by up to {:.1f} %", model, name_of(errors.worst(request.of)),
                     100 * largest(errors, request));
}

/// ": within the 1 % allowed of forces, pmax, and finite elements would change them by no more"
std::string within_text(const ModelRequest& request, const char* dearer) {
  std::vector<std::string_view> names;
  for (const ModelErrorOf what : request.of)
    names.push_back(name_of(what));
  return fmt::format(": within the {:g} % allowed, and {} would change {} by no more than that",
                     100 * request.tolerance, dearer, fmt::join(names, ", "));
}

std::string turn_text(double turn) {
  return fmt::format("the normal turns by {:.1f} degrees within the patch; ", degrees(turn));
}

} // namespace

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

double predicted_halfspace_error(double turn) {
  return halfspace_error * 0.25 * turn * turn;
}

double predicted_error(const HertzModel& model) {
  return hertz_deviation_error * model.deviation + predicted_halfspace_error(model.turn);
}

ModelRequest request_of(const ContactCase& asked) {
  const SceneFile::Solver& solver = asked.scene.solver;
  return {solver.model_tolerance, model_tolerance_of(solver.model_tolerance_of), names_bodies(asked)};
}

ModelChoice choose_hertz(const HertzModel& model, const ContactTraits& traits, const ModelRequest& request) {
  ContactTraits known = traits;
  known.turn = model.turn;
  ModelErrors errors = predicted_errors(Model::halfspace, known);
  errors.pmax += predicted_error(model);
  errors.forces += predicted_error(model);
  return {Model::hertz,
          fmt::format(
              "no friction, the undeformed distance is a quadratic within {:.1g} of the approach, {}{}{}",
              model.deviation, turn_text(model.turn), miss_text("Hertz's closed form is", errors, request),
              within_text(request, "a costlier model")),
          largest(errors, request) <= request.tolerance};
}

ModelChoice choose_model(const ContactTraits& traits, const ModelRequest& request) {
  const ModelErrors halfspace = predicted_errors(Model::halfspace, traits),
                    tangent_plane = predicted_errors(Model::tangent_plane, traits);
  const double by_halfspace = largest(halfspace, request), by_planes = largest(tangent_plane, request);
  std::string reason =
      traits.prescribed.structures ? "the structures' motion is included; " : turn_text(traits.turn);
  reason += miss_text("half-space theory is", halfspace, request);
  if (by_halfspace <= request.tolerance)
    return {Model::halfspace, reason + within_text(request, "finite elements")};
  reason += ", " + miss_text("tangent planes are", tangent_plane, request);
  if (by_planes <= request.tolerance)
    return {Model::tangent_plane, reason + within_text(request, "finite elements")};
  reason += fmt::format(": more than the {:g} % allowed", 100 * request.tolerance);
  if (request.fem)
    return {Model::fem, reason};
  return {by_planes < by_halfspace ? Model::tangent_plane : Model::halfspace,
          reason + ", but the scene names no influence files of both bodies", false};
}

} // namespace bem_contact
