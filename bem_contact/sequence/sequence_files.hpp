#pragma once

#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/pair_numbers.hpp"

#include <utility>
#include <vector>

namespace bem_contact {

/// Profiles and influence files of scenes, each read once: they must not change meanwhile. One object serves
/// one thread.
class SequenceFiles {
public:
  const WheelRailProfiles& profiles(const SceneFile& scene);
  const PairFiles& influence(const Body& rail, const Body& wheel);

private:
  struct ProfileSources {
    std::filesystem::path folder;
    std::string rail, wheel;
    ProfileReading rail_reading, wheel_reading;
    bool operator==(const ProfileSources&) const = default;
  };
  struct InfluenceSources { ///< with the materials, which the reader checks
    std::filesystem::path rail, wheel;
    Material rail_material, wheel_material;
    bool operator==(const InfluenceSources&) const = default;
  };
  std::vector<std::pair<ProfileSources, std::shared_ptr<const WheelRailProfiles>>> profiles_;
  std::vector<std::pair<InfluenceSources, std::shared_ptr<const PairFiles>>> influence_;
};

} // namespace bem_contact
