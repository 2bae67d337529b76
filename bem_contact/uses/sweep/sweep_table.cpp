#include "bem_contact/uses/sweep/sweep_table.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/record/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>

namespace bem_contact {

namespace {

/// Characters. HDF5 takes 64 kB as an attribute; longer lists are in the scene, which the file has, too.
constexpr std::size_t longest_list = 32'000;

/// How long cases took: quantiles within a thousandth, in a memory that does not grow with their number.
class Times {
public:
  void add(double seconds) {
    Bin& bin = bins_[static_cast<int>(std::lround(std::log(std::max(seconds, shortest)) / width))];
    ++bin.count;
    bin.sum += seconds;
    ++count_;
  }
  std::size_t count() const { return count_; }
  double quantile(double share) const {
    auto left = static_cast<std::size_t>(share * double(count_ - 1));
    for (const auto& [place, bin] : bins_) {
      if (left < bin.count)
        return bin.sum / double(bin.count);
      left -= bin.count;
    }
    return 0;
  }

private:
  static constexpr double width = 1e-3;    ///< of the logarithm of seconds
  static constexpr double shortest = 1e-9; ///< s, what a clock tells

  struct Bin {
    std::size_t count = 0;
    double sum = 0;
  };
  std::map<int, Bin> bins_;
  std::size_t count_ = 0;
};

double number(const SchemaValue& value) {
  if (const auto* v = std::get_if<double>(&value))
    return *v;
  if (const auto* v = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*v);
  return std::get<bool>(value) ? 1.0 : 0.0;
}

bool has_texts(const SweepFile::Axis& axis) {
  return std::holds_alternative<std::string>(axis.values.front());
}

/// The texts of an axis, as far as an attribute holds them.
std::vector<std::string> choices_of(const SweepFile::Axis& axis) {
  std::vector<std::string> out;
  std::size_t size = 0;
  for (const SchemaValue& value : axis.values) {
    out.push_back(std::get<std::string>(value));
    size += out.back().size() + 1;
    if (size > longest_list)
      return {};
  }
  return out;
}

/// "which of S1002 worn.txt"
std::string description_of(const SweepFile::Axis& axis) {
  if (!has_texts(axis))
    return axis.is_note() ? "carried along" : "swept over";
  std::string out = axis.is_note() ? "carried along, which of" : "which of";
  for (const SchemaValue& value : axis.values) {
    if (out.size() > longest_list)
      return out + " ...";
    out.append(" ").append(to_text(value));
  }
  return out;
}

/// An axis without its values.
H5Dataset form_of(const SweepFile::Axis& axis) {
  return {.unit = axis.unit(),
          .description = description_of(axis),
          .role = std::string(name_of(axis.is_note() ? record::Role::carried : record::Role::swept)),
          .choices = has_texts(axis) ? choices_of(axis) : std::vector<std::string>()};
}

/// Of cases, in the order of the numbers in files.
std::vector<std::string> outcome_names() {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < record::outcomes_of_cases; ++i)
    out.emplace_back(name_of(static_cast<record::Outcome>(i)));
  return out;
}

void add_axes(H5Table& table, const std::string& group, const SweepFile& sweep,
              std::span<const std::size_t> cases) {
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    const SweepFile::Axis& axis = sweep.axes[a];
    const bool text = has_texts(axis);
    H5Dataset& line = table.datasets[group + axis.key] = form_of(axis);
    line.shape = {cases.size()};
    for (const std::size_t i : cases) {
      const std::size_t at = sweep.indices(i)[a];
      line.values.push_back(text ? static_cast<double>(at) : number(axis.values[at]));
    }
  }
}

H5Dataset line_of(const SweepColumn& column, std::vector<double> values) {
  H5Dataset out = H5Dataset::line(std::move(values), column.unit, column.description);
  out.role = name_of(column.role);
  out.of = column.of;
  return out;
}

void add_patches(H5Table& table, const SweepFile& sweep, const SweepColumns& columns, SweepNumbers& numbers) {
  const auto add = [&](const SweepColumn& column, std::vector<double> values) {
    table.datasets[patch_group + column.name] = line_of(column, std::move(values));
  };
  add({"case", "1", "the case, from 0"}, {numbers.patch_case.begin(), numbers.patch_case.end()});
  add({"patch", "1", "1: the largest force"}, {numbers.patch_rank.begin(), numbers.patch_rank.end()});
  add_axes(table, patch_group, sweep, numbers.patch_case);
  for (std::size_t k = 0; k < numbers.patches.size(); ++k)
    add(columns.patches[k], std::move(numbers.patches[k]));
}

} // namespace

H5Table table_of(const SweepFile& sweep, const SweepColumns& columns, std::span<const SweepCase> cases) {
  H5Table table;
  const auto line = [&](const std::string& name, std::string unit, std::string description, auto value) {
    std::vector<double> values(cases.size());
    std::ranges::transform(cases, values.begin(), value);
    table.datasets[name] = H5Dataset::line(std::move(values), std::move(unit), std::move(description));
  };
  std::vector<std::size_t> numbers_of_cases(cases.size());
  std::ranges::transform(cases, numbers_of_cases.begin(), &SweepCase::index);
  add_axes(table, "", sweep, numbers_of_cases);
  line("status", "1", status_description, [](const SweepCase& r) { return static_cast<double>(r.status); });
  table.datasets["status"].role = name_of(record::Role::outcome);
  table.datasets["status"].choices = outcome_names();
  line("seconds", "s", seconds_description, std::mem_fn(&SweepCase::seconds));
  line("cpu_seconds", "s", cpu_description, std::mem_fn(&SweepCase::cpu_seconds));
  SweepNumbers numbers = numbers_of(cases, columns);
  for (std::size_t k = 0; k < numbers.cases.size(); ++k) {
    const SweepColumn& column = columns.cases[k];
    table.datasets[column.name] = line_of(column, std::move(numbers.cases[k]));
  }
  if (!columns.patches.empty())
    add_patches(table, sweep, columns, numbers);
  return table;
}

std::vector<SweepCase> missing_cases(CaseRange cases) {
  std::vector<SweepCase> out(cases.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].index = cases.first + i;
    out[i].seconds = out[i].cpu_seconds = std::nan("");
  }
  return out;
}

std::string group_of_case(std::size_t index) {
  return fmt::format("cases/{:06}", index);
}

void add_counts(H5Table& table, std::span<const std::size_t> counts) {
  for (std::size_t s = 0; s < counts.size(); ++s) {
    table.datasets[record::count_name(static_cast<record::Outcome>(s))] = {
        {}, {static_cast<double>(counts[s])}, "1", "cases of this status", true};
  }
}

std::size_t require_table(const H5Reader& file, const SweepColumns& columns, std::size_t cases) {
  for (const char* name : {"status", "seconds", "cpu_seconds"})
    file.require(name, cases);
  for (const SweepColumn& column : columns.cases)
    file.require(column.name, cases);
  if (columns.patches.empty())
    return 0;
  const std::string group = patch_group;
  const std::size_t patches = file.size(group + "case");
  for (const char* name : {"case", "patch"})
    file.require(group + name, patches);
  for (const SweepColumn& column : columns.patches)
    file.require(group + column.name, patches);
  return patches;
}

void require_within(CaseRange range, std::span<const double> values, const std::string& name,
                    const std::filesystem::path& file, bool may_be_nan) {
  const auto first = static_cast<double>(range.first), last = static_cast<double>(range.last);
  for (const double value : values)
    if (!(value >= first && value < last) && !(may_be_nan && std::isnan(value)))
      throw InputError(fmt::format("The file '{}' is damaged", file.string()),
                       fmt::format("its dataset '{}' has a number {}, not {} to {}", name, value, range.first,
                                   range.last - 1),
                       "Copy it again from where it was whole, or make it again.");
}

SweepSummary sweep_summary(const H5Reader& file, std::size_t cases) {
  std::array<std::size_t, record::outcomes_of_cases> counts{};
  std::size_t warned = 0;
  Times times;
  for (std::size_t first = 0; first < cases; first += rows_at_once) {
    const std::size_t count = std::min(rows_at_once, cases - first);
    const std::vector<double> status = file.line("status", first, count);
    require_within({0, record::outcomes_of_cases}, status, "status", file.file());
    const std::vector<double> warnings = file.line("warning_count", first, count);
    const std::vector<double> seconds = file.line("cpu_seconds", first, count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto kind = static_cast<record::Outcome>(status[i]);
      ++counts[static_cast<std::size_t>(kind)];
      warned += warnings[i] > 0; // nan: no result
      if (kind != record::Outcome::died && !std::isnan(seconds[i]))
        times.add(seconds[i]);
    }
  }

  SweepSummary out{record::counts_text(counts) + '\n', "",
                   counts[static_cast<std::size_t>(record::Outcome::certified)] == cases};
  if (warned > 0)
    out.more = fmt::format("{} warnings (column warning_count; reason says which)\n",
                           counted(warned, "case has", "cases have"));
  if (times.count() > 0)
    out.more += fmt::format("CPU seconds a case: median {:.3g}, 99 % below {:.3g}, largest {:.3g}\n",
                            times.quantile(0.5), times.quantile(0.99), times.quantile(1));
  return out;
}

} // namespace bem_contact
