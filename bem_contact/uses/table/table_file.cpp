#include "bem_contact/uses/table/table_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace bem_contact::table {

namespace {

using record::Number;
using record::Record;

template <class Named> std::string names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all)
    names.push_back(one.name);
  return fmt::format("{}", fmt::join(names, " "));
}

std::string held_of(const ContactTable& table) {
  std::vector<Column> held;
  std::ranges::copy_if(table.columns, std::back_inserter(held), &Column::held);
  return names_of(held);
}

/// What is stored in a table's file. Its functions throw InputError for what is missing, or not as it must
/// be.
class Stored {
public:
  Stored(const Record& file, const std::filesystem::path& path) : file_(&file), path_(&path) {}

  bool has(const std::string& name) const { return record::find(*file_, name) != nullptr; }
  /// One blank-separated list of names.
  std::vector<std::string> words(const std::string& name) const {
    const auto text = record::text_at(*file_, name);
    if (!text)
      refuse(fmt::format("it has no text '{}'", name));
    std::istringstream in{std::string(*text)};
    return {std::istream_iterator<std::string>(in), {}};
  }
  double number(const std::string& name) const {
    const auto value = record::number_at(*file_, name);
    if (!value)
      refuse(fmt::format("it has no number '{}'", name));
    return *value;
  }
  /// No count: one or more.
  const record::Field& field(const std::string& name, std::optional<std::size_t> count = {}) const {
    const record::Content* content = record::find(*file_, name);
    const auto* found = content ? std::get_if<record::Field>(content) : nullptr;
    if (!found)
      refuse(fmt::format("it has no dataset '{}'", name));
    if (found->values.size() != count.value_or(std::max<std::size_t>(found->values.size(), 1)))
      refuse(fmt::format("its dataset '{}' has {} numbers, not {}", name, found->values.size(),
                         count ? fmt::format("{}", *count) : "one or more"));
    return *found;
  }
  std::vector<double> values(const std::string& name, std::optional<std::size_t> count = {}) const {
    const record::Field& all = field(name, count);
    return {all.values.begin(), all.values.end()};
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("The file '{}' is damaged", path_->string()), why,
                     "Copy it again from where it was whole, or make it again.");
  }

private:
  const Record* file_;
  const std::filesystem::path* path_;
};

/// Throws std::out_of_range if the lines of the last axis are none.
void require_lines(const ContactTable& table) {
  const Axis& axis = table.axes.back();
  const std::span axes_before(table.axes.data(), table.axes.size() - 1);
  const std::size_t lines = ContactTable{.axes = {axes_before.begin(), axes_before.end()}}.size();
  const bool fit = axis.first.empty()
                       ? !axis.points.empty()
                       : axis.first.size() == lines + 1 && axis.first.front() == 0 &&
                             axis.first.back() == axis.points.size() &&
                             std::ranges::adjacent_find(axis.first, std::greater_equal()) == axis.first.end();
  if (!fit)
    throw std::out_of_range(axis.name);
}

ContactTable table_of(const Stored& file) {
  ContactTable table;
  for (const std::string& name : file.words("axis_names")) {
    const record::Field& axis = file.field("axes/" + name);
    if (!std::ranges::all_of(axis.values, [](double value) { return std::isfinite(value); }))
      file.refuse(fmt::format("its dataset '{}' has a number that is not finite", name));
    table.axes.push_back({name, axis.unit, axis.meaning, {axis.values.begin(), axis.values.end()}});
    if (file.has("first/" + name)) {
      const std::span<const double> first = file.field("first/" + name).values;
      table.axes.back().first.assign(first.begin(), first.end());
    }
    require_lines(table);
  }
  const std::vector<std::string> held = file.words("held");
  for (const std::string& name : file.words("column_names")) {
    const record::Field& values = file.field("values/" + name, table.size());
    table.columns.push_back({name,
                             values.unit,
                             values.meaning,
                             std::ranges::find(held, name) != held.end(),
                             file.number("scale/" + name),
                             file.number("interpolation_error/" + name),
                             file.number("element_error/" + name),
                             {values.values.begin(), values.values.end()}});
  }
  table.tolerance = file.number("tolerance");
  table.solved = static_cast<std::size_t>(file.number("solved"));
  table.checked = static_cast<std::size_t>(file.number("checked"));
  if (file.has("creep_scale/C11")) {
    const std::vector<double> c11 = file.values("creep_scale/C11");
    table.scale = {file.values("creep_scale/log10_a_over_b", c11.size()), c11,
                   file.values("creep_scale/C22", c11.size()), file.number("poisson")};
  }
  return table;
}

/// [n of the first axis][n of the second]...; [points] where axes are nested.
std::vector<std::size_t> shape_of(const ContactTable& table) {
  if (table.nested())
    return {table.size()};
  std::vector<std::size_t> shape;
  for (const Axis& axis : table.axes)
    shape.push_back(axis.points.size());
  return shape;
}

/// What a creep table is scaled with.
void add_scale(Record& out, const CreepScale& s) {
  const auto line = [](const std::vector<double>& values, const char* meaning) {
    return record::Field{"1", meaning, {values.size()}, values};
  };
  out.add("creep_scale", Record{{"log10_a_over_b", line(s.log10_a_over_b, "of the coefficients")},
                                {"C11", line(s.c11, "Kalker's; xi' = G a b C11 xi / (3 mu N)")},
                                {"C22", line(s.c22, "Kalker's; eta' = G a b C22 eta / (3 mu N)")}});
  out.add("spin", std::string("phi' = G a b sqrt(C11 C22) R phi / (3 mu N), R = sqrt((a^2 + b^2)/2)"));
  out.add("poisson", Number{s.poisson, "1", "Poisson's ratio of the pair"});
  out.add("symmetry",
          std::string("the sign of xi turns Fx; the signs of eta and phi together turn Fy and Mz"));
}

} // namespace

Record record_of(const ContactTable& table) {
  Record axes, first, values, interpolation, elements, scale;
  for (const Axis& axis : table.axes) {
    axes.add(axis.name, record::Field{axis.unit, axis.description, {axis.points.size()}, axis.points});
    if (!axis.first.empty())
      first.add(axis.name, record::field({axis.first.begin(), axis.first.end()}, "1",
                                         "where the points begin that belong to each point before"));
  }
  for (const Column& c : table.columns) {
    values.add(c.name, record::Field{c.unit, c.description, shape_of(table), c.values});
    interpolation.add(c.name,
                      Number{c.interpolation_error, c.unit,
                             "largest difference from a solution within any cell, and the largest jump"});
    elements.add(c.name, Number{c.element_error, c.unit,
                                "largest error by the size of the elements that a point states"});
    scale.add(c.name, Number{c.scale, c.unit, "what the tolerance is relative to"});
  }
  const auto count = [](std::size_t value, const char* meaning) {
    return Number{static_cast<double>(value), "1", meaning, {}, true};
  };
  Record out{
      {"axis_names", record::Text{names_of(table.axes)}},
      {"column_names", record::Text{names_of(table.columns)}},
      {"held", record::Text{held_of(table)}},
      {"interpolation", record::Text{"in each coordinate cubic, by the slopes of parabolas through three "
                                     "points; constant beyond the ends"}},
      {"tolerance", Number{table.tolerance, "1", "of the interpolation, relative to each scale"}},
      {"points", count(table.size(), "of the table")},
      {"solved", count(table.solved, "contact problems, points between the points included")},
      {"checked", count(table.checked, "of them, cells whose middle was solved to measure the error")},
      {"axes", std::move(axes)},
      {"first", std::move(first)},
      {"values", std::move(values)},
      {"interpolation_error", std::move(interpolation)},
      {"element_error", std::move(elements)},
      {"scale", std::move(scale)}};
  if (table.scale)
    add_scale(out, *table.scale);
  return out;
}

void write_table(const std::filesystem::path& file, const Record& head, const ContactTable& table) {
  record::write_hdf5(file, Record(head).append(record_of(table)));
}

std::string to_text(const ContactTable& table) {
  std::string out = fmt::format("bem_contact_table 3\n{} {} {}\n", table.axes.size(), table.columns.size(),
                                table.scale ? table.scale->c11.size() : 0);
  for (const Axis& axis : table.axes)
    out += fmt::format("{} ", axis.points.size());
  for (const Axis& axis : table.axes)
    out += fmt::format("\n{} '{}' {}\n{:.17g}\n{}", axis.name, axis.unit, axis.first.size(),
                       fmt::join(axis.points, "\n"), fmt::join(axis.first, "\n"));
  for (const Column& c : table.columns)
    out += fmt::format("\n{} '{}' {:.6g}\n{:.17g}", c.name, c.unit, c.error(), fmt::join(c.values, "\n"));
  out += "\n";
  if (const auto& s = table.scale)
    for (std::size_t i = 0; i < s->c11.size(); ++i)
      out += fmt::format("{:.17g} {:.17g} {:.17g}\n", s->log10_a_over_b[i], s->c11[i], s->c22[i]);
  return out;
}

namespace {

/// With the command that makes the table anew.
[[noreturn]] void refuse_other_version(const Record& stored, const std::filesystem::path& file) {
  const auto text = [&](const char* name, std::string_view otherwise) {
    return std::string(record::text_at(stored, name).value_or(otherwise));
  };
  const bool creep = record::find(stored, "creep_scale") != nullptr;
  throw InputError(fmt::format("The table '{}' was made by another version of bem_contact", file.string()),
                   fmt::format("its format is '{}', today's is '{}'", text("format", ""), table_format),
                   fmt::format("Make it again: bem_contact table {} -o {}",
                               creep ? "--creep-forces" : text("scene", "SCENE.toml"), file.string()));
}

} // namespace

ContactTable read_table(const std::filesystem::path& file) {
  const H5Table read = read_h5(file);
  const Record stored = record::from_h5(read);
  const std::string_view format = record::text_at(stored, "format").value_or("");
  if (format != table_format && kind_of(format) == kind_of(table_format))
    refuse_other_version(stored, file);
  try {
    if (format == table_format) {
      ContactTable table = table_of(Stored(stored, file));
      if (!read.checksums)
        say_warning("The table '{}' has no checksums (another program wrote it again) "
                    "Whether a number in it has changed since cannot be known; make it again to know it.",
                    file.string());
      return table;
    }
  } catch (const std::out_of_range&) { // the lines of an axis do not fit
  }
  throw InputError(fmt::format("'{}' is no table", file.string()),
                   "it was not made by bem_contact table, or is damaged", "Make it again.");
}

} // namespace bem_contact::table
