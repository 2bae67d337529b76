#include "bem_contact/uses/curves/creep_record.hpp"

#include "bem_contact/sequence/result_record.hpp"

namespace bem_contact {

namespace {

using record::field;
using record::Number;
using record::Record;

template <CreepForce which>
constexpr auto force = [](const CreepPoint& p) { return p.forces[static_cast<std::size_t>(which)]; };

record::Content matrix(const CreepMatrix* m, const char* meaning) {
  if (!m)
    return {};
  std::vector<double> values;
  for (const auto& row : *m)
    values.insert(values.end(), row.begin(), row.end());
  return field(std::move(values), "Fx, Fs: N (by phi: N mm); Mz: N mm (by phi: N mm2)", meaning, {3, 3});
}

/// Of the numbers of that name.
record::Content errors_of(const char* name, const CreepMatrix& errors) {
  record::Content out = matrix(&errors, "by the size of the elements, and of the steps of differences");
  auto& values = std::get<record::Field>(out);
  values.role = record::Role::error;
  values.of = name;
  return out;
}

/// Kalker's theory, of the nearest ellipse.
record::Content ellipse_of(const std::optional<LinearTheory>& l) {
  if (!l)
    return {};
  constexpr const char* coefficient = "Kalker's coefficient";
  return Record{
      {"semi_axis_x", Number{l->semi_axis_x, "mm", "of the nearest ellipse, along x"}},
      {"semi_axis_s", Number{l->semi_axis_s, "mm", "of the nearest ellipse, along s"}},
      {"tilt", Number{l->tilt, "rad", "of the ellipse out of the axes x and s; taken as 0"}},
      {"deviation", Number{l->deviation, "1", "of the distance from a quadratic, over the approach"}},
      {"shear_modulus", Number{l->shear_modulus, "MPa", "of the pair"}},
      {"poisson", Number{l->poisson, "1", "of the pair"}},
      {"c11", Number{l->coefficients.c11, "1", coefficient}},
      {"c22", Number{l->coefficients.c22, "1", coefficient}},
      {"c23", Number{l->coefficients.c23, "1", coefficient}},
      {"c33", Number{l->coefficients.c33, "1", coefficient}}};
}

} // namespace

std::span<const ColumnOf<CreepPoint>> creep_columns() {
  static constexpr Unit yes_no{"1", nullptr, QuantityKind::count};
  static constexpr ColumnOf<CreepPoint> columns[] = {
      {"Fx", "N", "on the rail", force<CreepForce::Fx>},
      {"Fs", "N", "on the rail", force<CreepForce::Fs>},
      {"Mz", "N mm", "on the rail", force<CreepForce::Mz>},
      {"adhesion_share", "1", "of the area in contact that adheres",
       [](const CreepPoint& p) { return p.adhesion_share; }, 6},
      {"certified", yes_no, "1: the point is a solution",
       [](const CreepPoint& p) { return p.certified ? 1.0 : 0.0; }, 1}};
  return columns;
}

const char* unit_of(CreepKind kind) {
  return kind == CreepKind::phi ? "1/mm" : "1";
}

record::Table table_of(const CreepCurve& curve) {
  record::Table out = record::table_of("creepage", creep_columns(), curve.points);
  record::Column creepage{
      "creepage", unit_of(curve.which), "varied; the other two as the scene has them", {}};
  for (const CreepPoint& p : curve.points)
    creepage.values.push_back(p.creepage);
  out.columns.insert(out.columns.begin(), std::move(creepage));
  return out;
}

Record record_of(const CreepCurves& c) {
  Record curves;
  for (const CreepCurve& curve : c.curves)
    curves.add(std::string(name_of(curve.which)), table_of(curve));
  const MeasuredCreepForces forces = forces_of(c.solution);
  const Creepages rigid = rigid_creepages(c.solution);
  Record out{
      {"model", record::Text{std::string(name_of(c.solution.choice.model))}},
      {"certified", certified(c)},
      {"Fz", Number{c.solution.result.totals.Fz, "N", "on the rail, down"}},
      {"bound", Number{c.bound, "N", "sum of mu p_n dS: no shear force is larger"}},
      {"radius", Number{c.radius, "mm", "c = sqrt(a b) of the ellipse, or of the area in contact"}},
      {"forces", field({forces.begin(), forces.end()}, "N, N, N mm", "Fx, Fs, Mz at the scene's creepages")},
      {"rigid_creepages",
       field({rigid.begin(), rigid.end()}, "1, 1, 1/mm",
             "xi, eta, phi of the scene's rigid slip, with those that the geometry makes")},
      {"slopes", matrix(&c.slopes.values, "[Fx, Fs, Mz][xi, eta, phi] where nothing moves over the other")},
      {"slopes_error", errors_of("slopes", c.slopes.errors)},
      {"slopes_by_differences", c.slopes.by_differences},
      {"sensitivities",
       matrix(&c.sensitivities.values, "[Fx, Fs, Mz][xi, eta, phi] at the scene's creepages")},
      {"sensitivities_error", errors_of("sensitivities", c.sensitivities.errors)},
      {"sensitivities_by_differences", c.sensitivities.by_differences},
      {"kalker", matrix(c.linear ? &c.linear->slopes : nullptr,
                        "[Fx, Fs, Mz][xi, eta, phi] by linear theory for the nearest ellipse")},
      {"kalker_ellipse", ellipse_of(c.linear)},
      {"contact_problems", Number{double(c.contact_problems), "1", "solved for all of this", {}, true}},
      {"curves", std::move(curves)}};
  return out.append(record_of(c.solution.warnings));
}

} // namespace bem_contact
