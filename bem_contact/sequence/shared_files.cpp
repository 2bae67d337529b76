#include "bem_contact/sequence/shared_files.hpp"

#include "bem_contact/sequence/numbers/sequence_files.hpp"

namespace bem_contact {

std::shared_ptr<SequenceFiles> shared_files() {
  return std::make_shared<SequenceFiles>();
}

WheelRailProfiles read_profiles(const SceneFile& scene, SequenceFiles& files) {
  return files.profiles(scene);
}

} // namespace bem_contact
