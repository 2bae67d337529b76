#include "bem_contact/report/report_page.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_kinds.hpp"
#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/report/settings.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

// embedded.S; each ends with a NUL.
extern "C" {
extern const char report_page_html[], report_page_css[], report_page_js[], report_contact_figures_js[],
    report_curve_figures_js[], report_words_js[], report_plotting_library[];
}

namespace bem_contact::report {

namespace {

using nlohmann::json;

std::string kind_of(const H5Table& table, const std::filesystem::path& file) {
  const std::string format = text_attribute(table, "format");
  for (const FileKind& kind : file_kinds)
    if (*kind.page && format.starts_with(fmt::format("bem_contact {}", kind.page))) // of any version
      return kind.page;
  throw InputError(
      fmt::format("'{}' cannot be reported", file.string()),
      "it is HDF5, but no result, comparison, sweep, creep curves, conicity, wheelset or wear",
      "Name a file that bem_contact solve, compare, sweep, creep-curves, conicity, wheelset or wear wrote; "
      "tools/plot draws tables of forces and of fatigue.");
}

/// What no figure draws.
bool left_out(const std::string& name) {
  constexpr std::array fields{
      "u_x", "u_s", "u_n", "work_rate", "element_power", "deformed_distance", "largest_shear", "stress"};
  const std::string last = name.substr(name.rfind('/') + 1);
  return name.starts_with("cases/") || name.starts_with("inputs/") ||
         name.find("structure/") != std::string::npos || std::ranges::find(fields, last) != fields.end();
}

/// The place of "fem/quantities/Fx" in the tree.
json& place(json& tree, const std::string& path) {
  json* at = &tree;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');)
    at = &(*at)[part];
  return *at;
}

json tree_of(const H5Table& table) {
  json tree = json::object();
  for (const auto& [name, data] : table.datasets)
    if (!left_out(name) && data.shape.size() <= 3)
      place(tree, name) = {{"unit", data.unit},
                           {"description", data.description},
                           {"shape", data.shape},
                           {"values", data.values}};
  for (const auto& [name, text] : table.texts)
    if (!left_out(name))
      place(tree, name) = {{"text", text.text}, {"description", text.description}};
  for (const auto& [name, value] : table.attributes) {
    const std::size_t slash = name.rfind('/');
    const std::string group = slash == std::string::npos ? "" : name.substr(0, slash + 1);
    if (group.starts_with("cases/") && !name.ends_with("/reason"))
      continue;
    std::visit([&](const auto& v) { place(tree, group + "attributes/" + name.substr(group.size())) = v; },
               value);
  }
  return tree;
}

/// The profiles of steps spread evenly from the first to the last, where all of them lie beside the file.
json worn_profiles(const std::filesystem::path& file, int last) {
  json out = json::array();
  for (int k = 0; k <= held_steps; ++k) {
    const int step = (last * k + held_steps / 2) / held_steps;
    if (!out.empty() && out.back()["step"] == step)
      continue;
    json one = {{"step", step}};
    for (const char* body : {"rail", "wheel"}) {
      const auto profile = file.parent_path() / fmt::format("{}_{:04}.txt", body, step);
      if (!file_exists(profile))
        return json::array();
      one[body] = json::array();
      for (const Point2& point : read_points(profile))
        one[body].push_back({point.y, point.z});
    }
    out.push_back(std::move(one));
  }
  return out;
}

/// What a page shows of a file that bem_contact wrote: a result, a comparison, a sweep, creep curves,
/// conicity, a wheelset or wear.
///
/// "kind" says which of these, "file" its name, and "data" holds what is in the file, as a tree: a group is
/// an object, its attributes are in "attributes", a dataset is {unit, description, shape, values} (row-major;
/// nan is null), a text {text, description}. Left out is what no figure draws: displacements, fields of
/// single steps, stresses by point, fields of a sweep's cases. Of wear, "steps" has up to five profiles of
/// each body
/// ([y, z] of each point), which lie beside the file. Throws InputError for any other file.
json report_data(const std::filesystem::path& file) {
  H5Table table = read_h5_top(file, "patches"); // the fields of a sweep's cases may be large
  const std::string kind = kind_of(table, file);
  if (kind != "sweep")
    table = read_h5(file);
  json out = {{"kind", kind}, {"file", file.filename().string()}, {"data", tree_of(table)}};
  if (kind == "wear")
    out["steps"] = worn_profiles(file, static_cast<int>(dataset_of(table, "step", file).values.size()) - 1);
  return out;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

/// Throws InputError if this build has no plotting library.
std::string report_page(const json& data) {
  if (*report_plotting_library == '\0')
    throw InputError("This build draws no reports",
                     "the Debian package python3-plotly was missing when it was built",
                     "Run tools/install_packages contact-only, configure again (cmake --fresh) and build.");
  std::string text = data.dump(-1, ' ', false, json::error_handler_t::replace);
  replace_all(text, "</", "<\\/"); // no text of a scene ends the script that holds it
  replace_all(text, "<!--", "<\\u0021--");
  std::string page = report_page_html;
  const std::array<std::pair<std::string, std::string>, 4> parts{
      {{"@STYLE@", report_page_css},
       {"@SCRIPT@",
        std::string(report_contact_figures_js) + report_curve_figures_js + report_words_js + report_page_js},
       {"@LIBRARY@", report_plotting_library},
       {"@DATA@", text}}};
  for (const auto& [name, part] : parts)
    page.replace(page.find(name), name.size(), part);
  return page;
}

void write_page(const json& data, const std::filesystem::path& output) {
  const std::string page = report_page(data);
  write_text(output, [&](std::ostream& out) { out << page; });
}

} // namespace

void write_profile_page(const std::string& name, const std::string& words,
                        const std::vector<DrawnProfile>& profiles, const std::filesystem::path& output) {
  json drawn = json::array();
  for (const DrawnProfile& p : profiles)
    drawn.push_back({{"name", p.name}, {"y", p.y}, {"z", p.z}, {"curvature", p.curvature}});
  write_page({{"kind", "profile"}, {"file", name}, {"data", {{"words", words}, {"profiles", drawn}}}},
             output);
}

void write_report(const std::filesystem::path& file, const std::filesystem::path& output) {
  require_outputs({file}, {{.option = "--output", .file = output, .required = true}});
  write_page(report_data(file), output);
}

} // namespace bem_contact::report
