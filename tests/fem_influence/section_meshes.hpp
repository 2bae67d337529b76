#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::fem::test {

/// A folder of this test's own, removed with it.
class Folder {
public:
  Folder();
  ~Folder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

void write_text(const std::filesystem::path& file, const std::string& text);

/// 0 .. inner in steps h, then on to `outer` in steps growing by `ratio`.
std::vector<double> graded(double h, double inner, double outer, double ratio);

/// y from -size to size, depth from 0 to size; fine squares h on |y| <= strip_half. Held below and at the
/// sides. up: the material lies at z < 0 and the surface z = 0 is walked towards -y (a wheel's tread).
void write_block_mesh(const std::filesystem::path& file, double h, double strip_half, double size,
                      bool up = false, double ratio = 1.4);

/// Rings between radius (contact) and end_radius (held; smaller: a disc, larger: a bore), `around` edges.
void write_ring_mesh(const std::filesystem::path& file, double radius, double end_radius, int around);

/// Half of a body in hexahedra between these lines, mm: the mirror plane at the first x, the contact at the
/// first z, held at the last.
struct Hexahedra {
  std::vector<double> x, y, z;
  int contact = 1;                                                    ///< number of the top's group
  int sides = 3;                                                      ///< and of the sides across y
  bool tetrahedron = false;                                           ///< adds one
  std::function<double(double x)> wider = [](double) { return 1.0; }; ///< 1, of y
};
/// MSH 2.2.
void write_hexahedra(const std::filesystem::path& file, const Hexahedra& mesh);

ProfileCurve straight_line(double half, bool up = false);
/// A full circle, s = 0 at (0, radius), s from -pi R to pi R; hole: walked as a bore, else as a disc.
ProfileCurve full_circle(double radius, bool hole);

} // namespace bem_contact::fem::test
