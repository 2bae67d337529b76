#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/wear/evolution.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace bem_contact::wear {

namespace {

WornBody after(const WornBody& now, const Depths& rate, double times) {
  WornBody out = now;
  std::vector<double> depth = rate.values();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] *= times;
    out.depth[i] += depth[i];
  }
  out.area += times * rate.area();
  out.points = worn(now.points, depth, times * rate.area());
  return out;
}

/// How often the wear of `rate` may be repeated until `depth` is reached somewhere.
double times_until(const std::vector<double>& now, const std::vector<double>& rate, double depth) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < now.size(); ++i)
    if (rate[i] > 0)
      least = std::min(least, (depth - now[i]) / rate[i]);
  return std::max(0.0, least);
}

/// What a revolution of the wheel takes off each body.
struct StepRates {
  std::vector<Depths> rail; ///< of the profile, or of each section
  Depths wheel;
  double rail_area = 0; ///< mm^2; of sections: mean along the passages
};

StepRates rates_of_profile(const WornPair& now, const std::vector<CollectiveCase>& cases,
                           const std::vector<CaseWear>& found, const EvolutionOptions& options) {
  double weights = 0;
  for (const CollectiveCase& one : cases)
    weights += one.weight;
  StepRates out{{Depths(now.rail.points)}, Depths(now.wheel.points)};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    out.rail[0].add(found[i].rail, options.passages * cases[i].weight / weights, options.smoothing);
    out.wheel.add(found[i].wheel, cases[i].weight / weights, options.smoothing);
  }
  out.rail_area = out.rail[0].area();
  return out;
}

/// `surfaces`: through the sections.
StepRates rates_of_sections(const WornPair& now, const std::vector<CollectiveCase>& cases,
                            const std::vector<CaseWear>& found, const EvolutionOptions& options,
                            std::vector<std::shared_ptr<const SectionedSurface>> surfaces) {
  const std::vector<PassagePlace> places = passage_places(on_track(cases));
  StepRates out{{}, Depths(now.wheel.points)};
  SectionDepths sections(now.sections, std::move(surfaces));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    sections.add(found[i].rail, found[i].on_sections, places[i], options.passages * places[i].frequency,
                 options.smoothing);
    out.wheel.add(found[i].wheel, places[i].share, options.smoothing);
    out.rail_area += options.passages * places[i].share * found[i].rail.area();
  }
  out.rail = sections.of_sections();
  return out;
}

/// What a step solves, and what follows for the profiles.
StepRates rates_of(const WornPair& now, const std::vector<CollectiveCase>& cases,
                   const EvolutionOptions& options, const std::filesystem::path& folder,
                   const KeptPair& influence) {
  std::shared_ptr<SequenceFiles> files;
  if (!options.solve || !now.sections.empty())
    files = read_profiles_of_step(cases.front().scene, now, folder);
  const std::vector<CaseWear> found = options.solve
                                          ? options.solve(now, influence)
                                          : wear_of_cases(now, cases, options, folder, influence, files);
  if (now.sections.empty())
    return rates_of_profile(now, cases, found, options);
  return rates_of_sections(
      now, cases, found, options,
      read_profiles(with_profiles(cases.front().scene, now, folder), *files).rail_bodies.surfaces);
}

} // namespace

WornPair wear_step(const WornPair& now, const std::vector<CollectiveCase>& cases,
                   const EvolutionOptions& options, double until, const std::filesystem::path& folder,
                   const KeptPair& influence) {
  require_kept("rail", influence.rail, now.rail.points, options.kept_turn);
  require_kept("wheel", influence.wheel, now.wheel.points, options.kept_turn);
  write_profiles(now, folder);
  const StepRates rates = rates_of(now, cases, options, folder, influence);
  WornPair out = now;
  std::vector<std::pair<WornBody*, const Depths*>> wearing;
  if (options.rail && now.sections.empty())
    wearing.emplace_back(&out.rail, &rates.rail[0]);
  for (std::size_t i = 0; options.rail && i < now.sections.size(); ++i)
    wearing.emplace_back(&out.sections[i].worn, &rates.rail[i]);
  if (options.wheel)
    wearing.emplace_back(&out.wheel, &rates.wheel);
  double times = std::numeric_limits<double>::infinity();
  for (const auto& [body, rate] : wearing)
    if (rate->largest() > 0)
      times =
          std::min({times, options.cap / rate->largest(), times_until(body->depth, rate->values(), until)});
  if (!std::isfinite(times))
    throw InputError("Nothing wears", "no case of the load collective slides anywhere",
                     "Give creepages or a position that makes the wheel slide.");
  out.revolutions += times;
  out.smoothing = options.smoothing;
  out.smoothed_off = 0;
  for (const auto& [body, rate] : wearing) {
    out.smoothed_off = std::max(out.smoothed_off, rate->smoothed_off());
    *body = after(*body, *rate, times);
  }
  if (options.rail && !now.sections.empty())
    out.rail.area += times * rates.rail_area;
  return out;
}

} // namespace bem_contact::wear
