#include "bem_contact/profile/sections/rail_surfaces.hpp"

#include <algorithm>
#include <numeric>

namespace bem_contact {

namespace {

/// mm of t between two bodies. Searches go in steps of some mm, and none leads from one to the other.
constexpr double gap_of_t = 1000;

double middle_y(const SectionedSurface& surface) {
  const auto [from, to] = surface.extent(surface.from());
  return surface.at(surface.from(), 0.5 * (from + to)).position.y;
}

} // namespace

RailSurfaces::RailSurfaces(std::vector<Body> bodies) : order_(bodies.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, {}, [&](int i) { return middle_y(*bodies[i].surface); });
  double begin = 0;
  for (const int i : order_) {
    const std::vector<double>& t = bodies[i].surface->nodes();
    begin_.push_back(begin - t.front());
    for (const double node : t)
      nodes_.push_back(begin_.back() + node);
    begin = nodes_.back() + gap_of_t;
    bodies_.push_back(bodies[i]);
  }
}

double RailSurfaces::from() const {
  return std::ranges::min(bodies_, {}, [](const Body& b) { return b.surface->from(); }).surface->from();
}

double RailSurfaces::to() const {
  return std::ranges::max(bodies_, {}, [](const Body& b) { return b.surface->to(); }).surface->to();
}

std::pair<double, double> RailSurfaces::places_about(double u) const {
  std::pair out{from(), to()};
  for (const Body& body : bodies_)
    for (const double at : body.surface->places())
      (at <= u ? out.first : out.second) = at <= u ? std::max(out.first, at) : std::min(out.second, at);
  return out;
}

const SectionedSurface& RailSurfaces::surface(int body) const {
  return *bodies_[std::ranges::find(order_, body) - order_.begin()].surface;
}

int RailSurfaces::place_of(double t) const {
  int place = 0;
  while (place + 1 < count() && t > begin_[place + 1] - 0.5 * gap_of_t)
    ++place;
  return place;
}

SectionedSurface::Point RailSurfaces::at(double u, double t, int side) const {
  const int place = place_of(t);
  SectionedSurface::Point out = bodies_[place].surface->at(u, t - begin_[place], side);
  out.position.z += bodies_[place].lowered;
  return out;
}

bool RailSurfaces::has(double u, double t) const {
  const int place = place_of(t);
  const SectionedSurface& surface = *bodies_[place].surface;
  if (count() > 1 && (u < surface.from() || u > surface.to()))
    return false;
  return surface.has(u, t - begin_[place]);
}

} // namespace bem_contact
