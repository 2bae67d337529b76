#include "bem_contact/profile/standard_profiles.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/own_outline.hpp"
#include "bem_contact/profile/rail_section.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/s1002.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace bem_contact {

namespace {

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
  throw InputError(fmt::format("unknown profile '{}'", name),
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

std::string graft_base(const BodyFile::Body& body) {
  const std::string base = !body.graft_onto.empty()      ? body.graft_onto
                           : body.kind == BodyKind::rail ? "60E1"
                                                         : "S1002";
  if (!is_standard_profile(base) || (base == "S1002") != (body.kind == BodyKind::wheel))
    throw InputError(fmt::format("a {} cannot be grafted onto '{}'", name_of(body.kind), base),
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
