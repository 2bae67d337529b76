#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/influence/h5_table.hpp"

#include <string>
#include <utility>
#include <vector>

/// Datasets as the output files have them.
namespace bem_contact::app {

/// One number.
inline H5Dataset single(double value, std::string unit, std::string description) {
  return {{}, {value}, std::move(unit), std::move(description)};
}

inline H5Dataset line(std::vector<double> values, std::string unit, std::string description) {
  const std::size_t n = values.size();
  return {{n}, std::move(values), std::move(unit), std::move(description)};
}

/// Rows of equal length.
template <class Rows> H5Dataset matrix(const Rows& rows, std::string unit, std::string description) {
  H5Dataset out{{rows.size(), rows.front().size()}, {}, std::move(unit), std::move(description)};
  for (const auto& row : rows)
    out.values.insert(out.values.end(), row.begin(), row.end());
  return out;
}

/// [point][y, z]
inline H5Dataset points(const std::vector<Point2>& all, std::string description) {
  H5Dataset out{{all.size(), 2}, {}, "mm", std::move(description)};
  for (const Point2& p : all)
    out.values.insert(out.values.end(), {p.y, p.z});
  return out;
}

} // namespace bem_contact::app
