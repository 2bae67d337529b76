#include "bem_contact/app/sweep/sweep_output.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/record/file_kinds.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <functional>
#include <numeric>
#include <ostream>

namespace bem_contact::app {

namespace {

constexpr const char* status_description =
    "0 missing, 1 certified, 2 not certified, 3 refused, 4 its process died; CSV: in words";
constexpr const char* seconds_description = "wall clock";
constexpr const char* cpu_description = "of its process";

double number(const SchemaValue& value) {
  if (const auto* v = std::get_if<double>(&value))
    return *v;
  if (const auto* v = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*v);
  return std::get<bool>(value) ? 1.0 : 0.0;
}

/// With these a spreadsheet begins a formula, which it computes when the table is opened.
constexpr std::string_view begins_formula = "=+-@";

bool is_formula(std::string_view text) {
  return !text.empty() && begins_formula.find(text.front()) != begins_formula.npos;
}

/// RFC 4180: doubled quotes. For people: in one line, and no formula.
std::string quoted(const std::string& text) {
  std::string out(is_formula(text) ? "\" " : "\"");
  for (const char c : text) {
    out.append(c == '"' ? 1 : 0, '"');
    out.push_back(c == '\n' ? ' ' : c);
  }
  out.push_back('"');
  return out;
}

} // namespace

SweepOutput::SweepOutput(const SweepFile& sweep, const SweepColumns& columns, std::string digest)
    : sweep_(&sweep), columns_(&columns), digest_(std::move(digest)), cases_(sweep.size()) {
  for (SweepCase& missing : cases_)
    missing.seconds = missing.cpu_seconds = std::nan("");
}

void SweepOutput::add(const SweepCase& r) {
  if (r.index < cases_.size() && !finished(r.index))
    cases_[r.index] = {r.index, r.status, {}, r.seconds, r.cpu_seconds, r.summary, r.patches};
}

std::size_t SweepOutput::count(CaseStatus status) const {
  return static_cast<std::size_t>(std::ranges::count(cases_, status, &SweepCase::status));
}

void SweepOutput::add_axes(H5Table& table, const std::string& group,
                           const std::vector<std::size_t>& cases) const {
  for (std::size_t a = 0; a < sweep_->axes.size(); ++a) {
    const SweepFile::Axis& axis = sweep_->axes[a];
    const bool text = std::holds_alternative<std::string>(axis.values.front());
    std::vector<double> values;
    for (const std::size_t i : cases) {
      const std::size_t at = sweep_->indices(i)[a];
      values.push_back(text ? static_cast<double>(at) : number(axis.values[at]));
    }
    std::string description = text ? "which of" : "swept over";
    for (const SchemaValue& value : axis.values)
      if (text)
        description.append(" ").append(bem_contact::to_text(value));
    table.datasets[group + axis.key] =
        H5Dataset::line(std::move(values), unit_of_key(axis.key), std::move(description));
  }
}

void SweepOutput::add_patches(H5Table& table, SweepNumbers& numbers) const {
  auto& d = table.datasets;
  d["patches/case"] =
      H5Dataset::line({numbers.patch_case.begin(), numbers.patch_case.end()}, "1", "the case, from 0");
  d["patches/patch"] =
      H5Dataset::line({numbers.patch_rank.begin(), numbers.patch_rank.end()}, "1", "1: the largest force");
  add_axes(table, "patches/", numbers.patch_case);
  for (std::size_t k = 0; k < numbers.patches.size(); ++k) {
    const SweepColumn& column = columns_->patches[k];
    d["patches/" + column.name] =
        H5Dataset::line(std::move(numbers.patches[k]), column.unit, column.description);
  }
}

H5Table SweepOutput::top() const {
  H5Table table;
  const std::size_t n = size();
  const auto line = [&](const std::string& name, std::string unit, std::string description, auto value) {
    std::vector<double> values(n);
    std::ranges::transform(cases_, values.begin(), value);
    table.datasets[name] = H5Dataset::line(std::move(values), std::move(unit), std::move(description));
  };
  std::vector<std::size_t> cases(n);
  std::iota(cases.begin(), cases.end(), std::size_t{0});
  add_axes(table, "", cases);
  line("status", "1", status_description, [](const SweepCase& r) { return static_cast<double>(r.status); });
  line("seconds", "s", seconds_description, std::mem_fn(&SweepCase::seconds));
  line("cpu_seconds", "s", cpu_description, std::mem_fn(&SweepCase::cpu_seconds));
  SweepNumbers numbers = numbers_of(cases_, *columns_);
  for (std::size_t k = 0; k < numbers.cases.size(); ++k) {
    const SweepColumn& column = columns_->cases[k];
    table.datasets[column.name] =
        H5Dataset::line(std::move(numbers.cases[k]), column.unit, column.description);
  }
  if (!columns_->patches.empty())
    add_patches(table, numbers);
  auto& a = table.attributes;
  a["format"] = std::string(sweep_format);
  a["digest"] = digest_;
  for (std::size_t s = 0; s < EnumNames<CaseStatus>::names.size(); ++s) {
    std::string name(EnumNames<CaseStatus>::names[s]);
    std::ranges::replace(name, ' ', '_');
    table.datasets[name + "_count"] = {
        {}, {static_cast<double>(count(static_cast<CaseStatus>(s)))}, "1", "cases of this status", true};
  }
  return table;
}

namespace {

/// Throws InputError where a number is not one of 0, 1, ... below `count`, which it stands for.
void require_below(std::size_t count, const H5Table& table, const std::string& name,
                   const std::filesystem::path& file, bool may_be_nan = false) {
  for (const double value : table.datasets.at(name).values)
    if (!(value >= 0 && value < static_cast<double>(count)) && !(may_be_nan && std::isnan(value)))
      throw InputError(fmt::format("The file '{}' is damaged", file.string()),
                       fmt::format("its dataset '{}' has a number {}, not 0 to {}", name, value, count - 1),
                       "Copy it again from where it was whole, or make it again.");
}

} // namespace

H5Table read_sweep_top(const std::filesystem::path& file, const SweepFile& sweep,
                       const SweepColumns& columns) {
  H5Table top = read_h5_top(file, "patches");
  for (const char* name : {"status", "seconds", "cpu_seconds"})
    dataset_of(top, name, file, sweep.size());
  require_below(EnumNames<CaseStatus>::names.size(), top, "status", file);
  for (const SweepColumn& column : columns.cases) {
    dataset_of(top, column.name, file, sweep.size());
    if (is_model(column))
      require_below(EnumNames<Model>::names.size(), top, column.name, file, true);
  }
  if (columns.patches.empty())
    return top;
  const auto cases = top.datasets.find("patches/case");
  const std::size_t rows = cases == top.datasets.end() ? 0 : cases->second.values.size();
  for (const char* name : {"patches/case", "patches/patch"})
    dataset_of(top, name, file, rows);
  require_below(sweep.size(), top, "patches/case", file);
  for (const SweepColumn& column : columns.patches)
    dataset_of(top, "patches/" + column.name, file, rows);
  return top;
}

H5Table group_of(const CaseRecord& record) {
  const std::string group = fmt::format("cases/{:06}/", record.index);
  H5Table table;
  add_group(table, group, record.fields);
  if (!record.reason.empty())
    table.attributes[group + "reason"] = record.reason;
  return table;
}

void require_csv_texts(const SweepFile& sweep) {
  const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  for (const SweepFile::Axis& axis : sweep.axes)
    for (const SchemaValue& value : axis.values)
      if (const auto* text = std::get_if<std::string>(&value))
        if (is_formula(*text) || std::ranges::any_of(*text, is_control))
          throw InputError(fmt::format("{} = {} cannot be a cell of --csv", axis.key, toml_text(*text)),
                           is_formula(*text) ? "a spreadsheet takes what begins with = + - @ as a formula"
                                             : "tables have one line for each case",
                           "Give the file another name, or leave out --csv.");
}

CsvFiles csv_files(const std::filesystem::path& csv) {
  if (csv.empty() || output_target(csv, OutputForm::text).stream)
    return {csv, {}, {}};
  const auto beside = [&](const char* what) {
    return csv.parent_path() / (csv.stem().string() + what + csv.extension().string());
  };
  return {csv, beside("_patches"), beside("_units")};
}

namespace {

/// An empty cell for nan.
std::string cell(const H5Table& table, const std::string& name, std::size_t i) {
  const double value = table.datasets.at(name).values[i];
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

std::string cell(const H5Table& table, const SweepColumn& column, std::size_t i) {
  const double value = table.datasets.at(column.name).values[i];
  return is_model(column) && !std::isnan(value) ? std::string(name_of(static_cast<Model>(value)))
                                                : cell(table, column.name, i);
}

std::string_view status_of(const H5Table& top, std::size_t i) {
  return name_of(static_cast<CaseStatus>(top.datasets.at("status").values[i]));
}

void print_axes(std::ostream& out, const SweepFile& sweep) {
  for (const SweepFile::Axis& axis : sweep.axes)
    fmt::print(out, ",{}", axis.key);
  if (!sweep.weights.empty())
    fmt::print(out, ",weight");
}

void print_changes(std::ostream& out, const SweepFile& sweep, std::size_t i) {
  for (const SceneChange& change : sweep.changes(i)) {
    const auto* text = std::get_if<std::string>(&change.value);
    fmt::print(out, ",{}", text ? quoted(*text) : bem_contact::to_text(change.value));
  }
  if (!sweep.weights.empty())
    fmt::print(out, ",{}", sweep.weight(i));
}

void print_cases(std::ostream& out, const SweepFile& sweep, const std::vector<SweepColumn>& columns,
                 const H5Table& top) {
  fmt::print(out, "case");
  print_axes(out, sweep);
  fmt::print(out, ",status,seconds,cpu_seconds");
  for (const SweepColumn& column : columns)
    fmt::print(out, ",{}", column.name);
  fmt::print(out, ",reason\n");
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    fmt::print(out, "{}", i);
    print_changes(out, sweep, i);
    fmt::print(out, ",{},{},{}", status_of(top, i), cell(top, "seconds", i), cell(top, "cpu_seconds", i));
    for (const SweepColumn& column : columns)
      fmt::print(out, ",{}", cell(top, column, i));
    const std::string reason = text_attribute(top, fmt::format("cases/{:06}/reason", i));
    fmt::print(out, ",{}\n", reason.empty() ? "" : quoted(reason));
  }
}

void print_patches(std::ostream& out, const SweepFile& sweep, const std::vector<SweepColumn>& columns,
                   const H5Table& top) {
  fmt::print(out, "case,patch");
  print_axes(out, sweep);
  fmt::print(out, ",status");
  for (const SweepColumn& column : columns)
    fmt::print(out, ",{}", column.name);
  fmt::print(out, "\n");
  const std::vector<double>& cases = top.datasets.at("patches/case").values;
  for (std::size_t row = 0; row < cases.size(); ++row) {
    const auto i = static_cast<std::size_t>(cases[row]);
    fmt::print(out, "{},{}", i, cell(top, "patches/patch", row));
    print_changes(out, sweep, i);
    fmt::print(out, ",{}", status_of(top, i));
    for (const SweepColumn& column : columns)
      fmt::print(out, ",{}", cell(top, "patches/" + column.name, row));
    fmt::print(out, "\n");
  }
}

void print_units(std::ostream& out, const SweepFile& sweep, const SweepColumns& columns) {
  fmt::print(out, "table,name,unit,description\n");
  std::vector<const char*> tables{"cases"};
  if (!columns.patches.empty())
    tables.push_back("patches");
  for (const char* table : tables)
    for (const SweepFile::Axis& axis : sweep.axes)
      fmt::print(out, "{},{},{},swept over\n", table, axis.key, unit_of_key(axis.key));
  if (!sweep.weights.empty())
    for (const char* table : tables)
      fmt::print(out, "{},weight,1,how often the case occurs compared with the others\n", table);
  fmt::print(out, "cases,status,1,{}\n", quoted(status_description));
  fmt::print(out, "cases,seconds,s,{}\ncases,cpu_seconds,s,{}\n", quoted(seconds_description),
             quoted(cpu_description));
  const auto print = [&](const char* table, const std::vector<SweepColumn>& all) {
    for (const SweepColumn& column : all)
      fmt::print(out, "{},{},{},{}\n", table, column.name, column.unit, quoted(column.description));
  };
  print("cases", columns.cases);
  print("patches", columns.patches);
}

} // namespace

void write_csv(const CsvFiles& files, const SweepFile& sweep, const SweepColumns& columns,
               const H5Table& top) {
  write_text(files.cases, [&](std::ostream& out) { print_cases(out, sweep, columns.cases, top); });
  if (!files.patches.empty() && !columns.patches.empty())
    write_text(files.patches, [&](std::ostream& out) { print_patches(out, sweep, columns.patches, top); });
  if (!files.units.empty())
    write_text(files.units, [&](std::ostream& out) { print_units(out, sweep, columns); });
}

} // namespace bem_contact::app
