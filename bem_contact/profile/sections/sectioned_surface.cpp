#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/sections/correspondence.hpp"
#include "bem_contact/profile/sections/section_checks.hpp"
#include "bem_contact/profile/sections/section_curve.hpp"
#include "bem_contact/profile/sections/section_spline.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// mm. Curves are tabulated at least this finely, as profiles are: cubic pieces this short follow every
/// curvature of a rail.
constexpr double largest_step = 0.1;
/// mm of t. Nodes nearer to each other are one.
constexpr double same_node = 1e-7;
/// 1/mm. A jump of the curvature that no node is made for: over a step it is worth 1e-10 mm.
constexpr double smooth_curvature = 1e-7;
/// rad. The same of a tangent's turn.
constexpr double smooth_turn_of_section = 1e-9;
/// mm. A feature this near to an end of the profile is its end, written with few digits.
constexpr double feature_at_end = 1e-3;
/// mm. Distance from a joint at which its other side is looked at.
constexpr double before_joint = 1e-9;
/// mm. A line this near to the end of what is there is that end.
constexpr double end_of_section = 1e-7;

/// Arc length of one section as a monotone cubic of t between its marks (Fritsch and Carlson 1980, slopes
/// after Butland).
class ArcLength {
public:
  ArcLength(const std::vector<double>& lines, const std::vector<double>& marks)
      : t_(lines), s_(marks), slope_(marks.size(), 0.0) {
    const int n = static_cast<int>(marks.size());
    for (int k = 0; k < n; ++k) {
      const bool left = k > 0 && has(k - 1), right = k + 1 < n && has(k);
      if (left && right)
        slope_[k] = inner(k);
      else if (left || right)
        slope_[k] = at_end(k, left ? -1 : 1);
    }
  }

  bool has(int stretch) const { return std::isfinite(s_[stretch]) && std::isfinite(s_[stretch + 1]); }
  struct Value {
    double s, slope;
  };
  Value at(int stretch, double t) const {
    const double length = t_[stretch + 1] - t_[stretch], v = (t - t_[stretch]) / length, w = 1 - v;
    const double a = s_[stretch], b = s_[stretch + 1], ma = slope_[stretch], mb = slope_[stretch + 1];
    const double s = a + (b - a) * v * v * (3 - 2 * v) + length * v * w * (w * ma - v * mb);
    const double slope = 6 * v * w * (b - a) / length + w * (1 - 3 * v) * ma + v * (3 * v - 2) * mb;
    return {std::clamp(s, a, b), std::max(slope, 0.0)};
  }
  /// Where the arc length is `s`.
  double t_of(int stretch, double s) const {
    const auto excess = [&](double t) { return at(stretch, t).s - s; };
    const double a = t_[stretch], b = t_[stretch + 1];
    if (!(excess(a) < 0 && excess(b) > 0))
      return excess(a) < 0 ? b : a;
    return boost::math::tools::bisect(excess, a, b, boost::math::tools::eps_tolerance<double>()).first;
  }

private:
  double secant(int k) const { return (s_[k + 1] - s_[k]) / (t_[k + 1] - t_[k]); }
  double inner(int k) const {
    const double a = secant(k - 1), b = secant(k);
    if (!(a > 0 && b > 0))
      return 0;
    const double ha = t_[k] - t_[k - 1], hb = t_[k + 1] - t_[k], wa = 2 * hb + ha, wb = 2 * ha + hb;
    return (wa + wb) / (wa / a + wb / b);
  }
  double at_end(int k, int inward) const {
    const int first = inward > 0 ? k : k - 1, second = first + inward;
    const double a = secant(first);
    if (second < 0 || second + 1 >= static_cast<int>(s_.size()) || !has(second))
      return a;
    const double b = secant(second), h = t_[first + 1] - t_[first], g = t_[second + 1] - t_[second];
    const double parabola = a + h * (a - b) / (h + g);
    return std::clamp(parabola, 0.0, 3 * a);
  }

  std::vector<double> t_, s_, slope_;
};

/// t of the lines: each stretch is as long as it is in the section in which it is longest.
std::vector<double> places_of_lines(const std::vector<std::vector<double>>& marks) {
  std::vector<double> t{0};
  for (std::size_t k = 0; k + 1 < marks.front().size(); ++k) {
    double longest = 0;
    for (const std::vector<double>& of : marks)
      if (const double length = of[k + 1] - of[k]; length > longest) // not of nan
        longest = length;
    t.push_back(t.back() + longest);
  }
  return t;
}

bool jumps_at(const ProfileCurve& curve, double s) {
  const CurvePoint after = curve.at(s), before = curve.at(s - before_joint);
  return std::abs(after.curvature - before.curvature) > smooth_curvature ||
         std::abs(after.delta - before.delta) >
             smooth_turn_of_section + before_joint * std::abs(before.curvature);
}

/// Nodes of one stretch: where a section's tangent or curvature jumps, and between these evenly.
std::vector<double> nodes_of_stretch(const std::vector<BodySection>& sections,
                                     const std::vector<ArcLength>& arcs, const std::vector<double>& lines,
                                     int stretch) {
  std::vector<double> at{lines[stretch], lines[stretch + 1]};
  for (std::size_t j = 0; j < sections.size(); ++j) {
    if (!arcs[j].has(stretch))
      continue;
    const double from = arcs[j].at(stretch, lines[stretch]).s, to = arcs[j].at(stretch, lines[stretch + 1]).s;
    for (const double s : sections[j].profile.joints())
      if (s > from + before_joint && s < to - before_joint && jumps_at(sections[j].profile, s))
        at.push_back(arcs[j].t_of(stretch, s));
  }
  std::ranges::sort(at);
  std::vector<double> out{at.front()};
  for (const double t : at) {
    const double length = t - out.back();
    if (length < same_node)
      continue;
    const int parts = static_cast<int>(std::ceil(length / largest_step - same_node));
    const double begin = out.back();
    for (int i = 1; i <= std::max(parts, 1); ++i)
      out.push_back(i >= parts ? t : begin + length * i / parts);
  }
  out.back() = lines[stretch + 1];
  return out;
}

void round_features(std::vector<BodySection>& sections) {
  for (BodySection& section : sections)
    for (double& s : section.features)
      for (const double end : {section.profile.s_begin(), section.profile.s_end()})
        if (std::abs(s - end) < feature_at_end)
          s = end;
}

/// Doubles each section with a kink, with nothing between the two: one spline ends in it and one begins.
void split_at_kinks(std::vector<BodySection>& sections, std::vector<std::vector<double>>& marks,
                    std::vector<std::vector<char>>& there) {
  const auto doubled = [](auto& list, std::ptrdiff_t i) {
    auto copy = list[i];
    list.insert(list.begin() + i, std::move(copy));
  };
  for (std::ptrdiff_t i = std::ssize(sections) - 2; i > 0; --i)
    if (sections[i].kink) {
      doubled(sections, i);
      doubled(marks, i);
      there.insert(there.begin() + i, std::vector<char>(there[i].size(), 0));
    }
}

/// Points and tangents of the sections from `first` on become those of the B-spline at their places `at`.
template <class Table> void smooth_sections(Table& table, const std::vector<double>& at, int first) {
  const Table given = table;
  for (std::size_t j = 1; j + 1 < at.size(); ++j) {
    const double before = at[j] - at[j - 1], after = at[j + 1] - at[j], sum = 3 * (before + after);
    const double a = after / sum, c = before / sum, b = 1 - a - c;
    auto& to = table[first + j];
    const auto &left = given[first + j - 1], &here = given[first + j], &right = given[first + j + 1];
    for (std::size_t k = 0; k < to.size(); ++k) {
      to[k].position = a * left[k].position + b * here[k].position + c * right[k].position;
      to[k].before = a * left[k].before + b * here[k].before + c * right[k].before;
      to[k].after = a * left[k].after + b * here[k].after + c * right[k].after;
    }
  }
}

} // namespace

SectionedSurface::SectionedSurface(std::vector<BodySection> sections, const SectionsAre& are) {
  round_features(sections);
  require_sections(sections, are);
  CorrespondingPoints points =
      sections.front().features.empty() ? corresponding_points(sections) : given_points(sections);
  there_ = stretches_there(sections, points, are);
  split_at_kinks(sections, points.marks, there_);
  for (const BodySection& section : sections)
    at_.push_back(section.at);
  marks_ = std::move(points.marks);
  tabulate(sections, marks_, are.approximated);
  require_gentle(*this, sections, are);
}

void SectionedSurface::tabulate(const std::vector<BodySection>& sections,
                                const std::vector<std::vector<double>>& marks, bool approximated) {
  lines_ = places_of_lines(marks);
  std::vector<ArcLength> arcs;
  for (const std::vector<double>& of : marks)
    arcs.emplace_back(lines_, of);
  t_ = {lines_.front()};
  for (int k = 0; k + 1 < static_cast<int>(lines_.size()); ++k) {
    const std::vector<double> t = nodes_of_stretch(sections, arcs, lines_, k);
    first_node_.push_back(static_cast<int>(t_.size()) - 1);
    t_.insert(t_.end(), t.begin() + 1, t.end());
    auto& table = nodes_.emplace_back(sections.size());
    for (std::size_t j = 0; j < sections.size(); ++j) {
      if (!arcs[j].has(k))
        continue;
      const ProfileCurve& curve = sections[j].profile;
      for (const double at : t) {
        const auto [s, slope] = arcs[j].at(k, at);
        const CurvePoint p = curve.at(s); // s of a corner is rounded to either side of it
        const double back = curve.at(std::max(s - before_joint, curve.s_begin())).delta,
                     ahead = curve.at(std::min(s + before_joint, curve.s_end())).delta;
        const bool smooth =
            std::abs(ahead - back) < smooth_turn_of_section + 2 * before_joint * std::abs(p.curvature);
        table[j].push_back({p.position,
                            slope * tangent_of(smooth ? p.delta : back),
                            slope * tangent_of(smooth ? p.delta : ahead),
                            {},
                            {},
                            {}});
      }
    }
    join(k, approximated);
  }
  first_node_.push_back(static_cast<int>(t_.size()) - 1);
}

/// Splines along u through the sections that follow each other.
void SectionedSurface::join(int stretch, bool approximated) {
  auto& table = nodes_[stretch];
  for (int first = 0; first + 1 < static_cast<int>(at_.size()); ++first) {
    int last = first;
    while (last + 1 < static_cast<int>(at_.size()) && there_[last][stretch])
      ++last;
    if (last == first)
      continue;
    if (approximated)
      smooth_sections(table, {at_.begin() + first, at_.begin() + last + 1}, first);
    const SectionSpline spline({at_.begin() + first, at_.begin() + last + 1});
    std::vector<Point2> values(last - first + 1);
    for (std::size_t node = 0; node < table[first].size(); ++node)
      for (const auto& [value, by_u] : {std::pair{&Node::position, &Node::position_u},
                                        {&Node::before, &Node::before_u},
                                        {&Node::after, &Node::after_u}}) {
        for (int j = first; j <= last; ++j)
          values[j - first] = table[j][node].*value;
        const std::vector<Point2> slopes = spline.slopes(values);
        for (int j = first; j <= last; ++j)
          table[j][node].*by_u = slopes[j - first];
      }
    first = last - 1;
  }
}

int SectionedSurface::interval(double u) const {
  const auto after = std::ranges::upper_bound(at_, u);
  return std::clamp(static_cast<int>(after - at_.begin()) - 1, 0, static_cast<int>(at_.size()) - 2);
}

std::pair<double, double> SectionedSurface::extent(double u) const {
  const std::vector<char>& there = there_[interval(u)];
  const auto first = std::ranges::find(there, 1);
  const auto last = std::find(first, there.end(), 0);
  return {lines_[first - there.begin()], lines_[last - there.begin()]};
}

bool SectionedSurface::has(double u, double t) const {
  const auto [from, to] = extent(u);
  return t >= from - end_of_section && t <= to + end_of_section;
}

std::optional<double> SectionedSurface::arc_length(double place, double t) const {
  const auto section = std::ranges::find(at_, place);
  if (section == at_.end())
    return std::nullopt;
  const ArcLength arcs(lines_, marks_[section - at_.begin()]);
  const auto after = std::ranges::upper_bound(lines_, t);
  const int stretch =
      std::clamp(static_cast<int>(after - lines_.begin()) - 1, 0, static_cast<int>(lines_.size()) - 2);
  return arcs.has(stretch) ? std::optional(arcs.at(stretch, t).s) : std::nullopt;
}

ProfileCurve SectionedSurface::section(double u, std::vector<double>& t) const {
  std::vector<SectionNode> nodes;
  for (const double node : t_)
    if (has(u, node)) {
      const Point before = at(u, node, -1), after = at(u, node, 1);
      nodes.push_back({u, node, after.position, before.by_t, after.by_t});
    }
  ProfileCurve out = curve_through(fmt::format("section at {:.6g}", u), nodes);
  t.clear();
  for (const SectionNode& node : nodes)
    t.push_back(node.t);
  return out;
}

SectionedSurface::Point SectionedSurface::at(double u, double t, int side) const {
  const auto after = side > 0 ? std::ranges::upper_bound(t_, t) : std::ranges::lower_bound(t_, t);
  return in_cell(u, t,
                 std::clamp(static_cast<int>(after - t_.begin()) - 1, 0, static_cast<int>(t_.size()) - 2));
}

SectionedSurface::Point SectionedSurface::in_cell(double u, double t, int cell) const {
  const int i = interval(u);
  const auto stretch_after = std::ranges::upper_bound(first_node_, cell);
  int stretch = std::clamp(static_cast<int>(stretch_after - first_node_.begin()) - 1, 0,
                           static_cast<int>(nodes_.size()) - 1);
  if (!there_[i][stretch]) { // the end of what is there
    const auto [from, to] = extent(u);
    const double end = t < 0.5 * (from + to) ? from : to;
    const auto node = std::ranges::lower_bound(t_, end) - t_.begin();
    return in_cell(u, end, static_cast<int>(end == from ? node : node - 1));
  }
  const auto& table = nodes_[stretch];
  const int k = cell - first_node_[stretch];
  const double length = t_[cell + 1] - t_[cell], v = (t - t_[cell]) / length, w = 1 - v;
  // Of the cubic Hermite polynomial along t and its slope: weights of both ends and of their tangents.
  const double p0 = w * w * (1 + 2 * v), p1 = v * v * (3 - 2 * v), m0 = length * v * w * w,
               m1 = -length * v * v * w, d1 = 6 * v * w / length, n0 = w * (1 - 3 * v), n1 = v * (3 * v - 2);
  struct Curve {
    Point2 position, position_u, slope, slope_u;
  };
  const auto along = [&](int section) {
    const Node &a = table[section][k], &b = table[section][k + 1];
    return Curve{p0 * a.position + p1 * b.position + m0 * a.after + m1 * b.before,
                 p0 * a.position_u + p1 * b.position_u + m0 * a.after_u + m1 * b.before_u,
                 d1 * (b.position - a.position) + n0 * a.after + n1 * b.before,
                 d1 * (b.position_u - a.position_u) + n0 * a.after_u + n1 * b.before_u};
  };
  const Curve a = along(i), b = along(i + 1);
  if (u < from())
    return {a.position + (u - from()) * a.position_u, a.slope + (u - from()) * a.slope_u, a.position_u};
  if (u > to())
    return {b.position + (u - to()) * b.position_u, b.slope + (u - to()) * b.slope_u, b.position_u};
  const double h = at_[i + 1] - at_[i], q = (u - at_[i]) / h, r = 1 - q;
  const double b0 = r * r * (1 + 2 * q), b1 = q * q * (3 - 2 * q), c0 = h * q * r * r, c1 = -h * q * q * r;
  return {b0 * a.position + b1 * b.position + c0 * a.position_u + c1 * b.position_u,
          b0 * a.slope + b1 * b.slope + c0 * a.slope_u + c1 * b.slope_u,
          (6 * q * r / h) * (b.position - a.position) + (r * (1 - 3 * q)) * a.position_u +
              (q * (3 * q - 2)) * b.position_u};
}

} // namespace bem_contact
