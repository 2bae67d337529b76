#pragma once

#include "bem_contact/contact/coupled/settings.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::contact {

/// Tells from the changes of outer iterations whether they will settle.
///
/// Accelerated iterations do not fall evenly, so that the smallest changes of two runs of iterations are
/// compared.
class SettlingRate {
public:
  /// After each outer iteration. True if, at the rate of the last ones, many more than are `left` are needed
  /// until a change is `enough`.
  bool is_hopeless(double change, double enough, int left) {
    changes_.push_back(change);
    const auto end = changes_.end();
    const int window = iterations_of_a_rate;
    if (static_cast<int>(changes_.size()) < 2 * window)
      return false;
    const double best = *std::min_element(changes_.begin(), end), last = *std::min_element(end - window, end),
                 before = *std::min_element(changes_.begin(), end - window);
    if (last >= before)
      return best > enough;
    const double needed = std::log(last / enough) / std::log(before / last) * window;
    return needed > hopeless_factor * left;
  }

private:
  std::vector<double> changes_;
};

} // namespace bem_contact::contact
