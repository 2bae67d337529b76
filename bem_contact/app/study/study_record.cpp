#include "bem_contact/app/study/study_record.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

namespace bem_contact::app {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Which number of a column or a field counts.
enum Pick { first = 0, last = -1, largest = -2, of_three_millimetres = -3 };

/// Where a number of the headline stands in the record of a part. Pick: or an index from 0.
struct HeadlinePlace {
  std::string path;
  int pick = first;
};

/// Those of a part, as words.json has them: a path alone, or with which number counts.
std::vector<HeadlinePlace> headline_places(const std::string& part) {
  static const auto all = nlohmann::json::parse(record_words_json).at("headlines of a study");
  static const std::map<std::string, int> picks{
      {"last", last}, {"largest", largest}, {"at 3 mm", of_three_millimetres}};
  std::vector<HeadlinePlace> out;
  for (const auto& place : all.value(part, nlohmann::json::array()))
    if (place.is_string())
      out.push_back({place});
    else
      out.push_back({place[0], place[1].is_number() ? place[1].get<int>() : picks.at(place[1])});
  return out;
}

/// Numbers at a path with their unit; one number is a column of one.
struct FoundNumbers {
  std::vector<double> values;
  std::string unit, meaning;
};

FoundNumbers numbers_at(const record::Record& record, const std::string& path) {
  FoundNumbers out;
  if (const record::Content* content = record::find(record, path)) {
    if (const auto* number = std::get_if<record::Number>(content))
      return {{number->value}, number->unit, number->meaning};
    if (const auto* field = std::get_if<record::Field>(content))
      return {{field->values.begin(), field->values.end()}, field->unit, field->meaning};
    return out;
  }
  const std::size_t slash = path.rfind('/');
  const record::Content* above =
      slash == std::string::npos ? nullptr : record::find(record, path.substr(0, slash));
  const auto* table = above ? std::get_if<record::Table>(above) : nullptr;
  if (const record::Column* column = table ? table->column(path.substr(slash + 1)) : nullptr)
    return {column->values, column->unit, column->meaning};
  return out;
}

/// Of the number that counts; nothing where there is none.
std::optional<std::size_t> index_of(const record::Record& record, const HeadlinePlace& place,
                                    const std::vector<double>& values) {
  std::optional<std::size_t> out;
  if (place.pick == last)
    return values.empty() ? out : values.size() - 1;
  if (place.pick >= 0)
    return std::size_t(place.pick) < values.size() ? std::optional<std::size_t>(place.pick) : out;
  const std::vector<double> amplitudes = numbers_at(record, "conicity/amplitude").values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (place.pick == largest ? std::isfinite(values[i]) && (!out || values[i] > values[*out])
                              : i < amplitudes.size() && std::abs(amplitudes[i] - 3) < 1e-9)
      out = i;
  return out;
}

/// Of forces by xi and eta, in N: the matrix has other units elsewhere.
bool is_derivative(const HeadlinePlace& place) {
  return place.path == "slopes" || place.path == "sensitivities";
}

/// "dFx/dxi" for the numbers of a matrix of forces by creepages.
std::string name_of_place(const HeadlinePlace& place) {
  const std::string& path = place.path;
  if (is_derivative(place))
    return fmt::format("{}: d{}/d{}", path, place.pick / 3 == 0 ? "Fx" : "Fs",
                       place.pick % 3 == 0 ? "xi" : "eta");
  if (place.pick == largest)
    return "largest " + path;
  return place.pick == of_three_millimetres ? path + " at 3 mm" : path;
}

std::optional<HeadlineNumber> number_of(const PartResult& result, const record::Record& record,
                                        const HeadlinePlace& place) {
  const FoundNumbers found = numbers_at(record, place.path);
  const std::optional<std::size_t> at = index_of(record, place, found.values);
  if (!at || !std::isfinite(found.values[*at]))
    return std::nullopt;
  const std::string error_path = record::error_name(place.path);
  const std::vector<double> errors = numbers_at(record, error_path).values; // of a field or a table
  const double error =
      *at < errors.size() ? errors[*at] : record::number_at(record, error_path).value_or(not_known);
  return HeadlineNumber{.part = result.part,
                        .name = name_of_place(place),
                        .meaning = found.meaning,
                        .unit = is_derivative(place) ? "N" : found.unit,
                        .value = found.values[*at],
                        .element_error = error,
                        .input_spread = not_known};
}

/// Calls `take` with each table of a record and its path.
void each_table(const record::Record& record, const std::string& path,
                const std::function<void(const std::string&, const record::Table&)>& take) {
  for (const record::Entry& entry : record.entries()) {
    if (const auto* table = std::get_if<record::Table>(&entry.content))
      take(path + "_" + entry.name, *table);
    else if (const auto* inner = std::get_if<record::Record>(&entry.content))
      each_table(*inner, path + "_" + entry.name, take);
  }
}

record::Table headline_table(const std::vector<HeadlineNumber>& headline) {
  record::Column value{"value", "", "in its unit"}, elements{"element_error", "", record::error_meaning},
      inputs{"input_spread", "", "standard deviation by the scatter of the inputs; nan: not drawn"},
      draws{"draws", "1", "draws that have the number", {}, true};
  for (const HeadlineNumber& number : headline) {
    value.values.push_back(number.value);
    elements.values.push_back(number.element_error);
    inputs.values.push_back(number.input_spread);
    draws.values.push_back(number.draws);
  }
  return {"number", {value, elements, inputs, draws}};
}

record::Content states_field(const std::vector<HeadlineNumber>& headline, std::size_t states) {
  std::vector<double> values;
  for (const HeadlineNumber& number : headline)
    values.insert(values.end(), number.by_state.begin(), number.by_state.end());
  return record::field(std::move(values), "", "[number][state], each in its unit; nan: not known",
                       {headline.size(), states});
}

record::Texts texts_of(const std::vector<HeadlineNumber>& headline, const char* meaning,
                       const std::function<std::string(const HeadlineNumber&)>& text) {
  record::Texts out{{}, meaning};
  std::ranges::transform(headline, std::back_inserter(out.lines), text);
  return out;
}

record::Record taken_record(const SceneText& scene) {
  record::Record out;
  for (const TakenValue& taken : taken_values(scene))
    out.add(taken.key, record::Record{{"value", record::Text{taken.value}},
                                      {"unit", record::Text{taken.unit}},
                                      {"given", taken.given}});
  return out;
}

} // namespace

record::Record record_of_part(const PartResult& result) {
  if (result.file.empty())
    return {};
  const bool cases = result.part->kind == PartKind::sweep;
  return cases ? record::read_hdf5_top(result.file, "patches") : record::read_hdf5(result.file);
}

std::vector<HeadlineNumber> headline_of(const std::vector<PartResult>& results) {
  std::vector<HeadlineNumber> out;
  for (const PartResult& result : results) {
    const record::Record record = record_of_part(result);
    for (const HeadlinePlace& place : headline_places(result.part->name))
      if (const auto number = number_of(result, record, place))
        out.push_back(*number);
  }
  return out;
}

record::Record study_record(const GivenScene& given, const std::filesystem::path& output,
                            const std::vector<PartResult>& results,
                            const std::vector<HeadlineNumber>& headline,
                            const std::vector<std::string>& states) {
  record::Record out = headed(study_format, given, output), parts;
  out.add("taken", taken_record(given.text));
  out.add("headline", headline_table(headline));
  out.add("headline_parts",
          texts_of(headline, "part of each number", [](const auto& n) { return std::string(n.part->name); }));
  out.add("headline_names", texts_of(headline, "its name", [](const auto& n) { return n.name; }));
  out.add("headline_units", texts_of(headline, "its unit", [](const auto& n) { return n.unit; }));
  out.add("headline_meanings", texts_of(headline, "in words", [](const auto& n) { return n.meaning; }));
  if (!states.empty()) {
    out.add("states", record::Texts{states, "states of the surfaces (layer.state)"});
    out.add("headline_states", states_field(headline, states.size()));
  }
  for (const PartResult& result : results) {
    record::Record one = record_of_part(result);
    const FileKind* kind = kind_of(record::text_at(one, "format").value_or(""));
    one.add("study_title", std::string(result.part->title));
    one.add("study_page", std::string(kind ? kind->page : ""));
    one.add("study_status", std::string(name_of(outcome_of(result))));
    one.add("study_about", result.about);
    one.add("study_code", record::Number{double(result.code), "1", "exit code", {}, true});
    one.add("study_order", record::Number{double(parts.entries().size()), "1", "among the parts", {}, true});
    one.add("study_seconds", record::Number{result.seconds, "s", "that it took"});
    one.add("study_errors", record::Texts{result.errors, "what went wrong"});
    parts.add(result.part->name, std::move(one));
  }
  return out.add("parts", std::move(parts));
}

std::vector<std::string> write_tables(OutputFolder& folder, const std::vector<PartResult>& results,
                                      const std::vector<HeadlineNumber>& headline,
                                      const std::vector<std::string>& states) {
  std::vector<std::string> names;
  const auto write = [&](std::string name, const std::function<void(std::ostream&)>& lines) {
    folder.write(name += ".csv", lines);
    names.push_back(name);
  };
  for (const PartResult& result : results) {
    if (result.part->kind == PartKind::sweep) { // the command has written them
      for (const char* name : {"sweep.csv", "sweep_patches.csv", "sweep_units.csv"})
        if (file_exists(folder / name))
          names.emplace_back(name);
      continue;
    }
    each_table(record_of_part(result), result.part->name,
               [&](const std::string& name, const record::Table& table) {
                 write(name, [&](std::ostream& out) { record::write_csv(out, table); });
               });
    if (const auto steps = result.file.parent_path() / "wear.csv"; file_exists(steps))
      write("wear", [&](std::ostream& out) { out << read_text_file(steps.string(), "table"); });
  }
  write("study", [&](std::ostream& out) {
    out << "part,name,value,element_error,input_spread,draws,unit\n";
    for (const HeadlineNumber& n : headline)
      out << fmt::format("{},{},{},{},{},{},{}\n", n.part->name, n.name, record::csv_cell(n.value, 9),
                         record::csv_cell(n.element_error, 3), record::csv_cell(n.input_spread, 3), n.draws,
                         n.unit);
  });
  if (!states.empty())
    write("states", [&](std::ostream& out) {
      out << fmt::format("part,name,value,{},unit\n", fmt::join(states, ","));
      for (const HeadlineNumber& n : headline) {
        out << fmt::format("{},{},{}", n.part->name, n.name, record::csv_cell(n.value, 9));
        for (const double value : n.by_state)
          out << ',' << record::csv_cell(value, 9);
        out << ',' << n.unit << '\n';
      }
    });
  return names;
}

} // namespace bem_contact::app
