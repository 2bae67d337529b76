#include "bem_contact/base/error.hpp"
#include "bem_contact/inside/stresses_inside.hpp"
#include "bem_contact/record/file_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact::inside {

std::span<const ColumnOf<AreaPeaks>> peak_columns() {
  using P = AreaPeaks;
  static constexpr std::array<ColumnOf<P>, 20> columns{
      {{"s", "mm", "middle of the points, arc length along the body's profile",
        [](const P& p) { return p.s; }},
       {"pmax", "MPa", "largest pressure", [](const P& p) { return p.pmax; }},
       {"von_mises", "MPa", "largest equivalent stress of von Mises",
        [](const P& p) { return p.von_mises.value; }},
       {"von_mises_s", "mm", "where that is", [](const P& p) { return p.von_mises.at.s; }},
       {"von_mises_depth", "mm", "how deep", [](const P& p) { return p.von_mises.at.depth; }},
       {"von_mises_x", "mm", "and where along x", [](const P& p) { return p.von_mises.x; }},
       {"mean_stress", "MPa", "hydrostatic stress there, tension positive",
        [](const P& p) { return p.mean; }},
       {"largest_shear", "MPa", "largest shear stress; Tresca's stress is twice as large",
        [](const P& p) { return p.shear.value; }},
       {"largest_shear_s", "mm", "where that is", [](const P& p) { return p.shear.at.s; }},
       {"largest_shear_depth", "mm", "how deep", [](const P& p) { return p.shear.at.depth; }},
       {"largest_shear_x", "mm", "and where along x", [](const P& p) { return p.shear.x; }},
       {"tresca", "MPa", "largest equivalent stress of Tresca",
        [](const P& p) {
          return Measured{2 * p.shear.value, 2 * p.shear.value.error};
        }},
       {"tension", "MPa", "largest principal stress", [](const P& p) { return p.tension; }},
       {"compression", "MPa", "least principal stress", [](const P& p) { return p.compression; }},
       {"halfspace_von_mises", "MPa", "the same of a half-space",
        [](const P& p) { return p.flat_von_mises.value; }},
       {"halfspace_von_mises_depth", "mm", "how deep", [](const P& p) { return p.flat_von_mises.at.depth; }},
       {"halfspace_largest_shear", "MPa", "the same of a half-space",
        [](const P& p) { return p.flat_shear.value; }},
       {"halfspace_largest_shear_depth", "mm", "how deep", [](const P& p) { return p.flat_shear.at.depth; }},
       {"von_mises_change", "1", "what the body has more than the half-space, over the latter",
        [](const P& p) { return p.von_mises_change; }, Missing::possible},
       {"largest_shear_change", "1", "the same of the largest shear stress",
        [](const P& p) { return p.shear_change; }, Missing::possible}}};
  return columns;
}

std::string in_words(const StressesInside& inside, const AreaStresses& area) {
  const AreaPeaks p = peaks_of(inside, area);
  const std::string where = inside.body.empty() ? "a half-space" : inside.body;
  std::string out =
      fmt::format("von Mises {:.0f} +- {:.0f} MPa {:.2f} mm deep, largest shear {:.0f} +- {:.0f} MPa "
                  "{:.2f} mm deep in {}",
                  p.von_mises.value.value, p.von_mises.value.error, p.von_mises.at.depth, p.shear.value.value,
                  p.shear.value.error, p.shear.at.depth, where);
  if (!area.body.empty())
    out += fmt::format("; a half-space has {:.0f} and {:.0f} MPa: the body {:+.1f} % and {:+.1f} %",
                       p.flat_von_mises.value.value, p.flat_shear.value.value, 100 * p.von_mises_change,
                       100 * p.shear_change);
  return out;
}

namespace {

using halfspace::Stress;

struct Component6 {
  const char *name, *meaning;
  double Stress::*member;
};
constexpr Component6 components[] = {{"xx", "stress xx, tension positive", &Stress::xx},
                                     {"ss", "stress ss", &Stress::ss},
                                     {"nn", "stress nn", &Stress::nn},
                                     {"xs", "shear stress xs", &Stress::xs},
                                     {"xn", "shear stress xn", &Stress::xn},
                                     {"sn", "shear stress sn", &Stress::sn}};

std::vector<std::size_t> shape_of(const AreaStresses& area) {
  return area.rows > 0 ? std::vector<std::size_t>{area.rows, area.depths}
                       : std::vector<std::size_t>{area.points.size()};
}

void add_tensors(const AreaStresses& area, const std::vector<Passage>& stresses, const std::string& prefix,
                 const std::string& of, record::Record& out) {
  std::vector<std::size_t> shape = shape_of(area);
  shape.push_back(area.x.size());
  for (const Component6& c : components) {
    std::vector<double> values;
    values.reserve(stresses.size() * area.x.size());
    for (const Passage& passage : stresses)
      for (const Stress& t : passage)
        values.push_back(t.*c.member);
    out.add(prefix + c.name, record::field(std::move(values), "MPa", c.meaning + of, shape));
  }
}

/// What is largest over the passage, at each point.
void add_maps(const AreaStresses& area, const std::vector<Passage>& stresses, const std::string& prefix,
              const std::string& of, record::Record& out) {
  const auto map = [&](const char* name, const char* meaning, double (*measure)(const Stress&)) {
    std::vector<double> values;
    for (const Passage& passage : stresses) {
      double largest = passage.empty() ? std::numeric_limits<double>::quiet_NaN() : measure(passage.front());
      for (const Stress& t : passage)
        largest = std::max(largest, measure(t));
      values.push_back(largest);
    }
    out.add(prefix + name, record::field(std::move(values), "MPa", meaning + of, shape_of(area)));
  };
  map("von_mises", "largest stress of von Mises over the passage", halfspace::von_mises);
  map("largest_shear", "largest shear stress over the passage", [](const Stress& t) {
    return std::isfinite(t.xx) ? halfspace::largest_shear(t) : std::numeric_limits<double>::quiet_NaN();
  });
  map("mean_stress", "largest hydrostatic stress over the passage",
      [](const Stress& t) { return (t.xx + t.ss + t.nn) / 3; });
}

record::Record section_record(const StressesInside& inside, const AreaStresses& area) {
  std::vector<double> s, depth, y, z;
  for (const BelowSurface& p : area.points) {
    s.push_back(p.s);
    depth.push_back(p.depth);
  }
  if (area.rows > 0) { // of a block
    std::vector<double> first;
    for (std::size_t is = 0; is < area.rows; ++is)
      first.push_back(s[is * area.depths]);
    s = std::move(first);
    depth.resize(area.depths);
  }
  using record::field;
  using record::Number;
  record::Record out{
      {"in_words", record::Text{in_words(inside, area)}},
      {"pmax", Number{area.pmax, "MPa", "largest pressure"}},
      {"curvature", Number{area.curvature, "1/mm", "of the body's surface there; above 0: convex"}},
      {"s", field(std::move(s), "mm", "of the points, arc length along the body's profile")},
      {"depth", field(std::move(depth), "mm", "of the points below the surface")},
      {"x", field(area.x, "mm", "places of the points while the load passes")}};
  if (!area.positions.empty()) {
    for (const Point2 p : area.positions) {
      y.push_back(p.y);
      z.push_back(p.z);
    }
    out.add("y", field(std::move(y), "mm", "of the points, frame of the body's profile", shape_of(area)));
    out.add("z", field(std::move(z), "mm", "the same, down", shape_of(area)));
  }
  add_maps(area, area.best(), "", "", out);
  if (!area.body.empty()) {
    out.add("error", field(area.error, "MPa", "what the body's stresses may be off, as von Mises' stress",
                           shape_of(area)));
    add_maps(area, area.flat, "halfspace_", ", of a half-space", out);
    add_tensors(area, area.body, "", "", out);
  }
  add_tensors(area, area.flat, "halfspace_", ", of a half-space", out);
  if (area.section) {
    std::vector<double> columns(area.section->columns.begin(), area.section->columns.end());
    out.add("columns", field(std::move(columns), "1", "of the grid, places of the passage"));
    out.add("s_knots", field(area.section->s_knots, "mm", "of residual stresses, along the surface"));
    out.add("depth_knots", field(area.section->depth_knots, "mm", "of residual stresses, below it"));
    out.add("size", Number{area.section->size, "mm", "smaller half width of the patch"});
  }
  return out;
}

} // namespace

record::Record record_of(const StressesInside& inside) {
  using record::Number;
  std::vector<AreaPeaks> peaks;
  for (const AreaStresses& area : inside.areas)
    peaks.push_back(peaks_of(inside, area));
  record::Record sections;
  for (std::size_t k = 0; k < inside.areas.size(); ++k)
    sections.add(fmt::format("{}", k + 1), section_record(inside, inside.areas[k]));
  record::Record out{
      {"side", record::Text{std::string(name_of(inside.side))}},
      {"body", record::Text{inside.body}},
      {"poisson", Number{inside.poisson, "1", "Poisson's ratio of the body"}},
      {"traction_error",
       Number{inside.traction_error, "1", "of the largest pressure, over it; 0: not known"}},
      {"unknowns", Number{double(inside.unknowns), "1", "of the section's solutions", {}, true}},
      {"wavenumbers", Number{double(inside.wavenumbers), "1", "of them", {}, true}},
      {"patches", record::as_rows(record::table_of("patch", peak_columns(), peaks))}};
  if (!inside.areas.empty())
    out.add("in_words", record::Text{in_words(inside, inside.areas.front())});
  return std::move(out.add("sections", std::move(sections)));
}

namespace {

[[noreturn]] void refuse_stresses(const std::string& why) {
  throw InputError("This is no file of stresses", why,
                   "Give what bem_contact stresses -o or fem_influence --stresses wrote.");
}

class Reader {
public:
  Reader(const record::Record& file, std::string folder) : file_(file), folder_(std::move(folder)) {}

  std::vector<double> values(const std::string& name) const {
    const std::span<const double> found = record::values_at(file_, folder_ + name);
    return {found.begin(), found.end()};
  }
  /// Of points and places, which must be numbers.
  std::vector<double> places(const std::string& name) const {
    std::vector<double> out = values(name);
    if (!std::ranges::all_of(out, [](double v) { return std::isfinite(v); }))
      refuse_stresses(fmt::format("'{}{}' has an entry that is no number", folder_, name));
    return out;
  }
  bool holds(const std::string& name) const { return record::has(file_, folder_ + name); }
  double number(const std::string& name) const {
    const auto found = record::number_at(file_, folder_ + name);
    if (!found || !std::isfinite(*found))
      refuse_stresses(fmt::format("'{}{}' is missing or no number", folder_, name));
    return *found;
  }
  std::vector<Passage> tensors(const std::string& prefix, std::size_t points, std::size_t places) const {
    std::vector<Passage> out(points, Passage(places));
    for (const Component6& c : components) {
      const std::vector<double> field = values(prefix + c.name);
      if (field.size() != points * places)
        refuse_stresses(
            fmt::format("'{}{}{}' does not have a value for each point and place", folder_, prefix, c.name));
      for (std::size_t i = 0; i < field.size(); ++i)
        out[i / places][i % places].*c.member = field[i];
    }
    return out;
  }

private:
  const record::Record& file_;
  std::string folder_;
};

AreaStresses area_from(const Reader& read, bool has_body) {
  AreaStresses out;
  const std::vector<double> s = read.places("s"), depth = read.places("depth");
  out.x = read.places("x");
  if (s.empty() || depth.empty() || out.x.empty())
    refuse_stresses("it has no points");
  if (read.holds("s_knots")) {
    out.rows = s.size();
    out.depths = depth.size();
    Section section{s, depth, {}, read.places("s_knots"), read.places("depth_knots"), read.number("size")};
    for (const double column : read.places("columns"))
      section.columns.push_back(static_cast<int>(column));
    if (section.columns.size() != out.x.size() || section.s_knots.size() < 2 ||
        section.depth_knots.size() < 2)
      refuse_stresses("its sections are not whole");
    out.points = section.points();
    out.section = std::move(section);
  } else {
    if (s.size() != depth.size())
      refuse_stresses("its points are not whole");
    for (std::size_t i = 0; i < s.size(); ++i)
      out.points.push_back({s[i], depth[i]});
  }
  const std::vector<double> y = read.values("y"), z = read.values("z");
  if (y.size() == out.points.size() && z.size() == y.size())
    for (std::size_t i = 0; i < y.size(); ++i)
      out.positions.push_back({y[i], z[i]});
  out.pmax = read.number("pmax");
  out.curvature = read.number("curvature");
  out.flat = read.tensors("halfspace_", out.points.size(), out.x.size());
  if (has_body) {
    out.body = read.tensors("", out.points.size(), out.x.size());
    out.error = read.values("error");
    if (out.error.size() != out.points.size())
      refuse_stresses("its errors are not whole");
  }
  return out;
}

} // namespace

StressesInside stresses_from(const record::Record& file) {
  if (record::text_at(file, "format") != std::string_view(stresses_format))
    refuse_stresses("it is of another kind");
  const Reader top(file, "");
  StressesInside out;
  const auto side = value_named<Side>(record::text_at(file, "side").value_or(""));
  if (!side)
    refuse_stresses("'side' is missing, or names no body");
  out.side = *side;
  out.body = record::text_at(file, "body").value_or("");
  out.poisson = top.number("poisson");
  out.traction_error = top.number("traction_error");
  out.unknowns = static_cast<std::size_t>(top.number("unknowns"));
  out.wavenumbers = static_cast<std::size_t>(top.number("wavenumbers"));
  for (std::size_t k = 1; record::has(file, fmt::format("sections/{}/s", k)); ++k)
    out.areas.push_back(area_from(Reader(file, fmt::format("sections/{}/", k)), !out.body.empty()));
  if (out.areas.empty())
    refuse_stresses("it has no sections");
  return out;
}

} // namespace bem_contact::inside
