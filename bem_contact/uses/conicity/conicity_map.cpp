#include "bem_contact/uses/conicity/conicity_map.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/noisy_profile.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

namespace {

/// mm. The nonlinearity needs amplitudes up to 4 mm, and the table reaches beyond the largest amplitude.
constexpr double rated_reach = 3.0;

/// Numbers whose mean and deviation are asked for.
struct Drawn {
  std::vector<double> values = {};

  void take(double value) {
    if (std::isfinite(value))
      values.push_back(value);
  }
  double mean() const { // from the first one: equal values have it to the last digit
    double sum = 0;
    for (const double value : values)
      sum += value - values.front();
    return values.empty() ? ConicityMap::unknown : values.front() + sum / static_cast<double>(values.size());
  }
  double deviation() const {
    if (values.size() < 2)
      return ConicityMap::unknown;
    double sum = 0;
    for (const double value : values)
      sum += (value - mean()) * (value - mean());
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
};

using Profiles = std::pair<TabulatedProfile, TabulatedProfile>; ///< rail and wheel

/// The profiles of each draw. Rail and wheel have random numbers of their own, so that the draws of one do
/// not depend on the other.
std::vector<Profiles> drawn_profiles(const WheelsetOnTrack& wheelset, const SceneFile& scene,
                                     const ProfileScatter& scatter) {
  const auto seed = 2 * static_cast<std::uint64_t>(scatter.seed);
  NormalDraws of_rail(seed), of_wheel(seed + 1);
  std::vector<Profiles> out;
  for (int k = 0; k < scatter.draws; ++k)
    out.emplace_back(
        noisy_profile(wheelset.right_rail.curve(), scatter.noise, scene.rail.reading.smoothing, of_rail),
        noisy_profile(wheelset.right_wheel.curve(), scatter.noise, scene.wheel.reading.smoothing, of_wheel));
  return out;
}

/// One map on its way.
class MapMaker {
public:
  MapMaker(const ConicityMapRange& range, const std::atomic<bool>* stop) : range_(range), stop_(stop) {}

  ConicityMap::Entry entry(WheelsetOnTrack wheelset, double gauge, const std::vector<Profiles>& draws) const {
    ConicityMap::Entry out{.gauge = gauge};
    wheelset.position.gauge = gauge;
    const WheelsetConicity found = steered(wheelset);
    const WheelsetConicity::Value& value = found.values.front();
    if (value.motion) {
      out.tan_gamma = value.motion->tan_gamma;
      out.wavelength = value.motion->wavelength;
    }
    out.rail_travel = value.rail_travel;
    out.wheel_travel = value.wheel_travel;
    out.play = found.play;
    out.rated_amplitude = found.rated_amplitude;
    out.nonlinearity = found.nonlinearity;
    take_draws(wheelset, draws, out);
    return out;
  }

private:
  WheelsetConicity steered(const WheelsetOnTrack& wheelset) const {
    end_if_stopped(stop_);
    return steering_of(wheelset,
                       {.largest = std::max(range_.amplitude, rated_reach), .step = range_.amplitude}, stop_);
  }

  void take_draws(WheelsetOnTrack& wheelset, const std::vector<Profiles>& draws,
                  ConicityMap::Entry& out) const {
    Drawn tan_gamma, nonlinearity;
    for (const auto& [rail, wheel] : draws) {
      wheelset.right_rail = wheelset.left_rail = rail;
      wheelset.right_wheel = wheelset.left_wheel = wheel;
      const WheelsetConicity found = steered(wheelset);
      if (const auto& motion = found.values.front().motion)
        tan_gamma.take(motion->tan_gamma);
      nonlinearity.take(found.nonlinearity);
    }
    out.mean = tan_gamma.mean();
    out.spread = tan_gamma.deviation();
    out.nonlinearity_spread = nonlinearity.deviation();
    out.draws = static_cast<int>(tan_gamma.values.size());
  }

  const ConicityMapRange& range_;
  const std::atomic<bool>* stop_;
};

/// Where the amplitude is refused for one wheelset it is for all, and so the map is.
void require_sound(const ConicityMapRange& range) {
  if (!(range.amplitude >= 0.1 && range.amplitude <= 45))
    throw InputError(fmt::format("A map has no amplitude of {:g} mm", range.amplitude),
                     "it must be 0.1 to 45 mm", "Give it in mm, for instance 3.");
  if (!range.scatter)
    return;
  const auto& [noise, draws, seed] = *range.scatter;
  if (!(noise >= 0 && noise <= 1))
    throw InputError(fmt::format("The points of profiles do not scatter by {:g} mm", noise),
                     "the standard deviation must be 0 to 1 mm", "Give it in mm, for instance 0.01.");
  if (draws < 2 || draws > 10000 || seed < 0)
    throw InputError(fmt::format("Noise is not drawn {} times from the seed {}", draws, seed),
                     "2 to 10000 draws are served, and a seed is 0 or more", "Give for instance 20 and 1.");
}

std::string which_of(const std::vector<std::string>& names) {
  return fmt::format("which of {}", fmt::join(names, " "));
}

} // namespace

ConicityMap conicity_map(const ConicityMapRange& range,
                         const std::function<SceneFile(const std::string&, const std::string&)>& scene_of,
                         const std::function<void()>& done, const std::atomic<bool>* stop) {
  require_sound(range);
  ConicityMap out{.wheels = range.wheels,
                  .rails = range.rails,
                  .amplitude = range.amplitude,
                  .scatter = range.scatter,
                  .entries = {}};
  const MapMaker maker(range, stop);
  for (std::size_t w = 0; w < range.wheels.size(); ++w)
    for (std::size_t r = 0; r < range.rails.size(); ++r) {
      const SceneFile scene = scene_of(range.wheels[w], range.rails[r]);
      WheelsetOnTrack wheelset = wheelset_of(scene);
      wheelset.rolls = range.rolls;
      const std::vector<Profiles> draws =
          range.scatter ? drawn_profiles(wheelset, scene, *range.scatter) : std::vector<Profiles>();
      for (const double gauge :
           range.gauges.empty() ? std::vector<double>{scene.position.gauge} : range.gauges) {
        ConicityMap::Entry entry{.gauge = gauge};
        try {
          entry = maker.entry(wheelset, gauge, draws);
        } catch (const InputError& error) {
          say_warning("{} on {} at a gauge of {:g} mm has no conicity: {}", range.wheels[w], range.rails[r],
                      gauge, error.what());
        }
        entry.wheel = w;
        entry.rail = r;
        out.entries.push_back(entry);
        done();
      }
    }
  return out;
}

std::span<const ColumnOf<ConicityMap::Entry>> map_columns() {
  using E = ConicityMap::Entry;
  static constexpr ColumnOf<E> columns[] = {
      {"gauge", "mm", "track gauge", [](const E& e) { return e.gauge; }},
      {"tan_gamma", "1", "equivalent conicity at the amplitude", [](const E& e) { return e.tan_gamma; }},
      {"wavelength", "mm", "of the free lateral motion", [](const E& e) { return e.wavelength; }},
      {"rail_travel", "mm", "width over which the right contact travels on the rail during it",
       [](const E& e) { return e.rail_travel; }},
      {"wheel_travel", "mm", "the same on the wheel", [](const E& e) { return e.wheel_travel; }},
      {"play", "mm", "gauge less the distance of the active faces", [](const E& e) { return e.play; }},
      {"rated_amplitude", "mm", "at which the conicity is rated, by the play",
       [](const E& e) { return e.rated_amplitude; }},
      {"nonlinearity", "1/mm", "slope of tan gamma over the amplitude, from 1 mm below to 1 mm above it",
       [](const E& e) { return e.nonlinearity; }}};
  return columns;
}

std::span<const ColumnOf<ConicityMap::Entry>> scatter_columns() {
  using E = ConicityMap::Entry;
  static constexpr ColumnOf<E> columns[] = {
      {"tan_gamma_mean", "1", "mean of tan gamma over the draws", [](const E& e) { return e.mean; }},
      {"tan_gamma_spread", "1", "its standard deviation", [](const E& e) { return e.spread; }},
      {"nonlinearity_spread", "1/mm", "standard deviation of the nonlinearity",
       [](const E& e) { return e.nonlinearity_spread; }},
      {"draws",
       {"1", nullptr, QuantityKind::count},
       "draws in which a motion has the amplitude",
       [](const E& e) { return double(e.draws); }}};
  return columns;
}

record::Record record_of(const ConicityMap& map) {
  using record::Number;
  using E = ConicityMap::Entry;
  record::Table table = record::table_of("pair and gauge", map_columns(), map.entries);
  const auto place = [&](const char* name, const std::vector<std::string>& names, std::size_t E::*of) {
    record::Column column{name, "1", which_of(names), {}, true};
    for (const E& entry : map.entries)
      column.values.push_back(double(entry.*of));
    return column;
  };
  table.columns.insert(table.columns.begin(),
                       {place("wheel", map.wheels, &E::wheel), place("rail", map.rails, &E::rail)});
  record::Record out{{"wheels", record::Texts{map.wheels, "profiles of wheels"}},
                     {"rails", record::Texts{map.rails, "profiles of rails"}},
                     {"amplitude", Number{map.amplitude, "mm", "of the motion"}}};
  if (map.scatter) {
    std::ranges::move(record::table_of("", scatter_columns(), map.entries).columns,
                      std::back_inserter(table.columns));
    out.add("noise", Number{map.scatter->noise, "mm", "standard deviation of a point along the normal"});
    out.add("seed", Number{double(map.scatter->seed), "1", "of the draws", {}, true});
    out.add("all_draws",
            Number{double(map.scatter->draws), "1", "how often the profiles were drawn", {}, true});
  }
  return out.add("map", std::move(table));
}

} // namespace bem_contact
