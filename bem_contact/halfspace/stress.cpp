#include "bem_contact/halfspace/stress.hpp"

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/kernels.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <string>

namespace bem_contact::halfspace {
namespace {

/// Derivatives of the potentials of a uniform rectangle. With r the distance from a point of the rectangle,
/// V = integral of 1/r, C of ln(r + z), P of z ln(r + z) - r; all harmonic, P_z = C, C_z = V. Each is the sum
/// over the corners of what stands in add_corner, signed: d/dx and d/dy undo one integration each.
struct Potentials {
  double v_x = 0, v_y = 0, v_z = 0, v_xx = 0, v_yy = 0, v_xy = 0, v_xz = 0, v_yz = 0;
  double c_xx = 0, c_yy = 0, c_xy = 0, c_xxy = 0, c_xyy = 0, p_xxy = 0, p_xyy = 0;

  double v_zz() const { return -v_xx - v_yy; }
  double c_xxx() const { return -v_xz - c_xyy; }
  double c_yyy() const { return -v_yz - c_xxy; }
  double p_xxx() const { return -v_x - p_xyy; }
  double p_yyy() const { return -v_y - p_xxy; }

  void add_corner(double sign, double x, double y, double z) {
    const double r = std::sqrt(x * x + y * y + z * z);
    // r + t without cancellation where t < 0; `rest` is r^2 - t^2
    const auto plus = [r](double t, double rest) { return t < 0 ? rest / (r - t) : r + t; };
    const double r_x = plus(x, y * y + z * z), r_y = plus(y, x * x + z * z), r_z = r + z;
    v_x += sign * std::log(r_y);
    v_y += sign * std::log(r_x);
    v_z -= sign * std::atan2(x * y, z * r);
    v_xx += sign * x / (r * r_y);
    v_yy += sign * y / (r * r_x);
    v_xy += sign / r;
    v_xz += sign * z / (r * r_y);
    v_yz += sign * z / (r * r_x);
    // atan(Y/X) - atan(z Y/(X r)), which is continuous at X = 0 while z > 0
    const double xyrz = x * y * (x * x + y * y) / r_z;
    c_xx += sign * std::atan2(xyrz, x * x * r + z * y * y);
    c_yy += sign * std::atan2(xyrz, y * y * r + z * x * x);
    c_xy += sign * std::log(r_z);
    c_xxy += sign * x / (r * r_z);
    c_xyy += sign * y / (r * r_z);
    p_xxy -= sign * x / r_z;
    p_xyy -= sign * y / r_z;
  }
};

} // namespace

Stress& Stress::add(double weight, const Stress& o) {
  xx += weight * o.xx;
  ss += weight * o.ss;
  nn += weight * o.nn;
  xs += weight * o.xs;
  xn += weight * o.xn;
  sn += weight * o.sn;
  return *this;
}

double von_mises(const Stress& t) {
  const double xs = t.xx - t.ss, sn = t.ss - t.nn, nx = t.nn - t.xx;
  return std::sqrt(0.5 * (xs * xs + sn * sn + nx * nx) + 3 * (t.xs * t.xs + t.xn * t.xn + t.sn * t.sn));
}

double largest_shear(const Stress& t) {
  Eigen::Matrix3d tensor;
  tensor << t.xx, t.xs, t.xn, t.xs, t.ss, t.sn, t.xn, t.sn, t.nn;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor, Eigen::EigenvaluesOnly);
  return 0.5 * (principal.eigenvalues()[2] - principal.eigenvalues()[0]);
}

std::array<Stress, 3> rectangle_stress(double poisson, double x, double s, double n, double a, double b) {
  require_size(2 * a, "length 2a");
  require_size(2 * b, "width 2b");
  if (!(std::isfinite(x) && std::isfinite(s) && std::isfinite(n) && n > 0))
    throw InputError("There is no stress below the surface at this point",
                     "(x, s, n) = (" + std::to_string(x) + ", " + std::to_string(s) + ", " +
                         std::to_string(n) + ")",
                     "Give finite coordinates and a depth above 0.");
  Potentials d;
  d.add_corner(1, x + a, s + b, n);
  d.add_corner(-1, x - a, s + b, n);
  d.add_corner(-1, x + a, s - b, n);
  d.add_corner(1, x - a, s - b, n);

  const double c = 1 / (2 * std::numbers::pi), nu = poisson, z = n;
  std::array<Stress, 3> stress;
  stress[component_n] = {c * (2 * nu * d.v_z - (1 - 2 * nu) * d.c_xx - z * d.v_xx),
                         c * (2 * nu * d.v_z - (1 - 2 * nu) * d.c_yy - z * d.v_yy),
                         c * (d.v_z - z * d.v_zz()),
                         c * (-(1 - 2 * nu) * d.c_xy - z * d.v_xy),
                         -c * z * d.v_xz,
                         -c * z * d.v_yz};
  stress[component_x] = {c * (2 * (1 + nu) * d.v_x + 2 * nu * d.p_xxx() - z * d.c_xxx()),
                         c * (2 * nu * (d.v_x + d.p_xyy) - z * d.c_xyy),
                         -c * z * d.v_xz,
                         c * (d.v_y + 2 * nu * d.p_xxy - z * d.c_xxy),
                         c * (d.v_z - z * d.v_xx),
                         -c * z * d.v_xy};
  stress[component_s] = {c * (2 * nu * (d.v_y + d.p_xxy) - z * d.c_xxy),
                         c * (2 * (1 + nu) * d.v_y + 2 * nu * d.p_yyy() - z * d.c_yyy()),
                         -c * z * d.v_yz,
                         c * (d.v_x + 2 * nu * d.p_xyy - z * d.c_xyy),
                         -c * z * d.v_xy,
                         c * (d.v_z - z * d.v_yy)};
  return stress;
}

} // namespace bem_contact::halfspace
