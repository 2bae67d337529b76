#pragma once

#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/sequence/plan/model_errors.hpp"

#include <optional>
#include <span>

namespace bem_contact {

struct NumbersParts;
struct PairFiles;

/// A model of the bodies' elasticity: all that the steps of a solution ask of it. models.cpp has one row for
/// each. A model either makes influence numbers, with which the contact is solved on its elements, or it
/// solves the contact itself by a closed form.
struct ElasticityModel {
  Model model;
  /// In the middle of a sentence: "half-space theory".
  const char* in_words;
  /// Influence numbers depend on both rows, not on their distance alone. Such numbers grow with the square of
  /// the rows.
  bool depends_on_both_rows = false;
  /// Makes the influence numbers of the pair on a grid. `known`: of earlier cases; null: nothing. `threads`
  /// share those of files. Throws InputError where the model does not serve. Null: a closed form.
  InfluenceNumbers (*numbers)(const ContactSetup& setup, const PairFiles& files, const ContactOnGrid& contact,
                              NumbersParts* known, int threads) = nullptr;
  /// Predicts what the model misses. Null: a closed form, or a model that misses nothing.
  ModelErrors (*errors)(const ContactTraits& traits) = nullptr;
  /// Solves a contact by the closed form. Throws InputError for a contact that it does not fit. Null: a model
  /// with influence numbers.
  ContactResult (*solve)(const ContactSetup& setup, const ContactProblem& problem) = nullptr;
  /// Tells how well the closed form fits a contact; nothing where it does not. Null: a model with influence
  /// numbers.
  std::optional<ClosedFormFit> (*fit)(const ContactSetup& setup, const ContactProblem& problem,
                                      const ContactTraits& traits) = nullptr;
  bool by_name_only = false; ///< no scene gets it without asking for it
};

/// Lists the models, the cheapest first.
std::span<const ElasticityModel> elasticity_models();
const ElasticityModel& elasticity_model(Model model);

/// Says whether the model has no influence numbers. It is of one contact area, and has no error of elements.
bool is_closed_form(Model model);
/// Says whether the influence numbers come from the bodies' influence files. Then rows must lie on the strips
/// of these files, and the bodies' structures may move.
bool has_files(Model model);
/// Says whether the influence numbers depend on both rows. Those of a model that is not chosen yet may.
bool depends_on_both_rows(std::optional<Model> model);
/// Says whether the influence numbers are of half-spaces that lie as the rows do. They depend on where all
/// rows lie, so that no two cases have the same.
bool turns_with_rows(Model model);

/// This model serves every contact, and it is the cheapest that does: for a look at a contact whose model is
/// not chosen yet.
inline constexpr Model rough_model = Model::halfspace;
/// What rough solutions of lateral forces are of: the same question with half-space numbers.
SceneFile rough_scene(const SceneFile& scene);
/// Returns the model of the bodies' own influence files. It is the reference of the others.
Model model_of_files();

/// Predicts what a model misses; nothing of a model that predicts no errors.
ModelErrors predicted_errors(Model model, const ContactTraits& traits);

/// The influence numbers of the pair by a model that has some.
InfluenceNumbers pair_numbers(Model model, const ContactSetup& setup, const PairFiles& files,
                              const ContactOnGrid& contact, NumbersParts* known = nullptr, int threads = 1);

} // namespace bem_contact
