#include "bem_contact/app/from_contact/scene_text.hpp"

#include "bem_contact/app/from_contact/histories.hpp"
#include "bem_contact/base/schema_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact::app::from_contact {

namespace {

/// A profile as a scene in `folder` names it.
std::string profile_beside(const std::string& value, const std::filesystem::path& folder) {
  const std::filesystem::path file = value.substr(1, value.size() - 2);
  return toml_text(
      file.lexically_proximate(std::filesystem::absolute(folder).lexically_normal()).generic_string());
}

} // namespace

std::string name_of_table(const std::string& stem, const SceneTableFile& table) {
  return fmt::format("{}_{}.csv", stem, table.key.substr(table.key.find('.') + 1));
}

std::vector<SceneTableFile> tables_of_case(const ContactCase& one) {
  std::vector<SceneTableFile> out = one.tables;
  if (needs_step_table(one))
    out.push_back({"motion.step_table", step_table(one)});
  return out;
}

std::string scene_of_case(const ContactCase& one, const std::filesystem::path& input,
                          const std::filesystem::path& folder, const std::string& stem) {
  std::string out = fmt::format("# {} of {}, written by bem_contact from-contact.\n",
                                one.first == one.last ? fmt::format("Case {}", one.first)
                                                      : fmt::format("Cases {} to {}", one.first, one.last),
                                input.filename().string());
  for (const std::string& sentence : one.left_out)
    out += fmt::format("# Left out: {}.\n", sentence);
  const bool slips =
      std::ranges::any_of(one.tables, [](const auto& t) { return t.key == "motion.slip_table"; });
  for (const auto& [key, value] : one.keys) {
    const bool creepage = key == "motion.xi" || key == "motion.eta" || key == "motion.phi";
    if (!(creepage && (slips || needs_step_table(one)))) // the table has them
      out += fmt::format("{} = {}\n", key, key.ends_with(".profile") ? profile_beside(value, folder) : value);
  }
  if (!one.steps.empty() && !needs_step_table(one))
    out += fmt::format("motion.steps = {}\n", one.steps.size());
  for (const SceneTableFile& table : tables_of_case(one))
    out += fmt::format("{} = {}\n", table.key, toml_text(name_of_table(stem, table)));
  return out;
}

} // namespace bem_contact::app::from_contact
