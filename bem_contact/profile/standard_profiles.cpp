#include "bem_contact/profile/standard_profiles.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/own_outline.hpp"
#include "bem_contact/profile/bodies/rail_section.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/standards/en13715_wheel.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace bem_contact {

namespace {

using std::numbers::pi;

/// As names are compared: in small letters, without spaces, hyphens, underscores and signs beyond ASCII.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (static_cast<signed char>(c) > 0 && c != ' ' && c != '-' && c != '_')
      out += static_cast<char>(std::tolower(c));
  return out;
}

/// The name without the standard in front of it, as in "EN 13674-1 - 60E1".
std::string_view without_standard(std::string_view name) {
  for (const std::string_view standard : {"EN 13674-1", "EN 13674-4", "EN 13715"})
    if (name.starts_with(standard) && name.size() > standard.size())
      return name.substr(std::min(name.find_first_of("0123456789S", standard.size()), name.size()));
  return name;
}

std::vector<std::string_view> names_of(const StandardEntry& entry) {
  std::vector<std::string_view> names{entry.name};
  names.insert(names.end(), entry.other_names.begin(), entry.other_names.end());
  return names;
}

struct FoundStandard {
  const StandardEntry* entry = nullptr;
  En13715Wheel wheel = {}; ///< if it is of EN 13715
};

/// The tables that the program varies by a rule.
bool is_of_en13715(const StandardEntry& entry) {
  return entry.table == "EN13715.csv";
}

FoundStandard found(std::string_view given) {
  const std::string_view name = without_standard(given);
  const std::string wanted = plain(name);
  for (const StandardEntry& entry : standard_entries())
    for (const std::string_view its : names_of(entry)) {
      if (plain(its) == wanted)
        return {&entry};
      if (is_of_en13715(entry) && wanted.starts_with(plain(its)) && name.size() > its.size() &&
          plain(name.substr(0, its.size())) == plain(its))
        if (const auto wheel = parse_en13715_wheel(name.substr(its.size())))
          return {&entry, *wheel};
    }
  return {};
}

std::string name_of(const FoundStandard& standard) {
  return standard.wheel == En13715Wheel{} ? standard.entry->name
                                          : standard.entry->name + ' ' + words_of(standard.wheel);
}

ProfileCurve mirrored_profile(std::string name, const std::vector<SectionPiece>& right) {
  std::vector<CurvePiece> pieces;
  const auto mirrored = [](Point2 p) { return Point2{-p.y, p.z}; };
  for (auto piece = right.rbegin(); piece != right.rend(); ++piece)
    pieces.push_back(curve_of({mirrored(piece->to), mirrored(piece->from), piece->radius}));
  for (const SectionPiece& piece : right)
    pieces.push_back(curve_of(piece));
  return ProfileCurve::from_pieces(std::move(name), std::move(pieces));
}

/// The curve of pieces in walking order; the piece at y = 0 stays where the table puts it.
ProfileCurve walked_profile(std::string name, const std::vector<DrawnPiece>& drawn) {
  std::vector<CurvePiece> pieces;
  Point2 jumps; // of all joints before that piece
  bool at_axis = false;
  for (const DrawnPiece& piece : drawn) {
    const std::vector<CurvePiece> curves = curves_of(piece);
    if (!pieces.empty() && !at_axis)
      jumps = jumps + (curves.front().start - point_on(pieces.back(), pieces.back().length).position);
    at_axis = at_axis || piece.from.y * piece.to.y <= 0;
    pieces.insert(pieces.end(), curves.begin(), curves.end());
  }
  pieces.front().start = pieces.front().start + jumps;
  pieces.front().middle = pieces.front().middle + jumps;
  return ProfileCurve::from_pieces(std::move(name), std::move(pieces));
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

const StandardEntry* find_standard(std::string_view name) {
  return found(name).entry;
}

bool is_standard_profile(std::string_view name) {
  return find_standard(name) != nullptr;
}

std::string standard_name(std::string_view name) {
  const FoundStandard standard = found(name);
  return standard.entry == nullptr ? std::string(name) : name_of(standard);
}

std::string advice_on_name(std::string_view name, std::optional<ProfileKind> kind) {
  std::vector<std::string> names;
  for (const StandardEntry& entry : standard_entries())
    if (!kind || entry.kind == *kind)
      for (const std::string_view its : names_of(entry))
        names.emplace_back(its);
  const auto like = nearest_names(name, names);
  return like.empty() ? "Use one of those that `bem_contact profile --list` prints, or check the path."
                      : fmt::format("Did you mean {}? (`bem_contact profile --list` prints all)",
                                    fmt::join(like, " or "));
}

std::string standards_text() {
  std::string out;
  for (const StandardEntry& entry : standard_entries()) {
    const std::string others =
        entry.other_names.empty() ? "" : fmt::format("; also {}", fmt::join(entry.other_names, ", "));
    const std::string varied = is_of_en13715(entry)
                                   ? fmt::format("; also with another flange and outer slope, as \"{} {}\"",
                                                 entry.name, words_of({.thickness = 30.5}))
                                   : "";
    out += fmt::format("{:14}  {:5}  {}{}{}{}\n", entry.name, name_of(entry.kind), entry.standard, others,
                       varied, entry.remark.empty() ? "" : "; " + entry.remark);
  }
  return out;
}

ProfileCurve standard_profile(std::string_view name) {
  const FoundStandard standard = found(name);
  if (standard.entry == nullptr)
    throw InputError(fmt::format("Unknown profile '{}'", name), "it is none of the built-in ones",
                     advice_on_name(name));
  const StandardEntry& entry = *standard.entry;
  if (entry.part == StandardEntry::Part::section)
    return mirrored_profile(entry.name, rail_head(entry.name));
  const std::vector<DrawnPiece> pieces = drawn_pieces(entry);
  if (entry.part == StandardEntry::Part::curve)
    return walked_profile(name_of(standard),
                          standard.wheel == En13715Wheel{} ? pieces : en13715_wheel(pieces, standard.wheel));
  std::vector<SectionPiece> right;
  for (const DrawnPiece& piece : pieces)
    right.push_back({piece.from, piece.to, piece.radius});
  return mirrored_profile(entry.name, right);
}

std::string standard_body_file(std::string_view name) {
  const ProfileCurve curve = standard_profile(name);
  const StandardEntry& entry = *find_standard(name);
  if (entry.kind == ProfileKind::rail && entry.part != StandardEntry::Part::section)
    throw InputError(
        fmt::format("There is no body of {}", entry.name),
        "the tables have its head alone, and influence functions need web and foot",
        "Write its points into a file (bem_contact profile --csv) and graft them onto another rail: "
        "data/bodies/README.md.");
  const std::string body =
      fmt::format("[body]\nkind = \"{}\"\nprofile = \"{}\"\n", name_of(entry.kind), standard_name(name));
  const BodyFile::Strip usual = parse_body_file(body, entry.name).strip;
  return fmt::format("{}\n[strip]\nfrom = {:g} # mm, arc length\nto = {:g}\nstation_width = {:g}\n", body,
                     std::max(usual.from, std::ceil(curve.s_begin())),
                     std::min(usual.to, std::floor(curve.s_end())), usual.station_width);
}

ProfileKind kind_of_standard(std::string_view name) {
  const StandardEntry* entry = find_standard(name);
  return entry == nullptr ? ProfileKind::rail : entry->kind;
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
  const bool wheel = body.kind == BodyKind::wheel;
  const StandardEntry* entry = find_standard(base);
  if (entry == nullptr || (entry->kind == ProfileKind::wheel) != wheel ||
      (!wheel && entry->part != StandardEntry::Part::section))
    throw InputError(fmt::format("A {} cannot be grafted onto '{}'", name_of(body.kind), base),
                     "bodies are known of the standard profiles only",
                     wheel ? "Use S1002." : "Use 60E1, or another rail whose whole section is known.");
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
  const std::string what = body.kind == BodyKind::wheel ? " (representative rim, web and hub)"
                           : body.roller_radius > 0
                               ? fmt::format(" as a roller of radius {:g} mm", body.roller_radius)
                               : "";
  if (standard)
    return fmt::format("{} {}{}", name_of(body.kind), base, what);
  return fmt::format("{} {} on {}{}", name_of(body.kind),
                     std::filesystem::path(body.profile).filename().string(), base, what);
}

} // namespace bem_contact
