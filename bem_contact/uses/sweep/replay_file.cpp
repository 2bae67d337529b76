#include "bem_contact/uses/sweep/replay_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace bem_contact {

namespace {

constexpr std::string_view columns_table = "columns", compare_table = "compare", wheels_table = "wheels",
                           placeholder = "{wheel}", time_key = "time";

/// What a left wheel counts to the left (geometry/placement.hpp).
constexpr std::string_view counted_to_the_left[] = {"motion.eta", "motion.phi", "load.force_y",
                                                    "Fy",         "Fs",         "Mz"};

struct KnownUnit {
  std::string_view name, of; ///< as columns have it, and ours
  double factor;
};
constexpr double degree = std::numbers::pi / 180;
constexpr KnownUnit known_units[] = {
    {"um", "mm", 1e-3},           {"m", "mm", 1e3},      {"mrad", "rad", 1e-3},
    {"deg", "rad", degree},       {"kN", "N", 1e3},      {"N m", "N mm", 1e3},
    {"kN m", "N mm", 1e6},        {"1/m", "1/mm", 1e-3}, {"%", "1", 1e-2},
    {"Pa", "MPa", 1e-6},          {"GPa", "MPa", 1e3},   {"m/s", "mm/s", 1e3},
    {"km/h", "mm/s", 1e6 / 3600}, {"ms", "s", 1e-3},     {"m2", "mm2", 1e6},
    {"cm2", "mm2", 1e2}};

/// What the scene says of one column.
struct Named {
  std::string key, column, unit; ///< unit: "" for our own
  double factor = 1;
  int line = 0;
};

class Reader {
public:
  Reader(const SceneText& scene, const ReplayAsked& asked) : scene_(scene), asked_(asked) {
    try {
      root_ = parse_toml(scene.toml, scene.source);
    } catch (const toml::parse_error& error) {
      throw InputError(fmt::format("{}:{}: {}", scene.source, error.source().begin.line, error.description()),
                       "the file is not valid TOML", "Correct the line.");
    }
    side_ = side();
    lines_ = csv_lines(asked.run);
    if (lines_.size() < 2)
      throw InputError(fmt::format("The run '{}' has no steps", asked.run.string()),
                       "it has no line below the names of its columns", "Give one line a step.");
  }

  SweepFile sweep() {
    SweepFile out{scene_};
    out.fields = false;
    out.replay = SweepFile::Replay{.tolerance = asked_.tolerance};
    out.tables.push_back({"replay.run", asked_.run.string(), asked_.run});
    if (!side_.empty())
      out.axes.push_back({"position.side", {SchemaValue(side_)}, line_of(wheels_table)});
    const std::size_t first = out.axes.size();
    for (const Named& named : named_in(columns_table)) {
      const bool is_time = named.key == time_key;
      SweepFile::Axis axis{is_time ? SweepFile::time_note : named.key, {}, named.line};
      if (!is_time)
        require_key(named.key, named.line);
      for (const double value : numbers(named, axis.unit()))
        axis.values.emplace_back(value);
      axis.table = asked_.run.string();
      std::ranges::transform(std::span(lines_).subspan(1), std::back_inserter(axis.lines), &CsvLine::number);
      axis.beside = out.axes.size() > first;
      out.axes.push_back(std::move(axis));
    }
    if (std::ranges::all_of(out.axes, [](const auto& axis) { return axis.is_note() || axis.table.empty(); }))
      throw InputError(fmt::format("'{}' does not say what is in the columns of a run", scene_.source),
                       "it has no table [replay.columns] with a key of the scene",
                       "Add [replay.columns] and below it, for instance, position.lateral = { column = "
                       "\"y\", unit = \"m\" }.");
    for (const Named& named : named_in(compare_table))
      out.replay->compared.push_back(compared(named));
    return out;
  }

private:
  [[noreturn]] void refuse(int line, const std::string& problem, const std::string& why,
                           const std::string& what_to_do) const {
    throw InputError(fmt::format("{}:{}: {}", scene_.source, line, problem), why, what_to_do);
  }

  toml::node_view<toml::node> table(std::string_view name) { return root_["replay"][name]; }
  int line_of(std::string_view name) {
    const toml::node* node = table(name).node();
    return node ? static_cast<int>(node->source().begin.line) : 0;
  }

  /// On which side the wheel is that was asked for; "" where the scene names no wheels.
  std::string side() {
    const toml::table* wheels = table(wheels_table).as_table();
    const int line = line_of(wheels_table);
    std::vector<std::string> names;
    if (wheels)
      for (const auto& [name, node] : *wheels) {
        names.emplace_back(name.str());
        const std::string on = node.value<std::string>().value_or("");
        if (on != "right" && on != "left")
          refuse(line, fmt::format("replay.wheels.{} is on no side", name.str()),
                 "a wheel is on the right or on the left", "Give \"right\" or \"left\".");
        if (asked_.wheel == name.str())
          return on;
      }
    if (names.empty() && asked_.wheel.empty())
      return "";
    const std::string known = names.empty() ? "" : fmt::format("{}", fmt::join(names, ", "));
    if (asked_.wheel.empty())
      refuse(line, "the run has several wheels", fmt::format("replay.wheels names {}", known),
             "Say which one is replayed: --wheel NAME.");
    throw InputError(fmt::format("There is no wheel '{}'", asked_.wheel),
                     names.empty() ? "the scene has no table [replay.wheels]"
                                   : fmt::format("replay.wheels names {}", known),
                     names.empty() ? "Add it, or leave out --wheel." : "Give one of these.");
  }

  /// All that one of the tables names, in the order of the file.
  std::vector<Named> named_in(std::string_view name) {
    std::vector<Named> out;
    if (const toml::table* all = table(name).as_table())
      collect(*all, fmt::format("replay.{}", name), "", out);
    std::ranges::stable_sort(out, {}, &Named::line);
    return out;
  }

  void collect(const toml::table& all, const std::string& where, const std::string& prefix,
               std::vector<Named>& out) const {
    for (const auto& [name, node] : all) {
      const std::string key = prefix + std::string(name.str());
      const int line = static_cast<int>(name.source().begin.line);
      Named named{key, node.value<std::string>().value_or(""), "", 1, line};
      if (const toml::table* inner = node.as_table()) {
        if (!inner->contains("column")) {
          collect(*inner, where, key + ".", out);
          continue;
        }
        for (const auto& [word, value] : *inner)
          if (word != "column" && word != "unit" && word != "factor")
            refuse(line, fmt::format("unknown key '{}' in {}.{}", word.str(), where, key),
                   "a column has a name, a unit and a factor",
                   "Give { column = \"y\", unit = \"m\", factor = -1 }.");
        named.column = (*inner)["column"].value<std::string>().value_or("");
        named.unit = (*inner)["unit"].value<std::string>().value_or("");
        named.factor = (*inner)["factor"].value<double>().value_or(inner->contains("factor") ? 0 : 1);
      }
      if (named.column.empty() || !std::isfinite(named.factor) || named.factor == 0)
        refuse(line, fmt::format("{}.{} cannot be that", where, key), "it says which column of the run it is",
               "Give the name of a column, or { column = \"y\", unit = \"m\", factor = -1 }.");
      if (const std::size_t at = named.column.find(placeholder); at != named.column.npos && !side_.empty())
        named.column.replace(at, placeholder.size(), asked_.wheel);
      out.push_back(std::move(named));
    }
  }

  void require_key(const std::string& key, int line) const {
    std::vector<std::string> keys;
    for (const KeyDescription& one : keys_of_scenes())
      keys.push_back(one.path);
    if (std::ranges::find(keys, key) == keys.end())
      refuse(line, fmt::format("unknown key '{}' in replay.columns", key), "no scene has such a key",
             did_you_mean(key, keys));
  }

  static std::string did_you_mean(const std::string& key, const std::vector<std::string>& known) {
    const auto like = nearest_names(key, known);
    return like.empty() ? "Look at bem_contact schema."
                        : fmt::format("Did you mean {}?", fmt::join(like, " or "));
  }

  SweepFile::Replay::Compared compared(const Named& named) const {
    std::vector<std::string> names;
    for (const Quantity& q : quantities()) {
      if (named.key == q.name)
        return {named.key, q.unit.rolling, numbers(named, q.unit.rolling)};
      names.emplace_back(q.name);
    }
    refuse(named.line, fmt::format("unknown quantity '{}' in replay.compare", named.key),
           "no result has such a number", did_you_mean(named.key, names));
  }

  /// What a number of the column is multiplied with.
  double factor_of(const Named& named, const std::string& unit_of_key) const {
    const std::string own = unit_of_key.empty() ? "1" : unit_of_key;
    const bool mirrored = side_ == "left" && std::ranges::count(counted_to_the_left, named.key) > 0;
    const double factor = mirrored ? -named.factor : named.factor;
    if (named.unit.empty() || named.unit == own)
      return factor;
    std::vector<std::string_view> names{own};
    for (const KnownUnit& unit : known_units) {
      if (unit.of == own && unit.name == named.unit)
        return factor * unit.factor;
      if (unit.of == own)
        names.push_back(unit.name);
    }
    refuse(named.line, fmt::format("the unit '{}' of {} is not known", named.unit, named.key),
           fmt::format("its numbers are in {}", own),
           fmt::format("Give one of {}, or leave out the unit and give a factor.", fmt::join(names, ", ")));
  }

  std::vector<double> numbers(const Named& named, const std::string& own) const {
    const double factor = factor_of(named, own);
    const std::vector<CsvCell>& head = lines_.front().cells;
    const auto cell = std::ranges::find(head, named.column, &CsvCell::text);
    if (cell == head.end()) {
      std::vector<std::string> names;
      std::ranges::transform(head, std::back_inserter(names), &CsvCell::text);
      const auto like = nearest_names(named.column, names);
      refuse(named.line, fmt::format("the run has no column '{}'", named.column),
             fmt::format("{} is to be read from it", named.key),
             like.empty() ? fmt::format("Its columns are {}.", fmt::join(names, ", "))
                          : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
    }
    const auto at = static_cast<std::size_t>(cell - head.begin());
    std::vector<double> out;
    out.reserve(lines_.size() - 1);
    for (const CsvLine& line : std::span(lines_).subspan(1)) {
      require_cells(asked_.run, line, head.size());
      const std::string_view text = line.cells[at].text;
      const std::optional<double> value = number_of_text(text.substr(text.starts_with('+') ? 1 : 0));
      if (!value || !std::isfinite(*value))
        refuse_line(
            asked_.run, line,
            fmt::format("'{}' in its column {} is not a finite number", line.cells[at].text, named.column),
            "Give a number with a decimal point, or leave the line out.");
      out.push_back(*value * factor);
    }
    return out;
  }

  const SceneText& scene_;
  const ReplayAsked& asked_;
  toml::table root_;
  std::string side_;
  std::vector<CsvLine> lines_;
};

} // namespace

SweepFile parse_replay(SceneText scene, const ReplayAsked& asked) {
  return Reader(scene, asked).sweep();
}

} // namespace bem_contact
