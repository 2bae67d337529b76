#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/halfspace/stress.hpp"

#include <span>
#include <vector>

namespace bem_contact::shakedown {

/// A block of the section (s, n) below a patch, and the passage of the patch over it.
struct Section {
  std::vector<double> s;      ///< points, mm, rising: in the middle of rows, some beside the patch
  std::vector<double> depths; ///< points, mm, rising; the first is the surface, 0
  /// Points of the passage, in columns of the grid from its first one, rising; some lie before the first
  /// column and behind the last.
  std::vector<int> columns;
  std::vector<double> s_knots, depth_knots; ///< of the residual stresses, mm
  double size = 0;                          ///< smaller half width of the patch, mm

  std::size_t points() const { return s.size() * depths.size(); }
  /// Number of a point: depth fastest.
  std::size_t point(std::size_t is, std::size_t id) const { return is * depths.size() + id; }
};

/// The block below these elements. Throws InputError in plane strain, where nothing passes.
Section section_below(const ContactProblem& problem, std::span<const int> elements);

/// Stresses of the half-space under all tractions of the result at each point of the section and of the
/// passage: [point][column], and a last one without load; in the frame (x, s, n), MPa, tension positive.
/// Distances are taken along the arc, as sequence/stresses.hpp does. On the surface they are those in the
/// middle of the elements.
std::vector<std::vector<halfspace::Stress>> stresses_of_passage(const Section& section,
                                                                const ContactProblem& problem,
                                                                const ContactResult& result, double poisson);

} // namespace bem_contact::shakedown
