#include "bem_contact/app/commands/conicity_maps.hpp"

#include "bem_contact/app/number_list.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/system/files.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/record/csv.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <ostream>

namespace bem_contact::app {

namespace {

constexpr int most_gauges = 1000; // a typing error

/// The names of a pattern as FOLDER/*.whl, sorted; any other name alone.
std::vector<std::string> names_of_pattern(const std::string& given) {
  if (is_standard_profile(given) || given.find_first_of("*?[") == std::string::npos || file_exists(given))
    return {given};
  const std::vector<std::string> out = system::files_like(given);
  if (out.empty())
    throw InputError(fmt::format("'{}' is no profile", given), "no file has a name like this",
                     "Give a pattern of files that are there, in quotes, as 'FOLDER/*.whl'.");
  return out;
}

std::vector<std::string> all_names(const std::vector<std::string>& given) {
  std::vector<std::string> out;
  for (const std::string& one : given)
    std::ranges::move(names_of_pattern(one), std::back_inserter(out));
  return out;
}

std::vector<double> gauges_of(const std::string& text) {
  if (text.empty())
    return {};
  if (auto steps = equal_steps(text, most_gauges))
    return *steps;
  throw InputError(fmt::format("The gauges '{}' cannot be read", text),
                   fmt::format("they are not FROM:TO:COUNT with a count of 2 to {}", most_gauges),
                   "Give them in mm, as 1430:1440:11.");
}

/// The name of a file without its folders.
std::string profile_title(const std::string& name) {
  return is_standard_profile(name) ? name : std::filesystem::path(name).filename().string();
}

std::string number_or_none(double value, const char* format) {
  return std::isnan(value) ? "none" : fmt::format(fmt::runtime(format), value);
}

} // namespace

bool MapArguments::asked() const {
  return !wheels.empty() || !rails.empty() || !gauges.empty() || noise->count() > 0;
}

void add_map_options(CLI::App& line, MapArguments& map) {
  const auto names = [&](const char* option, std::vector<std::string>& list, const char* what) {
    line.add_option(option, list, what)
        ->expected(1, -1)
        ->configurable(false)
        ->group("A map of many wheelsets");
  };
  names("--wheels", map.wheels, "Profiles of wheels: standards, files, patterns in quotes");
  names("--rails", map.rails, "Profiles of rails");
  const auto in_group = [](CLI::Option* option) { return option->group("A map of many wheelsets"); };
  in_group(line.add_option("--gauges", map.gauges, "Track gauges FROM:TO:COUNT, mm"));
  in_group(line.add_option("--amplitude", map.amplitude, "Amplitude of the conicity in a map, mm"))
      ->check(CLI::Range(0.1, 45.0))
      ->capture_default_str();
  map.noise = in_group(line.add_option("--noise", map.scatter.noise,
                                       "Standard deviation of a profile's points, mm: what does it do?"))
                  ->check(CLI::Range(0.0, 1.0));
  in_group(line.add_option("--draws", map.scatter.draws, "How often noise is drawn"))
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  in_group(line.add_option("--seed", map.scatter.seed, "Other seeds give other draws"))
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
}

ConicityMapRange map_range(const MapArguments& map, bool rolls) {
  return {.wheels = all_names(map.wheels),
          .rails = all_names(map.rails),
          .gauges = gauges_of(map.gauges),
          .amplitude = map.amplitude,
          .rolls = rolls,
          .scatter = map.noise->count() > 0 ? std::optional(map.scatter) : std::nullopt};
}

std::string map_text(const ConicityMap& map) {
  std::size_t wheel = 5, rail = 4;
  for (const std::string& name : map.wheels)
    wheel = std::max(wheel, profile_title(name).size());
  for (const std::string& name : map.rails)
    rail = std::max(rail, profile_title(name).size());
  std::string out =
      fmt::format("Equivalent conicity (EN 15302) for an amplitude of {:g} mm{}\n", map.amplitude,
                  map.scatter ? fmt::format("; points of profiles scatter by {:g} mm, {} draws, seed {}",
                                            map.scatter->noise, map.scatter->draws, map.scatter->seed)
                              : "");
  out += fmt::format("  {:{}}  {:{}} {:>9} {:>9} {:>13}{} {:>8} {:>13}\n", "wheel", wheel, "rail", rail,
                     "gauge mm", "tan gamma", "wavelength m", map.scatter ? "      mean    spread" : "",
                     "play mm", "nonlinearity");
  for (const ConicityMap::Entry& e : map.entries)
    out +=
        fmt::format("  {:{}}  {:{}} {:9g} {:>9} {:>13}{} {:>8} {:>13}\n", profile_title(map.wheels[e.wheel]),
                    wheel, profile_title(map.rails[e.rail]), rail, e.gauge,
                    number_or_none(e.tan_gamma, "{:.4f}"), number_or_none(1e-3 * e.wavelength, "{:.3f}"),
                    map.scatter ? fmt::format(" {:>9} {:>9}", number_or_none(e.mean, "{:.4f}"),
                                              number_or_none(e.spread, "{:.4f}"))
                                : "",
                    number_or_none(e.play, "{:.2f}"), number_or_none(e.nonlinearity, "{:+.4f}"));
  return out;
}

void write_map_csv(std::ostream& out, const ConicityMap& map) {
  record::Table table = record::table_of("", map_columns(), map.entries);
  if (map.scatter)
    std::ranges::move(record::table_of("", scatter_columns(), map.entries).columns,
                      std::back_inserter(table.columns));
  out << "wheel,rail," << record::csv_head(table) << '\n';
  for (std::size_t row = 0; row < table.size(); ++row)
    out << record::csv_text(map.wheels[map.entries[row].wheel]) << ','
        << record::csv_text(map.rails[map.entries[row].rail]) << ',' << record::csv_line(table, row) << '\n';
}

} // namespace bem_contact::app
