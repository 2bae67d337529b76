#include "bem_contact/app/commands/new_crossing.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <ostream>
#include <vector>

namespace bem_contact::app {

namespace {

/// mm below the top. How deep wing, nose and flangeway are drawn: deeper than a flange.
constexpr double drawn_depth = 32;
/// rad. How far the tops of wing and nose lean towards the track's centre: 1:40.
constexpr double lean = 0.025;
/// mm. Radius of the nose's corner on its field side; a thin nose has a smaller one, in widths (1).
constexpr double corner = 6, widest_corner = 0.35;
/// 1. Steps to the beginning of that corner, on a head that is almost level there.
constexpr int corner_steps = 20;
/// 1. In widths of the nose where it begins: a line that all its sections have on their gauge side.
constexpr double inner_line = 0.15;
/// mm below the top: the gauge face is upright there. And how closely a place across is found.
constexpr double gauge_face = 14, same_place = 1e-9;
/// mm. Distance of points, and of sections.
constexpr double point_spacing = 0.5, section_spacing = 40;
/// mm. Of plain rail before the wing leads away, and of nose after it has its full height; and how wide it
/// may get: a head is wider.
constexpr double before_knee = 150, after_nose = 200, widest_nose = 60;

/// One section with the points at which its feature lines lie: of nose and wing, or of the wing alone.
struct CrossingSection {
  double at = 0; ///< mm from the theoretical point
  bool kink = false;
  std::vector<Point2> points, nose_lines, wing_lines;
};

void add_line(std::vector<Point2>& points, Point2 to) {
  const Point2 from = points.back();
  const int parts = std::max(1, static_cast<int>(std::ceil(norm(to - from) / point_spacing)));
  for (int i = 1; i <= parts; ++i)
    points.push_back(from + (static_cast<double>(i) / parts) * (to - from));
}

/// The head of a rail, leaning, with its top at z = 0 and its gauge face at y = 0, as far down as
/// `drawn_depth`.
std::vector<Point2> head_points(const std::string& rail) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(named_profile(rail, ProfileKind::rail), point_spacing))
    points.push_back(turned(p.position, -lean));
  const double top = std::ranges::min(points, {}, &Point2::z).z;
  for (Point2& p : points)
    p.z -= top;
  const auto crest = std::ranges::min_element(points, {}, &Point2::z);
  auto from = crest, to = crest;
  while (from != points.begin() && from->z < drawn_depth)
    --from;
  while (to + 1 != points.end() && to->z < drawn_depth)
    ++to;
  if (from->z < drawn_depth)
    throw InputError(fmt::format("The rail '{}' makes no wing rail", rail),
                     fmt::format("its gauge face ends {:.3g} mm below the top, and {:g} mm are needed",
                                 from->z, drawn_depth),
                     "Give a profile that reaches further down, as 60E1 does.");
  std::vector<Point2> out(from, to + 1);
  const double face = std::ranges::min(out, {}, &Point2::y).y;
  for (Point2& p : out)
    p.y -= face;
  return out;
}

class Head {
public:
  explicit Head(const std::string& rail)
      : points_(head_points(rail)), curve_(ProfileCurve::through_points("head", points_)) {}
  const std::vector<Point2>& points() const { return points_; }
  /// Its point at y, between gauge face and field side.
  CurvePoint across(double y) const {
    double from = curve_.nearest({0, gauge_face}).s, to = curve_.s_end();
    while (to - from > same_place)
      (curve_.at(std::midpoint(from, to)).position.y < y ? from : to) = std::midpoint(from, to);
    return curve_.at(from);
  }

private:
  std::vector<Point2> points_;
  ProfileCurve curve_;
};

/// The rail's own gauge side with a round corner at the width of the nose, `lower` than the rail.
void add_nose(CrossingSection& out, const Head& head, double width, double inner, double lower) {
  const double r = std::min(corner, widest_corner * width);
  const Point2 down{0, lower};
  double delta = 0; // where the corner begins its slope is that of the head
  for (int i = 0; i < corner_steps; ++i)
    delta = head.across(width - r + r * std::sin(delta)).delta;
  const CurvePoint begin = head.across(width - r + r * std::sin(delta));
  const Point2 centre = begin.position + r * Point2{-std::sin(delta), std::cos(delta)} + down;
  for (const Point2& p : head.points())
    if (p.z > begin.position.z + point_spacing || p.y < begin.position.y - 0.5 * point_spacing)
      out.points.push_back(p + down);
    else
      break;
  out.points.push_back(begin.position + down);
  out.nose_lines = {out.points.front(), head.across(inner).position + down, out.points.back()};
  const int parts = std::max(8, static_cast<int>(std::ceil(2 * r / point_spacing)));
  for (int i = 1; i <= parts; ++i) {
    const double to = delta + (std::numbers::pi / 2 - delta) * i / parts;
    out.points.push_back(centre + r * Point2{std::sin(to), -std::cos(to)});
  }
  add_line(out.points, {width, drawn_depth});
  out.nose_lines.push_back(out.points.back());
}

class Crossing {
public:
  explicit Crossing(const NewCrossing& asked) : asked_(asked), head_(asked.rail) {}

  std::vector<CrossingSection> sections() const {
    const double n = asked_.number, knee = -n * asked_.flangeway, begin = n * asked_.nose_width,
                 full = n * asked_.full_width;
    std::vector<CrossingSection> out;
    stretch(knee - before_knee, knee, false, out);
    out.back().kink = true;
    stretch(knee, begin, false, out);
    out.pop_back();
    stretch(begin, full, true, out);
    out.back().kink = true;
    stretch(full, std::min(full + after_nose, n * widest_nose), true, out);
    return out;
  }

private:
  /// Sections from one place to another; the first is left out where it is there already.
  void stretch(double from, double to, bool nose, std::vector<CrossingSection>& out) const {
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / section_spacing)));
    for (int i = !out.empty() && out.back().at == from ? 1 : 0; i <= parts; ++i)
      out.push_back(section(i == parts ? to : from + (to - from) * i / parts, nose));
  }
  CrossingSection section(double at, bool nose) const {
    CrossingSection out;
    out.at = at;
    const double width = at / asked_.number, wing = std::max(0.0, width + asked_.flangeway);
    if (nose) {
      const double share = (width - asked_.nose_width) / (asked_.full_width - asked_.nose_width);
      add_nose(out, head_, width, inner_line * asked_.nose_width,
               std::max(0.0, asked_.nose_drop * (1 - share)));
      add_line(out.points, head_.points().front() + Point2{wing, 0});
      out.points.pop_back();
    }
    for (const Point2& p : head_.points())
      out.points.push_back(p + Point2{wing, 0});
    out.wing_lines = {head_.points().front() + Point2{wing, 0}, head_.points().back() + Point2{wing, 0}};
    return out;
  }

  const NewCrossing& asked_;
  Head head_;
};

constexpr const char* scene_head =
    R"(# A wheel over a crossing 1:{number:g}, written by bem_contact new --crossing.
#   bem_contact sweep {file} -o passage.h5    the passage, place by place
#   bem_contact plot passage.h5 -o passage.png
# Units are mm, N, MPa, rad; x forward, y to the right, z down. position.along is 0 at the theoretical point.
kind = "wheel_rail"
wheel.profile = {wheel}
solver.model = "halfspace"

[position]
along = 0                   # mm along the track
lateral = 0                 # mm to the right: the wheelset stands in the middle of the track
rail_inclination = 0        # rad: wing and nose lean by 1:40 in their files

[load]
force = {load:g}               # N

[motion]
friction = {friction:g}

[grid]
dx = 0.8                    # mm
ds = 0.5

[passage]
from = {from:g}                 # mm along the track
to = {to:g}
step = {step:g}

# The sections: a rail whose wing leads away from {knee:g} mm on, and a nose that begins {nose_width:g} mm wide and {nose_drop:g} mm
# too low. `features` are the lines that join them; `without` says which of them a section does not have.
[rail]
profile_z = "down"
unit = "mm"
)";

std::string numbers(const std::vector<double>& list) {
  std::vector<std::string> out;
  for (const double value : list)
    out.push_back(fmt::format("{:.6f}", value));
  return fmt::format("{}", fmt::join(out, ", "));
}

/// The table of one section, whose file is written.
std::string section_text(const CrossingSection& section, const std::filesystem::path& file,
                         const std::string& name) {
  const ProfileCurve curve =
      named_profile(file.string(), ProfileKind::rail, {},
                    {.unit = ProfileUnit::mm, .profile_z = ProfileZ::down, .keep_origin = true});
  std::vector<double> features;
  for (const auto* lines : {&section.nose_lines, &section.wing_lines})
    for (const Point2& p : *lines)
      features.push_back(curve.nearest(p).s);
  std::string out = fmt::format("\n[[rail.sections]]\nat = {:.6g}\nprofile = {}\nfeatures = [{}]\n",
                                section.at, toml_text(name), numbers(features));
  if (section.nose_lines.empty())
    out += "without = [1, 2, 3, 4]\n";
  if (section.kink)
    out += "kink = true\n";
  return out;
}

void require_crossing(const NewCrossing& n) {
  if (n.output.empty())
    throw InputError("A crossing needs a name (-o)", "its sections are files beside the scene",
                     "Give for instance -o crossing.toml.");
  if (!(n.full_width > n.nose_width))
    throw InputError(fmt::format("The nose begins {:g} mm wide", n.nose_width),
                     fmt::format("at {:g} mm it has its full height", n.full_width),
                     "Give a smaller --nose-width.");
}

} // namespace

ExitCode write_crossing(const NewCrossing& asked) {
  using fmt::arg;
  require_crossing(asked);
  const std::filesystem::path file = asked.output,
                              folder = file.parent_path() / (file.stem().string() + "_sections");
  for (const std::filesystem::path& output : {file, folder})
    if (file_exists(output))
      throw InputError(fmt::format("'{}' exists", output.string()), "what is in it would be lost",
                       "Give another name, or remove it.");
  named_profile(asked.wheel, ProfileKind::wheel); // what cannot be read is refused here
  const std::vector<CrossingSection> sections = Crossing(asked).sections();
  const double knee = -asked.number * asked.flangeway, full = asked.number * asked.full_width;
  std::string text = fmt::format(
      fmt::runtime(scene_head), arg("number", asked.number), arg("file", file.filename().string()),
      arg("wheel", toml_text(asked.wheel_in_scene)), arg("load", asked.load), arg("friction", asked.friction),
      arg("from", std::ceil(knee / 10) * 10 - 50), arg("to", std::floor(full / 10) * 10 + 50),
      arg("step", 10.0), arg("knee", knee), arg("nose_width", asked.nose_width),
      arg("nose_drop", asked.nose_drop));
  make_folder(folder);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string name = fmt::format("section_{:02}.txt", i + 1);
    write_text(folder / name, [&](std::ostream& out) {
      for (const Point2& p : sections[i].points)
        out << fmt::format("{:.9f} {:.9f}\n", p.y, p.z);
    });
    text += section_text(sections[i], folder / name, (folder.filename() / name).generic_string());
  }
  parse_scene_file({text, "the new scene", file.parent_path()});
  write_text(file, [&](std::ostream& out) { out << text; });
  return success;
}

} // namespace bem_contact::app
