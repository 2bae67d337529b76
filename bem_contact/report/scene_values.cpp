#include "bem_contact/report/scene_values.hpp"

#include "bem_contact/base/toml.hpp"

#include <fmt/format.h>
#include <string>

namespace bem_contact::report {

namespace {

void add_values(const toml::table& table, const std::string& prefix, record::Record& out) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    if (const toml::table* inner = node.as_table())
      add_values(*inner, key + ".", out);
    else if (const auto* text = node.as_string())
      out.add(key, text->get());
    else if (const auto* flag = node.as_boolean())
      out.add(key, std::string(flag->get() ? "true" : "false"));
    else if (const auto number = node.value<double>())
      out.add(key, fmt::format("{}", *number));
  }
}

} // namespace

record::Record scene_values(std::string_view scene) {
  record::Record out;
  try {
    add_values(parse_toml(scene), "", out);
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
  }
  return out;
}

} // namespace bem_contact::report
