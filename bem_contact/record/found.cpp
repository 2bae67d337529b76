#include "bem_contact/record/found.hpp"

#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact::record {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct KindOfAnswer {
  std::string_view page; ///< FileKind::page
  Found (*found)(const Record&);
};
constexpr KindOfAnswer kinds_of_answers[] = {{"result", of_result},
                                             {"comparison", of_comparison},
                                             {"wheelset", of_wheelset},
                                             {"sweep", of_sweep},
                                             {"creep curves", of_creep_curves},
                                             {"fit", of_fit},
                                             {"conicity", of_conicity},
                                             {"conicity map", of_conicity_map},
                                             {"table", of_table},
                                             {"wear", of_wear},
                                             {"wear of one contact", of_contact_wear},
                                             {"fatigue", of_fatigue},
                                             {"shakedown", of_shakedown},
                                             {"stresses", of_stresses},
                                             {"study", of_study}};

/// The column at "patches/pmax"; null: none.
const Column* column_at(const Record& record, const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const Content* above = slash == path.npos ? nullptr : find(record, path.substr(0, slash));
  const auto* table = above ? std::get_if<Table>(above) : nullptr;
  return table ? table->column(path.substr(slash + 1)) : nullptr;
}

template <class Better>
std::optional<std::size_t> best_of(const Record& record, const std::string& path, Better better) {
  const std::span<const double> values = values_at(record, path);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && (!best || better(values[i], values[*best])))
      best = i;
  return best;
}

} // namespace

std::optional<Stated> stated_at(const Record& record, const std::string& path, std::size_t at) {
  Stated out{none, none, {}};
  const Content* content = find(record, path);
  const auto* number = content ? std::get_if<Number>(content) : nullptr;
  if (number)
    out = {number->value, number->error.value_or(none), number->unit};
  else if (const std::span<const double> values = values_at(record, path); at < values.size()) {
    const auto* field = content ? std::get_if<Field>(content) : nullptr;
    const Column* column = field ? nullptr : column_at(record, path);
    const std::span<const double> errors = values_at(record, error_name(path));
    out = {values[at], at < errors.size() ? errors[at] : none,
           field    ? field->unit
           : column ? column->unit
                    : std::string()};
  }
  return std::isfinite(out.value) ? std::optional(out) : std::nullopt;
}

std::string text_of(const Stated& number) {
  const std::string unit = number.unit.substr(0, number.unit.find(" (")); // "N (shift: N mm)" of all cases
  return rounded(number.value, number.error) + (unit.empty() || unit == "1" ? "" : " " + unit);
}

std::string said(const Record& record, const std::string& path) {
  const auto number = stated_at(record, path);
  return number ? text_of(*number) : "";
}

std::optional<std::size_t> largest_of(const Record& record, const std::string& path) {
  return best_of(record, path, std::greater<>());
}
std::optional<std::size_t> smallest_of(const Record& record, const std::string& path) {
  return best_of(record, path, std::less<>());
}

const Record& part(const Record& record, std::string_view path) {
  static const Record empty;
  const Content* content = find(record, path);
  const auto* found = content ? std::get_if<Record>(content) : nullptr;
  return found ? *found : empty;
}

NextQuestion question(const Record& answer, const char* asks, const char* command) {
  return {asks, fmt::format("bem_contact {} {}", command, text_at(answer, "scene").value_or("SCENE.toml"))};
}

void add_if(std::vector<std::string>& lines, std::string line) {
  if (!line.empty())
    lines.push_back(std::move(line));
}

Found found_in(const Record& answer, std::string_view kind) {
  const auto* known = std::ranges::find(kinds_of_answers, kind, &KindOfAnswer::page);
  return known == std::ranges::end(kinds_of_answers) ? Found{} : known->found(answer);
}

Found found_in(const Record& answer) {
  const FileKind* kind = kind_of(text_at(answer, "format").value_or(""));
  return kind ? found_in(answer, kind->page) : Found{};
}

Record with_found(Record answer) {
  Found found = found_in(answer);
  if (found.sentences.empty())
    return answer;
  Texts next{{}, "what may be asked next"};
  std::ranges::transform(found.next, std::back_inserter(next.lines), &NextQuestion::text);
  Record out{{"found", Texts{std::move(found.sentences), "what was found"}}, {"next", std::move(next)}};
  return std::move(out.append(std::move(answer)));
}

std::string found_text(const Record& answer) {
  std::string out;
  for (const std::string& sentence : found_in(answer).sentences)
    out += sentence + "\n";
  return out.empty() ? "" : out + "\n";
}

} // namespace bem_contact::record
