#pragma once

#include "bem_contact/base/measured.hpp"
#include "bem_contact/inside/section.hpp"
#include "bem_contact/record/column.hpp"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Stresses inside a body while a contact passes: what they are, their peaks, and their files.
namespace bem_contact::inside {

using Passage = std::vector<halfspace::Stress>; ///< one stress for each place along x

/// Stresses below one patch, or at points of one's own.
struct AreaStresses {
  std::vector<BelowSurface> points;
  std::vector<Point2> positions; ///< of the points in the frame of the body's profile, mm; empty: not known
  std::size_t rows = 0, depths = 0; ///< rows x depths points, depth fastest; 0: points of one's own
  std::vector<double> x;            ///< places along x (of a wheel: along the surface), mm, rising
  std::vector<Passage> flat; ///< of the half-space: [point][place], frame (x, s, n), MPa, tension positive
  /// Of the body; empty: not computed. nan where the body is not there.
  std::vector<Passage> body;
  std::vector<double> error;      ///< of each point: von Mises' stress of what the body's may be off, MPa
  std::optional<Section> section; ///< of a patch
  double pmax = 0;                ///< MPa
  double curvature = 0;           ///< of the body's surface, mean over the patch, 1/mm; above 0 convex

  const std::vector<Passage>& best() const { return body.empty() ? flat : body; }
};

/// What one contact does to the inside of one body.
struct StressesInside {
  Side side = Side::rail;
  std::string body; ///< its name; "": the half-space alone
  double poisson = 0.28;
  double traction_error = 0;                 ///< 1, of the largest pressure over it; 0: not known
  std::size_t unknowns = 0, wavenumbers = 0; ///< of the body's solution
  std::vector<AreaStresses> areas; ///< one for each patch, the largest force first; or one of one's own
  std::size_t too_small = 0;       ///< patches with fewer than four rows or columns, which have none
};

/// Points below each patch of at least four rows and columns, with the stresses of the half-space; or these
/// points, if there is contact.
StressesInside halfspace_inside(const SurfaceTractions& tractions, Side side,
                                std::span<const BelowSurface> own = {});

/// Whether a patch has fewer than four rows or columns: too few for stresses worth looking at.
bool is_too_small(std::span<const int> elements, int columns);

/// Points of one's own: a CSV file with the columns s and depth (mm). Throws InputError.
std::vector<BelowSurface> read_points_below(const std::filesystem::path& file);

/// A largest value, with its error, and where it is. Depth and s in mm.
struct Peak {
  Measured value;
  double x = 0;
  BelowSurface at;
};

/// The largest of a measure over points and places. The error has what the body's stresses are off there,
/// what the tractions are off, and what lies between the points.
Peak peak_of(const StressesInside& inside, const AreaStresses& area, const std::vector<Passage>& stresses,
             const std::function<double(const halfspace::Stress&)>& measure);

/// The numbers of one area.
struct AreaPeaks {
  double s = 0, pmax = 0;              ///< middle of the points, mm; MPa
  Peak shear, von_mises;               ///< of the body, or of the half-space where there is none
  double mean = 0;                     ///< hydrostatic stress where von Mises' is largest, MPa
  double tension = 0, compression = 0; ///< largest and least principal stress, MPa
  Peak flat_shear, flat_von_mises;     ///< of the half-space

  /// By how much the half-space is below the body, over the half-space; nan: no body.
  double shear_change = unknown_error, von_mises_change = unknown_error;
};
AreaPeaks peaks_of(const StressesInside& inside, const AreaStresses& area);
std::span<const ColumnOf<AreaPeaks>> peak_columns();

/// One sentence for each area.
std::string in_words(const StressesInside& inside, const AreaStresses& area);

/// What every door says: `patches`, and `sections/1` ... with the tensors over points and places.
record::Record record_of(const StressesInside& inside);
/// The same back from a file. Throws InputError for another kind of file, or one with parts missing.
StressesInside stresses_from(const record::Record& file);

/// One line for each point and place.
void write_csv(std::ostream& out, const StressesInside& inside);
/// Cells between the points of all sections for ParaView (VTK XML UnstructuredGrid, ASCII), in the frame of
/// the body's profile where it is known, else unrolled: x, s, depth.
void write_vtu(std::ostream& out, const StressesInside& inside);

} // namespace bem_contact::inside
