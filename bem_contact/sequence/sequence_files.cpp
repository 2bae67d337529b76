#include "bem_contact/sequence/sequence_files.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

/// What is kept for `key`, made by `make` when it is first asked for.
template <class Key, class Value, class Make>
const Value& kept(std::vector<std::pair<Key, std::shared_ptr<const Value>>>& all, const Key& key,
                  const Make& make) {
  const auto found = std::ranges::find(all, key, [](const auto& entry) { return entry.first; });
  if (found != all.end())
    return *found->second;
  all.emplace_back(key, std::make_shared<const Value>(make()));
  return *all.back().second;
}

} // namespace

const WheelRailProfiles& SequenceFiles::profiles(const SceneFile& scene) {
  return kept(profiles_,
              ProfileSources{scene.folder, scene.rail.profile, scene.wheel.profile, scene.rail.reading,
                             scene.wheel.reading},
              [&] { return read_profiles(scene); });
}

const PairFiles& SequenceFiles::influence(const Body& rail, const Body& wheel) {
  return kept(influence_, InfluenceSources{rail.influence, wheel.influence, rail.material, wheel.material},
              [&] { return read_pair_files(rail, wheel); });
}

} // namespace bem_contact
