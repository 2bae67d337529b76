#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "fem_influence/harmonic/harmonic_system.hpp"

namespace bem_contact::fem::test {

/// lay_out() and fill() in one.
inline SectionOperator assemble(const Section& section, const Material& material, double reference_radius) {
  SectionOperator op = lay_out(section, material, reference_radius);
  fill(op, section, reference_radius);
  return op;
}

/// lay_out_system() and fill() in one.
inline HarmonicSystem assemble_system(const Section& section, const BodyFile& body,
                                      const ProfileCurve& curve) {
  HarmonicSystem system = lay_out_system(section, body, curve);
  fill(system.op, section, reference_radius_of(body));
  return system;
}

} // namespace bem_contact::fem::test
