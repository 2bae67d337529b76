#pragma once

#include "bem_contact/halfspace/line_store.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/influence_numbers.hpp"
#include "bem_contact/influence/series_points.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/numbers/section_blend.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace bem_contact {

/// Everything that the influence numbers of a pair depend on. If two of these are equal, so are the numbers.
struct NumbersSource {
  Model model{};
  Body rail, wheel;
  int columns = 0, rows = 0;
  double dx = 0, ds = 0;               ///< mm; dx 0: plane strain
  double reference_distance = 0;       ///< of plane strain, mm
  std::vector<double> rail_s, wheel_s; ///< stations of the rows where influence functions are taken, mm
  SectionBlend blend = {};             ///< of a rail of sections
  double contact_radius = 0;           ///< of the wheel, mm
  double roller_contact_radius = 0;    ///< of the rail, mm; 0: straight
  /// This is the inclination of the rows against the wheel's axle, rad, where the wheel's radial displacement
  /// is added.
  std::vector<double> inclination;

  bool operator==(const NumbersSource&) const = default;
};

/// What one body's influence numbers depend on besides rows and offsets, if they come from its file.
struct BodyNumbersSource {
  std::shared_ptr<const InfluenceFile> file;
  StructuralCompliance structural = StructuralCompliance::removed;
  double dx = 0, ds = 0; ///< mm; dx 0: plane strain

  bool operator==(const BodyNumbersSource&) const = default;
};

/// The rail's numbers from its influence file. Rows of a wheel on a rail lie on the same stations of the rail
/// (origin + whole multiples of ds, GridPlan) in all cases with this ds, while the wheel's rows lie elsewhere
/// in each. So the rail's numbers serve every case whose rows are among those of an earlier one.
class RailNumbersStore {
public:
  /// Returns the numbers of rows at `row_s`, from `compute` unless they are part of what is kept. They are
  /// the caller's.
  InfluenceNumbers get(const BodyNumbersSource& source, const std::vector<double>& row_s, int offsets,
                       const std::function<InfluenceNumbers()>& compute);

private:
  struct Kept {
    BodyNumbersSource source;
    std::vector<double> row_s;
    InfluenceNumbers numbers;
  };
  std::deque<Kept> kept_; ///< made last: in front
};

/// Parts of influence numbers that several cases share.
struct NumbersParts {
  RailNumbersStore rail;
  halfspace::LineStore lines;
  SeriesStore series;
};

/// The pair's influence numbers on the grids met last.
class NumbersStore {
public:
  /// The numbers of `source`: those that are kept, or else new ones from `compute`. The caller owns them
  /// until it gives them back with keep().
  InfluenceNumbers take(const NumbersSource& source, const std::function<InfluenceNumbers()>& compute);
  void keep(const NumbersSource& source, InfluenceNumbers numbers);

  NumbersParts& parts() { return parts_; }
  int found() const { return found_; } ///< how often they were kept

private:
  int found_ = 0;
  std::deque<std::pair<NumbersSource, InfluenceNumbers>> kept_; ///< used last: in front
  NumbersParts parts_;
};

} // namespace bem_contact
