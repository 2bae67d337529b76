#pragma once

#include "bem_contact/uses/wear/evolution.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::wear {

/// How users say which body wears.
inline constexpr std::array<std::string_view, 3> body_names{"both", "rail", "wheel"};

/// What users ask of a wear study. The defaults are those of the program and of Python.
struct StudyOptions {
  std::string law = "energy";                ///< one of law_names
  double hardness = ArchardLaw{}.hardness;   ///< for archard, MPa
  double speed = ArchardLaw{}.rolling_speed; ///< for archard, mm/s
  std::string body = "both";                 ///< one of body_names
  double depth = 0.1;                        ///< at the deepest place, at which the study ends, mm
  EvolutionOptions steps = {};               ///< their law and bodies are those named above
};

/// A load collective under which profiles wear.
struct Study {
  std::vector<CollectiveCase> cases; ///< one or more
  EvolutionOptions options;          ///< of each step
  double depth = 0;                  ///< at the deepest place, at which the study ends, mm

  const SceneFile& scene() const { return cases.front().scene; } ///< the bodies are those of all cases
};

/// `model`: instead of the scenes' own, "": none. Throws InputError for names that are not known and for what
/// validate() refuses.
Study study_of(const SweepFile& sweep, const std::string& model, const StudyOptions& asked);

/// Takes one wear_step() in `folder` after the other until the study's depth is reached. `influence`: the
/// functions for these profiles. `on_step` is called after each step.
void evolve(const Study& study, WornPair pair, const std::filesystem::path& folder,
            const std::function<KeptPair(const WornPair&)>& influence,
            const std::function<void(const WornPair&)>& on_step);

} // namespace bem_contact::wear
