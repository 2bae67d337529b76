#include "bem_contact/scene/sweep_file.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/scene/case_table.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/passage.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/scene/value_range.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace bem_contact {

namespace {

/// Cases. More keep no fields unless the scene asks for them: of so many they are 0.2 GB. Chosen.
constexpr std::size_t most_with_fields = 1000;
struct Reader {
  SweepFile& sweep;
  std::string_view section; ///< "sweep", "sweep.together", or "table", which has axes and options of
                            ///< the command
  int table_line = 0;       ///< of a CSV file of lists
  std::filesystem::path table_file = {};
  std::map<std::string, std::string> renamed = {}; ///< columns of it
  int columns_line = 0;
  bool zip = false;
  std::vector<SweepFile::Axis> together = {}; ///< the lists of sweep.together

  [[noreturn]] void refuse(int line, const std::string& problem, const std::string& why,
                           const std::string& what_to_do) const {
    throw InputError(fmt::format("{}:{}: {}", sweep.text.source, line, problem), why, what_to_do);
  }

  void table(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : table) {
      const std::string key =
          prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
      const int line = static_cast<int>(name.source().begin.line);
      const toml::table* inner = node.as_table();
      const bool is_sweep = section == "sweep";
      if (prefix.empty())
        require_no_misspelt_option(key, line);
      if (is_sweep && key == "together")
        groups(node, line);
      else if (is_sweep && key == "mode")
        mode(node, line);
      else if (is_sweep && key == "fields" && node.is_boolean())
        sweep.fields = *node.value<bool>();
      else if (is_sweep && key == "weight")
        weights(node, line);
      else if (section != "table" && key == "table")
        case_table(node, line);
      else if (section != "table" && key == "columns")
        columns(node, line);
      else if (inner && is_range(*inner))
        sweep.axes.push_back({key, range(*inner, key, line), line, true});
      else if (inner)
        this->table(*inner, key);
      else if (section == "table" && prefix.empty() && !inner && !node.is_array())
        continue; // an option of the command table
      else if (const toml::array* list = node.as_array())
        sweep.axes.push_back({key, values(*list, key, line), line});
      else
        refuse(line, fmt::format("{}.{} is a single value", section, key),
               fmt::format("a {} needs a list or a range", section),
               fmt::format(
                   "Give a list [a, b, ...] or {{ from = a, to = b, step = c }}, or move it out of [{}].",
                   section));
    }
  }

  static bool is_range(const toml::table& table) {
    return std::ranges::any_of(keys_of_ranges, [&](std::string_view key) { return table.contains(key); });
  }

  /// Throws InputError for a name that no table of scenes has and that is most like one of the section's own
  /// keys: else it would be taken for a list without values.
  void require_no_misspelt_option(const std::string& name, int line) const {
    std::vector<std::string> own{"table", "columns"};
    if (section == "sweep")
      own.insert(own.end(), {"together", "mode", "fields", "weight"});
    if (section == "table" || std::ranges::find(own, name) != own.end())
      return;
    std::vector<std::string> known = first_names_of_scenes();
    if (std::ranges::find(known, name) != known.end())
      return;
    known.insert(known.begin(), own.begin(), own.end());
    if (const auto like = nearest_names(name, known, 1);
        !like.empty() && std::ranges::find(own, like[0]) != own.end())
      refuse(line, fmt::format("unknown key '{}.{}'", section, name), "neither this table nor a scene has it",
             fmt::format("Did you mean {}.{}?", section, like[0]));
  }

  /// Lists side by side: one list of the product.
  void join(std::vector<SweepFile::Axis>& axes) const {
    for (std::size_t k = 1; k < axes.size(); ++k) {
      axes[k].beside = true;
      if (axes[k].values.size() != axes[0].values.size())
        refuse(axes[k].line, "the lists cannot be zipped",
               fmt::format("{} has {} and {} has {}", axes[0].key,
                           counted(axes[0].values.size(), "value", "values"), axes[k].key,
                           axes[k].values.size()),
               section == "sweep" ? "Give lists of equal lengths, or mode = \"product\"."
                                  : "Give lists of equal lengths.");
    }
  }

  void groups(const toml::node& node, int line) {
    const toml::array* all = node.as_array();
    if (!all || !std::ranges::all_of(*all, &toml::node::is_table))
      refuse(line, "sweep.together has no lists", "it is a list of tables, each with lists side by side",
             "Give [[sweep.together]] and below it rail.profile = [...] and rail.influence = [...].");
    for (const toml::node& one : *all) {
      SweepFile group{sweep.text};
      Reader reader{group, "sweep.together"};
      reader.table(*one.as_table(), "");
      reader.finish(false);
      std::ranges::move(group.axes, std::back_inserter(together));
      std::ranges::move(group.tables, std::back_inserter(sweep.tables));
    }
  }

  /// After all else is read: the cases of a table, and which lists go side by side.
  void finish(bool mode_given) {
    std::ranges::stable_sort(sweep.axes, {}, &SweepFile::Axis::line);
    if (columns_line > 0 && table_line == 0)
      refuse(columns_line, fmt::format("{}.columns is given without a table", section),
             "it says what columns of a table are", fmt::format("Give {}.table, or leave it out.", section));
    if (table_line > 0)
      cases_of_table(mode_given);
    if (zip || section == "sweep.together")
      join(sweep.axes);
  }

  void cases_of_table(bool mode_given) {
    if (!sweep.axes.empty() || !sweep.weights.empty() || mode_given)
      refuse(table_line, fmt::format("{}.table is given beside lists, weights or a mode", section),
             "its columns are the lists, its lines the cases", "Give either the table or lists.");
    CaseTable cases = read_case_table(table_file, renamed);
    for (CaseTable::Column& column : cases.columns)
      sweep.axes.push_back({std::move(column.key), std::move(column.values), table_line, false, false,
                            sweep.tables.back().file.string(), cases.lines});
    sweep.weights = std::move(cases.weights);
    if (section != "sweep" && !sweep.weights.empty())
      refuse(table_line, "a table of sweep.together has weights",
             "weights belong to the load collective, which is swept with every pair of bodies",
             "Remove the column weight.");
    zip = true;
  }

  void columns(const toml::node& node, int line) {
    const toml::table* names = node.as_table();
    if (!names || !std::ranges::all_of(*names, [](const auto& one) { return one.second.is_string(); }))
      refuse(line, fmt::format("{}.columns cannot be that", section),
             "it says of columns of the table which key each is",
             "Give for instance columns = { time = \"note\", y = \"position.lateral\" }.");
    for (const auto& [name, meaning] : *names)
      renamed.emplace(name.str(), meaning.value_or(std::string()));
    columns_line = line;
  }

  void mode(const toml::node& node, int line) {
    const auto mode = node.value<std::string>();
    if (mode != "product" && mode != "zip")
      refuse(line, "sweep.mode cannot be that", "known are product and zip", "Use one of these.");
    zip = mode == "zip";
  }

  void weights(const toml::node& node, int line) {
    const toml::array* list = node.as_array();
    if (!list)
      refuse(line, "sweep.weight is no list", "each case has a weight of its own", "Give [a, b, ...].");
    for (const toml::node& one : *list) {
      const auto weight = one.value<double>();
      if (!weight || !std::isfinite(*weight) || *weight <= 0)
        refuse(line, "sweep.weight holds something that is no weight", "weights are positive numbers",
               "Correct the list.");
      sweep.weights.push_back(*weight);
    }
  }

  void case_table(const toml::node& node, int line) {
    const std::string name = node.value<std::string>().value_or("");
    if (name.empty())
      refuse(line, fmt::format("{}.table names no file", section),
             "it is the name of a CSV file with one line a case", "Give table = \"FILE.csv\".");
    table_file = sweep.text.folder / name;
    sweep.tables.push_back({fmt::format("{}.table", section), name, table_file});
    table_line = line;
  }

  std::vector<SchemaValue> range(const toml::table& ends, const std::string& key, int line) const {
    return values_of_range(ends, fmt::format("{}.{}", section, key),
                           fmt::format("{}:{}: ", sweep.text.source, line));
  }

  std::vector<SchemaValue> values(const toml::array& list, const std::string& key, int line) const {
    std::vector<SchemaValue> out;
    for (const toml::node& node : list) {
      node.visit([&](const auto& value) {
        if constexpr (toml::is_integer<decltype(value)> || toml::is_floating_point<decltype(value)> ||
                      toml::is_boolean<decltype(value)> || toml::is_string<decltype(value)>)
          out.emplace_back(value.get());
        else
          refuse(line, fmt::format("{}.{} holds something that is no value", section, key),
                 "its elements must be numbers, texts, true or false", "Correct the list.");
      });
    }
    if (out.empty())
      refuse(line, fmt::format("{}.{} is empty", section, key), "there is nothing to solve", "Give values.");
    return out;
  }
};

} // namespace

std::string SweepFile::Axis::unit() const {
  return key == time_note ? "s" : unit_of_key(key);
}

std::size_t SweepFile::size() const {
  std::size_t n = 1;
  for (const Axis& axis : axes)
    n *= axis.beside ? 1 : axis.values.size();
  return n;
}

bool SweepFile::keeps_fields() const {
  return fields.value_or(size() <= most_with_fields);
}

std::vector<std::size_t> SweepFile::indices(std::size_t index) const {
  std::vector<std::size_t> out(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    out[a] = index % axes[a].values.size();
    if (!axes[a].beside)
      index /= axes[a].values.size();
  }
  return out;
}

std::vector<SceneChange> SweepFile::changes(std::size_t index) const {
  const std::vector<std::size_t> at = indices(index);
  std::vector<SceneChange> out;
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (const Axis& axis = axes[a]; !axis.is_note())
      out.push_back(
          {axis.key, axis.values[at[a]], axis.lines.empty() ? axis.line : axis.lines[at[a]], axis.table});
  return out;
}

SceneFile SweepFile::scene(std::size_t index) const {
  return SweepScenes(*this).scene(index);
}

SceneFile SweepFile::first_scene() const {
  if (std::ranges::all_of(axes, &std::string::empty, &Axis::table))
    return scene(0);
  for (std::size_t i = 0; i < size(); ++i)
    try {
      return scene(i);
    } catch (const InputError&) { // another line may be one
    }
  return scene(0);
}

SceneFile SweepScenes::scene(std::size_t index) {
  if (!reader_)
    reader_.emplace(sweep_.text);
  for (const SceneChange& change : sweep_.changes(index))
    reader_->set(change);
  return reader_->scene();
}

void SweepScenes::require_effect() const {
  std::vector<std::string> swept;
  for (const SweepFile::Axis& axis : sweep_.axes)
    if (axis.values.size() > 1)
      swept.push_back(axis.key);
  reader_->require_effect(swept);
}

std::string SweepFile::describe(std::size_t index) const {
  std::string out;
  const std::vector<std::size_t> at = indices(index);
  for (std::size_t a = 0; a < axes.size(); ++a)
    out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", axes[a].key, to_text(axes[a].values[at[a]]));
  return out;
}

bool has_sweep(const SceneText& given, std::string_view section) {
  try {
    const toml::table root = parse_toml(given.toml);
    return root.contains(section) || (section == "sweep" && root.contains("passage"));
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
    return false;
  }
}

namespace {

/// Throws InputError where there is no list, too many cases, a key twice, or another number of weights than
/// of cases.
void require_cases(const SweepFile& sweep, const std::vector<SweepFile::Axis>& together,
                   std::string_view section) {
  const std::string& source = sweep.text.source;
  std::vector<const SweepFile::Axis*> all;
  for (const auto* axes : {&together, &sweep.axes})
    for (const SweepFile::Axis& axis : *axes)
      all.push_back(&axis);
  if (all.empty()) {
    require_no_misspelt_section(sweep.text, section);
    throw InputError(
        fmt::format("'{}' describes no {}", source, section),
        fmt::format("it has no table [{}] with lists", section),
        fmt::format("Add one, for instance [{}] with position.lateral = {{ from = 6.2, to = 7.1, "
                    "step = 0.05 }} below it.",
                    section));
  }
  double cases = 1;
  std::set<std::string_view> keys;
  for (const SweepFile::Axis* axis : all) {
    if (!axis->beside)
      cases *= double(axis->values.size());
    if (!keys.insert(axis->key).second)
      throw InputError(fmt::format("{}:{}: {}.{} is given twice", source, axis->line, section, axis->key),
                       "each key has one list", "Remove one.");
  }
  const bool product = cases > double(all.back()->values.size());
  if (product && cases > double(most_cases))
    throw InputError(fmt::format("'{}' has {:.3g} cases", source, cases),
                     fmt::format("at most {} are possible", most_cases), "Sweep over fewer values.");
  if (!sweep.weights.empty() && sweep.weights.size() != sweep.size())
    throw InputError(fmt::format("'{}' has {}", source, counted(sweep.weights.size(), "weight", "weights")),
                     fmt::format("{} has {}", together.empty() ? "it" : "a pair of bodies",
                                 counted(sweep.size(), "case", "cases")),
                     "Give one weight for each case.");
}

} // namespace

SweepFile parse_sweep_file(SceneText given, std::string_view section) {
  SweepFile sweep{std::move(given)};
  const std::string& source = sweep.text.source;
  require_text(sweep.text.toml, source, fmt::format("scene with a table [{}]", section));
  toml::table root;
  try {
    root = parse_toml(sweep.text.toml, source);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", source, error.source().begin.line, error.description()),
                     "the file is not valid TOML", "Correct the line.");
  }
  const toml::table* table = root[section].as_table();
  Reader reader{sweep, section};
  if (table) {
    reader.table(*table, "");
    reader.finish(table->contains("mode"));
  }
  if (const auto passage = root.find("passage"); section == "sweep" && passage != root.end())
    std::ranges::move(
        axes_of_passage(passage->second, static_cast<int>(passage->first.source().begin.line), sweep),
        std::back_inserter(sweep.axes));
  require_cases(sweep, reader.together, section);
  sweep.axes.insert(sweep.axes.begin(), reader.together.begin(), reader.together.end());
  return sweep;
}

SweepFile read_sweep_file(const std::filesystem::path& file) {
  return parse_sweep_file(read_scene_text(file));
}

std::string to_text(const SchemaValue& value) {
  if (const auto* text = std::get_if<std::string>(&value))
    return fmt::format("\"{}\"", *text);
  return std::visit([](const auto& plain) { return fmt::format("{}", plain); }, value);
}

} // namespace bem_contact
