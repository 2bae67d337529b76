#include "bem_contact/sequence/plan/model_choice.hpp"

#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Hertz: this times what the undeformed distance departs from a quadratic, over the approach. A waviness
/// as long as the contact does not do more to the pressure.
constexpr double hertz_deviation_error = 5.0;

double largest(const ModelErrors& errors, const ModelRequest& request) {
  return errors.of(errors.worst(request.of));
}

/// "half-space theory is 0.2 % in pmax"
std::string error_text(const char* model, const ModelErrors& errors, const std::vector<ModelErrorOf>& of) {
  const ModelErrorOf worst = errors.worst(of);
  return fmt::format("{} {:.1f} % in {}", model, 100 * errors.of(worst), name_of(worst));
}

/// The quantities asked for, by whether the influence files of both bodies would add to their errors: how the
/// real bodies roll freely is known from these files alone (ContactTraits::bodies).
struct PredictedQuantities {
  std::vector<ModelErrorOf> known, unknown;
};
PredictedQuantities split_by_what_files_add(const ContactTraits& traits, const ModelRequest& request) {
  ContactTraits with_bodies = traits;
  with_bodies.bodies = true;
  const ModelErrors here = predicted_errors(Model::halfspace, traits),
                    there = predicted_errors(Model::halfspace, with_bodies);
  PredictedQuantities out;
  for (const ModelErrorOf what : request.of)
    (there.of(what) > here.of(what) ? out.unknown : out.known).push_back(what);
  return out;
}

/// "the largest predicted error of half-space theory is 0.2 % in pmax: within the 1 % allowed". `errors`: of
/// the models, by error_text().
std::string judged(const std::string& errors, bool within, const ModelRequest& request) {
  return fmt::format("the largest predicted error of {}: {} the {:g} % allowed", errors,
                     within ? "within" : "more than", 100 * request.tolerance);
}

/// Why a model without the bodies' influence functions is enough. `errors`: as judged() takes them.
std::string enough_text(const std::string& errors, const ModelRequest& request,
                        const PredictedQuantities& predicted) {
  std::string out = predicted.known.empty() ? "" : judged(errors, true, request);
  if (!predicted.unknown.empty())
    out += fmt::format("{} in {} are not known without influence files of both bodies",
                       predicted.known.empty() ? "errors" : ". Errors", names_of(predicted.unknown));
  return out;
}

std::string turn_text(double turn) {
  return fmt::format("the normal turns by {:.1f} degrees; ", degrees(turn));
}

} // namespace

double predicted_halfspace_error(double turn) {
  return halfspace_error * 0.25 * turn * turn;
}

double predicted_error(const HertzModel& model) {
  return hertz_deviation_error * model.deviation + predicted_halfspace_error(model.turn);
}

ModelRequest request_of(const ContactCase& asked) {
  const SceneFile::Solver& solver = asked.scene.solver;
  return {solver.model_tolerance, solver.model_tolerance_of, has_influence_files_of_both(asked)};
}

ModelChoice choose_hertz(const HertzModel& model, const ContactTraits& traits, const ModelRequest& request) {
  ContactTraits known = traits;
  known.turn = model.turn;
  ModelErrors errors = predicted_errors(Model::halfspace, known);
  errors.pmax += predicted_error(model);
  errors.forces += predicted_error(model);
  return {
      Model::hertz,
      fmt::format("no friction, the undeformed distance is a quadratic within {:.1g} of the approach, {}{}",
                  model.deviation, turn_text(model.turn),
                  judged(error_text("Hertz's closed form is", errors, request.of),
                         largest(errors, request) <= request.tolerance, request)),
      largest(errors, request) <= request.tolerance};
}

ModelChoice choose_model(const ContactTraits& traits, const ModelRequest& request) {
  const ModelErrors halfspace = predicted_errors(Model::halfspace, traits),
                    tangent_plane = predicted_errors(Model::tangent_plane, traits);
  const double by_halfspace = largest(halfspace, request), by_planes = largest(tangent_plane, request);
  const std::string turn =
      traits.prescribed.structures ? "the structures' motion is included; " : turn_text(traits.turn);
  const PredictedQuantities predicted = split_by_what_files_add(traits, request);
  const auto errors = [&](const std::vector<ModelErrorOf>& of, bool both) {
    if (of.empty())
      return std::string();
    const std::string first = error_text("half-space theory is", halfspace, of);
    return both ? first + ", of " + error_text("tangent planes", tangent_plane, of) : first;
  };
  for (const auto& [model, error] :
       {std::pair{Model::halfspace, by_halfspace}, {Model::tangent_plane, by_planes}})
    if (error <= request.tolerance)
      return {model,
              turn + enough_text(errors(predicted.known, model == Model::tangent_plane), request, predicted)};
  const std::string reason = turn + judged(errors(request.of, true), false, request);
  if (request.fem)
    return {Model::fem, reason};
  return {by_planes < by_halfspace ? Model::tangent_plane : Model::halfspace,
          reason + ", but " + request.without_fem, false};
}

} // namespace bem_contact
