#include "bem_contact/profile/running_head.hpp"

#include <vector>

namespace bem_contact {

namespace {

/// mm. A flange is thicker than 20 mm (EN 15313); a gap that is narrower, as between a blade and its stock
/// rail, is no groove for it.
constexpr double narrowest_groove = 20.0;
/// mm. Check rails stand up to 60 mm above the running rail; what lies lower is no head. Chosen.
constexpr double deepest_head = 80.0;
/// mm. Narrower is the lip of a groove. Heads of light rails are 32 mm wide. Chosen.
constexpr double narrowest_head = 25.0;

/// y at which the walk from node k to the next reaches the height z.
double crossing(std::span<const Point2> nodes, std::size_t k, double z) {
  const Point2 a = nodes[k], b = nodes[k + 1];
  return a.y + (b.y - a.y) * (z - a.z) / (b.z - a.z);
}

/// Whether wheels may run on the head of which `top` is the highest node: it has a gauge face, a flange fits
/// in the groove before it, and another head stands beyond that.
bool is_beyond_groove(std::span<const Point2> nodes, std::size_t top, double gauge_height) {
  const double level = nodes[top].z + gauge_height;
  std::size_t face = top; // the first node of the head that is not below the level
  while (face > 0 && nodes[face - 1].z < level)
    --face;
  std::size_t wall = face; // and the first one of the groove
  while (wall > 0 && nodes[wall - 1].z >= level)
    --wall;
  if (face == 0 || wall == 0)
    return false;
  std::size_t end = top;
  while (end + 1 < nodes.size() && nodes[end + 1].z < level)
    ++end;
  const double gauge = crossing(nodes, face - 1, level),
               field = end + 1 < nodes.size() ? crossing(nodes, end, level) : nodes[end].y;
  return gauge - crossing(nodes, wall - 1, level) >= narrowest_groove && field - gauge >= narrowest_head;
}

} // namespace

std::size_t top_of_running_head(std::span<const Point2> nodes, double gauge_height) {
  std::vector<std::size_t> highest(nodes.size(), nodes.size() - 1); // of each node and all behind it
  for (std::size_t k = nodes.size() - 1; k-- > 0;)
    highest[k] = nodes[k].z <= nodes[highest[k + 1]].z ? k : highest[k + 1];
  std::size_t found = highest[0];
  const double lowest = nodes[found].z + deepest_head;
  for (std::size_t k = found; k < nodes.size() && nodes[highest[k]].z <= lowest; ++k)
    if (const std::size_t top = highest[k]; nodes[k].z >= nodes[top].z + gauge_height && // behind a groove
                                            is_beyond_groove(nodes, top, gauge_height))
      found = k = top;
  return found;
}

} // namespace bem_contact
