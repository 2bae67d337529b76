#include "bem_contact/scene/choices.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

std::string name_of(std::optional<Model> model) {
  return std::string(model ? name_of(*model) : automatic_model);
}

std::optional<Model> model_named(const std::string& name) {
  if (name == automatic_model)
    return std::nullopt;
  const std::optional<Model> model = value_named<Model>(name);
  if (!model)
    throw InputError(
        fmt::format("There is no model '{}'", name),
        fmt::format("the models are {}, {}", automatic_model, fmt::join(EnumNames<Model>::names, ", ")),
        "Choose one of them.");
  return model;
}

std::vector<Model> models_to_compare() {
  return {Model::halfspace, Model::fem};
}

std::string models_help() {
  constexpr std::size_t width = 13;
  std::string out;
  for (const ModelWords& words : model_words)
    out += fmt::format("  {:<{}}  {}\n", words.name, width, words.help);
  return out +
         fmt::format("  {:<{}}  the cheapest of them whose predicted error is below solver.model_tolerance\n",
                     automatic_model, width);
}

} // namespace bem_contact
