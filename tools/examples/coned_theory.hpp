#pragma once

// What textbooks say about the coned wheelset of wheelset_running.cpp: linear_model.py in C++. Units mm, N,
// s, rad.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

inline constexpr double pi = std::numbers::pi;

inline constexpr double mass = 1.25, yaw_inertia = 7e5; ///< N s^2/mm, N mm s^2
inline constexpr double weight = 1e5;                   ///< N, of the wheelset and what it carries
inline constexpr double radius = 460;                   ///< mm, at the tape circle

/// Between frame and wheelset, N/mm and N mm/rad.
struct Springs {
  double lateral = 200, yaw = 4e8;
};

/// A cone touches the rail's head where that has the cone's slope.
struct ConedPair {
  double slope = 1.0 / 40, head_radius = 300, rail = 750; ///< mm

  double half_distance() const { return rail - head_radius * std::sin(slope); } ///< of the contacts
  double rolling_radius() const { return radius + slope * (rail - half_distance()); }
  double conicity() const { // Wickens 2003, section 2.2
    const double b = half_distance();
    return slope * (b + head_radius * slope) / (b - rolling_radius() * slope);
  }
  double klingel() const { return 2 * pi * std::sqrt(half_distance() * rolling_radius() / slope); } ///< mm
};

/// y is the real part of exp((growth + i frequency) t), in 1/s, and psi = yaw times that.
struct Oscillation {
  double growth = 0, frequency = 0;
  std::complex<double> yaw = {};

  /// y, psi, dy/dt and dpsi/dt at the time 0.
  std::array<double, 4> start(double amplitude) const {
    const std::complex<double> rate(growth, frequency);
    return {amplitude, amplitude * yaw.real(), amplitude * growth, amplitude * (rate * yaw).real()};
  }
};

/// The motion of the linear model that is damped least. The ellipse has the semi-axes of Hertz for 50 kN
/// (5.710 and 4.294 mm), the coefficients are those of bem_contact/reference/creep_coefficients.hpp for it.
inline Oscillation least_damped(double speed, Springs springs) {
  using Complex = std::complex<double>;
  const ConedPair pair;
  const double b = pair.half_distance(), r = pair.rolling_radius(), conicity = pair.conicity();
  const double shear_modulus = 82000, c = std::sqrt(5.71015 * 4.29412);
  const double f11 = shear_modulus * c * c * 4.5458, f22 = shear_modulus * c * c * 4.1367,
               f23 = shear_modulus * c * c * c * 1.8588, f33 = shear_modulus * c * c * c * c * 0.9916;
  const double at_rail = 1 + r * conicity / b; // the wheelset rolls about its centre as it moves
  // Rows of D(s) (y, psi) = 0: the lateral force and the moment about the vertical.
  const auto matrix = [&](Complex s) {
    return std::array{mass * s * s + 2 * f22 * at_rail / speed * s + springs.lateral + weight * conicity / b,
                      -2 * f22 + 2 * f23 / speed * s,
                      2 * f11 * b * conicity / r - 2 * f23 * at_rail / speed * s,
                      yaw_inertia * s * s + 2 * (f11 * b * b + f33) / speed * s + springs.yaw + 2 * f23};
  };
  const auto determinant = [&](Complex s) {
    const auto d = matrix(s);
    return d[0] * d[3] - d[1] * d[2];
  };
  Complex s(0, 2 * pi * speed / pair.klingel());
  for (int i = 0; i < 50; ++i) {
    const Complex h = 1e-6 * s;
    s -= determinant(s) * 2.0 * h / (determinant(s + h) - determinant(s - h));
  }
  const auto d = matrix(s);
  return {s.real(), s.imag(), -d[0] / d[1]};
}

/// mm/s, above which small motions grow.
inline double critical_speed(Springs springs) {
  double below = 1e4, above = 3e5;
  while (above - below > 1) {
    const double middle = 0.5 * (below + above);
    (least_damped(middle, springs).growth < 0 ? below : above) = middle;
  }
  return below;
}
