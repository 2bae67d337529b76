#include "bem_contact/wear/history.hpp"

#include <numbers>

namespace bem_contact::wear {

namespace {

constexpr double mm_per_km = 1e6;

} // namespace

WearRow history_row(int step, const WornPair& pair, double wheel_radius) {
  return {.step = double(step),
          .revolutions = pair.revolutions,
          .mileage = pair.revolutions * 2 * std::numbers::pi * wheel_radius / mm_per_km,
          .rail_depth = pair.rail.largest(),
          .wheel_depth = pair.wheel.largest(),
          .rail_area = pair.rail.area,
          .wheel_area = pair.wheel.area};
}

} // namespace bem_contact::wear
