#pragma once

#include "bem_contact/base/conventions.hpp"

#include <vector>

namespace bem_contact::meshes {

/// How long an element edge may be, as a function of the place.
/// size(p) = min(largest, min over sources (size_i + grading * |p - source_i|)).
class SizeField {
public:
  SizeField(double largest, double grading) : largest_(largest), grading_(grading) {}
  void add(double size, std::vector<Point2> sources);
  double operator()(Point2 p) const;

private:
  struct Level {
    double size;
    std::vector<Point2> sources;
  };
  double largest_, grading_;
  std::vector<Level> levels_; ///< rising in size
};

} // namespace bem_contact::meshes
