#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/material.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/profile/contact_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact {

/// The body is the same all along x (a rail), or all around its axle (a wheel).
enum class Invariance { prismatic, revolution };

/// What is done about the body's motion as a whole (the deflection of its support, web and foot or hub).
///   included: the body is held as the file says (`held`), all compliance counts;
///   removed:  every section's remote part (`remote`) has no mean displacement and no mean rotation.
enum class StructuralCompliance { removed, included };

/// One station: an element of the contact strip, `station_width` long along s, infinitely long along x. Its
/// centre in the frame of the body's section.
using Station = ContactRow;

/// What an influence function says beside its numbers: of which body it is, and how good it is.
struct InfluenceDescription {
  std::string body;    ///< name of the body, e.g. "rail 60E1"
  std::string profile; ///< name of the profile curve
  std::uint64_t profile_digest = 0;
  Material material;
  std::string held;   ///< how the body is held, in words
  std::string method; ///< "harmonic" or "solid3d", with degree and mesh in words
  Invariance invariance = Invariance::prismatic;
  /// R_ref, mm (revolution only): z of a point of the section is r - R_ref. Above 0: the axis lies above the
  /// contact (a wheel). Below 0: it lies below (a roller), and r is below 0 too.
  double reference_radius = 0;
  double half_period = 0;   ///< L, mm: the series has the multiples of pi / L (revolution: L = pi |R_ref|)
  double station_width = 0; ///< ds, mm
  double table_dx = 0;      ///< mm, element length of the table; 0: the function is given by its kernel

  /// Radius of a body of revolution at a point of its section, mm.
  double radius_at(Point2 p) const { return std::abs(reference_radius + p.z); }

  /// What the file says of its own error: the largest that was found. The first and the last are relative to
  /// self numbers, the second to the load.
  double betti_error = 0;    ///< asymmetry as computed; what is stored is symmetric
  double reaction_error = 0; ///< | reaction - load | / load at k = 0
  double estimated_error =
      0; ///< from the wavenumber sampling and a coarser companion run; < 0: not estimated
};

/// Stations first .. first + count - 1 of a strip.
struct StationRange {
  int first = 0, count = 0;

  int end() const { return first + count; }
  bool operator==(const StationRange&) const = default;
};

/// What an influence function has beside its kernel or table: the stations of its strip, and how the body
/// moves as a whole. It is small; the kernel of a whole running surface has 200 MB.
///
/// The remote section is the part of the section that lies far from the strip. It has six generalised
/// displacements (area means: u_x, u_y, u_z in mm, rotations about x, y, z in rad; data/INFLUENCE_FORMAT.md).
/// For each wavenumber, by its index,
///   remote[NK][6][3 NS]     has them under each load of 1 MPa on a station (mm/MPa, 1/MPa);
///   remote_self[NK][6][6]   has them under station_width times each unit generalised load on the remote
///                           section itself (mm/MPa, and per mm for each rotation).
/// A function that is given by a table has no wavenumbers.
struct InfluenceStrip : InfluenceDescription {
  std::vector<Station> stations = {}; ///< NS of them, equally spaced, ascending in s

  std::vector<double> wavenumber = {};  ///< NK values, 1/mm, ascending, the first is 0
  std::vector<double> remote = {};      ///< NK x 6 x 3NS
  std::vector<double> remote_self = {}; ///< NK x 6 x 6

  std::size_t station_count() const { return stations.size(); }
  std::size_t wavenumber_count() const { return wavenumber.size(); }
  bool is_table() const { return table_dx > 0; }
  StationRange all_stations() const { return {0, static_cast<int>(stations.size())}; }

  /// Returns both ends of the strip, arc length in mm.
  std::pair<double, double> ends() const {
    return {stations.front().s - 0.5 * station_width, stations.back().s + 0.5 * station_width};
  }
  /// The one whose centre is nearest to the arc length s, mm.
  const Station& nearest_station(double s) const {
    const double index = (s - stations.front().s) / station_width;
    return stations[static_cast<std::size_t>(
        std::lround(std::clamp(index, 0.0, static_cast<double>(stations.size() - 1))))];
  }
};

/// The influence function of one body: the kernel g_ij(k; s_I, s_J).
///
/// A traction of component j on station J with amplitude 1 MPa, varying along x as cos(kx), gives the
/// displacement i of station I, averaged over its width. The list below says how this varies along x.
/// Frame: the body's own (x, s, n), n into the body, turned to the inclination of each station.
///
/// `kernel` has a symmetric matrix for each wavenumber k. Its number at (row, column) = (3 I + i, 3 J + j) is
/// g_ij, in mm/MPa. Only the lower triangle is kept, by rows; the wavenumbers of a number lie one after the
/// other, for they are what is worked on together:
///   load p_j cos kx, j in {s, n}:  u_x = g_xj sin kx,  u_i = g_ij cos kx  (i in {s, n});
///   load p_x cos kx:               u_x = g_xx cos kx,  u_i = -g_ix sin kx (i in {s, n}).
/// On a body of revolution x = R_ref theta, k = harmonic / R_ref, and the unit load is 1 MPa per REFERENCE
/// area (R_ref dtheta ds): that is what keeps Maxwell-Betti exact without weights.
/// `removed` is g - remote^T remote_self^-1 remote, again symmetric and positive.
struct InfluenceFunction : InfluenceStrip {
  std::vector<double> kernel = {}; ///< 3NS (3NS + 1) / 2 x NK

  /// Instead of the kernel, its wavenumbers and the remote section: influence numbers of elements table_dx
  /// long at x = 0, table_dx, .., all compliance included. table[m][3 I + i][3 J + j] as
  /// InfluenceNumbers::values, Maxwell-Betti to the last bit; on a body of revolution x and the unit load are
  /// those of the reference radius.
  std::vector<double> table = {};

  std::size_t table_offsets() const { return table.size() / (9 * stations.size() * stations.size()); }

  /// Numbers of the kernel for one wavenumber.
  std::size_t kernel_size() const { return lower_size(3 * stations.size()); }
  /// Where g of the row and column for wavenumber[k] is, or, the same, of column and row.
  std::size_t kernel_index(std::size_t k, std::size_t row, std::size_t column) const {
    return (lower_size(std::max(row, column)) + std::min(row, column)) * wavenumber_count() + k;
  }
};

/// Returns the same body without stations, wavenumbers and numbers, to be filled with others.
inline InfluenceFunction without_numbers(const InfluenceDescription& description) {
  return {{description}};
}

/// Returns the same strip with these stations alone.
InfluenceStrip part_of(const InfluenceStrip& strip, StationRange range);

/// Throws InputError unless sizes agree, all numbers are finite, and stations and wavenumbers ascend.
void validate(const InfluenceStrip& strip);
/// Throws it unless the kernel's diagonal is positive, too, or a table's, which must be reciprocal as well.
void validate(const InfluenceFunction& function);

} // namespace bem_contact
