#include "bem_contact/profile/bodies/rail_section.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>

namespace bem_contact {

namespace {

/// z up from the top, as drawings have it.
struct Step {
  Point2 to;
  double radius;
};

/// The head is a chain of arcs, each tangent to the one before, then a straight flank; below it the steps.
struct RailData {
  struct Arc {
    double radius;
    double to_y; ///< half width where the arc ends; 0: where it is as steep as the flank
  };
  std::string_view name;
  std::vector<Arc> arcs;
  double flank_slope; ///< dz/dy
  Point2 flank_end;   ///< z up
  std::span<const Step> below_head;
  bool exact; ///< the whole outline is the standard's
};

/// Under-head fillet, web and foot of 60E1 and 60E2, EN 13674-1.
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

/// 54E1: fishing surfaces 1:2.75 that meet the axis 49.4 mm below the top and 30.2 mm above the base, web
/// R508 about the height 76.2 mm (16 mm thick there), fillets R25.4, R8 and R16, foot 1:10 and 11 mm thick at
/// its edge, all joints tangent. Deduced from published dimensions and outlines, not from the standard's
/// drawing: it gives A, Ix and Iy of the standard within .05 %.
constexpr Step e54_below_head[] = {{{34.0268, -37.0266}, 3},
                                   {{14.9378, -43.9681}, 0},
                                   {{10.1302, -48.8171}, -8},
                                   {{8.7101, -55.9498}, -25.4},
                                   {{9.5370, -122.2873}, -508},
                                   {{20.0207, -136.0803}, -16},
                                   {{43.9226, -144.7719}, 0},
                                   {{48.7674, -145.8767}, -20},
                                   {{67.2985, -147.7299}, 0},
                                   {{70, -150.7150}, 3},
                                   {{70, -157}, 0},
                                   {{68, -159}, 2},
                                   {{0, -159}, 0}};

/// 46E3: height, foot and web of the standard; fishing surfaces 1:2.75 (45.8 mm below the top, 27.64 mm above
/// the base on the axis) and the foot's edge (11.71 mm) chosen so that A, Ix and Iy are the standard's within
/// .02 %; fillets as on 54E1.
constexpr Step e46_below_head[] = {{{35.8354, -32.7690}, 3},
                                   {{12.2661, -41.3396}, 0},
                                   {{7, -48.8580}, -8},
                                   {{7, -105.6986}, 0},
                                   {{17.5321, -120.7353}, -16},
                                   {{35.3123, -127.2008}, 0},
                                   {{40.1571, -128.3057}, -20},
                                   {{57.2985, -130.0199}, 0},
                                   {{60, -133.0050}, 3},
                                   {{60, -140}, 0},
                                   {{58, -142}, 2},
                                   {{0, -142}, 0}};

constexpr Point2 e60_flank_end{37.0486, -35.2753};

const std::vector<RailData>& rails() {
  static const std::vector<RailData> all{
      {"60E1", {{300, 10.228}, {80, 26.0265}, {13, 0}}, 20, e60_flank_end, e60_below_head, true},
      {"60E2",
       {{200, 23.778 / 2}, {70, 48.913 / 2}, {16, 70.774 / 2}, {8, 0}},
       20,
       e60_flank_end,
       e60_below_head,
       true},
      {"54E1",
       {{300, 20.024 / 2}, {80, 49.727 / 2}, {13, 0}},
       20,
       {35.9979, -34.0574},
       e54_below_head,
       false},
      {"46E3",
       {{300, 23.015 / 2}, {80, 53.761 / 2}, {13, 0}},
       16.5,
       {37.8047, -29.7681},
       e46_below_head,
       false}};
  return all;
}

const RailData& rail_data(std::string_view name) {
  for (const RailData& rail : rails())
    if (rail.name == name)
      return rail;
  const std::vector<std::string> known{"60E1", "60E2", "54E1", "46E3"};
  const auto like = nearest_names(name, known);
  throw InputError(fmt::format("Unknown rail '{}'", name), "known are 60E1, 60E2, 54E1 and 46E3",
                   like.empty() ? "Use one of these." : fmt::format("Did you mean {}?", like.front()));
}

} // namespace

std::vector<SectionPiece> rail_head(std::string_view name) {
  const RailData& data = rail_data(name);
  const double flank_delta = std::atan(data.flank_slope);
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
  pieces.push_back({p, {data.flank_end.y, -data.flank_end.z}, 0});
  return pieces;
}

std::vector<SectionPiece> rail_section(std::string_view name) {
  std::vector<SectionPiece> pieces = rail_head(name);
  for (const Step& step : rail_data(name).below_head)
    pieces.push_back({pieces.back().to, {step.to.y, -step.to.z}, step.radius});
  return pieces;
}

bool is_exact_rail_section(std::string_view name) {
  return rail_data(name).exact;
}

CurvePiece curve_of(const SectionPiece& piece) {
  return arc_piece(piece.from, piece.to, piece.radius == 0 ? 0 : 1 / piece.radius);
}

} // namespace bem_contact
