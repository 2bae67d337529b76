#pragma once

#include "bem_contact/wear/evolution.hpp"

#include <array>

namespace bem_contact::wear {

/// What has become of both bodies after a step.
struct WearRow {
  double step = 0, revolutions = 0, mileage = 0; ///< 1, 1, km
  double rail_depth = 0, wheel_depth = 0;        ///< largest depth of each body, mm
  double rail_area = 0, wheel_area = 0;          ///< gone from each section, mm^2
};

/// A column of wear.csv, a dataset of wear.h5, an array of Python's wear().
struct WearColumn {
  const char *name, *unit;
  double WearRow::*member;
};
inline constexpr std::array<WearColumn, 7> wear_columns{{{"step", "1", &WearRow::step},
                                                         {"revolutions", "1", &WearRow::revolutions},
                                                         {"mileage", "km", &WearRow::mileage},
                                                         {"rail_depth", "mm", &WearRow::rail_depth},
                                                         {"wheel_depth", "mm", &WearRow::wheel_depth},
                                                         {"rail_area", "mm^2", &WearRow::rail_area},
                                                         {"wheel_area", "mm^2", &WearRow::wheel_area}}};

/// The row of a state after so many steps; the mileage is that of a wheel of this radius, mm.
WearRow history_row(int step, const WornPair& pair, double wheel_radius);

} // namespace bem_contact::wear
