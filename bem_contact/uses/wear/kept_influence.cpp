#include "bem_contact/uses/wear/kept_influence.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::wear {

double turn_between(std::span<const Point2> before, std::span<const Point2> after) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < before.size(); ++i)
    largest = std::max(largest, std::abs(angle_from_to(before[i + 1] - before[i], after[i + 1] - after[i])));
  return largest;
}

void refuse_outgrown(std::string_view body, double turn, double limit, std::string_view since,
                     const std::string& advice) {
  throw InputError(
      fmt::format("The {} has outgrown its influence functions", body),
      fmt::format("its surface has turned by up to {:.4f} rad since {}, and they are kept up to {:.4g} rad",
                  turn, since, limit),
      advice);
}

void require_kept(std::string_view body, const KeptInfluence& influence, std::span<const Point2> now,
                  double limit) {
  if (influence.file.empty())
    return;
  if (influence.shape.size() != now.size())
    throw InputError(fmt::format("The influence functions of the {} are of another profile", body),
                     fmt::format("its shape has {} points, theirs {}", now.size(), influence.shape.size()),
                     "Give the shape that they were computed for.");
  if (const double turn = turn_between(influence.shape, now); turn > limit)
    refuse_outgrown(body, turn, limit, "they were computed",
                    "Compute those of its present shape, and go on with them.");
}

} // namespace bem_contact::wear
