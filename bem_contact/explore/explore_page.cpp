#include "bem_contact/explore/explore_page.hpp"

#include "bem_contact/profile/standards/standard_tables.hpp"
#include "bem_contact/report/report_page.hpp"
#include "bem_contact/scene/choices.hpp"

#include <nlohmann/json.hpp>

// embedded.S; each ends with a NUL. The modules of a page are one script (CMakeLists.txt).
extern "C" {
extern const char explore_explore_html[], explore_explore_css[], explore_explore_js[];
}

namespace bem_contact::explore {

namespace {

using nlohmann::json;

json standards_of(ProfileKind kind) {
  json names = json::array();
  for (const StandardEntry& entry : standard_entries())
    if (entry.kind == kind)
      names.push_back(entry.name);
  return names;
}

json models() {
  json all = json::array({{{"name", automatic_model}, {"title", "auto: the cheapest that serves"}}});
  for (const ModelWords& words : model_words)
    all.push_back({{"name", words.name}, {"title", words.title}});
  return all;
}

} // namespace

std::string explore_page(const Start& start) {
  json changes = json::object();
  for (const SceneChange& change : start.changes)
    std::visit([&](const auto& value) { changes[change.key] = value; }, change.value);
  const json data{{"name", start.scene.source},
                  {"file", start.file},
                  {"scene", {{"text", start.scene.toml}, {"changes", changes}, {"files", start.files}}},
                  {"rails", standards_of(ProfileKind::rail)},
                  {"wheels", standards_of(ProfileKind::wheel)},
                  {"folder", start.scene.folder.string()},
                  {"models", models()}};
  return report::page_with_figures(
      {.html = explore_explore_html, .style = explore_explore_css, .script = explore_explore_js},
      data.dump(-1, ' ', false, json::error_handler_t::replace));
}

} // namespace bem_contact::explore
