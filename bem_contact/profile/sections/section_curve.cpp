#include "bem_contact/profile/sections/section_curve.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// mm. A node this near to the one before it has no direction.
constexpr double same_point = 1e-6;

/// A cubic Hermite piece whose parameter is t.
CurvePiece hermite_piece(const SectionNode& first, const SectionNode& last) {
  const double length = last.t - first.t;
  const Point2 secant = (1 / length) * (last.position - first.position);
  const Point2 from = norm(first.after) < same_point ? secant : first.after,
               to = norm(last.before) < same_point ? secant : last.before;
  const Point2 second = (1 / length) * (3 * secant - 2 * from - to),
               third = (1 / (length * length)) * (from + to - 2 * secant);
  const double y[] = {first.position.y, from.y, second.y, third.y},
               z[] = {first.position.z, from.z, second.z, third.z};
  return polynomial_piece(y, z, length);
}

} // namespace

ProfileCurve curve_through(const std::string& name, std::vector<SectionNode>& nodes) {
  std::vector<SectionNode> kept;
  for (const SectionNode& node : nodes)
    if (!kept.empty() && norm(node.position - kept.back().position) < same_point)
      kept.back().after = node.after;
    else
      kept.push_back(node);
  nodes = std::move(kept);
  if (nodes.size() < 3)
    throw InputError(fmt::format("There is no {}", name), "its sections have no part in common there",
                     "Check the features of the sections.");
  std::vector<CurvePiece> pieces;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    pieces.push_back(hermite_piece(nodes[k], nodes[k + 1]));
  return ProfileCurve::from_pieces(name, std::move(pieces));
}

} // namespace bem_contact
