#pragma once

#include "bem_contact/contact/layer.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace bem_contact {

/// What the influence numbers of a contact depend on. Half-space numbers depend on the size of the grid
/// alone.
NumbersSource numbers_source(Model model, const ContactSetup& setup, const ContactOnGrid& contact);
/// Computes them, without a layer.
InfluenceNumbers computed_numbers(const ContactCase& asked, Model model, const ContactOnGrid& contact,
                                  const SolveResources& resources);

/// Takes the pair's numbers from where a solution leaves them, puts the layer between the bodies, and gives
/// them back without it. Everything outlives it.
class NumbersOfGrid {
public:
  NumbersOfGrid(const ContactCase& asked, Model model, const ContactOnGrid& contact,
                const SolveResources& resources);

  /// `elsewhere`: where they are without a store, if they are there.
  InfluenceNumbers take(InfluenceNumbers& elsewhere);
  void keep(InfluenceNumbers numbers, InfluenceNumbers& elsewhere) const;

private:
  NumbersStore* store_;
  NumbersSource source_;
  std::function<InfluenceNumbers()> compute_;
};

/// While it lives, numbers have a layer on their diagonal; then they are what they were, bit by bit.
class LayerInNumbers {
public:
  LayerInNumbers(const SurfaceLayer& layer, InfluenceNumbers& numbers);
  ~LayerInNumbers();
  LayerInNumbers(const LayerInNumbers&) = delete;
  LayerInNumbers& operator=(const LayerInNumbers&) = delete;

private:
  InfluenceNumbers& numbers_;
  std::optional<InfluenceNumbers> before_;
  std::vector<double> diagonal_;
};

} // namespace bem_contact
