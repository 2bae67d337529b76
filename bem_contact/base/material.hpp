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

} // namespace bem_contact
