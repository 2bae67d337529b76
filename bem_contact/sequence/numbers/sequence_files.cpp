#include "bem_contact/sequence/numbers/sequence_files.hpp"

#include "bem_contact/sequence/numbers/keep_newest.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

double size_of_files(const PairFiles& files) {
  double megabytes = 0;
  for (const auto& file : files.all())
    megabytes += file->megabytes();
  return megabytes;
}

/// What is kept for `key`, made by `make` if there is none. It is put in front; of the others, those
/// stay that keep_newest() keeps.
template <class Key, class Value, class Make, class SizeOf>
Value take(std::deque<std::pair<Key, Value>>& all, const Key& key, const Make& make, const SizeOf& size_of,
           double most) {
  const auto found = std::ranges::find(all, key, [](const auto& entry) { return entry.first; });
  if (found != all.end())
    std::rotate(all.begin(), found, found + 1);
  else
    all.emplace_front(key, make());
  keep_newest(
      all, [&](const auto& entry) { return size_of(entry.second); }, most);
  return all.front().second;
}

} // namespace

WheelRailProfiles SequenceFiles::profiles(const SceneFile& scene) {
  return take(
      profiles_,
      ProfileSources{scene.folder, scene.rail.profile, scene.wheel.profile, scene.rail.reading,
                     scene.wheel.reading, scene.rail.sections, scene.wheel.sections},
      [&] { return read_profiles(scene); }, [](const WheelRailProfiles&) { return 1.0; },
      static_cast<double>(most_profiles_));
}

PairFiles SequenceFiles::influence(const Body& rail, const Body& wheel) {
  return take(
      influence_,
      InfluenceSources{rail.influence, wheel.influence, rail.sections, rail.material, wheel.material},
      [&] { return read_pair_files(rail, wheel); }, size_of_files, most_megabytes_);
}

std::shared_ptr<const inside::FileOfStresses> SequenceFiles::stresses(const std::filesystem::path& file) {
  return take(
      stresses_, file, [&] { return std::make_shared<const inside::FileOfStresses>(file); },
      [](const auto&) { return 1.0; }, static_cast<double>(files_of_stresses_kept));
}

} // namespace bem_contact
