#pragma once

#include "meshes/section.hpp"

#include <vector>

namespace bem_contact::meshes {

/// A closely sampled point of an outline.
struct Sample {
  Point2 position;
  std::size_t piece = 0; ///< of the span's pieces
  double t = 0;
  double length = 0; ///< from the span's beginning, mm
  double turn = 0;   ///< sum of the absolute turns since the span's beginning, rad
};

/// Pieces that join smoothly and belong to one group: a stretch of the outline without corners.
struct Span {
  std::vector<const Piece*> pieces; ///< of the loop given to sample_spans, which must outlive the span
  std::vector<Sample> samples;
  Group group = Group::free;
  bool closed = false; ///< the whole loop
};

/// True where the outline turns by more than 15 degrees from the end of `a` to the beginning of `b`.
bool corner_between(const Piece& a, const Piece& b);

/// The spans of a loop in walking order; a loop that begins with the strip keeps it first.
std::vector<Span> sample_spans(const Loop& loop);

/// Absolute curvature around a sample, over half a millimetre or the neighbouring samples, 1/mm.
double curvature_at(const Span& span, std::size_t sample);

/// The point of the span's curve `part` (0 .. 1) of the way from a sample to the next.
Point2 point_between(const Span& span, std::size_t sample, double part);

} // namespace bem_contact::meshes
