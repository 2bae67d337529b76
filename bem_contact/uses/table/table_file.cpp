#include "bem_contact/uses/table/table_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/influence/file_kinds.hpp"
#include "bem_contact/profile/messages.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace bem_contact::table {

namespace {

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

/// One blank-separated list of names.
std::vector<std::string> words(const H5Table& file, const char* attribute) {
  std::istringstream in(std::get<std::string>(file.attributes.at(attribute)));
  return {std::istream_iterator<std::string>(in), {}};
}

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

void require_finite(const H5Dataset& data, const std::string& name, const std::filesystem::path& file) {
  if (!std::ranges::all_of(data.values, [](double value) { return std::isfinite(value); }))
    throw InputError(fmt::format("The file '{}' is damaged", file.string()),
                     fmt::format("its dataset '{}' has a number that is not finite", name),
                     "Copy it again from where it was whole, or make it again.");
}

ContactTable table_of(const H5Table& file, const std::filesystem::path& path) {
  const auto data = [&](const std::string& name, std::optional<std::size_t> count = {}) -> const H5Dataset& {
    return dataset_of(file, name, path, count);
  };
  const auto number = [&](const char* name) { return std::get<double>(file.attributes.at(name)); };
  ContactTable table;
  for (const std::string& name : words(file, "axes")) {
    const H5Dataset& axis = data("axes/" + name);
    require_finite(axis, "axes/" + name, path);
    table.axes.push_back({name, axis.unit, axis.description, axis.values});
    if (const auto first = file.datasets.find("first/" + name); first != file.datasets.end())
      table.axes.back().first.assign(first->second.values.begin(), first->second.values.end());
    require_lines(table);
  }
  const std::vector<std::string> held = words(file, "held");
  for (const std::string& name : words(file, "columns")) {
    const H5Dataset& values = data("values/" + name, table.size());
    table.columns.push_back(
        {name, values.unit, values.description, std::ranges::find(held, name) != held.end(),
         data("scale/" + name, 1).values.front(), data("interpolation_error/" + name, 1).values.front(),
         data("element_error/" + name, 1).values.front(), values.values});
  }
  table.tolerance = number("tolerance");
  table.solved = static_cast<std::size_t>(number("solved"));
  table.checked = static_cast<std::size_t>(number("checked"));
  if (file.datasets.contains("creep_scale/C11")) {
    const std::vector<double>& c11 = data("creep_scale/C11").values;
    table.scale = {data("creep_scale/log10_a_over_b", c11.size()).values, c11,
                   data("creep_scale/C22", c11.size()).values, number("poisson")};
  }
  return table;
}

} // namespace

H5Table to_h5(const ContactTable& table) {
  H5Table out;
  out.checksums = true;
  std::vector<std::size_t> shape;
  for (const Axis& axis : table.axes) {
    shape.push_back(axis.points.size());
    out.datasets["axes/" + axis.name] = H5Dataset::line(axis.points, axis.unit, axis.description);
    if (!axis.first.empty())
      out.datasets["first/" + axis.name] =
          H5Dataset::line({axis.first.begin(), axis.first.end()}, "1",
                          "where the points begin that belong to each point before");
  }
  if (table.nested())
    shape = {table.size()};
  for (const Column& c : table.columns) {
    out.datasets["values/" + c.name] = {shape, c.values, c.unit, c.description};
    out.datasets["interpolation_error/" + c.name] = H5Dataset::single(
        c.interpolation_error, c.unit, "largest difference from a solution in the middle of any cell");
    out.datasets["element_error/" + c.name] = H5Dataset::single(
        c.element_error, c.unit, "largest error by the size of the elements that a point states");
    out.datasets["scale/" + c.name] = H5Dataset::single(c.scale, c.unit, "what the tolerance is relative to");
  }
  auto& a = out.attributes;
  a["format"] = std::string(table_format);
  a["program"] = provenance("bem_contact");
  a["axes"] = names_of(table.axes);
  a["columns"] = names_of(table.columns);
  a["held"] = held_of(table);
  a["interpolation"] = std::string(
      "in each coordinate cubic, by the slopes of parabolas through three points; constant beyond the ends");
  a["tolerance"] = table.tolerance;
  a["points"] = static_cast<double>(table.size());
  a["solved"] = static_cast<double>(table.solved);
  a["checked"] = static_cast<double>(table.checked);
  if (const auto& s = table.scale) {
    out.datasets["creep_scale/log10_a_over_b"] =
        H5Dataset::line(s->log10_a_over_b, "1", "of the coefficients");
    out.datasets["creep_scale/C11"] = H5Dataset::line(s->c11, "1", "Kalker's; xi' = G a b C11 xi / (3 mu N)");
    out.datasets["creep_scale/C22"] =
        H5Dataset::line(s->c22, "1", "Kalker's; eta' = G a b C22 eta / (3 mu N)");
    a["spin"] = std::string("phi' = G a b sqrt(C11 C22) R phi / (3 mu N), R = sqrt((a^2 + b^2)/2)");
    a["poisson"] = s->poisson;
    a["symmetry"] = std::string("the sign of xi turns Fx; the signs of eta and phi together turn Fy and Mz");
  }
  return out;
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
    out += fmt::format("\n{} '{}' {:.6g}\n{:.17g}", c.name, c.unit, c.interpolation_error,
                       fmt::join(c.values, "\n"));
  out += "\n";
  if (const auto& s = table.scale)
    for (std::size_t i = 0; i < s->c11.size(); ++i)
      out += fmt::format("{:.17g} {:.17g} {:.17g}\n", s->log10_a_over_b[i], s->c11[i], s->c22[i]);
  return out;
}

ContactTable read_table(const std::filesystem::path& file) {
  const H5Table stored = read_h5(file);
  const auto format = stored.attributes.find("format");
  try {
    if (format != stored.attributes.end() && format->second == H5Attribute(std::string(table_format))) {
      ContactTable table = table_of(stored, file);
      if (!stored.checksums)
        messages()->warn(
            "The table '{}' has no checksums (an earlier version made it, or it was written again) "
            "Whether a number in it has changed since cannot be known; make it again to know it.",
            file.string());
      return table;
    }
  } catch (const std::out_of_range&) {       // an attribute is missing
  } catch (const std::bad_variant_access&) { // or is of another kind
  }
  throw InputError(fmt::format("'{}' is no table", file.string()),
                   "it was not made by bem_contact table, or is damaged", "Make it again.");
}

} // namespace bem_contact::table
