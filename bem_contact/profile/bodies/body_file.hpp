#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/base/material.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

enum class BodyKind { rail, wheel, block, disc, bore, outline };
template <> struct EnumNames<BodyKind> {
  static constexpr std::array<std::string_view, 6> names{"rail", "wheel", "block", "disc", "bore", "outline"};
};

/// What a piece of an own outline is: part of the contact surface, held, or neither.
enum class PieceGroup { contact, held, free };
template <> struct EnumNames<PieceGroup> {
  static constexpr std::array<std::string_view, 3> names{"contact", "held", "free"};
};

enum class HoleGroup { held, free };
template <> struct EnumNames<HoleGroup> {
  static constexpr std::array<std::string_view, 2> names{"held", "free"};
};

/// A body file (TOML): all that mesh_body and fem_influence need to know of one body. Both read the same
/// file. Keys and members have the same names: [strip] station_width is `strip.station_width`.
struct BodyFile {
  std::filesystem::path folder; ///< not a key: where a relative profile path starts

  /// A line or arc of an own outline; it begins where the piece before it ends, the first one at the end of
  /// the last. Arcs are at most half a circle.
  struct OutlinePiece {
    Point2 to;         ///< (y, z), mm
    double radius = 0; ///< 0: a line; > 0: convex, < 0: concave arc, mm
    PieceGroup group = PieceGroup::free;
  };
  struct Hole {
    Point2 centre;     ///< mm
    double radius = 1; ///< mm
    HoleGroup group = HoleGroup::free;
  };

  struct Body {
    BodyKind kind = BodyKind::rail;
    std::string profile = "60E1"; ///< a standard or a file; a wheel's default: S1002
    ProfileReading reading = {};  ///< how a profile file is read: keys smoothing, unit, profile_z, ...
    std::string graft_onto =
        {}; ///< of a profile from a file: the standard whose body it gets; "": 60E1 or S1002
    /// Where the origin of that standard lies in the file's frame, mm, and how the body is turned there, from
    /// +y towards +z, rad. If both are empty, they are found; if one is, it is zero.
    std::optional<Point2> graft_at = {};
    std::optional<double> graft_angle = {};
    std::string held = {};        ///< rail: foot | web, wheel: bore | rim, block: base | sides; "": the first
    double radius = 10;           ///< disc, bore: radius of the contact surface, mm
    double size = 100;            ///< block, bore: half width and depth of the block, mm
    std::string name = "outline"; ///< outline: name of the body and of its contact profile
    /// rail: 0: straight, else a roller's: of revolution about an axis so far below z = 0, mm
    double roller_radius = 0;
    /// outline: 0: prismatic, > 0: of revolution about an axis so far above z = 0, < 0: below it, mm
    double reference_radius = 0;
    std::vector<OutlinePiece> outline = {}; ///< walked with the material on the side of e_n (conventions.hpp)
    std::vector<Hole> holes = {};
  } body;
  Material material;   ///< [material] shear_modulus, poisson
  struct Strip {       ///< a wheel's default: 20 .. 50, tread and flange root
    double from = -45; ///< arc length on the profile, mm
    double to = -20;
    double station_width = 0.2; ///< mm; (to - from) / station_width must be whole
    int stations() const { return static_cast<int>(std::lround((to - from) / station_width)); }
  } strip;
  /// The error asked for, of the influence number itself. Keys of [mesh] and [harmonic] that a file does not
  /// give follow from it; the values below are those of 1e-3.
  double tolerance = 1e-3;
  struct Mesh {
    int elements_per_station = 1; ///< element edges per station on the strip
    double grading = 0.3;         ///< h <= h_strip + grading * distance from the strip
    double largest = 15;          ///< mm
  } mesh;
  struct Harmonic {
    int degree = 3;           ///< of the finite elements
    int border_levels = 4;    ///< how often elements at the borders of the stations are halved
    double half_period = 600; ///< L of the Fourier series, mm; a body of revolution uses pi times its radius
    double shortest_dx = 0.2; ///< shortest element length along x that the file must serve: k_max = 10/dx
    int samples_per_decade = 7; ///< wavenumbers per decade above the lowest harmonics
    double remote_distance =
        0; ///< the remote section lies between one and two times this from the strip; 0: automatic
  } harmonic;
  /// Stresses of the inside under unit loads, which an influence file may have beside its kernel.
  struct Stress {
    int depths = 0;      ///< how many; 0: none are computed
    double deepest = 15; ///< mm; the others get denser towards 1.5 stations
    double beyond = 5;   ///< so far beside the strip, mm
  } stress;
  struct Solid {
    double size = 2.5;         ///< element size on the strip of the 3-D mesh, before it is refined, mm
    double edge_angle = 15;    ///< edges of that mesh on an arc turn by at most so much, deg
    int degree = 2;            ///< of the finite elements
    double dx = 0;             ///< element length along x, mm; 0: the station width
    int offsets = 41;          ///< numbers at x = 0, dx, .. (offsets - 1) dx
    int elements_per_load = 8; ///< element edges along each side of the loaded element
    double grading = 0.3;      ///< h <= h_load + grading * distance from the loaded element
    int loads_at_once = 4;     ///< stations loaded on one refined mesh
  } solid;
};

/// Throws InputError (unknown key with the nearest names, wrong type, value out of range).
BodyFile read_body_file(const std::filesystem::path& file);
BodyFile parse_body_file(std::string_view toml, std::string_view source_name = "text");
/// What can be computed but is probably a mistake, in sentences: the strip of a rail or of a wheel that lies
/// wholly on the field side.
std::vector<std::string> body_warnings(const BodyFile& body);
/// Radius at which a wheel's angle is measured as a length: x = R_ref theta, r = R_ref + z, mm.
inline constexpr double wheel_reference_radius = 460.0;
/// R_ref, mm: a body of revolution has r = R_ref + z. Above 0: the axis lies above the contact (a wheel), and
/// r > 0. Below 0: it lies below (a roller), and r < 0. 0: a prismatic body.
double reference_radius_of(const BodyFile& body);
double half_period_of(const BodyFile& body); ///< L, mm; pi |R_ref| for bodies of revolution
/// Digest of all that a mesh depends on, [body], [strip], [mesh] and the digest of the profile curve: tells
/// the mesh of one body file from that of another. 16 hexadecimal digits.
std::string mesh_digest(const BodyFile& body, std::uint64_t profile_digest);
/// The whole schema with defaults, units, ranges and one line of documentation per key, as valid TOML.
std::string default_body_file();

} // namespace bem_contact
