#include "bem_contact/record/hdf5.hpp"

#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <sstream>

namespace bem_contact::record {

namespace {

constexpr const char *row_attribute = "row", *table_attribute = "table";
constexpr const char *of_rows = "rows", *of_columns = "columns";
/// An attribute holds at most 64 kB.
constexpr std::size_t longest_attribute = 60'000;

/// Adds what the group `path` holds ("" or with its last slash).
class ToH5 {
public:
  ToH5(H5Table& table, std::string path) : table_(&table), path_(std::move(path)) {}

  void add(const Record& record) {
    for (const Entry& entry : record.entries()) {
      name_ = path_ + entry.name;
      std::visit(*this, entry.content);
    }
  }

  void operator()(std::monostate) {}
  void operator()(bool flag) { table_->attributes[name_] = flag; }
  void operator()(const Number& number) {
    table_->datasets[name_] = {{}, {number.value}, number.unit, number.meaning, number.whole};
    if (number.error)
      table_->datasets[error_name(name_)] = {.values = {*number.error},
                                             .unit = number.unit,
                                             .description = error_meaning,
                                             .role = std::string(name_of(Role::error)),
                                             .of = name_.substr(path_.size())};
  }
  void operator()(const Text& text) {
    if (text.meaning.empty() && text.text.size() < longest_attribute)
      table_->attributes[name_] = text.text;
    else
      table_->texts[name_] = {text.text, text.meaning};
  }
  void operator()(const Texts& texts) {
    std::string all;
    for (const std::string& line : texts.lines)
      all += line + "\n";
    table_->texts[name_] = {std::move(all), texts.meaning, true};
  }
  void operator()(const Field& values) {
    table_->datasets[name_] = {values.shape,   {values.values.begin(), values.values.end()},
                               values.unit,    values.meaning,
                               false,          std::string(name_of(values.role)),
                               values.choices, values.of};
  }
  void operator()(const Table& table) {
    if (table.size() == 0) // as what an answer does not have
      return;
    const std::string group = name_ + "/";
    table_->attributes[group + row_attribute] = table.row;
    table_->attributes[group + table_attribute] =
        std::string(table.layout == Layout::rows ? of_rows : of_columns);
    for (const Column& column : table.columns)
      table_->datasets[group + column.name] = {{column.values.size()},
                                               column.values,
                                               column.unit,
                                               column.meaning,
                                               column.whole,
                                               std::string(name_of(column.role)),
                                               {},
                                               column.of};
  }
  void operator()(const Record& record) { ToH5(*table_, name_ + "/").add(record); }

private:
  H5Table* table_;
  std::string path_, name_;
};

/// What a file holds, as a tree.
struct Node {
  std::map<std::string, Node> groups;
  std::map<std::string, const H5Dataset*> datasets;
  std::map<std::string, const H5Attribute*> attributes;
  std::map<std::string, const H5Text*> texts;
};

std::pair<Node*, std::string> place(Node& root, const std::string& path) {
  Node* at = &root;
  std::size_t from = 0;
  for (std::size_t slash; (slash = path.find('/', from)) != path.npos; from = slash + 1)
    at = &at->groups[path.substr(from, slash - from)];
  return {at, path.substr(from)};
}

Node tree_of(const H5Table& table) {
  Node root;
  const auto put = [&](const auto& all, auto member) {
    for (const auto& [path, value] : all) {
      const auto [node, name] = place(root, path);
      (node->*member)[name] = &value;
    }
  };
  put(table.datasets, &Node::datasets);
  put(table.attributes, &Node::attributes);
  put(table.texts, &Node::texts);
  return root;
}

Content of_attribute(const H5Attribute& attribute) {
  if (const auto* text = std::get_if<std::string>(&attribute))
    return Text{*text};
  if (const auto* flag = std::get_if<bool>(&attribute))
    return *flag;
  return Number{std::get<double>(attribute), "", ""};
}

Content of_text(const H5Text& text) {
  if (!text.lines)
    return Text{text.text, text.description};
  Texts out{{}, text.description};
  std::istringstream all(text.text);
  for (std::string line; std::getline(all, line);)
    out.lines.push_back(line);
  return out;
}

Role role_of(const H5Dataset& data) {
  return value_named<Role>(data.role).value_or(Role::other);
}

Table table_of_node(const Node& node) {
  Table out;
  if (const auto row = node.attributes.find(row_attribute); row != node.attributes.end())
    if (const auto* text = std::get_if<std::string>(row->second))
      out.row = *text;
  const auto* layout = std::get_if<std::string>(node.attributes.at(table_attribute));
  out.layout = layout && *layout == of_rows ? Layout::rows : Layout::columns;
  for (const auto& [name, data] : node.datasets)
    out.columns.push_back({.name = name,
                           .unit = data->unit,
                           .meaning = data->description,
                           .values = data->values,
                           .whole = data->whole,
                           .role = role_of(*data),
                           .of = data->of});
  return out;
}

bool is_table(const Node& node) {
  const auto length = [](const auto& entry) {
    return entry.second->shape.size() == 1 ? entry.second->values.size() : std::size_t(-1);
  };
  return node.attributes.contains(table_attribute) && node.groups.empty() &&
         std::ranges::all_of(node.datasets, [&](const auto& entry) {
           return length(entry) != std::size_t(-1) && length(entry) == length(*node.datasets.begin());
         });
}

Record record_of_node(const Node& node) {
  Record out;
  for (const auto& [name, value] : node.attributes)
    out.add(name, of_attribute(*value));
  for (const auto& [name, text] : node.texts)
    out.add(name, of_text(*text));
  const auto is_one = [](const H5Dataset& data) { return data.shape.empty() && data.values.size() == 1; };
  std::map<std::string, double> errors; // of the number with this name
  for (const auto& [name, data] : node.datasets)
    if (const auto number = node.datasets.find(data->of); role_of(*data) == Role::error && is_one(*data) &&
                                                          number != node.datasets.end() &&
                                                          is_one(*number->second))
      errors[data->of] = data->values.front();
  for (const auto& [name, data] : node.datasets) {
    if (role_of(*data) == Role::error && is_one(*data) && errors.contains(data->of))
      continue;
    if (!data->shape.empty() || data->values.size() != 1) {
      Field values = field(data->values, data->unit, data->description, data->shape);
      values.role = role_of(*data);
      values.choices = data->choices;
      values.of = data->of;
      out.add(name, std::move(values));
      continue;
    }
    Number number{data->values.front(), data->unit, data->description, {}, data->whole};
    if (const auto error = errors.find(name); error != errors.end())
      number.error = error->second;
    out.add(name, std::move(number));
  }
  for (const auto& [name, group] : node.groups)
    if (is_table(group))
      out.add(name, table_of_node(group));
    else
      out.add(name, record_of_node(group));
  return out;
}

/// A record of a file, unless the file is of a kind that this program writes and has another number.
Record in_todays_layout(Record record, const std::filesystem::path& file) {
  const std::string_view format = text_at(record, "format").value_or("");
  if (const FileKind* kind = kind_of(format); kind && kind->format != format)
    throw InputError(fmt::format("'{}' was written by another version of bem_contact", file.string()),
                     fmt::format("its format is '{}', today's is '{}'", format, kind->format),
                     "Make it again with this version, or read it with the version that wrote it.");
  return record;
}

} // namespace

H5Table to_h5(const Record& record) {
  H5Table table;
  table.checksums = true;
  ToH5(table, "").add(record);
  return table;
}

Record from_h5(const H5Table& table) {
  return record_of_node(tree_of(table));
}

void write_hdf5(const std::filesystem::path& file, const Record& record) {
  write_h5(file, to_h5(record));
}

std::string hdf5_bytes(const Record& record) {
  return h5_bytes(to_h5(record));
}

std::string format_of(const std::filesystem::path& file) {
  try {
    return text_attribute(H5Reader(file).attributes(), "format");
  } catch (const InputError&) {
    return "";
  }
}

Record read_hdf5(const std::filesystem::path& file) {
  return in_todays_layout(from_h5(read_h5(file)), file);
}

Record read_hdf5_top(const std::filesystem::path& file, const std::string& group) {
  return in_todays_layout(from_h5(read_h5_top(file, group)), file);
}

Record read_hdf5_for_found(const std::filesystem::path& file) {
  return in_todays_layout(from_h5(read_h5_where(file, is_found_in_sweep)), file);
}

} // namespace bem_contact::record
