#include "bem_contact/sequence/plan/model_choice.hpp"

#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <algorithm>
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
std::string error_text(const std::string& model, const ModelErrors& errors,
                       const std::vector<ErrorQuantity>& of) {
  const ErrorQuantity worst = errors.worst(of);
  return fmt::format("{} {:.1f} % in {}", model, 100 * errors.of(worst), name_of(worst));
}

/// The quantities asked for, by whether the influence files of both bodies would add to their errors: how the
/// real bodies roll freely is known from these files alone (ContactTraits::bodies).
struct PredictedQuantities {
  std::vector<ErrorQuantity> known, unknown;
};
PredictedQuantities split_by_what_files_add(const ContactTraits& traits, const ModelRequest& request) {
  ContactTraits with_bodies = traits;
  with_bodies.bodies = true;
  const ModelErrors here = halfspace_errors(traits), there = halfspace_errors(with_bodies);
  PredictedQuantities out;
  for (const ErrorQuantity what : request.of)
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

ClosedFormFit fit_of_hertz(const HertzModel& model, const ContactTraits& traits) {
  ContactTraits known = traits;
  known.turn = model.turn;
  ModelErrors errors = halfspace_errors(known);
  errors.pmax += predicted_error(model);
  errors.forces += predicted_error(model);
  return {errors,
          fmt::format("no friction, the undeformed distance is a quadratic within {:.1g} of the approach, {}",
                      model.deviation, turn_text(model.turn))};
}

std::optional<ClosedFormFit> fit_of_hertz(const ContactSetup& setup, const ContactProblem& problem,
                                          const ContactTraits& traits) {
  const std::optional<HertzModel> hertz = hertz_of(setup, problem);
  return hertz ? std::optional(fit_of_hertz(*hertz, traits)) : std::nullopt;
}

ModelChoice choose_closed_form(Model model, const ClosedFormFit& fit, const ModelRequest& request) {
  const bool within = largest(fit.errors, request) <= request.tolerance;
  const std::string errors =
      error_text(fmt::format("{} is", elasticity_model(model).in_words), fit.errors, request.of);
  return {model, fit.why + judged(errors, within, request), within};
}

std::string asked_closed_form_text(Model model, const ClosedFormFit& fit) {
  std::string out =
      fmt::format("asked for; {}predicted errors of {}", fit.why, elasticity_model(model).in_words);
  for (const ErrorQuantity what : predicted_quantities)
    out += fmt::format("{} {} {:.1f} %", what == predicted_quantities.front() ? ":" : ",", name_of(what),
                       100 * fit.errors.of(what));
  return out;
}

ModelChoice choose_model(const ContactTraits& traits, const ModelRequest& request) {
  struct Candidate {
    const ElasticityModel* model;
    ModelErrors errors;
  };
  std::vector<Candidate> candidates; // the cheapest first
  for (const ElasticityModel& model : elasticity_models())
    if (model.errors)
      candidates.push_back({&model, model.errors(traits)});
  const bool by_turn = !traits.prescribed.structures;
  const std::string turn = by_turn ? turn_text(traits.turn) : "the structures' motion is included; ";
  const PredictedQuantities predicted = split_by_what_files_add(traits, request);
  const auto errors = [&](const std::vector<ErrorQuantity>& of, std::size_t models) {
    std::string out;
    for (std::size_t k = 0; k < models && !of.empty(); ++k)
      out +=
          (k > 0 ? ", of " : "") + error_text(candidates[k].model->in_words + std::string(k > 0 ? "" : " is"),
                                              candidates[k].errors, of);
    return out;
  };
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (largest(candidates[k].errors, request) <= request.tolerance)
      return {candidates[k].model->model,
              turn + enough_text(errors(predicted.known, k + 1), request, predicted), true, by_turn};
  const std::string too_large = turn + judged(errors(request.of, candidates.size()), false, request);
  if (request.fem)
    return {model_of_files(), too_large, true, by_turn};
  const auto best = std::ranges::min_element(candidates, {},
                                             [&](const Candidate& c) { return largest(c.errors, request); });
  return {best->model->model, too_large + ", but " + request.without_fem, false, by_turn};
}

ModelChoice choose_model(const ContactSetup& setup, const ContactProblem& problem,
                         const ContactTraits& traits, const ModelRequest& request) {
  for (const ElasticityModel& model : elasticity_models())
    if (const auto fit =
            model.fit && !model.by_name_only ? model.fit(setup, problem, traits) : std::nullopt) {
      ModelChoice choice = choose_closed_form(model.model, *fit, request);
      if (choice.enough)
        return choice;
    }
  return choose_model(traits, request);
}

} // namespace bem_contact
