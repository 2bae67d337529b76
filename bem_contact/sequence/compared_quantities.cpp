#include "bem_contact/sequence/compared_quantities.hpp"

#include "bem_contact/sequence/quantities.hpp"

#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

using Scale = DifferenceScale;

constexpr std::string_view approach_name = "approach";
constexpr ComparedQuantity compared[] = {
    {"pmax", "MPa", "pmax", Scale::own},
    {"area", "mm2", "area", Scale::own},
    {"approach", "mm", approach_name, Scale::own},
    {"Fx", "N", "Fx", Scale::friction, true},
    {"Fy", "N", "Fy", Scale::resultant},
    {"Fz", "N", "Fz", Scale::resultant},
    {"Mz", "N mm", "Mz", Scale::friction_moment, true},
    {"T-gamma", "N", "T_gamma", Scale::own, true},
    {"adhesion", "share", "adhesion_share", Scale::plain, true},
    {"free rolling", "xi", "free_rolling_xi", Scale::plain},
    {"rolling radius", "mm", "free_rolling_radius", Scale::plain},
    {"lateral", "mm", "lateral", Scale::plain},
};

} // namespace

double ComparedQuantity::scale_of(double own, const SceneResult& r) const {
  return scale == Scale::own         ? std::abs(own)
         : scale == Scale::resultant ? std::hypot(r.result.totals.Fy, r.result.totals.Fz)
         : scale == Scale::friction  ? friction_bound(r.problem, r.result)
         : scale == Scale::friction_moment
             ? friction_bound(r.problem, r.result) * std::sqrt(r.result.totals.area / std::numbers::pi)
             : 1;
}

std::optional<Measured> ComparedQuantity::of(const SceneResult& r) const {
  const Measured number = quantity(name).measured(r);
  return std::isnan(number) || (friction && !r.problem.has_friction()) ? std::nullopt : std::optional(number);
}

std::optional<double> ComparedQuantity::difference(const SceneResult& model,
                                                   const SceneResult& reference) const {
  const std::optional<Measured> a = of(model), b = of(reference);
  if (!a || !b || (name == approach_name && model.approach_datum != reference.approach_datum))
    return std::nullopt;
  const double divisor = scale_of(*a, model);
  return divisor > 0 ? std::optional((*b - *a) / divisor) : std::nullopt;
}

std::span<const ComparedQuantity> compared_quantities() {
  return compared;
}

record::Record differences_of(const SceneResult& model, const SceneResult& reference) {
  record::Record out;
  for (const ComparedQuantity& q : compared) {
    const bool plain = q.scale == Scale::plain;
    out.add(std::string(q.name), record::Number{q.difference(model, reference).value_or(std::nan("")),
                                                plain ? quantity(q.name).unit.rolling : "1",
                                                plain ? "what the reference has more"
                                                      : "what the reference has more, over its scale"});
  }
  return out;
}

} // namespace bem_contact
