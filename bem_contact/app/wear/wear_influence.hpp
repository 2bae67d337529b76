#pragma once

#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/uses/wear/evolution.hpp"

#include <filesystem>

namespace bem_contact::app {

/// The influence functions of a wear study, from shape to shape.
///
/// They begin with the files that the scene names. A step whose shape they do not serve any more needs new
/// ones: FOLDER/rail_0012.h5 for the rail after step 12. Where that file is missing, the body file
/// FOLDER/rail_0012.toml is written, from which `tools/influence` makes it. If the study was given that
/// program, it is called; else an InputError says what to do, and the same command goes on with the file.
class WearInfluence {
public:
  /// `unworn`: the profiles at step 0. `program`: what makes influence functions of a body file, called as
  /// PROGRAM BODY.toml BODY.h5; "": nothing does. Throws InputError where the files are not of the scene's
  /// profiles.
  WearInfluence(const SceneFile& scene, const wear::WornPair& unworn, std::filesystem::path folder,
                std::string program);

  /// The functions for the profiles after a step, whose files are in the folder already. Throws InputError
  /// where they have to be computed first, and where computing them fails.
  const wear::KeptPair& at(int step, const wear::WornPair& now, double kept_turn);

private:
  struct Side {
    const char* name;
    ProfileKind kind;
    SceneFile::Side scene;
    int step; ///< after which its functions were computed
  };
  void take_newest(Side& side, wear::KeptInfluence& kept, int step);
  void renew(const Side& side, const wear::KeptInfluence& kept, int step, double turn,
             double kept_turn) const;

  std::filesystem::path folder_;
  std::string program_;
  bool used_ = false, resumed_ = false;
  Side rail_, wheel_;
  wear::KeptPair kept_;
};

} // namespace bem_contact::app
