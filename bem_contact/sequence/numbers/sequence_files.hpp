#pragma once

#include "bem_contact/inside/stresses_by_file.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/numbers/pair_numbers.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>

namespace bem_contact {

/// Profiles and influence files of scenes, read when they are first asked for: they must not change
/// meanwhile. Those used last are kept, and others are read again. One object serves one thread.
class SequenceFiles {
public:
  /// How many pairs of profiles, and how many MB of influence functions, are kept. The last of each always
  /// is.
  explicit SequenceFiles(std::size_t most_profiles = profiles_kept,
                         double most_megabytes = largest_kept_files)
      : most_profiles_(most_profiles), most_megabytes_(most_megabytes) {}

  WheelRailProfiles profiles(const SceneFile& scene);
  PairFiles influence(const Body& rail, const Body& wheel);
  /// Throws InputError where the file has no stresses.
  std::shared_ptr<const inside::FileOfStresses> stresses(const std::filesystem::path& file);

private:
  struct ProfileSources {
    std::filesystem::path folder;
    std::string rail, wheel;
    ProfileReading rail_reading, wheel_reading;
    std::vector<SceneFile::Section> rail_sections, wheel_sections;
    bool operator==(const ProfileSources&) const = default;
  };
  struct InfluenceSources { ///< with the materials, which the reader checks
    std::filesystem::path rail, wheel;
    std::vector<SectionInfluence> sections;
    Material rail_material, wheel_material;
    bool operator==(const InfluenceSources&) const = default;
  };
  std::size_t most_profiles_;
  double most_megabytes_;
  std::deque<std::pair<ProfileSources, WheelRailProfiles>> profiles_; ///< used last: in front
  std::deque<std::pair<InfluenceSources, PairFiles>> influence_;      ///< used last: in front
  std::deque<std::pair<std::filesystem::path, std::shared_ptr<const inside::FileOfStresses>>>
      stresses_; ///< used last: in front
};

} // namespace bem_contact
