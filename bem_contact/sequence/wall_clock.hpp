#pragma once

#include <chrono>

namespace bem_contact {

/// Wall-clock seconds since it was made.
class WallClock {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace bem_contact
