#include "bem_contact/sequence/plan/model_choice.hpp"

#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

double largest(const ModelErrors& errors, const ModelRequest& request) {
  return errors.of(errors.worst(request.of));
}

/// "half-space theory is predicted to miss pmax by up to 0.2 %"
std::string miss_text(const char* model, const ModelErrors& errors, const std::vector<ModelErrorOf>& of) {
  const ModelErrorOf worst = errors.worst(of);
  return fmt::format("{} predicted to miss {} by up to {:.1f} %", model, name_of(worst),
                     100 * errors.of(worst));
}

/// The quantities asked for, by whether the influence files of both bodies would add to their errors: how the
/// real bodies roll freely is known from these files alone (ContactTraits::bodies).
struct Told {
  std::vector<ModelErrorOf> known, unknown;
};
Told told_by(const ContactTraits& traits, const ModelRequest& request) {
  ContactTraits with_bodies = traits;
  with_bodies.bodies = true;
  const ModelErrors here = predicted_errors(Model::halfspace, traits),
                    there = predicted_errors(Model::halfspace, with_bodies);
  Told out;
  for (const ModelErrorOf what : request.of)
    (there.of(what) > here.of(what) ? out.unknown : out.known).push_back(what);
  return out;
}

/// "Hertz's closed form is predicted to miss pmax by up to 0.2 %: within the 1 % allowed, and a costlier
/// model would change forces, pmax by no more than that"
std::string within_text(const std::string& miss, const ModelRequest& request, const char* dearer,
                        const std::vector<ModelErrorOf>& of) {
  return fmt::format("{}: within the {:g} % allowed, and {} would change {} by no more than that", miss,
                     100 * request.tolerance, dearer, names_of(of));
}

/// Why a model without the bodies' influence functions is enough. `misses`: what is said of the models.
std::string enough_text(const std::string& misses, const ModelRequest& request, const Told& told) {
  std::string out = told.known.empty() ? misses : within_text(misses, request, "finite elements", told.known);
  if (!told.unknown.empty())
    out += fmt::format("{}how much finite elements would change {} is not known without influence files of "
                       "both bodies, which say how these roll freely",
                       told.known.empty() ? "" : "; ", names_of(told.unknown));
  return out;
}

std::string turn_text(double turn) {
  return fmt::format("the normal turns by {:.1f} degrees within the patch; ", degrees(turn));
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
  return {solver.model_tolerance, solver.model_tolerance_of, names_bodies(asked)};
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
                  within_text(miss_text("Hertz's closed form is", errors, request.of), request,
                              "a costlier model", request.of)),
      largest(errors, request) <= request.tolerance};
}

ModelChoice choose_model(const ContactTraits& traits, const ModelRequest& request) {
  const ModelErrors halfspace = predicted_errors(Model::halfspace, traits),
                    tangent_plane = predicted_errors(Model::tangent_plane, traits);
  const double by_halfspace = largest(halfspace, request), by_planes = largest(tangent_plane, request);
  const std::string turn =
      traits.prescribed.structures ? "the structures' motion is included; " : turn_text(traits.turn);
  const Told told = told_by(traits, request);
  const auto misses = [&](const std::vector<ModelErrorOf>& of, bool both) {
    if (of.empty())
      return std::string();
    const std::string first = miss_text("half-space theory is", halfspace, of);
    return both ? first + ", " + miss_text("tangent planes are", tangent_plane, of) : first;
  };
  for (const auto& [model, error] :
       {std::pair{Model::halfspace, by_halfspace}, {Model::tangent_plane, by_planes}})
    if (error <= request.tolerance)
      return {model, turn + enough_text(misses(told.known, model == Model::tangent_plane), request, told)};
  const std::string reason = fmt::format("{}{}: more than the {:g} % allowed", turn, misses(request.of, true),
                                         100 * request.tolerance);
  if (request.fem)
    return {Model::fem, reason};
  return {by_planes < by_halfspace ? Model::tangent_plane : Model::halfspace,
          reason + ", but " + request.without_fem, false};
}

} // namespace bem_contact
