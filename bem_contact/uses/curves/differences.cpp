#include "bem_contact/uses/curves/differences.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

Differences::Differences(std::span<const double> computed, std::span<const double> measured,
                         std::span<const double> scatter) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const double off = computed[i] - measured[i];
    each.push_back(off);
    sum += off;
    squares += off * off;
    largest = std::max(largest, std::abs(off));
    within_scatter += !scatter.empty() && std::abs(off) <= scatter[i];
  }
  mean = sum / double(computed.size());
  root_mean_square = std::sqrt(squares / double(computed.size()));
}

} // namespace bem_contact
