#include "bem_contact/geometry/sectioned_wheel.hpp"

#include "bem_contact/base/place_in_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Points of each section whose height is compared with that of the others: one each 5 mm. Chosen.
constexpr int compared_points = 30;

} // namespace

SectionedWheel::SectionedWheel(std::shared_ptr<const SectionedSurface> surface, double turned)
    : surface_(std::move(surface)), turned_(turned), section_(surface_->section(angle(0), t_)) {
  s_ = section_.joints();
  range_ = greatest_difference();
}

/// Where it is on the surface.
double SectionedWheel::angle(double theta) const {
  return std::remainder(theta + turned_, 2 * std::numbers::pi);
}

Point2 SectionedWheel::offset(double theta, double s) const {
  const auto [k, share] = PlaceInTable(s_, s);
  const double t = t_[k] + share * (t_[k + 1] - t_[k]);
  return surface_->at(angle(theta), t).position - surface_->at(angle(0), t).position;
}

double SectionedWheel::greatest_difference() const {
  double most = 0;
  for (int i = 0; i <= compared_points; ++i) {
    const double t = t_.front() + (t_.back() - t_.front()) * i / compared_points;
    const SectionedSurface::Point here = surface_->at(angle(0), t);
    const double length = norm(here.by_t);
    if (!(length > 0))
      continue;
    double highest = 0, lowest = 0;
    for (const double u : surface_->places()) {
      const Point2 off = surface_->at(u, t).position - here.position;
      const double along_normal = (off.z * here.by_t.y - off.y * here.by_t.z) / length;
      highest = std::max(highest, along_normal), lowest = std::min(lowest, along_normal);
    }
    most = std::max(most, highest - lowest);
  }
  return most;
}

} // namespace bem_contact
