#include "bem_contact/sequence/models.hpp"

#include "bem_contact/sequence/numbers/pair_numbers.hpp"
#include "bem_contact/sequence/plan/hertz_model.hpp"
#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/plan/simplified_model.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

// The order is that of cost.
constexpr ElasticityModel rows_of_models[] = {
    {.model = Model::simplified,
     .in_words = "simplified theory",
     .solve = solve_simplified,
     .fit = fit_of_simplified,
     .by_name_only = true},
    {.model = Model::hertz, .in_words = "Hertz's closed form", .solve = solve_hertz, .fit = fit_of_hertz},
    {.model = Model::halfspace,
     .in_words = "half-space theory",
     .numbers = [](const ContactSetup& setup, const PairFiles&, const ContactOnGrid& contact,
                   NumbersParts* known, int) { return halfspace_pair(setup, contact, known); },
     .errors = halfspace_errors},
    {.model = Model::tangent_plane,
     .in_words = "tangent planes",
     .depends_on_both_rows = true,
     .numbers = [](const ContactSetup& setup, const PairFiles&, const ContactOnGrid& contact,
                   NumbersParts* known, int) { return tangent_plane_pair(setup, contact, known); },
     .errors = tangent_plane_errors},
    {.model = Model::fem, .in_words = "finite elements", .depends_on_both_rows = true, .numbers = fem_pair},
};
static_assert(std::size(rows_of_models) == model_words.size());

} // namespace

std::span<const ElasticityModel> elasticity_models() {
  return rows_of_models;
}

const ElasticityModel& elasticity_model(Model model) {
  return *std::ranges::find(rows_of_models, model, &ElasticityModel::model);
}

bool is_closed_form(Model model) {
  return elasticity_model(model).solve != nullptr;
}

bool has_files(Model model) {
  return words_of(model).needs_files;
}

bool depends_on_both_rows(std::optional<Model> model) {
  return !model || elasticity_model(*model).depends_on_both_rows;
}

bool turns_with_rows(Model model) {
  return depends_on_both_rows(model) && !has_files(model);
}

Model model_of_files() {
  return std::ranges::find_if(rows_of_models, has_files, &ElasticityModel::model)->model;
}

ModelErrors predicted_errors(Model model, const ContactTraits& traits) {
  const ElasticityModel& row = elasticity_model(model);
  return row.errors ? row.errors(traits) : ModelErrors();
}

InfluenceNumbers pair_numbers(Model model, const ContactSetup& setup, const PairFiles& files,
                              const ContactOnGrid& contact, NumbersParts* known, int threads) {
  return elasticity_model(model).numbers(setup, files, contact, known, threads);
}

SceneFile rough_scene(const SceneFile& scene) {
  SceneFile rough = with_model(scene, rough_model);
  rough.grid = SceneFile::Grid();
  rough.grid.rows = scene.grid.rows;
  rough.grid.planar = scene.grid.planar;
  rough.motion.free_rolling = false;
  rough.load.force_y.reset();
  rough.stresses.depths.clear();
  return rough;
}

} // namespace bem_contact
