#pragma once

#include "bem_contact/geometry/placement.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The rail as a height over y, as it is seen from above: where several parts of it lie at the same y, the
/// upper one counts. So what stands behind a vertical or overhanging wall is seen too: the keeper of a
/// grooved rail, the stock rail beside a blade. Undersides are not seen.
class RailHeight {
public:
  explicit RailHeight(const WheelOnRail& pair);

  double from() const { return seen_.front().from; } ///< y of its ends, mm
  double to() const { return seen_.back().to; }

  struct Height {
    double z = 0, s = 0; ///< track frame; arc length on the rail, mm
  };
  /// Returns the height at y, nothing beyond the ends of the rail. `near`: the interval where the search
  /// starts and, afterwards, where it ended.
  std::optional<Height> at(double y, int& near) const;

private:
  /// Nodes from `first` to `last`, between which y grows, and where it is they that are seen.
  struct Stretch {
    int first = 0, last = 0;
    double from = 0, to = 0; ///< y, mm
  };
  std::vector<Stretch> rising_stretches() const;
  void keep_upper(const std::vector<Stretch>& rising);
  double rough_height(const Stretch& stretch, double y) const;
  Height on(const Stretch& stretch, double y, int& near) const;

  TabulatedProfile rail_;
  Point2 origin_;
  Turn turn_;                 ///< of the rail's section into the track frame, as its pose has it
  std::vector<Point2> nodes_; ///< track frame
  std::vector<Stretch> seen_; ///< by rising y; they do not overlap
};

} // namespace bem_contact
