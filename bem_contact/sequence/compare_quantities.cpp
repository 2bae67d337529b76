#include "bem_contact/sequence/compare_quantities.hpp"

#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// Of one of the two solutions.
double scale_of(const Quantity& quantity, double value, const SceneResult& r) {
  const ContactResult& c = r.result;
  const double force = std::max({std::abs(c.totals.Fx), std::abs(c.totals.Fy), std::abs(c.totals.Fz)});
  switch (quantity.unit.kind) {
  case QuantityKind::force:
    return force;
  case QuantityKind::moment:
    return force * std::sqrt(c.totals.area);
  case QuantityKind::pressure:
  case QuantityKind::temperature:
  case QuantityKind::area:
    return std::abs(value);
  case QuantityKind::length:
    return std::max(std::abs(value), least_length);
  case QuantityKind::creepage:
    return std::max(std::abs(value), least_creepage);
  case QuantityKind::power:
    return std::max(std::abs(value), least_creepage * force);
  case QuantityKind::angle:
  case QuantityKind::share:
    return 1;
  case QuantityKind::count:
  case QuantityKind::effort:
  case QuantityKind::other:
    break;
  }
  return 0;
}

} // namespace

std::vector<QuantityDifference> differing_quantities(const std::map<std::string, double>& before,
                                                     const SceneResult& now) {
  std::vector<QuantityDifference> out;
  for (const Quantity& quantity : quantities()) {
    const auto found = before.find(quantity.name);
    if (found == before.end() || quantity.unit.kind == QuantityKind::effort)
      continue;
    const double value = quantity.value(now), was = found->second;
    const double allowed = now.result.trust.certificate.tolerance * scale_of(quantity, value, now);
    const bool same = std::isnan(value) || std::isnan(was) ? std::isnan(value) && std::isnan(was)
                                                           : std::abs(value - was) <= allowed;
    if (!same)
      out.push_back({&quantity, was, value, allowed});
  }
  return out;
}

} // namespace bem_contact
