#pragma once

#include "bem_contact/geometry/placement.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The rail as a height over y: from its highest point outwards to either side, as far as it can be seen
/// from above without looking past an edge.
class RailHeight {
public:
  explicit RailHeight(const WheelOnRail& pair);

  double from() const { return y_.front(); } ///< y of its ends, mm
  double to() const { return y_.back(); }

  struct Height {
    double z = 0, s = 0; ///< track frame; arc length on the rail, mm
  };
  /// Nothing beyond its ends. `near`: the interval where the search starts and, afterwards, where it ended.
  std::optional<Height> at(double y, int& near) const;

private:
  TabulatedProfile rail_;
  Point2 origin_;
  Turn turn_; ///< of the rail's section into the track frame, as its pose has it
  int first_ = 0;
  std::vector<double> y_; ///< of the nodes first_ .. that are seen
};

} // namespace bem_contact
