#include "bem_contact/sequence/quantities.hpp"

#include "bem_contact/sequence/uncertified.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

using Kind = QuantityKind;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr Unit mm{"mm", nullptr, Kind::length}, newton{"N", nullptr, Kind::force},
    moment_unit{"N mm", nullptr, Kind::moment}, megapascal{"MPa", nullptr, Kind::pressure},
    square{"mm2", nullptr, Kind::area}, radian{"rad", nullptr, Kind::angle},
    celsius{"degC", nullptr, Kind::temperature}, share_unit{"1", nullptr, Kind::share},
    plain_number{"1", nullptr, Kind::count}, effort{"1", nullptr, Kind::effort};
constexpr Unit creepage_unit{"1", "mm", Kind::creepage}, spin_unit{"1/mm", "rad", Kind::creepage};
constexpr Unit compliance_unit{"mm3/N"};
constexpr Unit creepage_alone{"1", nullptr, Kind::creepage};
/// Work per rolled length is a force (T-gamma).
constexpr Unit work_unit{"N", "N mm", Kind::power}, work_density_unit{"MPa", "N/mm"};

/// A total, with its error.
template <auto member>
constexpr auto of_totals = [](const SceneResult& r) { return r.result.totals.*member; };
template <auto member>
constexpr auto of_motion = [](const SceneResult& r) -> double { return r.motion.*member; };
template <int ElementCounts::*count>
constexpr auto elements = [](const SceneResult& r) { return double(count_elements(r.result).*count); };
template <int Effort::*count>
constexpr auto of_effort = [](const SceneResult& r) { return double(r.result.effort.*count); };

/// Numbers that are members of a patch: a Measured, a number, or a count.
constexpr Measured as_number(const Measured& member) {
  return member;
}
constexpr double as_number(double member) {
  return member;
}
template <auto member>
constexpr auto of_patch =
    [](const SceneResult& r, std::size_t patch) { return as_number(r.result.patches[patch].*member); };
template <auto member>
constexpr auto of_place =
    [](const SceneResult& r, std::size_t patch) { return r.patch_places[patch].*member; };

/// The same of one step, without an error.
template <auto member>
constexpr auto of_step =
    [](const SceneResult&, const ContactResult& step) -> double { return step.totals.*member; };

/// A stored field; it may be empty, as the slip of a frictionless result is.
void copy_stored(const std::vector<double>& field, std::span<double> to) {
  std::ranges::fill(to, 0.0);
  std::ranges::copy(field, to.begin());
}
template <auto member> void copy_result(const SceneResult& r, std::span<double> to) {
  copy_stored(r.result.*member, to);
}
template <auto member> std::span<const double> stored_result(const SceneResult& r) {
  return r.result.*member;
}
/// A field that the result keeps.
template <auto member>
constexpr ElementQuantity kept_field(const char* name, const Unit& unit, const char* meaning) {
  return {name, unit, meaning, copy_result<member>, nullptr, stored_result<member>};
}
template <auto member> void copy_displacement(const SceneResult& r, std::span<double> to) {
  copy_stored(r.result.displacements.*member, to);
}
void copy_work_density(const SceneResult& r, std::span<double> to) {
  copy_stored(friction_work_density(r.result), to);
}

bool has_temperatures(const SceneResult& r) {
  return r.result.temperatures.has_value();
}
template <auto surface> void copy_temperature(const SceneResult& r, std::span<double> to) {
  std::ranges::fill(to, none);
  if (has_temperatures(r))
    std::ranges::copy((*r.result.temperatures).*surface, to.begin());
}
constexpr Quantity known_quantities[] = {
    {"Fx", newton, "on the rail", of_totals<&ContactTotals::Fx>},
    {"Fy", newton, "on the rail, to the right (left wheel: to the left)", of_totals<&ContactTotals::Fy>},
    {"Fz", newton, "on the rail, down", of_totals<&ContactTotals::Fz>},
    {"Fs", newton, "shear force along the tangent at the reference point", of_totals<&ContactTotals::Fs>},
    {"Mz", moment_unit, "on the rail, about the vertical axis through the reference point",
     [](const SceneResult& r) { return r.moment; }},
    {"lateral", mm, "lateral displacement of the wheelset, given or found for load.force_y; nan: of a patch",
     [](const SceneResult& r) {
       const auto& found = r.motion.found_lateral;
       return Measured{r.motion.lateral.value_or(none), found ? found->lateral.error : none};
     },
     Missing::possible},
    {"approach", mm, "along z", of_totals<&ContactTotals::approach>},
    {"vertical", mm,
     "how far the wheelset's centre is lower than wheel_radius above the rail, loaded; nan: of a patch",
     [](const SceneResult& r) {
       const Measured approach = r.result.totals.approach;
       return r.motion.lowered ? Measured{*r.motion.lowered + approach, approach.error}
                               : Measured{none, none};
     },
     Missing::possible},
    {"Fx_slope", newton,
     "longitudinal force of the pressure on a rail that rises or falls along x, besides Fx; nan: wheel and "
     "rail are the same along x",
     [](const SceneResult& r) { return r.motion.slope_force.value_or(none); }, Missing::possible},
    {"pmax", megapascal, "largest pressure", of_totals<&ContactTotals::pmax>},
    {"area", square, "in contact", of_totals<&ContactTotals::area>},
    {"indentation", mm,
     "how deep the surfaces are indented for good at most; nan: no limit_pressure is given",
     [](const SceneResult& r) {
       return r.problem.limit_pressure ? std::max(0.0, -std::ranges::min(r.result.deformed_distance)) : none;
     },
     Missing::possible},
    {"adhesion_share", share_unit, "of the area in contact that adheres",
     of_totals<&ContactTotals::adhesion_share>},
    {"T_gamma", work_unit, "work of friction per unit of rolled distance (shift: in the step)",
     of_totals<&ContactTotals::T_gamma>},
    {"Tmax_rail", celsius, "highest temperature of the rail's surface; nan: not asked for",
     of_totals<&ContactTotals::Tmax_rail>, Missing::possible},
    {"Tmax_wheel", celsius, "highest temperature of the wheel's surface; nan: not asked for",
     of_totals<&ContactTotals::Tmax_wheel>, Missing::possible},
    {"xi", creepage_unit, "longitudinal creepage, with what was found for load.force_x",
     [](const SceneResult& r) {
       return Measured{r.motion.xi, r.result.totals.creepage_x.error};
     }},
    {"eta", creepage_unit, "lateral creepage, with what was found for load.force_s",
     [](const SceneResult& r) {
       return Measured{r.motion.eta, r.result.totals.creepage_s.error};
     }},
    {"phi", spin_unit, "spin, without that of the geometry (patches have all of it)",
     of_motion<&SceneMotion::phi>},
    {"creepage_x", creepage_unit, "longitudinal creepage found for load.force_x",
     of_totals<&ContactTotals::creepage_x>},
    {"creepage_s", creepage_unit, "lateral creepage found for load.force_s",
     of_totals<&ContactTotals::creepage_s>},
    {"layer_compliance", compliance_unit,
     "of the layer under shear, given or found for layer.slope; nan: there is none, or rows differ",
     [](const SceneResult& r) {
       return r.layer.shear.empty() || r.layer.by_row() ? none : r.layer.shear.front();
     },
     Missing::possible},
    {"layer_slope", share_unit,
     "slope of Fx over xi at 0 with the layer, over that without it, by slopes in series (within 4 %); nan: "
     "no layer",
     [](const SceneResult& r) { return r.layer.shear.empty() ? none : r.layer_slope; }, Missing::possible},
    {"layer_normal_compliance", compliance_unit, "of the layer under pressure; nan: there is none",
     [](const SceneResult& r) { return r.layer.normal > 0 ? r.layer.normal : none; }, Missing::possible},
    {"largest_plastic_slip", mm, "largest plastic slip of the layer; nan: it does not yield",
     [](const SceneResult& r) {
       return r.result.plastic.empty() ? none : std::ranges::max(r.result.plastic);
     },
     Missing::possible},
    {"free_rolling_xi", creepage_alone, "longitudinal creepage at which Fx is 0; nan: not looked for",
     [](const SceneResult& r) { return r.motion.free_rolling ? r.motion.free_rolling->xi : Measured{none}; },
     Missing::possible},
    {"free_rolling_radius", mm, "rolling radius at which Fx is 0; nan: not looked for",
     [](const SceneResult& r) {
       return r.motion.free_rolling ? r.motion.free_rolling->radius() : Measured{none};
     },
     Missing::possible},
    {"patch_count", plain_number, "connected areas in contact",
     [](const SceneResult& r) { return double(r.result.patches.size()); }},
    {"Fn_2", newton, "normal force of the second largest patch; 0: there is none",
     [](const SceneResult& r) { return r.result.patches.size() > 1 ? r.result.patches[1].fn : Measured{}; }},
    {"contact", plain_number, "elements in contact", elements<&ElementCounts::contact>},
    {"adhesion", plain_number, "elements in adhesion", elements<&ElementCounts::adhesion>},
    {"slip", plain_number, "elements in slip", elements<&ElementCounts::slip>},
    {"mx", plain_number, "columns of the grid",
     [](const SceneResult& r) { return double(r.problem.grid.mx); }},
    {"ms", plain_number, "rows of the grid", [](const SceneResult& r) { return double(r.problem.grid.ms); }},
    {"dx", mm, "length of an element", [](const SceneResult& r) { return r.problem.grid.dx; }},
    {"ds", mm, "width of an element", [](const SceneResult& r) { return r.problem.grid.ds; }},
    {"reference_s", mm, "reference point: arc length on the rail",
     [](const SceneResult& r) { return r.motion.reference.s; }},
    {"reference_y", mm, "reference point, track frame",
     [](const SceneResult& r) { return r.motion.reference.position.y; }},
    {"reference_z", mm, "reference point, track frame, down",
     [](const SceneResult& r) { return r.motion.reference.position.z; }},
    {"reference_delta", radian, "inclination at the reference point",
     [](const SceneResult& r) { return r.motion.reference.delta; }},
    {"certificate", effort, "worst violation of the contact conditions, relative",
     [](const SceneResult& r) { return r.result.trust.certificate.worst(); }},
    {"discretisation", effort, "estimated discretisation error, relative; nan: not estimated",
     [](const SceneResult& r) {
       const double error = r.result.trust.certificate.discretisation;
       return error < 0 ? none : error;
     },
     Missing::possible},
    {"outer_iterations", effort, "between the normal and the tangential problem",
     of_effort<&Effort::outer_iterations>},
    {"normal_iterations", effort, "changes of the active set", of_effort<&Effort::normal_iterations>},
    {"tangential_iterations", effort, "steps of the tangential solver",
     of_effort<&Effort::tangential_iterations>},
    {"warning_count", effort, "how many warnings there are",
     [](const SceneResult& r) { return double(r.warnings.size()); }},
};

constexpr PatchQuantity all_of_patches[] = {
    {"Fn", newton, "sum of the pressure", of_patch<&PatchSummary::fn>},
    {"Fx", newton, "on the rail", of_patch<&PatchSummary::fx>},
    {"Fs", newton, "sum of the shear traction along s", of_patch<&PatchSummary::fs>},
    {"Fy", newton, "on the rail, track frame", of_patch<&PatchSummary::fy>},
    {"Fz", newton, "on the rail, track frame, down", of_patch<&PatchSummary::fz>},
    {"Mx", moment_unit, "on the rail, about x through the patch's centre", of_patch<&PatchSummary::moment_x>},
    {"Ms", moment_unit, "on the rail, about s at the patch's centre", of_patch<&PatchSummary::moment_s>},
    {"Mn", moment_unit, "on the rail, about n at the patch's centre", of_patch<&PatchSummary::moment_n>},
    {"overlap", mm, "largest overlap of the undeformed bodies, along n", of_patch<&PatchSummary::overlap>},
    {"pmax", megapascal, "largest pressure", of_patch<&PatchSummary::pmax>},
    {"area", square, "in contact", of_patch<&PatchSummary::area>},
    {"semi_axis_a", mm,
     "ellipse whose Hertzian pressure has the second moments of this one: semi-axis nearest to x",
     of_patch<&PatchSummary::semi_axis_a>},
    {"semi_axis_b", mm, "the other semi-axis of this ellipse", of_patch<&PatchSummary::semi_axis_b>},
    {"axis_angle", radian, "from x to the first semi-axis, towards s", of_patch<&PatchSummary::axis_angle>},
    {"x", mm, "centre of pressure, rolling direction", of_patch<&PatchSummary::x>},
    {"s", mm, "centre of pressure, arc length along the rail", of_patch<&PatchSummary::s>},
    {"y", mm, "centre of pressure, track frame, to the right (left wheel: to the left)",
     [](const SceneResult& r, std::size_t i) { return r.result.patches[i].position.y; }},
    {"z", mm, "centre of pressure, track frame, down",
     [](const SceneResult& r, std::size_t i) { return r.result.patches[i].position.z; }},
    {"delta", radian, "inclination there", of_patch<&PatchSummary::delta>},
    {"rail_y", mm, "the same point in the frame of the rail's profile", of_place<&PatchPlace::rail_y>},
    {"rail_z", mm, "the same point in the frame of the rail's profile", of_place<&PatchPlace::rail_z>},
    {"wheel_s", mm, "the point opposite, arc length along the wheel's profile",
     of_place<&PatchPlace::wheel_s>},
    {"wheel_y", mm, "the point opposite, in the frame of the wheel's profile",
     of_place<&PatchPlace::wheel_y>},
    {"wheel_z", mm, "the point opposite, in the frame of the wheel's profile",
     of_place<&PatchPlace::wheel_z>},
    {"wheel_delta", radian, "inclination of the wheel's profile there, 0: parallel to the axle",
     of_place<&PatchPlace::wheel_delta>},
    {"xi", creepage_unit, "rigid slip along x at the patch's centre", of_place<&PatchPlace::xi>},
    {"eta", creepage_unit, "rigid slip along s at the patch's centre", of_place<&PatchPlace::eta>},
    {"phi", spin_unit, "rotation of the rigid slip about n there, with that of the geometry",
     of_place<&PatchPlace::phi>},
    {"body", plain_number,
     "which of several bodies of the rail bears it, from 1 in the order of the scene; 0: there is one",
     of_place<&PatchPlace::body>},
    {"T_gamma", work_unit, "work of friction per unit of rolled distance (shift: in the step)",
     of_patch<&PatchSummary::T_gamma>},
    {"contact", plain_number, "elements in contact", of_patch<&PatchSummary::contact>},
    {"adhesion", plain_number, "elements in adhesion", of_patch<&PatchSummary::adhesion>},
    {"slip", plain_number, "elements in slip", of_patch<&PatchSummary::slip>},
};

/// The number of that name, of one step.
template <class Number> constexpr StepQuantity of_each_step(std::string_view name, Number of_one) {
  const Quantity& q = named(known_quantities, name);
  return {q.name, q.unit, q.meaning, of_one};
}

constexpr StepQuantity all_of_steps[] = {
    of_each_step("Fx", of_step<&ContactTotals::Fx>),
    of_each_step("Fy", of_step<&ContactTotals::Fy>),
    of_each_step("Fz", of_step<&ContactTotals::Fz>),
    of_each_step("Fs", of_step<&ContactTotals::Fs>),
    of_each_step("Mz",
                 [](const SceneResult& r, const ContactResult& step) -> double {
                   return moment_about(r.motion.reference, step);
                 }),
    of_each_step("approach", of_step<&ContactTotals::approach>),
    of_each_step("pmax", of_step<&ContactTotals::pmax>),
    of_each_step("area", of_step<&ContactTotals::area>),
    of_each_step("T_gamma", of_step<&ContactTotals::T_gamma>),
    of_each_step("creepage_x", of_step<&ContactTotals::creepage_x>),
    of_each_step("creepage_s", of_step<&ContactTotals::creepage_s>),
    of_each_step("certificate", [](const SceneResult&,
                                   const ContactResult& step) { return step.trust.certificate.worst(); }),
    {"certified", effort, "1: the step is a solution",
     [](const SceneResult&, const ContactResult& step) { return double(step.certified()); }},
};

constexpr RowQuantity all_of_rows[] = {
    {"s", mm, "middle of the rows, arc length along the rail",
     [](const SceneResult& r, std::size_t row) { return r.problem.rows[row].s; }},
    {"y", mm, "middle of the rows, track frame, to the right (left wheel: to the left)",
     [](const SceneResult& r, std::size_t row) { return r.problem.rows[row].position.y; }},
    {"z", mm, "middle of the rows, track frame, down",
     [](const SceneResult& r, std::size_t row) { return r.problem.rows[row].position.z; }},
    {"delta", radian, "inclination of the rows",
     [](const SceneResult& r, std::size_t row) { return r.problem.rows[row].delta; }},
    {"wheel_s", mm, "arc length along the wheel's profile opposite the rows; nan: it has none",
     [](const SceneResult& r, std::size_t row) {
       return r.bodies.wheel_s.empty() ? none : r.bodies.wheel_s[row];
     }},
    {"rail_s", mm, "of a patch on influence files: arc length of the rows along the lower body's profile",
     [](const SceneResult& r, std::size_t row) {
       return r.bodies.rail_s.empty() ? none : r.bodies.rail_s[row];
     }},
    {"layer", compliance_unit, "compliance of the layer under shear on the rows; nan: there is none",
     [](const SceneResult& r, std::size_t row) {
       return r.layer.shear.empty() ? none : r.layer.shear_of(static_cast<int>(row));
     }},
};

constexpr ElementQuantity all_of_elements[] = {
    kept_field<&ContactFields::px>("p_x", megapascal, "traction on the rail along x"),
    kept_field<&ContactFields::ps>("p_s", megapascal, "traction on the rail along s"),
    kept_field<&ContactFields::pn>("p_n", megapascal, "pressure"),
    kept_field<&ContactFields::slip_x>("slip_x", creepage_unit,
                                       "slip along x, per unit of rolled distance (shift: in the step)"),
    kept_field<&ContactFields::slip_s>("slip_s", creepage_unit,
                                       "slip along s, per unit of rolled distance (shift: in the step)"),
    {"u_x", mm, "displacement of the wheel less that of the rail, along x",
     copy_displacement<&Displacements::ux>},
    {"u_s", mm, "displacement of the wheel less that of the rail, along s",
     copy_displacement<&Displacements::us>},
    {"u_n", mm, "displacement of the wheel less that of the rail, along n",
     copy_displacement<&Displacements::un>},
    {"friction_work_density", work_density_unit,
     "work of friction per area and unit of rolled distance (shift: per area)", copy_work_density},
    {"friction_work", work_unit, "work of friction of the whole element; the sum is T_gamma",
     [](const SceneResult& r, std::span<double> to) {
       copy_work_density(r, to);
       for (double& value : to)
         value *= r.problem.element_area();
     }},
    {"T_rail", celsius, "flash temperature of the rail's surface",
     copy_temperature<&SurfaceTemperatures::rail>, has_temperatures},
    {"T_wheel", celsius, "flash temperature of the wheel's surface",
     copy_temperature<&SurfaceTemperatures::wheel>, has_temperatures},
    {"plastic_slip", mm, "plastic slip of the layer, which rolling carries along",
     [](const SceneResult& r, std::span<double> to) {
       std::ranges::fill(to, none);
       std::ranges::copy(r.result.plastic, to.begin());
     },
     [](const SceneResult& r) { return !r.result.plastic.empty(); }},
    kept_field<&ContactFields::deformed_distance>("deformed_distance", mm,
                                                  "between the deformed surfaces, along n"),
    {"gap", mm, "undeformed distance along the rail's normal",
     [](const SceneResult& r, std::span<double> to) { copy_stored(r.problem.gap, to); }},
    {"state", plain_number, "0 exterior, 1 adhesion, 2 slip",
     [](const SceneResult& r, std::span<double> to) {
       std::ranges::fill(to, 0.0);
       std::ranges::transform(r.result.state, to.begin(),
                              [](ElementState state) { return static_cast<double>(state); });
     }},
};

} // namespace

std::span<const Quantity> quantities() {
  return known_quantities;
}

std::span<const PatchQuantity> patch_quantities() {
  return all_of_patches;
}

std::span<const StepQuantity> step_quantities() {
  return all_of_steps;
}

std::span<const RowQuantity> row_quantities() {
  return all_of_rows;
}

std::span<const ElementQuantity> element_quantities() {
  return all_of_elements;
}

std::vector<double> ElementQuantity::values(const SceneResult& result) const {
  std::vector<double> out(static_cast<std::size_t>(result.problem.grid.size()));
  copy(result, out);
  return out;
}

std::string why_no_errors(const SceneResult& r) {
  const auto& estimate = r.result.trust.discretisation;
  if (!estimate || estimate->converges)
    return r.result.trust.why_no_errors;
  return fmt::format(
      "the pressure does not converge with the size of the elements ({}). Give smaller elements, or "
      "smooth the profiles",
      why_not_convergent(r.result));
}

} // namespace bem_contact
