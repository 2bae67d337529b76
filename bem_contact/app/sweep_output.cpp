#include "bem_contact/app/sweep_output.hpp"

#include "bem_contact/app/settings.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/provenance.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <limits>
#include <ostream>

namespace bem_contact::app {

namespace {

double number(const SchemaValue& value) {
  if (const auto* v = std::get_if<double>(&value))
    return *v;
  if (const auto* v = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*v);
  return std::get<bool>(value) ? 1.0 : 0.0;
}

/// RFC 4180: doubled quotes.
std::string quoted(const std::string& text) {
  std::string out(1, '"');
  for (const char c : text) {
    out.append(c == '"' ? 1 : 0, '"');
    out.push_back(c == '\n' ? ' ' : c);
  }
  out.push_back('"');
  return out;
}

} // namespace

const char* status_text(CaseStatus status) {
  switch (status) {
  case CaseStatus::certified:
    return "certified";
  case CaseStatus::not_certified:
    return "not certified";
  case CaseStatus::refused:
    return "refused";
  case CaseStatus::died:
    return "died";
  case CaseStatus::missing:
    break;
  }
  return "missing";
}

SweepOutput::SweepOutput(const SweepFile& sweep, std::string digest)
    : sweep_(&sweep), digest_(std::move(digest)), status_(sweep.size(), CaseStatus::missing),
      seconds_(sweep.size(), std::nan("")), cpu_seconds_(sweep.size(), std::nan("")),
      summary_(summary_columns().size(), std::vector<double>(sweep.size(), std::nan(""))) {}

void SweepOutput::add(const CaseRecord& record) {
  if (record.index >= status_.size() || status_[record.index] != CaseStatus::missing)
    return;
  status_[record.index] = record.status;
  seconds_[record.index] = record.seconds;
  cpu_seconds_[record.index] = record.cpu_seconds;
  for (std::size_t k = 0; k < record.summary.size() && k < summary_.size(); ++k)
    summary_[k][record.index] = record.summary[k];
}

std::size_t SweepOutput::count(CaseStatus status) const {
  return static_cast<std::size_t>(std::ranges::count(status_, status));
}

H5Table SweepOutput::top() const {
  H5Table table;
  const std::size_t n = status_.size();
  const auto line = [&](const std::string& name, std::vector<double> values, std::string unit,
                        std::string description) {
    table.datasets[name] = {{n}, std::move(values), std::move(unit), std::move(description)};
  };
  for (std::size_t a = 0; a < sweep_->axes.size(); ++a) {
    const SweepFile::Axis& axis = sweep_->axes[a];
    const bool text = std::holds_alternative<std::string>(axis.values.front());
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = sweep_->indices(i)[a];
      values[i] = text ? static_cast<double>(at) : number(axis.values[at]);
    }
    std::string description = text ? "which of" : "swept over";
    for (const SchemaValue& value : axis.values)
      if (text)
        description.append(" ").append(to_text(value));
    line(axis.key, std::move(values), "", std::move(description));
  }
  std::vector<double> status(n);
  std::ranges::transform(status_, status.begin(), [](CaseStatus s) { return static_cast<double>(s); });
  line("status", std::move(status), "1",
       "0 missing, 1 certified, 2 not certified, 3 refused, 4 its process died");
  line("seconds", seconds_, "s", "wall clock");
  line("cpu_seconds", cpu_seconds_, "s", "of its process");
  for (std::size_t k = 0; k < summary_.size(); ++k) {
    const SummaryColumn& column = summary_columns()[k];
    line(column.name, summary_[k], column.unit, column.description);
  }
  auto& a = table.attributes;
  a["format"] = std::string(sweep_format);
  a["program"] = provenance("bem_contact");
  a["digest"] = digest_;
  a["scene"] = sweep_->source;
  if (sweep_->text.size() < largest_attribute)
    a["scene_text"] = sweep_->text;
  a["cases"] = static_cast<double>(n);
  for (const CaseStatus s : {CaseStatus::missing, CaseStatus::certified, CaseStatus::not_certified,
                             CaseStatus::refused, CaseStatus::died}) {
    std::string name = status_text(s);
    std::ranges::replace(name, ' ', '_');
    a[name] = static_cast<double>(count(s));
  }
  return table;
}

H5Table group_of(const CaseRecord& record) {
  const std::string group = fmt::format("cases/{:06}/", record.index);
  H5Table table;
  for (const auto& [name, data] : record.fields.datasets)
    table.datasets[group + name] = data;
  for (const auto& [name, value] : record.fields.attributes)
    table.attributes[group + name] = value;
  if (!record.reason.empty())
    table.attributes[group + "reason"] = record.reason;
  return table;
}

void write_csv(const std::filesystem::path& csv, const SweepFile& sweep, const H5Table& top,
               const std::vector<std::string>& reasons) {
  write_text(csv, [&](std::ostream& out) {
    fmt::print(out, "case");
    for (const SweepFile::Axis& axis : sweep.axes)
      fmt::print(out, ",{}", axis.key);
    fmt::print(out, ",status,seconds,cpu_seconds");
    for (const SummaryColumn& column : summary_columns())
      fmt::print(out, ",{}", column.name);
    fmt::print(out, ",reason\n");
    const auto cell = [&](const std::string& name, std::size_t i) {
      const double value = top.datasets.at(name).values[i];
      return std::isnan(value) ? std::string() : fmt::format("{}", value);
    };
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      fmt::print(out, "{}", i);
      for (const SceneChange& change : sweep.changes(i)) {
        const auto* text = std::get_if<std::string>(&change.value);
        fmt::print(out, ",{}", text ? quoted(*text) : to_text(change.value));
      }
      fmt::print(out, ",{},{},{}", status_text(static_cast<CaseStatus>(top.datasets.at("status").values[i])),
                 cell("seconds", i), cell("cpu_seconds", i));
      for (const SummaryColumn& column : summary_columns())
        fmt::print(out, ",{}", cell(column.name, i));
      fmt::print(out, ",{}\n", reasons[i].empty() ? "" : quoted(reasons[i]));
    }
  });
}

} // namespace bem_contact::app
