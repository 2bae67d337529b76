#pragma once

#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <deque>
#include <utility>
#include <vector>

namespace bem_contact {

/// Everything that a pair's influence numbers depend on; two equal ones have the same numbers.
struct NumbersSource {
  Model model = Model::halfspace;
  Body rail, wheel;
  int columns = 0, rows = 0;
  double dx = 0, ds = 0;               ///< mm; dx 0: plane strain
  double reference_distance = 0;       ///< of plane strain, mm
  std::vector<double> rail_s, wheel_s; ///< stations of the rows where influence functions are taken, mm
  double contact_radius = 0;           ///< mm
  /// Of the rows against the wheel's axle, rad, where the wheel's radial displacement is added.
  std::vector<double> inclination;

  bool operator==(const NumbersSource&) const = default;
};

/// Influence numbers of the grids met last.
class NumbersStore {
public:
  /// Those of `source`, computed by `compute` unless they are kept.
  template <class Compute> InfluenceNumbers get(const NumbersSource& source, const Compute& compute) {
    for (const auto& [of, numbers] : kept_)
      if (of == source) {
        ++found_;
        return numbers;
      }
    kept_.emplace_front(source, compute());
    if (kept_.size() > static_cast<std::size_t>(numbers_kept))
      kept_.pop_back();
    return kept_.front().second;
  }

  int found() const { return found_; } ///< how often they were kept

private:
  int found_ = 0;
  std::deque<std::pair<NumbersSource, InfluenceNumbers>> kept_;
};

} // namespace bem_contact
