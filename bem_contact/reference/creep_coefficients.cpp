#include "bem_contact/reference/creep_coefficients.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

// The linear theory of Kalker 1967 ("On the Rolling Contact of Two Elastic Bodies in the Presence of Dry
// Friction", Delft, chapter 4): no slip anywhere, so that the displacement differs from the rigid one by a
// function of s alone, and no infinite traction at the leading edge, which determines that function.
//
// Galin's theorem: a traction P / sqrt(1 - x^2/a^2 - s^2/b^2), P a polynomial of degree M in (x, s),
// displaces the ellipse by polynomials of degree M. In polar coordinates about a point the 1/R of the
// half-space's displacement cancels; along a chord the integral is one of Gauss and Chebyshev, exact, and
// over the directions of the chords it is periodic and smooth. The conditions within the ellipse are met
// exactly, those at the leading edge (the numerators vanish there) in the mean square over the eccentric
// angle.
namespace bem_contact::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 1. Directions of the chords in the creep coefficients, per ratio of the long to the short axis. The
/// integrand has its nearest pole about one over that ratio off the real axis; 20 give all digits.
constexpr double directions_per_aspect = 20.0;
/// 1. Points of the leading edge at which the creep coefficients ask for finite tractions, per degree of the
/// polynomials plus 1. Chosen: enough for a mean square over the edge.
constexpr int edge_points_per_degree = 8;

using std::numbers::pi;

/// Monomials x^i s^j of the coordinates over the semi-axes, i + j <= degree.
struct Monomials {
  int degree;

  Eigen::Index size() const { return (degree + 1) * (degree + 2) / 2; }

  template <class Use> void visit(const Use& use) const { // use(index, i, j)
    for (int i = 0, k = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        use(k++, i, j);
  }

  void add(double x, double s, VectorXd& sum) const {
    double of_x = 1;
    for (int i = 0, k = 0; i <= degree; ++i, of_x *= x) {
      double value = of_x;
      for (int j = 0; i + j <= degree; ++j, value *= s)
        sum[k++] += value;
    }
  }

  /// Integrals of x^(i + more_x) s^(j + more_s) / sqrt(1 - x^2 - s^2) over the unit disc: half of those over
  /// the unit sphere.
  VectorXd integrals(int more_x, int more_s) const {
    VectorXd sums = VectorXd::Zero(size());
    visit([&](int k, int i, int j) {
      const int m = i + more_x, n = j + more_s;
      if (m % 2 == 0 && n % 2 == 0)
        sums[k] = std::sqrt(pi) * std::tgamma(0.5 * (m + 1)) * std::tgamma(0.5 * (n + 1)) /
                  std::tgamma(0.5 * (m + n + 3));
    });
    return sums;
  }
};

/// Points on which a polynomial of that degree vanishes only if it is zero. Shape [points][2].
MatrixXd points_of_disc(int degree) {
  const int rings = degree / 2 + 1, angles = 2 * degree + 1;
  MatrixXd points(rings * angles, 2);
  for (int k = 0; k < rings; ++k)
    for (int l = 0; l < angles; ++l) {
      const double r = std::cos(0.5 * pi * k / rings), angle = 2 * pi * l / angles;
      points.row(k * angles + l) << r * std::cos(angle), r * std::sin(angle);
    }
  return points;
}

/// Displacements (u_x of all points, then u_s) under each of the tractions (p_x, then p_s), G = 1, a pair of
/// equal bodies: 1/pi times (1 - nu + nu cos^2, 1 - nu + nu sin^2; nu sin cos) / R (Cerruti; Johnson 1985,
/// eq. 3.75).
MatrixXd displacements(const MatrixXd& points, const Monomials& basis, double a, double b, double poisson) {
  const Eigen::Index count = points.rows(), n = basis.size();
  const int on_chord = basis.degree / 2 + 1; // exact to degree 2 on_chord - 1
  // The integrand's nearest pole lies atanh(min/max of the semi-axes) off the real axis of the angle.
  const int directions = 2 * basis.degree + static_cast<int>(directions_per_aspect * std::max(a / b, b / a));
  MatrixXd u = MatrixXd::Zero(2 * count, 2 * n);
  VectorXd sum(n);
  for (Eigen::Index point = 0; point < count; ++point) {
    const double x = points(point, 0), s = points(point, 1), outside = x * x + s * s - 1;
    for (int d = 0; d < directions; ++d) {
      const double c = std::cos(pi * (d + 0.5) / directions), t = std::sin(pi * (d + 0.5) / directions);
      const double along_x = c / a, along_s = t / b, square = along_x * along_x + along_s * along_s;
      const double middle = -(x * along_x + s * along_s) / square;
      const double half = std::sqrt(std::max(0.0, middle * middle - outside / square));
      sum.setZero();
      for (int k = 0; k < on_chord; ++k) {
        const double r = middle + half * std::cos(pi * (k + 0.5) / on_chord);
        basis.add(x + r * along_x, s + r * along_s, sum);
      }
      sum *= pi / directions / on_chord / std::sqrt(square);
      u.row(point).head(n) += (1 - poisson + poisson * c * c) * sum;
      u.row(point).tail(n) += poisson * c * t * sum;
      u.row(count + point).tail(n) += (1 - poisson + poisson * t * t) * sum;
    }
    u.row(count + point).head(n) = u.row(point).tail(n);
  }
  return u;
}

/// The tractions' numerators at points of the leading edge: [p_x of all, p_s of all] under each polynomial.
MatrixXd leading_edge(const Monomials& basis) {
  const Eigen::Index n = basis.size(), count = edge_points_per_degree * (basis.degree + 1);
  MatrixXd numerators = MatrixXd::Zero(2 * count, 2 * n);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = pi * ((static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5);
    VectorXd values = VectorXd::Zero(n);
    basis.add(std::cos(angle), std::sin(angle), values);
    numerators.row(i).head(n) = numerators.row(count + i).tail(n) = values;
  }
  return numerators;
}

void require_table(double a_over_b, double poisson, int degree) {
  if (!(a_over_b >= 0.1 && a_over_b <= 10 && poisson >= 0 && poisson <= 0.5 && degree >= 2 && degree <= 20))
    throw InputError("No creep coefficients of such an ellipse",
                     "a/b is " + std::to_string(a_over_b) + ", Poisson's ratio " + std::to_string(poisson) +
                         ", the degree " + std::to_string(degree),
                     "Give a/b of .1 to 10, a ratio of 0 to .5 and a degree of 2 to 20.");
}

constexpr int degrees_of_ratio = 8, degrees_of_poisson = 3;
/// 1. ln C11, ln C22, ln C23 = sum of these times T_i(log10 a/b) T_j(4 nu - 1): least squares over 24 x 7
/// Chebyshev points of creep_coefficients() at degree 12. CreepCoefficients.QuickOnesAgreeWithThem compares
/// them elsewhere.
constexpr double chebyshev_of_logarithms[3][(degrees_of_ratio + 1) * (degrees_of_poisson + 1)] = {
    {1.64488,      0.211707,    0.0128767,    0.00116058,   0.604611,     -0.127137,
     -0.0130625,   -0.00147288, 0.210142,     -0.00177298,  0.00158597,   0.000346719,
     0.0186012,    0.0102631,   0.00103498,   8.50892e-05,  -0.00896933,  -0.000525659,
     -0.000325448, -6.5658e-05, -0.0012839,   -0.00108196,  -8.61562e-05, 7.04868e-07,
     0.000733472,  0.000137059, 4.93438e-05,  9.14248e-06,  9.57137e-05,  0.00010943,
     5.47394e-06,  -1.5706e-06, -6.78937e-05, -2.34328e-05, -6.498e-06,   -1.03808e-06},
    {1.53413,      0.0920165,    0.00301285,   0.0001265,    0.820062,     0.105373,
     0.00568029,   0.000399528,  0.223105,     0.0114921,    0.00172431,   0.000143136,
     0.0017752,    -0.00774509,  -0.000222061, 7.69015e-06,  -0.00944412,  -0.000877801,
     -0.000149718, -2.78104e-06, 0.000506648,  0.00080156,   2.53342e-06,  -5.82675e-06,
     0.000670662,  4.534e-05,    1.18764e-05,  -6.95411e-07, -8.34881e-05, -7.34397e-05,
     4.26049e-06,  1.48548e-06,  -4.88085e-05, -1.3134e-07,  -1.30128e-06, 4.03668e-08},
    {0.697056,     0.202072,     0.0106637,    0.000867199, 1.70909,      -0.0807096,
     -0.00709953,  -0.000859308, 0.295759,     0.0933052,   0.00618683,   0.000638203,
     -0.00121106,  -0.0174221,   0.000528675,  1.62744e-06, -0.0147814,   -0.0077665,
     -0.00146224,  -7.91389e-05, 0.00195019,   0.00345535,  0.000381122,  8.58458e-06,
     0.000950877,  0.000405451,  0.000114634,  1.64687e-05, -0.000314351, -0.000482225,
     -8.90676e-05, -7.89532e-06, -3.80171e-05, 2.43018e-05, 4.82247e-06,  -9.70798e-07}};

} // namespace

std::array<double, 3> quick_creep_coefficients(double a_over_b, double poisson) {
  require_table(a_over_b, poisson, 2);
  const auto chebyshev = [](double at, auto& values) {
    values[0] = 1, values[1] = at;
    for (std::size_t i = 2; i < values.size(); ++i)
      values[i] = 2 * at * values[i - 1] - values[i - 2];
  };
  std::array<double, degrees_of_ratio + 1> of_ratio;
  std::array<double, degrees_of_poisson + 1> of_poisson;
  chebyshev(std::log10(a_over_b), of_ratio);
  chebyshev(4 * poisson - 1, of_poisson);
  std::array<double, 3> out;
  for (std::size_t k = 0; k < out.size(); ++k) {
    double logarithm = 0;
    const double* c = chebyshev_of_logarithms[k];
    for (const double r : of_ratio)
      for (const double p : of_poisson)
        logarithm += *c++ * r * p;
    out[k] = std::exp(logarithm);
  }
  return out;
}

CreepCoefficients creep_coefficients(double a_over_b, double poisson, int degree) {
  require_table(a_over_b, poisson, degree);
  const double a = std::sqrt(a_over_b), b = 1 / a; // c = 1
  const Monomials basis{degree};
  const Eigen::Index n = basis.size(), free = degree + 1;
  const MatrixXd points = points_of_disc(degree);
  const Eigen::Index count = points.rows();

  // A p = -(rigid + function of s): the rigid displacement of xi, eta and phi, then s^k in u_x, in u_s
  MatrixXd known = MatrixXd::Zero(2 * count, 3 + 2 * free);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = a * points(i, 0), s = b * points(i, 1);
    known(i, 0) = known(count + i, 1) = x;
    known(i, 2) = -x * s;
    known(count + i, 2) = 0.5 * x * x;
    for (Eigen::Index k = 0; k < free; ++k)
      known(i, 3 + k) = known(count + i, 3 + free + k) = std::pow(points(i, 1), static_cast<int>(k));
  }
  const MatrixXd responses =
      displacements(points, basis, a, b, poisson).colPivHouseholderQr().solve(-known); // [2 n][3 + 2 free]

  const MatrixXd edge = leading_edge(basis) * responses;
  const MatrixXd chosen = edge.rightCols(2 * free).colPivHouseholderQr().solve(-edge.leftCols(3));
  const MatrixXd p = responses.leftCols(3) + responses.rightCols(2 * free) * chosen;

  const VectorXd area = basis.integrals(0, 0), first_x = a * basis.integrals(1, 0),
                 first_s = b * basis.integrals(0, 1);
  const auto moment = [&](int i) { return first_x.dot(p.col(i).tail(n)) - first_s.dot(p.col(i).head(n)); };
  return {a_over_b,
          poisson,
          area.dot(p.col(0).head(n)),
          area.dot(p.col(1).tail(n)),
          0.5 * (area.dot(p.col(2).tail(n)) - moment(1)),
          moment(2)};
}

} // namespace bem_contact::reference
