#include "bem_contact/geometry/tabulated_profile.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact {

namespace {

using Node = TabulatedProfile::Node;

/// mm. The table gets no finer, so that noise in a measured profile cannot make it endless.
constexpr double smallest_table_step = 2e-3;

TabulatedProfile::Point hermite(const Node& a, const Node& b, double t) {
  const double length = b.s - a.s, u = 1 - t;
  const Point2 chord = b.position - a.position;
  const Point2 position = a.position + (t * t * (3 - 2 * t)) * chord + (length * t * u * u) * a.after -
                          (length * t * t * u) * b.before;
  const Point2 slope =
      length > 0 ? (6 * t * u / length) * chord + (u * (1 - 3 * t)) * a.after + (t * (3 * t - 2)) * b.before
                 : a.after;
  return {position, slope};
}

/// Nodes after `a` up to and with `b`, both within one piece.
void refine(const ProfileCurve& curve, const Node& a, const Node& b, std::vector<Node>& out) {
  const double middle = 0.5 * (a.s + b.s), length = b.s - a.s;
  if (length > smallest_table_step) {
    const CurvePoint p = curve.at(middle);
    if (length > largest_table_step || norm(hermite(a, b, 0.5).position - p.position) > table_tolerance) {
      const Node m{middle, p.position, tangent_of(p.delta), tangent_of(p.delta), p.delta};
      refine(curve, a, m, out);
      refine(curve, m, b, out);
      return;
    }
  }
  out.push_back(b);
}

std::vector<Node> tabulate(const ProfileCurve& curve) {
  const std::vector<double> joints = curve.joints();
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const CurvePoint p = curve.at(joints[k]);
    Node node{joints[k], p.position, tangent_of(p.delta), tangent_of(p.delta), p.delta};
    if (k > 0) {
      const double length = joints[k] - joints[k - 1];
      node.before = tangent_of(curve.at(joints[k] - std::min(1e-9, 0.5 * length)).delta);
      if (k + 1 == joints.size())
        node.after = node.before;
      const Node from = nodes.back();
      refine(curve, from, node, nodes);
    } else {
      nodes.push_back(node);
    }
  }
  return nodes;
}

} // namespace

TabulatedProfile::TabulatedProfile(ProfileCurve curve) {
  std::vector<Node> nodes = tabulate(curve);
  const std::uint64_t digest = curve.digest();
  data_ = std::make_shared<const Data>(Data{std::move(curve), std::move(nodes), digest});
}

TabulatedProfile::Point TabulatedProfile::between(int k, double t) const {
  return hermite(data_->nodes[k], data_->nodes[k + 1], t);
}

int TabulatedProfile::interval(double s, int near) const {
  const std::vector<Node>& nodes = data_->nodes;
  const int last = static_cast<int>(nodes.size()) - 2;
  near = std::clamp(near, 0, last);
  for (int step = 0; step < 8; ++step) {
    if (s < nodes[near].s && near > 0)
      --near;
    else if (s > nodes[near + 1].s && near < last)
      ++near;
    else
      return near;
  }
  const auto after = std::ranges::upper_bound(nodes, s, {}, &Node::s);
  return std::clamp(static_cast<int>(after - nodes.begin()) - 1, 0, last);
}

CurvePoint TabulatedProfile::quick(double s, int& near) const {
  near = interval(s, near);
  const Node &a = data_->nodes[near], &b = data_->nodes[near + 1];
  const Point p = between(near, b.s > a.s ? (s - a.s) / (b.s - a.s) : 0.0);
  return {s, p.position, a.delta + angle_from_to(a.after, p.tangent),
          angle_from_to(a.after, b.before) / (b.s - a.s)};
}

} // namespace bem_contact
