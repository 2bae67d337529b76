#include "bem_contact/uses/wear/study.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact::wear {

Study study_of(const SweepFile& sweep, const std::string& model, const StudyOptions& asked) {
  if (std::ranges::find(body_names, asked.body) == body_names.end())
    throw InputError(fmt::format("There is no body '{}'", asked.body), "there are rail and wheel",
                     "Give both, rail or wheel.");
  Study out{collective_of(sweep, sweep.all(), model), asked.steps, asked.depth};
  out.options.law = law_named(asked.law, asked.hardness, asked.speed, wear_map_of(out.scene()));
  out.options.rail = asked.body != "wheel";
  out.options.wheel = asked.body != "rail";
  validate(out.cases, out.options, out.depth);
  return out;
}

void evolve(const Study& study, WornPair pair, const std::filesystem::path& folder,
            const std::function<KeptPair(const WornPair&)>& influence,
            const std::function<void(const WornPair&)>& on_step) {
  constexpr double rounding = 1e-9; // relative: the last step ends at the depth, but for this
  while (pair.largest() < study.depth * (1 - rounding)) {
    pair = wear_step(pair, study.cases, study.options, study.depth, folder, influence(pair));
    on_step(pair);
  }
}

} // namespace bem_contact::wear
