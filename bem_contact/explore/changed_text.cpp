#include "bem_contact/explore/changed_text.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string_view>

namespace bem_contact::explore {

namespace {

/// Where a place of the library, counted in characters from 1, lies in the text.
std::size_t byte_at(std::string_view text, const toml::source_position& place) {
  std::size_t at = 0;
  for (auto line = place.line; line > 1 && at != std::string_view::npos; --line)
    at = text.find('\n', at) + 1;
  for (auto column = place.column; column > 1 && at < text.size(); --column)
    do
      ++at;
    while (at < text.size() &&
           (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80); // a later byte of one character
  return at;
}

/// The end of the line "[table]"; nothing if the text has none.
std::optional<std::size_t> end_of_header(std::string_view text, std::string_view table) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line(text.substr(at, end - at));
    line = line.substr(0, line.find('#'));
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    if (line == fmt::format("[{}]", table))
      return end;
    at = end + 1;
  }
  return {};
}

/// Before the first header of a table, behind which a key without one would belong to that table.
std::size_t end_of_root(std::string_view text) {
  if (text.starts_with('['))
    return 0;
  const std::size_t header = text.find("\n[");
  return header == std::string_view::npos ? text.size() : header + 1;
}

/// Writes a key that the text does not have: into { ... }, behind the header of its table, or before all
/// tables.
void insert_value(std::string& text, const toml::table& root, const std::string& key,
                  const std::string& value) {
  for (std::size_t dot = key.rfind('.'); dot != std::string::npos && dot > 0; dot = key.rfind('.', dot - 1)) {
    const std::string name = key.substr(0, dot), entry = fmt::format("{} = {}", key.substr(dot + 1), value);
    const toml::table* table = root.at_path(name).as_table();
    if (table && table->is_inline()) {
      text.insert(byte_at(text, table->source().begin) + 1,
                  fmt::format(" {}{}", entry, table->empty() ? " " : ","));
      return;
    }
    if (const auto end = end_of_header(text, name)) {
      text.insert(*end, "\n" + entry);
      return;
    }
  }
  const std::size_t at = end_of_root(text);
  const bool on_a_line = at == 0 || text[at - 1] == '\n';
  text.insert(at, fmt::format("{}{} = {}\n", on_a_line ? "" : "\n", key, value));
}

void set_value(std::string& text, const std::string& key, const std::string& value) {
  const toml::table root = parse_toml(text);
  if (const auto node = root.at_path(key)) {
    const toml::source_region& place = node.node()->source();
    const std::size_t from = byte_at(text, place.begin), to = byte_at(text, place.end);
    text.replace(from, to - from, value);
  } else
    insert_value(text, root, key, value);
}

/// Whether two scenes are the same but for remarks on their texts.
bool same_scene(SceneFile a, SceneFile b) {
  a.unused.clear();
  b.unused.clear();
  return a == b;
}

} // namespace

std::string changed_text(const SceneText& given, std::span<const SceneChange> changes) {
  const SceneFile wanted = parse_scene_file(given, changes);
  SceneText text = given;
  try {
    for (const SceneChange& change : changes)
      set_value(text.toml, change.key, to_text(change.value));
    if (same_scene(parse_scene_file(text), wanted))
      return text.toml;
  } catch (const InputError&) { // the text has a form that is not foreseen here
  } catch (const toml::parse_error&) {
  }
  return scene_with_defaults(wanted);
}

} // namespace bem_contact::explore
