#include "bem_contact/c/result_values.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// The field of that name. It may be empty, as the slip of a frictionless result is.
const std::vector<double>* field_of(const SceneResult& r, int which) {
  switch (which) {
  case CONFORMAL_P_X:
    return &r.result.px;
  case CONFORMAL_P_S:
    return &r.result.ps;
  case CONFORMAL_P_N:
    return &r.result.pn;
  case CONFORMAL_SLIP_X:
    return &r.result.slip_x;
  case CONFORMAL_SLIP_S:
    return &r.result.slip_s;
  case CONFORMAL_U_X:
    return &r.result.displacements.ux;
  case CONFORMAL_U_S:
    return &r.result.displacements.us;
  case CONFORMAL_U_N:
    return &r.result.displacements.un;
  case CONFORMAL_GAP:
    return &r.problem.gap;
  case CONFORMAL_DEFORMED_DISTANCE:
    return &r.result.deformed_distance;
  default:
    return nullptr;
  }
}

double row_value(const ContactRow& row, int which) {
  switch (which) {
  case CONFORMAL_S:
    return row.s;
  case CONFORMAL_Y:
    return row.position.y;
  case CONFORMAL_Z:
    return row.position.z;
  default:
    return row.delta;
  }
}

} // namespace

std::array<double, CONFORMAL_TOTALS> totals_of(const SceneResult& result) {
  const ContactResult& r = result.result;
  std::array<double, CONFORMAL_TOTALS> out{};
  out[CONFORMAL_FX] = r.Fx;
  out[CONFORMAL_FY] = r.Fy;
  out[CONFORMAL_FZ] = r.Fz;
  out[CONFORMAL_FS] = r.Fs;
  out[CONFORMAL_MZ] = result.moment;
  out[CONFORMAL_APPROACH] = r.approach;
  out[CONFORMAL_CREEPAGE_X] = r.creepage_x;
  out[CONFORMAL_CREEPAGE_S] = r.creepage_s;
  out[CONFORMAL_PMAX] = largest_pressure(r);
  out[CONFORMAL_AREA] = contact_area(r);
  out[CONFORMAL_FRICTION_POWER] = friction_power(r, result.problem.element_area());
  out[CONFORMAL_CERTIFICATE] = r.certificate.worst();
  out[CONFORMAL_DISCRETISATION] = r.certificate.discretisation < 0 ? -1 : r.certificate.discretisation;
  return out;
}

std::array<double, CONFORMAL_PATCH_VALUES> values_of(const PatchSummary& patch) {
  std::array<double, CONFORMAL_PATCH_VALUES> out{};
  out[CONFORMAL_PATCH_FN] = patch.fn;
  out[CONFORMAL_PATCH_FX] = patch.fx;
  out[CONFORMAL_PATCH_FS] = patch.fs;
  out[CONFORMAL_PATCH_APPROACH] = patch.approach;
  out[CONFORMAL_PATCH_PMAX] = patch.pmax;
  out[CONFORMAL_PATCH_AREA] = patch.area;
  out[CONFORMAL_PATCH_X] = patch.x;
  out[CONFORMAL_PATCH_S] = patch.s;
  out[CONFORMAL_PATCH_CONTACT] = patch.contact;
  out[CONFORMAL_PATCH_ADHESION] = patch.adhesion;
  out[CONFORMAL_PATCH_SLIP] = patch.slip;
  return out;
}

void copy_first(std::span<const double> values, double* to, int count) {
  if (count < 0 || count > static_cast<int>(values.size()))
    throw InputError(fmt::format("{} values cannot be copied", count),
                     fmt::format("there are {}", values.size()),
                     "Give the size of the array, at most the number of values.");
  std::copy_n(values.begin(), count, to);
}

void copy_array(const SceneResult& result, int which, std::span<double> to) {
  const ContactGrid& grid = result.problem.grid;
  if (which < CONFORMAL_X || which > CONFORMAL_STATE)
    throw InputError(fmt::format("There is no array {}", which),
                     fmt::format("they have the numbers {} to {}", CONFORMAL_X, CONFORMAL_STATE),
                     "See CONFORMAL_X and the following in conformal_contact.h.");
  const int size = which == CONFORMAL_X ? grid.mx : which <= CONFORMAL_DELTA ? grid.ms : grid.size();
  if (to.size() != static_cast<std::size_t>(size))
    throw InputError(fmt::format("The array {} does not fit into {} values", which, to.size()),
                     fmt::format("it has {}: the grid is mx = {} by ms = {}", size, grid.mx, grid.ms),
                     "Ask conformal_grid() after each solution.");
  if (which == CONFORMAL_X) {
    for (int ix = 0; ix < grid.mx; ++ix)
      to[static_cast<std::size_t>(ix)] = grid.x(ix);
  } else if (which <= CONFORMAL_DELTA) {
    std::ranges::transform(result.problem.rows, to.begin(),
                           [&](const ContactRow& row) { return row_value(row, which); });
  } else if (which == CONFORMAL_STATE) {
    std::ranges::fill(to, 0.0);
    std::ranges::transform(result.result.state, to.begin(),
                           [](ElementState s) { return static_cast<double>(s); });
  } else {
    std::ranges::fill(to, 0.0);
    std::ranges::copy(*field_of(result, which), to.begin());
  }
}

} // namespace bem_contact
