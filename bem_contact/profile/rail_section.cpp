#include "bem_contact/profile/rail_section.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/curve_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bem_contact {

namespace {

/// EN 13674-1: the head is a chain of arcs, each tangent to the one before, then a flank of slope 1:20.
struct HeadData {
  struct Arc {
    double radius;
    double to_y; ///< half width where the arc ends; 0: where it is as steep as the flank
  };
  std::vector<Arc> arcs;
  Point2 flank_end;
  bool flank_end_known; ///< false: only its z counts, the flank is cut there
};

constexpr double flank_slope = 20; // dz/dy
constexpr Point2 e60_flank_end{37.0486, 35.2753};

HeadData head_data(std::string_view name) {
  if (name == "60E1")
    return {{{300, 10.228}, {80, 26.0265}, {13, 0}}, e60_flank_end, true};
  if (name == "60E2")
    return {{{200, 23.778 / 2}, {70, 48.913 / 2}, {16, 70.774 / 2}, {8, 0}}, e60_flank_end, true};
  if (name == "54E1")
    return {{{300, 20.024 / 2}, {80, 49.727 / 2}, {13, 0}}, {0, 30}, false};
  const std::vector<std::string> known{"60E1", "60E2", "54E1"};
  const auto like = nearest_names(name, known);
  throw InputError(fmt::format("unknown rail '{}'", name), "known are 60E1, 60E2 and 54E1",
                   like.empty() ? "Use one of these." : fmt::format("Did you mean {}?", like.front()));
}

/// Under-head fillet, web and foot of 60E1, right half, z up from the top as the standard's drawing gives it.
struct Step {
  Point2 to;
  double radius;
};
constexpr Step e60_below_head[] = {{{35.0776, -38.2445}, 3},
                                   {{16.5016, -44.9994}, 0},
                                   {{12.2380, -49.4100}, -7},
                                   {{11.4505, -52.2206}, -35},
                                   {{8.25, -79.75}, -120},
                                   {{8.25, -111.75}, 0},
                                   {{11.4505, -139.2794}, -120},
                                   {{12.2380, -142.0900}, -35},
                                   {{16.5016, -146.5006}, -7},
                                   {{44.8622, -156.8135}, 0},
                                   {{55.6821, -159.1201}, -40},
                                   {{71.2850, -160.2346}, 0},
                                   {{75, -164.2245}, 4},
                                   {{75, -170}, 0},
                                   {{73, -172}, 2},
                                   {{0, -172}, 0}};

} // namespace

std::vector<SectionPiece> rail_head(std::string_view name) {
  const HeadData data = head_data(name);
  const double flank_delta = std::atan(flank_slope);
  std::vector<SectionPiece> pieces;
  Point2 p{0, 0};
  double delta = 0;
  for (const auto& arc : data.arcs) {
    const Point2 centre = p + arc.radius * normal_of(delta);
    delta = arc.to_y > 0 ? std::asin((arc.to_y - centre.y) / arc.radius) : flank_delta;
    const Point2 end = centre - arc.radius * normal_of(delta);
    pieces.push_back({p, end, arc.radius});
    p = end;
  }
  const Point2 end = data.flank_end_known
                         ? data.flank_end
                         : Point2{p.y + (data.flank_end.z - p.z) / flank_slope, data.flank_end.z};
  pieces.push_back({p, end, 0});
  return pieces;
}

std::vector<SectionPiece> rail_section(std::string_view name) {
  std::vector<SectionPiece> pieces = rail_head(name);
  if (name == "54E1")
    throw InputError("the whole section of rail 54E1 is not known", "only its head is built in",
                     "Use 60E1 or 60E2, or give the section's profile in a file.");
  for (const Step& step : e60_below_head)
    pieces.push_back({pieces.back().to, {step.to.y, -step.to.z}, step.radius});
  return pieces;
}

SectionProperties section_properties(const std::vector<SectionPiece>& right_half) {
  // Green's theorem along the outline: integral of f dA = integral of F dz with F = integral of f dy. The
  // part of the boundary on the axis y = 0 adds nothing. 5-point Gauss on sixteenths of each piece.
  constexpr double x[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                          0.9061798459386640};
  constexpr double w[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                          0.2369268850561891};
  constexpr int parts = 16;
  double area = 0, first = 0, second_z = 0, second_y = 0, lowest = 0;
  for (const SectionPiece& piece : right_half) {
    const CurvePiece curve = arc_piece(piece.from, piece.to, piece.radius == 0 ? 0 : 1 / piece.radius);
    for (int part = 0; part < parts; ++part)
      for (int g = 0; g < 5; ++g) {
        const PiecePoint p = point_on(curve, curve.length * (part + (1 + x[g]) / 2) / parts);
        const double dz = std::sin(p.delta) * w[g] * curve.length / (2 * parts);
        const double y = p.position.y, z = p.position.z;
        area += y * dz;
        first += y * z * dz;
        second_z += y * z * z * dz;
        second_y += y * y * y / 3 * dz;
      }
    lowest = std::max(lowest, piece.to.z);
  }
  const double z_mean = first / area;
  return {2 * area, lowest - z_mean, 2 * (second_z - area * z_mean * z_mean), 2 * second_y};
}

} // namespace bem_contact
