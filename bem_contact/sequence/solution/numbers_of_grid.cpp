#include "bem_contact/sequence/solution/numbers_of_grid.hpp"

#include "bem_contact/sequence/models.hpp"

#include <utility>

namespace bem_contact {

namespace {

/// No other case has the same numbers where they turn with the rows.
NumbersStore* store_for(Model model, NumbersStore* store) {
  return turns_with_rows(model) ? nullptr : store;
}

} // namespace

NumbersSource numbers_source(Model model, const ContactSetup& setup, const ContactOnGrid& contact) {
  const ContactGrid& grid = contact.problem.grid;
  NumbersSource source{model,       setup.rail,
                       setup.wheel, grid.mx,
                       grid.ms,     contact.problem.plane_strain() ? 0.0 : grid.dx,
                       grid.ds,     setup.reference_distance(),
                       {},          {},
                       {},          0,
                       0,           {}};
  if (has_files(model)) {
    source.rail_s = contact.rail_s;
    source.wheel_s = contact.wheel_s;
    if (!setup.rail.sections.empty())
      source.blend = section_blend(setup, contact.problem.rows);
    source.contact_radius = contact.contact_radius;
    source.roller_contact_radius = contact.roller_contact_radius;
    source.inclination = radial_inclination(setup, contact.problem.rows);
  }
  return source;
}

InfluenceNumbers computed_numbers(const ContactCase& asked, Model model, const ContactOnGrid& contact,
                                  const SolveResources& resources) {
  return pair_numbers(model, asked.setup, asked.files, contact,
                      resources.numbers ? &resources.numbers->parts() : nullptr, resources.threads);
}

NumbersOfGrid::NumbersOfGrid(const ContactCase& asked, Model model, const ContactOnGrid& contact,
                             const SolveResources& resources)
    : store_(store_for(model, resources.numbers)), source_(numbers_source(model, asked.setup, contact)),
      compute_([&asked, &contact, &resources, model] {
        return computed_numbers(asked, model, contact, resources);
      }) {}

InfluenceNumbers NumbersOfGrid::take(InfluenceNumbers& elsewhere) {
  if (!elsewhere.values.empty())
    return std::move(elsewhere);
  return store_ ? store_->take(source_, compute_) : compute_();
}

void NumbersOfGrid::keep(InfluenceNumbers numbers, InfluenceNumbers& elsewhere) const {
  if (store_)
    store_->keep(source_, std::move(numbers));
  else
    elsewhere = std::move(numbers);
}

LayerInNumbers::LayerInNumbers(const SurfaceLayer& layer, InfluenceNumbers& numbers) : numbers_(numbers) {
  if (layer.is_none())
    return;
  if (layer.by_row() && numbers.translational)
    before_ = numbers; // small, and the others take another form
  else
    for (int row = 0; row < numbers.rows; ++row)
      for (int i = 0; i < 3; ++i)
        diagonal_.push_back(numbers.at(0, row, i, row, i));
  add_layer(layer, numbers);
}

LayerInNumbers::~LayerInNumbers() {
  if (before_)
    numbers_ = std::move(*before_);
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    const int row = static_cast<int>(k / 3), i = static_cast<int>(k % 3);
    numbers_.at(0, row, i, row, i) = diagonal_[k];
  }
}

} // namespace bem_contact
