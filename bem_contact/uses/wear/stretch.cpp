#include "bem_contact/uses/wear/stretch.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/profile/sections/sectioned_surface.hpp"
#include "bem_contact/scene/sectioned_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>

namespace bem_contact::wear {

namespace {

constexpr const char* along = "position.along";
/// 1. So near to a section, over the distance to the next one, its surface is looked at from there.
constexpr double beside_section = 1e-9;

std::string section_file(std::size_t index) {
  return fmt::format("section_{:03}.txt", index + 1);
}

/// A straight line over an interval of the track; nothing beyond it.
struct Ramp {
  double from, to, begin, end; ///< mm; values at both

  double operator()(double u) const { return begin + (end - begin) * (u - from) / (to - from); }
};

/// Integral of the product of two straight lines where both are, mm.
double product(const Ramp& a, const Ramp& b) {
  const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  if (!(to > from))
    return 0;
  const double middle = 0.5 * (from + to);
  return (to - from) / 6 * (a(from) * b(from) + 4 * a(middle) * b(middle) + a(to) * b(to)); // Simpson: exact
}

std::vector<Ramp> ramps_of(const PassagePlace& place) {
  std::vector<Ramp> out;
  if (place.before < place.at)
    out.push_back({place.before, place.at, 0, 1});
  if (place.at < place.after)
    out.push_back({place.at, place.after, 1, 0});
  return out;
}

double length_of(const PassagePlace& place) {
  return 0.5 * (place.after - place.before);
}

/// The feature lines of a section in numbers of its points, which lie evenly.
std::vector<double> features_by_points(const BodySection& section, std::size_t points) {
  std::vector<double> out;
  const ProfileCurve& curve = section.profile;
  for (const double s : section.features)
    out.push_back((s - curve.s_begin()) / (curve.s_end() - curve.s_begin()) * double(points - 1));
  return out;
}

WornSection worn_section(const BodySection& section, const std::string& body) {
  WornSection out{section.at, body, section.kink, {}, {}};
  out.worn.points = points_of(section.profile);
  out.worn.depth.assign(out.worn.points.size(), 0.0);
  out.features = features_by_points(section, out.worn.points.size());
  return out;
}

} // namespace

std::vector<WornSection> unworn_sections(const SceneFile& scene) {
  if (scene.rail.has_influence())
    throw InputError("A rail of sections with influence files does not wear",
                     "the files are of the sections as they are, and no others are computed",
                     "Leave out the influence files of its sections and of the wheel.");
  std::vector<WornSection> out;
  for (const SectionsOfBody& one : sections_of_bodies(scene, ProfileKind::rail)) {
    const std::string body = one.name.empty() ? "The rail" : fmt::format("Body '{}' of the rail", one.name);
    if (one.body.approximated)
      throw InputError(body + " cannot wear",
                       "its slices file asks for a surface that does not go through its sections",
                       "Ask for interpolation (1) in the slices file.");
    if (one.body.sections.size() < 2)
      throw InputError(body + " cannot wear place by place",
                       "it has one section, which is the same everywhere",
                       "Give it a section at each place between which its wear may change.");
    for (const BodySection& section : one.body.sections)
      out.push_back(worn_section(section, one.name));
  }
  return out;
}

std::vector<SectionRow> section_rows(const std::vector<WornSection>& sections) {
  std::vector<SectionRow> out;
  double body = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    body += i == 0 || sections[i].body != sections[i - 1].body ? 1 : 0;
    out.push_back({sections[i].at, body, sections[i].worn.largest(), sections[i].worn.area});
  }
  return out;
}

std::span<const ColumnOf<SectionRow>> section_columns() {
  using Row = SectionRow;
  static constexpr ColumnOf<Row> columns[] = {
      {"at", "mm", "place of the section along the track", [](const Row& row) { return row.at; }},
      {"body", "1", "of several rails beside each other, which one, from 1",
       [](const Row& row) { return row.body; }},
      {"depth", "mm", "largest depth gone from it", [](const Row& row) { return row.depth; }},
      {"area", "mm2", "gone from it", [](const Row& row) { return row.area; }}};
  return columns;
}

void write_sections(const std::vector<WornSection>& sections, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < sections.size(); ++i)
    write_profile(folder / section_file(i), sections[i].worn.points);
}

SceneFile::Section section_in_scene(const WornSection& section, std::string profile) {
  SceneFile::Section out{.at = section.at,
                         .profile = std::move(profile),
                         .features = {},
                         .without = {},
                         .kink = section.kink,
                         .body = section.body};
  if (section.features.empty())
    return out;
  const std::vector<double> s = ProfileCurve::through_points("worn", section.worn.points).joints();
  for (std::size_t k = 0; k < section.features.size(); ++k) {
    const double place = section.features[k];
    if (std::isnan(place)) {
      out.without.push_back(double(k + 1));
      continue;
    }
    const auto before = std::min(static_cast<std::size_t>(std::max(place, 0.0)), s.size() - 2);
    out.features.push_back(std::lerp(s[before], s[before + 1], place - double(before)));
  }
  return out;
}

void use_sections(SceneFile::Side& rail, const std::vector<WornSection>& sections,
                  const std::filesystem::path& folder) {
  rail.sections.clear();
  for (std::size_t i = 0; i < sections.size(); ++i)
    rail.sections.push_back(
        section_in_scene(sections[i], std::filesystem::absolute(folder / section_file(i)).string()));
  rail.profile = rail.sections.front().profile;
}

std::vector<std::size_t> passages_of(const SweepFile& sweep) {
  const std::vector<SweepFile::Axis>& axes = sweep.axes;
  const auto found = std::ranges::find(axes, along, &SweepFile::Axis::key);
  std::size_t first = found - axes.begin(), last = first;
  if (found != axes.end()) {
    while (axes[first].beside && first > 0)
      --first;
    for (++last; last < axes.size() && axes[last].beside;)
      ++last;
  }
  std::map<std::vector<std::size_t>, std::size_t> known;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    std::vector<std::size_t> others = sweep.indices(i);
    others.erase(others.begin() + std::ptrdiff_t(first), others.begin() + std::ptrdiff_t(last));
    out.push_back(known.try_emplace(std::move(others), known.size()).first->second);
  }
  return out;
}

std::vector<PassagePlace> passage_places(const std::vector<CaseOnTrack>& cases) {
  std::map<std::size_t, std::vector<std::size_t>> passages; // cases by rising place
  for (std::size_t i = 0; i < cases.size(); ++i)
    passages[cases[i].passage].push_back(i);
  double all = 0;
  for (auto& [number, places] : passages) {
    std::ranges::stable_sort(places, {}, [&](std::size_t i) { return cases[i].at; });
    all += cases[places.front()].weight;
  }
  std::vector<PassagePlace> out(cases.size());
  for (const auto& [number, places] : passages) {
    const CaseOnTrack &begin = cases[places.front()], &end = cases[places.back()];
    if (!(end.at > begin.at))
      throw InputError("The load collective is no passage along the track",
                       "the rail changes along it, and the cases are all at one place",
                       "Give [passage] with from, to and step.");
    for (std::size_t k = 0; k < places.size(); ++k) {
      const CaseOnTrack& here = cases[places[k]];
      if (here.weight != begin.weight)
        throw InputError(
            "The places of a passage have several weights",
            fmt::format("{:g} at {:g} mm, and {:g} at {:g} mm", begin.weight, begin.at, here.weight, here.at),
            "Give all places of one passage the same weight.");
      if (k > 0 && cases[places[k - 1]].at == here.at)
        throw InputError(fmt::format("A passage is twice at {:g} mm", here.at),
                         "its cases are told apart by their places along the track",
                         "Leave one of them out.");
      PassagePlace& place = out[places[k]];
      place.at = here.at;
      place.before = k > 0 ? cases[places[k - 1]].at : here.at;
      place.after = k + 1 < places.size() ? cases[places[k + 1]].at : here.at;
      place.frequency = here.weight / all;
      place.share = place.frequency * length_of(place) / (end.at - begin.at);
    }
  }
  return out;
}

SectionDepths::SectionDepths(const std::vector<WornSection>& sections,
                             std::vector<std::shared_ptr<const SectionedSurface>> surfaces) {
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i == 0 || sections[i].body != sections[i - 1].body)
      bodies_.push_back({i, i, surfaces[bodies_.size()]});
    ++bodies_.back().last;
    at_.push_back(sections[i].at);
    points_.push_back(sections[i].worn.points);
    s_.push_back(ProfileCurve::through_points("worn", sections[i].worn.points).joints());
    depths_.emplace_back(sections[i].worn.points);
  }
}

std::vector<SectionDepths::Share> SectionDepths::shares(const Body& body, const PassagePlace& place,
                                                        double t) const {
  const std::size_t count = body.last - body.first;
  std::vector<double> passed(count, 0.0), length(count, 0.0); // mm
  std::vector<int> inwards(count, 0);
  for (std::size_t j = 0; j + 1 < count; ++j) {
    const double from = at_[body.first + j], to = at_[body.first + j + 1];
    if (!body.surface->has(0.5 * (from + to), t))
      continue;
    for (const Ramp& ramp : ramps_of(place)) {
      passed[j] += product(ramp, {from, to, 1, 0});
      passed[j + 1] += product(ramp, {from, to, 0, 1});
    }
    length[j] += 0.5 * (to - from);
    length[j + 1] += 0.5 * (to - from);
    inwards[j] = 1;
    inwards[j + 1] = -1; // unless there is more behind it
  }
  double all = 0;
  for (const double one : passed)
    all += one;
  if (!(all > 0)) { // beyond the ends: the nearest section that has this point
    std::size_t nearest = count;
    for (std::size_t j = 0; j < count; ++j)
      if (length[j] > 0 && (nearest == count || std::abs(at_[body.first + j] - place.at) <
                                                    std::abs(at_[body.first + nearest] - place.at)))
        nearest = j;
    if (nearest == count)
      return {};
    all = passed[nearest] = 1;
  }
  std::vector<Share> out;
  for (std::size_t j = 0; j < count; ++j)
    if (passed[j] > 0)
      out.push_back({body.first + j, passed[j] / all * length_of(place) / length[j], inwards[j]});
  return out;
}

/// On the polygon of the section's points, of which the surface's point is one or between two.
double SectionDepths::arc_length(const Share& on, const Body& body, double t) const {
  const std::size_t k = on.section;
  const double next = on.inwards > 0 ? at_[k + 1] : at_[k - 1];
  const Point2 p = body.surface->at(at_[k] + beside_section * (next - at_[k]), t).position;
  const std::vector<Point2>& points = points_[k];
  double least = std::numeric_limits<double>::infinity(), s = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point2 edge = points[i + 1] - points[i], away = p - points[i];
    const double share = std::clamp(dot(away, edge) / dot(edge, edge), 0.0, 1.0);
    const Point2 off = away - share * edge;
    if (const double distance = dot(off, off); distance < least) {
      least = distance;
      s = std::lerp(s_[k][i], s_[k][i + 1], share);
    }
  }
  return s;
}

void SectionDepths::add(const DepthOverS& wear, const RowsOnSections& rows, const PassagePlace& place,
                        double weight, double smoothing) {
  std::map<std::size_t, DepthOverS> by_section;
  for (std::size_t row = 0; row < wear.depth.size(); ++row) {
    if (wear.depth[row] == 0)
      continue;
    const double ahead = rows.u[row] - place.at;
    const PassagePlace here{place.before + ahead, rows.u[row], place.after + ahead};
    const Body& body = bodies_[static_cast<std::size_t>(rows.body[row])];
    for (const Share& share : shares(body, here, rows.t[row])) {
      DepthOverS& of = by_section[share.section];
      of.width = wear.width;
      of.s.push_back(arc_length(share, body, rows.t[row]));
      of.depth.push_back(weight * share.part * wear.depth[row]);
    }
  }
  for (const auto& [section, depth] : by_section)
    depths_[section].add(depth, 1, smoothing);
}

} // namespace bem_contact::wear
