#pragma once

#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/wear/evolution.hpp"

#include <filesystem>

namespace bem_contact::app {

/// The influence functions of a wear study, from shape to shape.
///
/// They begin with the files that the scene names. A step whose shape they do not serve any more needs new
/// ones: FOLDER/rail_0012.h5 for the rail after step 12. Where that file is missing, the body file
/// FOLDER/rail_0012.toml is written, from which `tools/influence` makes it, and an InputError says so. The
/// same command goes on with it.
class WearInfluence {
public:
  /// `unworn`: the profiles at step 0. Throws InputError where the files are not of the scene's profiles.
  WearInfluence(const SceneFile& scene, const wear::WornPair& unworn, std::filesystem::path folder);

  /// The functions for the profiles after a step, whose files are in the folder already.
  const wear::KeptPair& at(int step, const wear::WornPair& now, double kept_turn);

private:
  struct Side {
    const char* name;
    ProfileKind kind;
    SceneFile::Side scene;
    int step; ///< after which its functions were computed
  };
  void begin(Side& side, wear::KeptInfluence& kept, const wear::WornBody& unworn);
  void take_newest(Side& side, wear::KeptInfluence& kept, int step);

  std::filesystem::path scene_folder_, folder_;
  bool used_ = false, resumed_ = false;
  Side rail_, wheel_;
  wear::KeptPair kept_;
};

} // namespace bem_contact::app
