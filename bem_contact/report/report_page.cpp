#include "bem_contact/report/report_page.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/report/mesh_file.hpp"
#include "bem_contact/report/scene_values.hpp"
#include "bem_contact/report/settings.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <ostream>
#include <utility>
#include <variant>

// embedded.S; each ends with a NUL. The modules of a page are one script (CMakeLists.txt).
extern "C" {
extern const char report_page_html[], report_page_css[], report_page_js[], report_plotting_library_txt[];
}

namespace bem_contact::report {

namespace {

using record::Record;

std::string page_of(const Record& file, const std::filesystem::path& path) {
  if (const FileKind* kind = kind_of(record::text_at(file, "format").value_or("")); kind && *kind->page)
    return kind->page;
  if (record::has(file, "stations") && (record::has(file, "kernel") || record::has(file, "table")))
    return "influence file";
  throw InputError(
      fmt::format("'{}' cannot be reported", path.string()),
      "it is HDF5, but no file of answers of bem_contact and no influence file",
      "Name a file that solve, compare, sweep, creep-curves, fit, conicity, wheelset, table, wear, "
      "fatigue, stresses, shakedown or study of bem_contact wrote, or an influence file.");
}

/// What no figure draws.
bool left_out(std::string_view path) {
  if (!path.starts_with("data/"))
    return false;
  if (path == "data/table") // the numbers of an influence file without a kernel
    return true;
  std::string_view name = path.substr(5);
  if (name.starts_with("parts/")) // of a study
    name =
        name.substr(std::min(name.size(), name.find('/', 6))).substr(name.find('/', 6) == name.npos ? 0 : 1);
  constexpr std::array fields{"u_x",           "u_s",
                              "u_n",           "friction_work_density",
                              "friction_work", "deformed_distance",
                              "largest_shear", "stress",
                              "kernel",        "remote",
                              "remote_self",   "wavenumber"};
  const std::string_view last = name.substr(name.rfind('/') + 1);
  constexpr std::array of_cases{"reason", "model", "side", "frame", "friction", "quantities",
                                "dx",     "ds",    "x",    "s",     "y",        "z",
                                "delta",  "state", "p_n",  "p_x",   "p_s"};
  if (name.starts_with("sections/") || name.starts_with("patches/")) { // all of stresses but their tensors
    constexpr std::array tensors{"xx", "ss", "nn", "xs", "xn", "sn", "columns", "s_knots", "depth_knots"};
    constexpr std::string_view of_flat = "halfspace_";
    const std::string_view component = last.starts_with(of_flat) ? last.substr(of_flat.size()) : last;
    return name.starts_with("sections/") && std::ranges::find(tensors, component) != tensors.end();
  }
  const bool of_case = name.starts_with("cases/") && name.find('/', 6) != name.npos;
  return (of_case && std::ranges::find(of_cases, last) == of_cases.end()) ||
         (name.starts_with("inputs/") && last == "content") || last == "structure" || last == "step_fields" ||
         std::ranges::find(fields, last) != fields.end();
}

/// The profiles of steps spread evenly from the first to the last, where all of them lie beside the file.
Record worn_profiles(const std::filesystem::path& file, int last) {
  Record out;
  int before = -1;
  for (int k = 0; k <= held_steps; ++k) {
    const int step = (last * k + held_steps / 2) / held_steps;
    if (step == std::exchange(before, step))
      continue;
    Record one;
    for (const char* body : {"rail", "wheel"}) {
      const auto profile = file.parent_path() / fmt::format("{}_{:04}.txt", body, step);
      if (!file_exists(profile))
        return {};
      std::vector<double> points;
      for (const Point2& point : read_points(profile))
        points.insert(points.end(), {point.y, point.z});
      const std::size_t count = points.size() / 2;
      one.add(body, record::field(std::move(points), "mm", "profile: y, z", {count, 2}));
    }
    out.add(fmt::format("{}", step), std::move(one));
  }
  return out;
}

/// What a page shows of a file that bem_contact wrote, of an influence file or of a mesh.
///
/// "kind" says which of these, "file" its name, and "data" holds what is in the file (to_described_json()).
/// Left out is what no figure draws: displacements, fields of single steps, stresses by point, fields of a
/// sweep's cases. Of wear, "steps" has up to five profiles of each body ([y, z] of each point), which lie
/// beside the file. Throws InputError for any other file.
Record report_data(const std::filesystem::path& file) {
  if (file.extension() == mesh_ending)
    return {{"kind", record::Text{"mesh"}},
            {"file", record::Text{file.filename().string()}},
            {"data", mesh_data(file)}};
  Record data = record::read_hdf5_top(file, "patches"); // the fields of a sweep's cases may be large
  const std::string kind = page_of(data, file);
  std::error_code unknown;
  if (kind != "sweep" || std::filesystem::file_size(file, unknown) <= largest_with_fields)
    data = record::read_hdf5(file);
  Record out{{"kind", record::Text{kind}}, {"file", record::Text{file.filename().string()}}};
  const bool study = kind == "study";
  if (kind == "wear" || (study && record::has(data, "parts/wear/step")))
    out.add("steps",
            worn_profiles(
                study ? file.parent_path() / "parts" / "wear" / "wear.h5" : file,
                static_cast<int>(record::values_at(data, study ? "parts/wear/step" : "step").size()) - 1));
  return out.add("data", std::move(data));
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

void require_library() {
  if (*report_plotting_library_txt == '\0')
    throw InputError("This build draws no pages",
                     "one of the Debian packages python3-plotly and esbuild was missing when it was built",
                     "Run tools/install_packages contact-only, configure again (cmake --fresh) and build.");
}

Record said_of(const Record& answer) {
  const record::Found found = record::found_in(answer);
  Record next;
  for (const record::NextQuestion& one : found.next)
    next.add(fmt::format("{}", next.entries().size()),
             Record{{"asks", record::Text{one.asks}}, {"command", record::Text{one.command}}});
  return {{"found", record::Texts{found.sentences, "what was found"}},
          {"next", std::move(next)},
          {"scene_values", scene_values(record::text_at(answer, "scene_with_defaults").value_or(""))}};
}

/// With what was found and asked, of a study in each part too.
Record with_words(Record page) {
  const Record& data = std::get<Record>(*record::find(page, "data"));
  Record parts, out = said_of(data);
  if (const auto* all = record::find(data, "parts"); all && std::holds_alternative<Record>(*all))
    for (const auto& [name, one] : std::get<Record>(*all).entries())
      if (const auto* part = std::get_if<Record>(&one))
        parts.add(name, said_of(*part));
  out.add("parts", std::move(parts));
  return std::move(out.append(std::move(page)));
}

std::string report_page(Record data) {
  return page_with_figures({.html = report_page_html, .style = report_page_css, .script = report_page_js},
                           record::to_described_json(with_words(std::move(data)), left_out));
}

void write_page(Record data, const std::filesystem::path& output) {
  const std::string page = report_page(std::move(data));
  write_text(output, [&](std::ostream& out) { out << page; });
}

} // namespace

std::string page_with_figures(const PageParts& parts, std::string data) {
  require_library();
  replace_all(data, "</", "<\\/"); // no text of a scene ends the script that holds it
  replace_all(data, "<!--", "<\\u0021--");
  std::string page(parts.html);
  const std::array<std::pair<std::string_view, std::string_view>, 4> places{
      {{"@STYLE@", parts.style},
       {"@SCRIPT@", parts.script},
       {"@LIBRARY@", report_plotting_library_txt},
       {"@DATA@", data}}};
  for (const auto& [name, part] : places)
    page.replace(page.find(name), name.size(), part);
  return page;
}

std::string page_of_record(const Record& file, const std::string& name) {
  return report_page(
      {{"kind", record::Text{page_of(file, name)}}, {"file", record::Text{name}}, {"data", file}});
}

void write_profile_page(const std::string& name, const std::string& words,
                        const std::vector<DrawnProfile>& profiles, const std::filesystem::path& output) {
  Record drawn;
  for (const DrawnProfile& p : profiles)
    drawn.add(fmt::format("{}", drawn.entries().size()),
              Record{{"name", record::Text{p.name}},
                     {"y", record::field(p.y, "mm", "across the track")},
                     {"z", record::field(p.z, "mm", "down")},
                     {"curvature", record::field(p.curvature, "1/mm", "of the profile")}});
  write_page({{"kind", record::Text{"profile"}},
              {"file", record::Text{name}},
              {"data", Record{{"words", record::Text{words}}, {"profiles", std::move(drawn)}}}},
             output);
}

void write_sections_page(const std::string& name, const std::string& words, const record::Table& points,
                         const std::filesystem::path& output) {
  write_page({{"kind", record::Text{"sections"}},
              {"file", record::Text{name}},
              {"data", Record{{"words", record::Text{words}}, {"section_lines", points}}}},
             output);
}

void write_report(const std::filesystem::path& file, const std::filesystem::path& output) {
  require_outputs({file}, {{.option = "--output", .file = output, .required = true}});
  write_page(report_data(file), output);
}

} // namespace bem_contact::report
