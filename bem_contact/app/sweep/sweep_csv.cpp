#include "bem_contact/app/sweep/sweep_csv.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <ostream>

namespace bem_contact::app {

namespace {

/// Some rows of a table, column by column.
class Rows {
public:
  Rows(const H5Reader& file, const std::string& group, std::vector<SweepColumn> columns, CaseRange rows)
      : columns_(std::move(columns)) {
    for (const SweepColumn& column : columns_) {
      values_.push_back(file.line(group + column.name, rows.first, rows.size()));
      if (is_model(column))
        require_within({0, EnumNames<Model>::names.size()}, values_.back(), group + column.name, file.file(),
                       true);
    }
  }

  std::span<const double> column(std::size_t k) const { return values_[k]; }
  double at(std::size_t row, std::size_t column) const { return values_[column][row]; }
  /// Cells of a row from a column on; an empty one for nan.
  void print(std::ostream& out, std::size_t row, std::size_t column) const {
    for (; column < columns_.size(); ++column)
      if (const double value = at(row, column); std::isnan(value))
        fmt::print(out, ",");
      else if (is_model(columns_[column]))
        fmt::print(out, ",{}", name_of(static_cast<Model>(value)));
      else
        fmt::print(out, ",{}", value);
  }

private:
  std::vector<SweepColumn> columns_;
  std::vector<std::vector<double>> values_;
};

/// Calls `print` with some rows after the others, and the number of the first.
void for_rows(const H5Reader& file, const std::string& group, const std::vector<const char*>& first_columns,
              const std::vector<SweepColumn>& more, std::size_t count, const auto& print) {
  std::vector<SweepColumn> columns;
  for (const char* name : first_columns)
    columns.push_back({name, {}, {}});
  columns.insert(columns.end(), more.begin(), more.end());
  for (std::size_t first = 0; first < count; first += rows_at_once) {
    const CaseRange rows{first, std::min(count, first + rows_at_once)};
    print(Rows(file, group, columns, rows), rows);
  }
}

std::string_view status_word(double status, const H5Reader& file) {
  require_within({0, record::outcomes_of_cases}, std::span(&status, 1), "status", file.file());
  return name_of(static_cast<record::Outcome>(status));
}

void print_axes(std::ostream& out, const SweepFile& sweep) {
  for (const SweepFile::Axis& axis : sweep.axes)
    fmt::print(out, ",{}", axis.key);
  if (!sweep.weights.empty())
    fmt::print(out, ",weight");
}

void print_changes(std::ostream& out, const SweepFile& sweep, std::size_t i) {
  const std::vector<std::size_t> at = sweep.indices(i);
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const SchemaValue& value = sweep.axes[a].values[at[a]];
    const auto* text = std::get_if<std::string>(&value);
    fmt::print(out, ",{}", text ? record::csv_text(*text) : bem_contact::to_text(value));
  }
  if (!sweep.weights.empty())
    fmt::print(out, ",{}", sweep.weight(i));
}

void print_names(std::ostream& out, const std::vector<SweepColumn>& columns) {
  for (const SweepColumn& column : columns)
    fmt::print(out, ",{}", column.name);
}

void print_cases(std::ostream& out, const SweepFile& sweep, const std::vector<SweepColumn>& columns,
                 const H5Reader& file) {
  fmt::print(out, "case");
  print_axes(out, sweep);
  fmt::print(out, ",status,seconds,cpu_seconds");
  print_names(out, columns);
  fmt::print(out, ",reason\n");
  for_rows(file, "", {"status", "seconds", "cpu_seconds"}, columns, sweep.size(),
           [&](const Rows& rows, CaseRange cases) {
             for (std::size_t i = cases.first; i < cases.last; ++i) {
               fmt::print(out, "{}", i);
               print_changes(out, sweep, i);
               fmt::print(out, ",{}", status_word(rows.at(i - cases.first, 0), file));
               rows.print(out, i - cases.first, 1);
               const std::string reason = file.text(group_of_case(i), "reason");
               fmt::print(out, ",{}\n", reason.empty() ? "" : record::csv_text(reason));
             }
           });
}

void print_patches(std::ostream& out, const SweepFile& sweep, const std::vector<SweepColumn>& columns,
                   const H5Reader& file) {
  out << patches_begin;
  print_axes(out, sweep);
  fmt::print(out, ",status");
  print_names(out, columns);
  fmt::print(out, "\n");
  const std::string number_of_case = std::string(patch_group) + "case";
  for_rows(file, patch_group, {"case", "patch"}, columns, file.size(number_of_case),
           [&](const Rows& rows, CaseRange range) {
             const std::span<const double> cases = rows.column(0);
             require_within(sweep.all(), cases, number_of_case, file.file());
             const auto [first, last] = std::ranges::minmax(cases);
             const auto begin = static_cast<std::size_t>(first);
             const std::vector<double> status =
                 file.line("status", begin, static_cast<std::size_t>(last) + 1 - begin);
             for (std::size_t row = 0; row < range.size(); ++row) {
               const auto i = static_cast<std::size_t>(cases[row]);
               fmt::print(out, "{},{}", i, rows.at(row, 1));
               print_changes(out, sweep, i);
               fmt::print(out, ",{}", status_word(status[i - begin], file));
               rows.print(out, row, 2);
               fmt::print(out, "\n");
             }
           });
}

void print_units(std::ostream& out, const SweepFile& sweep, const SweepColumns& columns) {
  out << units_begin;
  std::vector<const char*> tables{"cases"};
  if (!columns.patches.empty())
    tables.push_back("patches");
  for (const char* table : tables)
    for (const SweepFile::Axis& axis : sweep.axes)
      fmt::print(out, "{},{},{},swept over\n", table, axis.key, axis.unit());
  if (!sweep.weights.empty())
    for (const char* table : tables)
      fmt::print(out, "{},weight,1,how often the case occurs compared with the others\n", table);
  fmt::print(out, "cases,status,1,{}\n", record::csv_text(status_description));
  fmt::print(out, "cases,seconds,s,{}\ncases,cpu_seconds,s,{}\n", record::csv_text(seconds_description),
             record::csv_text(cpu_description));
  const auto print = [&](const char* table, const std::vector<SweepColumn>& all) {
    for (const SweepColumn& column : all)
      fmt::print(out, "{},{},{},{}\n", table, column.name, column.unit, record::csv_text(column.description));
  };
  print("cases", columns.cases);
  print("patches", columns.patches);
}

} // namespace

void require_csv_texts(const SweepFile& sweep) {
  for (const SweepFile::Axis& axis : sweep.axes)
    for (const SchemaValue& value : axis.values)
      if (const auto* text = std::get_if<std::string>(&value))
        record::require_cell(*text, axis.key);
}

CsvFiles csv_files(const std::filesystem::path& csv) {
  if (csv.empty() || output_target(csv, OutputForm::text).stream)
    return {csv, {}, {}};
  const auto beside = [&](const char* what) {
    return csv.parent_path() / (csv.stem().string() + what + csv.extension().string());
  };
  return {csv, beside("_patches"), beside("_units")};
}

void write_csv(const CsvFiles& files, const SweepFile& sweep, const SweepColumns& columns,
               const H5Reader& file) {
  write_text(files.cases, [&](std::ostream& out) { print_cases(out, sweep, columns.cases, file); });
  if (!files.patches.empty() && !columns.patches.empty())
    write_text(files.patches, [&](std::ostream& out) { print_patches(out, sweep, columns.patches, file); });
  if (!files.units.empty())
    write_text(files.units, [&](std::ostream& out) { print_units(out, sweep, columns); });
}

} // namespace bem_contact::app
