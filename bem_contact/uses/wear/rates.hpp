#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/uses/wear/wear_of_result.hpp"

#include <span>

namespace bem_contact::wear {

/// What one contact wears away in the units that railways count in. Depths are those of the deepest row,
/// areas are gone from the section. The profiles are as they are: wear soon changes them.
struct WearRates {
  double t_gamma = 0;                           ///< work of friction per rolled distance, N
  double wheel_depth = 0, wheel_area = 0;       ///< mm and mm^2 by km that the wheel runs
  double rail_depth = 0, rail_area = 0;         ///< mm and mm^2 by a million axles, of which one wheel passes
  double axle_load = 0;                         ///< t
  double mgt_rail_depth = 0, mgt_rail_area = 0; ///< mm and mm^2 by a million gross tonnes of such axles
};

/// What wears of a wheel and its rail. `axle_force`: vertical force of both wheels, N. The wheel turns once
/// in 2 pi rolling radius / (1 - xi), and 1e6 t are 1e6 t / axle load passages. Throws InputError for a
/// patch, which has no wheel.
WearRates rates_of(const SceneResult& result, const Wear& wear, double axle_force);

/// The numbers, in the order of the outputs.
std::span<const ColumnOf<WearRates>> rate_columns();

/// What wear of one contact says at every door: the numbers, and the table "rows" over s.
record::Record record_of(const WearRates& rates, const Wear& wear);
/// That table: what a row of elements takes off both bodies, and how far they slide.
record::Table rows_of(const WearRates& rates, const Wear& wear);

} // namespace bem_contact::wear
