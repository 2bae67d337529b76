#include "bem_contact/app/from_contact/patch_grid.hpp"

#include "bem_contact/reference/hertz.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::app::from_contact {

PatchGrid grid_by_places(const contact_input::Block& p) {
  PatchGrid out{.mx = static_cast<std::size_t>(p["MX"]), .ms = static_cast<std::size_t>(p["MY"])};
  const double nx = p["MX"], ns = p["MY"];
  if (p.has("DX")) {
    out.dx = p["DX"], out.ds = p["DY"];
    out.x = p.has("XL") ? p["XL"] + nx * out.dx / 2 : p["XC1"] + (nx - 1) * out.dx / 2;
    out.y = p.has("YL") ? p["YL"] + ns * out.ds / 2 : p["YC1"] + (ns - 1) * out.ds / 2;
    return out;
  }
  const bool edges = p.has("XL");
  const double x0 = edges ? p["XL"] : p["XC1"], x1 = edges ? p["XH"] : p["XCM"];
  const double y0 = edges ? p["YL"] : p["YC1"], y1 = edges ? p["YH"] : p["YCM"];
  out.dx = (x1 - x0) / (edges ? nx : std::max(1.0, nx - 1));
  out.ds = (y1 - y0) / (edges ? ns : std::max(1.0, ns - 1));
  out.x = (x0 + x1) / 2, out.y = (y0 + y1) / 2;
  return out;
}

HertzianGrid grid_by_ellipse(const contact_input::Block& p, double modulus, bool by_force, double load) {
  const auto ellipse = [&](double a, double b) {
    return by_force ? reference::hertz_by_force(a, b, modulus, load)
                    : reference::hertz_by_approach(a, b, modulus, load);
  };
  double a = p.number("A1", 1), b = p.number("B1", 1);
  if (p.has("AOB"))
    b = a / reference::hertz_curvature_ratio(p["AOB"]);
  if (p.has("AA")) { // semi-axes grow as (force / curvature)^(1/3), or as (approach / curvature)^(1/2)
    b = 1 / reference::hertz_curvature_ratio(p["AA"] / p["BB"]);
    const double scale = std::pow(ellipse(1, b).semi_axis_x / p["AA"], by_force ? 3 : 2);
    a = scale, b *= scale;
  }
  const reference::HertzContact found = ellipse(a, b);
  HertzianGrid out{.grid = {.mx = static_cast<std::size_t>(p["MX"]), .ms = static_cast<std::size_t>(p["MY"])},
                   .curvature_x = a,
                   .curvature_s = b};
  out.grid.dx = 2 * p["SCALE"] * found.semi_axis_x / p["MX"];
  out.grid.ds = 2 * p["SCALE"] * found.semi_axis_s / p["MY"];
  return out;
}

} // namespace bem_contact::app::from_contact
