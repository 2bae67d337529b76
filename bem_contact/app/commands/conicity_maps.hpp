#pragma once

#include "bem_contact/uses/conicity/conicity_map.hpp"

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Options of the command conicity that ask for many wheelsets.
struct MapArguments {
  std::vector<std::string> wheels, rails; ///< standards, files, patterns
  std::string gauges;                     ///< FROM:TO:COUNT
  ProfileScatter scatter;
  CLI::Option* noise = nullptr; ///< given: the profiles are drawn
  double amplitude = 3;         ///< mm

  bool asked() const;
};

void add_map_options(CLI::App& line, MapArguments& map);

/// What is asked for; without wheels or rails where none are given. Files of a pattern are sorted by their
/// names. Throws InputError for a pattern that no file has and for gauges that cannot be read.
ConicityMapRange map_range(const MapArguments& map, bool rolls);

/// A table for people: a line for each wheel, rail and gauge.
std::string map_text(const ConicityMap& map);
/// The same as CSV, with all columns and the names of the profiles.
void write_map_csv(std::ostream& out, const ConicityMap& map);

} // namespace bem_contact::app
