#pragma once

namespace bem_contact {

/// Isotropic linear elastic material.
struct Material {
  double shear_modulus = 82000.0; ///< G, MPa
  double poisson = 0.28;          ///< nu, in [0, 0.5)

  /// Young's modulus, MPa.
  constexpr double young() const { return 2.0 * shear_modulus * (1.0 + poisson); }
  bool operator==(const Material&) const = default;
};

/// 1 / E* of two bodies in contact: (1 - nu) / 2G of both together, 1/MPa (Johnson 1985, eq. 4.20).
constexpr double contact_compliance(const Material& one, const Material& other) {
  return (1 - one.poisson) / (2 * one.shear_modulus) + (1 - other.poisson) / (2 * other.shear_modulus);
}
/// G of two equal bodies with the same sum of 1/G, MPa (Kalker 1990, section 1.4).
constexpr double shear_modulus_of_pair(const Material& one, const Material& other) {
  return 2 / (1 / one.shear_modulus + 1 / other.shear_modulus);
}

} // namespace bem_contact
