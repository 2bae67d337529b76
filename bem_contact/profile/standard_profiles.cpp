#include "bem_contact/profile/standard_profiles.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/own_outline.hpp"
#include "bem_contact/profile/bodies/rail_section.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace bem_contact {

namespace {

// EN 13715:2020, S1002 (also UIC 510-2): zone by zone from the field side to the flange back.

struct PolynomialZone {
  double from, to; ///< y, from > to
  std::array<double, 9> c;
};

constexpr PolynomialZone zone_a{60, 32.15796, {1.364323640, -0.066666667}};
constexpr PolynomialZone zone_b{32.15796,
                                -26,
                                {0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8,
                                 -1.562379023e-8, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13}};
constexpr PolynomialZone zone_c{-26,
                                -35,
                                {-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875,
                                 -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7}};
constexpr PolynomialZone zone_e{-38.426669071, -39.764473993, {-93.576667419, -2.747477419}};

struct ArcZone {
  double from, to; ///< y, from > to
  Point2 centre;
  double radius; ///< > 0: z = centre + root, convex; < 0: z = centre - root, concave
};

constexpr ArcZone zone_d{-35, -38.426669071, {-26.210665, 16.446}, -13};
constexpr ArcZone zone_f{-39.764473993, -49.662510381, {-58.558326413, 8.834924130}, 20};
constexpr ArcZone zone_g{-49.662510381, -62.764705882, {-55, 16}, 12};
constexpr ArcZone zone_h{-62.764705882, -70, {-49.5, 9.519259302}, 20.5};

double height(const PolynomialZone& zone, double y) {
  long double z = 0;
  for (std::size_t k = zone.c.size(); k-- > 0;)
    z = z * y + zone.c[k];
  return static_cast<double>(z);
}

double height(const ArcZone& zone, double y) {
  const double root = std::sqrt(std::max(0.0, zone.radius * zone.radius - std::pow(y - zone.centre.y, 2)));
  return zone.centre.z + std::copysign(root, zone.radius);
}

/// Pieces of at most s1002_piece, each about its own start: (y, z) = (y0 - t, zone(y0 - t)).
void add(std::vector<CurvePiece>& pieces, const PolynomialZone& zone) {
  const int count = static_cast<int>(std::ceil((zone.from - zone.to) / s1002_piece));
  for (int i = 0; i < count; ++i) {
    const double y0 = zone.from + (zone.to - zone.from) * i / count;
    const double y1 = zone.from + (zone.to - zone.from) * (i + 1) / count;
    std::array<long double, 9> c{};
    std::copy(zone.c.begin(), zone.c.end(), c.begin());
    // Taylor shift to y0 by repeated synthetic division; in long double, zone C cancels four digits.
    for (std::size_t k = 0; k < c.size(); ++k)
      for (std::size_t j = c.size() - 1; j-- > k;)
        c[j] += c[j + 1] * static_cast<long double>(y0);
    std::array<double, 9> z{};
    for (std::size_t k = 0; k < c.size(); ++k)
      z[k] = static_cast<double>(k % 2 == 0 ? c[k] : -c[k]);
    pieces.push_back(polynomial_piece(std::array<double, 2>{y0, -1}, z, y0 - y1));
  }
}

void add(std::vector<CurvePiece>& pieces, const ArcZone& zone) {
  const double sign = zone.radius > 0 ? 1 : -1;
  const auto inclination = [&](double y) {
    const Point2 outward = Point2{y, height(zone, y)} - zone.centre;
    const double delta = std::atan2(sign * outward.y, -sign * outward.z);
    return delta < 0 ? delta + 2 * std::numbers::pi : delta;
  };
  const double start = inclination(zone.from), end = inclination(zone.to);
  pieces.push_back(arc_piece({zone.from, height(zone, zone.from)}, start, 1 / zone.radius,
                             std::abs((end - start) * zone.radius)));
}

/// The S1002 wheel profile from the formulas of EN 13715 (see standard_profiles.hpp).
ProfileCurve s1002_profile() {
  std::vector<CurvePiece> pieces;
  pieces.push_back(
      line_piece({zone_a.from, height(zone_a, zone_a.from)}, {zone_a.to, height(zone_a, zone_a.to)}));
  add(pieces, zone_b);
  // So that the tread is where the formulas put it, the line of zone A starts at the small jump off it.
  const Point2 jump = pieces[1].start - point_on(pieces[0], pieces[0].length).position;
  pieces[0].start = pieces[0].start + jump;
  pieces[0].middle = pieces[0].middle + jump;
  add(pieces, zone_c);
  add(pieces, zone_d);
  pieces.push_back(
      line_piece({zone_e.from, height(zone_e, zone_e.from)}, {zone_e.to, height(zone_e, zone_e.to)}));
  add(pieces, zone_f);
  add(pieces, zone_g);
  add(pieces, zone_h);
  return ProfileCurve::from_pieces("S1002", std::move(pieces));
}

using std::numbers::pi;

ProfileCurve rail_head_profile(std::string_view name) {
  const std::vector<SectionPiece> right = rail_head(name);
  std::vector<CurvePiece> pieces;
  const auto mirrored = [](Point2 p) { return Point2{-p.y, p.z}; };
  for (auto piece = right.rbegin(); piece != right.rend(); ++piece)
    pieces.push_back(curve_of({mirrored(piece->to), mirrored(piece->from), piece->radius}));
  for (const SectionPiece& piece : right)
    pieces.push_back(curve_of(piece));
  return ProfileCurve::from_pieces(std::string(name), std::move(pieces));
}

/// The lower half of a circle, in two quarters so that a joint, exact, lies at the lowest point.
ProfileCurve lower_half_circle(std::string name, double radius, bool upper_body) {
  const double quarter = pi / 2 * radius;
  const Point2 start{upper_body ? radius : -radius, 0}, lowest{0, radius};
  const double curvature = (upper_body ? 1 : -1) / radius;
  return ProfileCurve::from_pieces(std::move(name),
                                   {arc_piece(start, pi / 2, curvature, quarter),
                                    arc_piece(lowest, upper_body ? pi : 0, curvature, quarter)});
}

} // namespace

std::span<const std::string> standard_profile_names() {
  static const std::array<std::string, 5> names{"60E1", "60E2", "54E1", "46E3", "S1002"};
  return names;
}

bool is_standard_profile(std::string_view name) {
  const auto names = standard_profile_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

ProfileCurve standard_profile(std::string_view name) {
  if (name == "S1002")
    return s1002_profile();
  if (is_standard_profile(name))
    return rail_head_profile(name);
  const auto like = nearest_names(name, standard_profile_names());
  throw InputError(fmt::format("Unknown profile '{}'", name),
                   fmt::format("built in are {}", fmt::join(standard_profile_names(), ", ")),
                   like.empty() ? "Use one of these or the path of a profile file."
                                : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
}

ProfileKind kind_of_standard(std::string_view name) {
  return name == "S1002" ? ProfileKind::wheel : ProfileKind::rail;
}

ProfileCurve body_profile(const BodyFile& file) {
  const auto& body = file.body;
  if (body.kind == BodyKind::outline)
    return outline_profile(body);
  if (body.kind == BodyKind::rail || body.kind == BodyKind::wheel)
    return named_profile(body.profile, body.kind == BodyKind::rail ? ProfileKind::rail : ProfileKind::wheel,
                         file.folder, body.reading);
  if (body.kind == BodyKind::disc)
    return lower_half_circle(fmt::format("disc R {}", body.radius), body.radius, true);
  if (body.kind == BodyKind::bore)
    return lower_half_circle(fmt::format("bore R {}", body.radius), body.radius, false);
  return ProfileCurve::from_pieces(fmt::format("block {}", body.size),
                                   {line_piece({-body.size, 0}, {0, 0}), line_piece({0, 0}, {body.size, 0})});
}

void require_strip_on_profile(const BodyFile::Strip& strip, const ProfileCurve& profile) {
  if (strip.from < profile.s_begin() - end_slack || strip.to > profile.s_end() + end_slack)
    throw InputError(
        fmt::format("The strip from {} to {} mm is not on profile {}", strip.from, strip.to, profile.name()),
        fmt::format("the profile runs from {:.3f} to {:.3f} mm", profile.s_begin(), profile.s_end()),
        "Change [strip] from and to.");
}

std::string graft_base(const BodyFile::Body& body) {
  const std::string base = !body.graft_onto.empty()      ? body.graft_onto
                           : body.kind == BodyKind::rail ? "60E1"
                                                         : "S1002";
  if (!is_standard_profile(base) || (base == "S1002") != (body.kind == BodyKind::wheel))
    throw InputError(fmt::format("A {} cannot be grafted onto '{}'", name_of(body.kind), base),
                     "bodies are known of the standard profiles only",
                     body.kind == BodyKind::rail ? "Use 60E1, 60E2, 54E1 or 46E3." : "Use S1002.");
  return base;
}

std::filesystem::path profile_file_of(const BodyFile& body) {
  const std::string& name = body.body.profile;
  return name.empty() || is_standard_profile(name) ? std::filesystem::path()
                                                   : profile_file_name(name, body.folder).file;
}

std::string held_part(const BodyFile::Body& body) {
  if (!body.held.empty())
    return body.held;
  const auto& k = body.kind;
  return k == BodyKind::rail    ? "foot"
         : k == BodyKind::wheel ? "bore"
         : k == BodyKind::block ? "base"
                                : "its pieces of group held";
}

std::string body_name(const BodyFile& file) {
  const auto& body = file.body;
  if (body.kind != BodyKind::rail && body.kind != BodyKind::wheel)
    return body_profile(file).name();
  const bool standard = is_standard_profile(body.profile);
  const std::string base = standard ? body.profile : graft_base(body);
  const char* what = body.kind == BodyKind::wheel  ? " (representative rim, web and hub)"
                     : is_exact_rail_section(base) ? ""
                                                   : " (representative web and foot)";
  if (standard)
    return fmt::format("{} {}{}", name_of(body.kind), base, what);
  return fmt::format("{} {} on {}{}", name_of(body.kind),
                     std::filesystem::path(body.profile).filename().string(), base, what);
}

} // namespace bem_contact
