#pragma once

#include "bem_contact/sequence/solve_scene.hpp"
#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact {

/// Influence numbers of the grids met last, by what they depend on.
class NumbersStore {
public:
  /// Those of `key`, computed by `compute` unless they are kept.
  template <class Compute> InfluenceNumbers get(const std::string& key, const Compute& compute) {
    for (const auto& [name, numbers] : kept_)
      if (name == key) {
        ++found;
        return numbers;
      }
    kept_.emplace_front(key, compute());
    if (kept_.size() > most)
      kept_.pop_back();
    return kept_.front().second;
  }

  int found = 0; ///< how often they were kept

private:
  static constexpr std::size_t most = 6;
  std::deque<std::pair<std::string, InfluenceNumbers>> kept_;
};

/// Tractions of an earlier case, from which a case may start.
struct FormerTractions {
  ContactGrid grid;
  double first_s = 0;               ///< of the first row, on the rail's arc length, mm
  double force = 0;                 ///< Fz, N
  double approach = 0;              ///< mm
  std::vector<PotentialArea> areas; ///< where the bodies might touch, along s
  std::vector<double> px, ps, pn;
};

/// What solve_scene() may use of earlier cases; whatever is null it makes itself. wheel_rail only.
struct SceneAids {
  const WheelRailScene* placed = nullptr; ///< of this scene
  const PairFiles* files = nullptr;       ///< of this scene
  NumbersStore* numbers = nullptr;
  const FormerTractions* start = nullptr;
  WorkBudget* work = nullptr;     ///< of the case; null: one for this call
  Workspace* workspace = nullptr; ///< what solving made of the numbers of earlier cases
  bool coarse_start = true;       ///< of a case without start
};

SceneResult solve_scene(const SceneFile& scene, const SceneAids& aids);

/// Whether the two have as many areas, each of them over its counterpart: else the one is no start for the
/// other.
bool alike(const std::vector<PotentialArea>& a, const std::vector<PotentialArea>& b);

/// `former` where this problem expects it: what lay in an area lies in its counterpart, as far from its
/// edges. Pressure scaled by the third root of the force, as Hertz has it, the approach by its square (force
/// 0: not scaled). `areas` are alike() the former ones.
StartingPoint start_from(const FormerTractions& former, const ContactProblem& problem,
                         const std::vector<PotentialArea>& areas, double force);

} // namespace bem_contact
