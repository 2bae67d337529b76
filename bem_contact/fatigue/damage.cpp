#include "bem_contact/fatigue/damage.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::fatigue {

double damage_of(const DamageFunction& f, double t_gamma) {
  const std::vector<double>& nodes = f.t_gamma;
  if (t_gamma < nodes.front() || (t_gamma > nodes.back() && !f.wear_is_negative))
    return 0;
  const auto above = std::ranges::upper_bound(nodes, t_gamma) - nodes.begin();
  const std::size_t right = std::min<std::size_t>(above, nodes.size() - 1), left = right - 1;
  const double share = (t_gamma - nodes[left]) / (nodes[right] - nodes[left]);
  return std::lerp(f.damage[left], f.damage[right], share);
}

void validate(const DamageFunction& f) {
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto refuse = [](const std::string& why) {
    throw InputError("The damage function cannot have these nodes", why,
                     "Give rising values of T-gamma, and one damage for each.");
  };
  if (f.t_gamma.size() < 2 || f.t_gamma.size() != f.damage.size())
    refuse(fmt::format("there are {} values of T-gamma and {} of damage", f.t_gamma.size(), f.damage.size()));
  if (!std::ranges::all_of(f.t_gamma, finite) || !std::ranges::all_of(f.damage, finite) ||
      f.t_gamma.front() < 0 ||
      std::ranges::adjacent_find(f.t_gamma, std::greater_equal<>()) != f.t_gamma.end())
    refuse("T-gamma must be finite, not negative, and rise");
}

} // namespace bem_contact::fatigue
