#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <atomic>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// How far the points of measured profiles scatter, and how often that is drawn.
struct ProfileScatter {
  double noise = 0; ///< standard deviation of a point along the normal, mm
  int draws = 20;   ///< 2 at least
  int seed = 1;     ///< at least 0; the same seed gives the same draws
};

/// What a map is of: every wheel on every rail at every gauge.
struct ConicityMapRange {
  std::vector<std::string> wheels, rails; ///< standards or files, as a scene names them; one at least
  std::vector<double> gauges;             ///< mm; empty: that of the scene
  double amplitude = 3;                   ///< mm
  bool rolls = false;                     ///< WheelsetOnTrack::rolls
  std::optional<ProfileScatter> scatter = {};
};

/// Equivalent conicities over profiles and gauges.
struct ConicityMap {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  /// A wheel on a rail at a gauge. nan: no motion has this amplitude, or a wheel finds no touch point.
  struct Entry {
    std::size_t wheel = 0, rail = 0;                          ///< which of them
    double gauge = 0;                                         ///< mm
    double tan_gamma = unknown, wavelength = unknown;         ///< 1, mm; at the amplitude of the map
    double rail_travel = unknown, wheel_travel = unknown;     ///< WheelsetConicity::Value, mm
    double play = unknown;                                    ///< mm
    double rated_amplitude = unknown, nonlinearity = unknown; ///< WheelsetConicity
    /// Over the draws of the scatter: mean and standard deviation of tan_gamma, deviation of nonlinearity.
    double mean = unknown, spread = unknown, nonlinearity_spread = unknown;
    int draws = 0; ///< in which a motion has the amplitude
  };
  std::vector<std::string> wheels, rails; ///< as given
  double amplitude = 0;                   ///< mm
  std::optional<ProfileScatter> scatter;
  std::vector<Entry> entries; ///< by wheel, then by rail, then by gauge
};

/// The map. `scene_of` returns the scene of a wheel and a rail, both names as in the range; its track counts.
/// Each draw scatters the points of both profiles, and reads them with the smoothing of the scene or the one
/// that their noise asks for; both sides have the same profiles. An entry has the same draws whatever else is
/// in the map. Warns where a wheel finds no touch point. Throws InputError for an amplitude or
/// a scatter that is none, and for profiles that cannot be read; Stopped soon after another thread sets
/// `stop`. `done` is called after each entry.
ConicityMap conicity_map(const ConicityMapRange& range,
                         const std::function<SceneFile(const std::string&, const std::string&)>& scene_of,
                         const std::function<void()>& done, const std::atomic<bool>* stop = nullptr);

/// Columns of the entries in the order of the outputs, without and with those of a scatter.
std::span<const ColumnOf<ConicityMap::Entry>> map_columns();
std::span<const ColumnOf<ConicityMap::Entry>> scatter_columns();
/// What the map says at every door: the table "map", whose wheels and rails are places in the lists of names.
record::Record record_of(const ConicityMap& map);

} // namespace bem_contact
