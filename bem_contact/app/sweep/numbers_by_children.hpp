#pragma once

#include "bem_contact/scene/sweep_file.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Work of many items, each of which gives some numbers: points of a table or of a curve, cases of a step.
struct ItemsOfWork {
  using Give = std::function<void(std::vector<double>)>;

  std::size_t count = 0;
  /// In a child: solves neighbours, the first from a cold start, and gives the numbers of one after the
  /// other, each at once.
  std::function<void(CaseRange items, const Give& give)> solve;
  /// An item in a message: "The point (1, 2) of the table".
  std::function<std::string(std::size_t item)> name;
  std::function<void(std::size_t more)> done = nullptr; ///< so many more items are solved; null: nobody asks
};

/// Solves chunks of items (chunk_size()) in `jobs` processes side by side; 0: one for each core. So the
/// numbers do not depend on `jobs`. What a child throws is thrown here. ConvergenceError where a child dies.
std::vector<std::vector<double>> numbers_by_children(const ItemsOfWork& work, int jobs);

} // namespace bem_contact::app
