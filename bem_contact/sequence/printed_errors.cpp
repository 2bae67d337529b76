#include "bem_contact/sequence/printed_errors.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Of a total whose error is a member.
template <double TotalErrors::*error> double total(const SceneResult& r) {
  return r.result.discretisation ? r.result.discretisation->errors.*error : none;
}

double moment(const SceneResult& r) {
  return r.result.discretisation
             ? r.result.discretisation->moment_error(r.result, r.reference.x, r.reference.position.y)
             : none;
}

constexpr PrintedNumber numbers[] = {
    {"Fx", "Fx_error", "N", "on the rail", [](const SceneResult& r) { return r.result.Fx; },
     total<&TotalErrors::Fx>},
    {"Fy", "Fy_error", "N", "on the rail, to the right (left wheel: to the left)",
     [](const SceneResult& r) { return r.result.Fy; }, total<&TotalErrors::Fy>},
    {"Fz", "Fz_error", "N", "on the rail, down", [](const SceneResult& r) { return r.result.Fz; },
     total<&TotalErrors::Fz>},
    {"Fs", "Fs_error", "N", "shear force along the tangent at the reference point",
     [](const SceneResult& r) { return r.result.Fs; }, total<&TotalErrors::Fs>},
    {"Mz", "Mz_error", "N mm", "about the vertical axis through the reference point",
     [](const SceneResult& r) { return r.moment; }, moment},
    {"approach", "approach_error", "mm", "along z", [](const SceneResult& r) { return r.result.approach; },
     total<&TotalErrors::approach>},
    {"pmax", "pmax_error", "MPa", "largest pressure",
     [](const SceneResult& r) { return largest_pressure(r.result); }, total<&TotalErrors::pmax>},
    {"area", "area_error", "mm2", "in contact", [](const SceneResult& r) { return contact_area(r.result); },
     total<&TotalErrors::area>},
    {"adhesion_share", "adhesion_share_error", "1", "of the area in contact that adheres",
     [](const SceneResult& r) { return adhesion_share(r.result); }, total<&TotalErrors::adhesion_share>},
    {"xi", "xi_error", "1 (shift: mm)", "creepage found for load.force_x",
     [](const SceneResult& r) { return r.result.creepage_x; }, total<&TotalErrors::creepage_x>},
    {"eta", "eta_error", "1 (shift: mm)", "creepage found for load.force_s",
     [](const SceneResult& r) { return r.result.creepage_s; }, total<&TotalErrors::creepage_s>},
    {"friction_power", "friction_power_error", "N mm per mm rolled (shift: N mm)", "dissipated by friction",
     [](const SceneResult& r) { return friction_power(r.result, r.problem.element_area()); },
     total<&TotalErrors::friction_power>},
};

constexpr PrintedPatchNumber patch_numbers[] = {
    {"Fn", "Fn_error", "N", &PatchSummary::fn, &PatchErrors::fn},
    {"Fx", "Fx_error", "N", &PatchSummary::fx, &PatchErrors::fx},
    {"Fs", "Fs_error", "N", &PatchSummary::fs, &PatchErrors::fs},
    {"approach", "approach_error", "mm", &PatchSummary::approach, &PatchErrors::approach},
    {"pmax", "pmax_error", "MPa", &PatchSummary::pmax, &PatchErrors::pmax},
    {"area", "area_error", "mm2", &PatchSummary::area, &PatchErrors::area},
};

} // namespace

std::span<const PrintedNumber> printed_numbers() {
  return numbers;
}

std::span<const PrintedPatchNumber> printed_patch_numbers() {
  return patch_numbers;
}

PatchErrors errors_of_patch(const ContactResult& result, std::size_t patch) {
  return result.discretisation ? result.discretisation->patches.at(patch) : PatchErrors{};
}

double adhesion_share(const ContactResult& result) {
  const ElementCounts counts = count_elements(result);
  return counts.contact > 0 ? double(counts.adhesion) / counts.contact : 0.0;
}

} // namespace bem_contact
