#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/record/record.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::inside {

/// Which of the two bodies of a contact. Of a patch given directly, `rail` is the lower one.
enum class Side { rail, wheel };

} // namespace bem_contact::inside

template <> struct bem_contact::EnumNames<bem_contact::inside::Side> {
  static constexpr std::array<std::string_view, 2> names{"rail", "wheel"};
};

namespace bem_contact::inside {

/// Tractions on the surface of one body, constant on each element, in the body's own frame (x, s, n) with n
/// into it (base/conventions.hpp); MPa.
struct SurfaceTractions {
  double dx = 0, ds = 0; ///< of an element, mm
  double x0 = 0;         ///< middle of the first column, mm
  int columns = 0;
  std::vector<double> s = {};                    ///< middle of the rows on the body's profile, mm, rising
  std::vector<double> px = {}, ps = {}, pn = {}; ///< [row][column]
  double poisson = 0.28;                         ///< of the body

  int rows() const { return static_cast<int>(s.size()); }
  double x(int column) const { return x0 + column * dx; } ///< mm; also beside the grid
  std::array<double, 3> at(std::size_t element) const { return {px[element], ps[element], pn[element]}; }
  bool has_shear() const;
  /// Sum of the tractions along x, s and n over the elements, N.
  std::array<double, 3> force() const;
};

/// The elements in contact (p_n > 0) of each patch (8 neighbours), the largest force first.
std::vector<std::vector<int>> loaded_patches(const SurfaceTractions& tractions);

/// Those on the upper body (wheel), from those on the lower one (rail). The wheel's own frame is the contact
/// frame turned by pi about x, and the tractions have the other sign: (-p_x, p_s, p_n) from the last row to
/// the first. Rows are as wide as on the rail, about the middle of each area: the two differ by the distance
/// of the bodies over their radii. `wheel_s`: arc length of each row of the rail on the wheel's profile, mm;
/// nan where there is none. Throws InputError where a row in contact has none.
SurfaceTractions on_upper_body(const SurfaceTractions& rail, std::span<const double> wheel_s, double poisson);

/// The tractions that a result file (bem_contact solve -o) has on one of its bodies. Throws InputError for
/// what is no certified result, and for one in plane strain.
SurfaceTractions read_tractions(const record::Record& result, Side side);

/// The body of that result with this profile (ProfileCurve::digest()). Of a patch given directly, the lower
/// one. Throws InputError if it is neither.
Side side_of(const record::Record& result, std::uint64_t profile_digest);

/// The largest pressure's error over it as the result states it; 0: not known.
double traction_error(const record::Record& result);

} // namespace bem_contact::inside
