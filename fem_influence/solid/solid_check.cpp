#include "fem_influence/solid/solid_check.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double motion_from = 4.5; // mm: nearer elements do not count for the rigid motion

/// Place and frame (columns e_x, e_s, e_n) of element (m, I).
struct Element {
  Vector3d position;
  Matrix3d frame;
};

Element element_at(const Station& station, double x, double radius) {
  const Point2 s = tangent_of(station.delta), n = normal_of(station.delta), p = station.position;
  const double theta = radius > 0 ? x / radius : 0, c = std::cos(theta), d = std::sin(theta);
  Element e;
  e.frame << c, s.z * d, n.z * d, 0, s.y, n.y, -d, s.z * c, n.z * c;
  e.position =
      radius > 0 ? Vector3d((radius + p.z) * d, p.y, (radius + p.z) * c - radius) : Vector3d(x, p.y, p.z);
  return e;
}

/// The three rigid motions that the mirror plane x = 0 lets pass, in the element's frame, as columns.
Matrix3d rigid_motions(const Element& e, bool odd, const Vector3d& centre) {
  const Vector3d r = e.position - centre;
  Matrix3d motions;
  if (odd) // along x, about y, about z
    motions << 1, r.z(), -r.y(), 0, 0, r.x(), 0, -r.x(), 0;
  else // along y, along z, about x
    motions << 0, 0, 0, 1, 0, -r.z(), 0, 1, r.y();
  return e.frame.transpose() * motions;
}

} // namespace

std::vector<SolidDifference> compare(const SolidNumbers& a, const InfluenceNumbers& reference,
                                     double reference_radius, bool rigid_motion_removed) {
  if (reference.rows != static_cast<int>(a.stations.size()) || reference.offsets < a.offsets ||
      std::abs(reference.dx - a.dx) > 1e-9 * a.dx || std::abs(reference.ds - a.ds) > 1e-9 * a.ds)
    throw InputError("The influence numbers cannot be compared", "they belong to other stations or elements",
                     "compute both from one body file");
  std::vector<SolidDifference> bands(4);
  bands[1].up_to = 1.6;
  bands[2].up_to = 4.5;
  bands[3].up_to = 16;
  for (std::size_t load = 0; load < a.loads.size(); ++load) {
    const int J = a.loads[load];
    const Element loaded = element_at(a.stations[static_cast<std::size_t>(J)], 0, reference_radius);
    const auto each = [&](auto&& visit) {
      for (int m = 0; m < a.offsets; ++m)
        for (int I = 0; I < reference.rows; ++I) {
          const Element e = element_at(a.stations[static_cast<std::size_t>(I)], m * a.dx, reference_radius);
          if (const double distance = (e.position - loaded.position).norm(); distance <= 16 * (1 + 1e-9))
            visit(m, I, e, distance);
        }
    };
    const auto difference = [&](int m, int I, int j) {
      Vector3d d;
      for (int i = 0; i < 3; ++i)
        d[i] = a.at(load, j, m, I, i) - reference.at(m, I, i, J, j);
      return d;
    };
    for (int j = 0; j < 3; ++j) {
      Vector3d motion = Vector3d::Zero();
      if (rigid_motion_removed) {
        Matrix3d normal = Matrix3d::Zero();
        Vector3d right = Vector3d::Zero();
        each([&](int m, int I, const Element& e, double distance) {
          if (distance <= motion_from)
            return;
          const Matrix3d r = rigid_motions(e, j == component_x, loaded.position);
          normal += r.transpose() * r;
          right += r.transpose() * difference(m, I, j);
        });
        motion = normal.ldlt().solve(right);
      }
      each([&](int m, int I, const Element& e, double distance) {
        auto& band = *std::find_if(bands.begin(), bands.end(),
                                   [&](const auto& b) { return distance <= b.up_to * (1 + 1e-9); });
        Vector3d left = difference(m, I, j);
        left -= rigid_motions(e, j == component_x, loaded.position) * motion;
        band.elements += j == 0;
        double local = 0;
        for (int i = 0; i < 3; ++i)
          local = std::max(local, std::abs(reference.at(m, I, i, J, i)));
        for (int i = 0; i < 3; ++i) {
          if (m == 0 && parity(i, j) < 0)
            continue; // the mean of an odd one, zero on both sides
          const double self = std::sqrt(reference.at(0, J, i, J, i) * reference.at(0, J, j, J, j));
          band.of_self[i][j] = std::max(band.of_self[i][j], std::abs(left[i]) / self);
          band.of_local[i][j] = std::max(band.of_local[i][j], std::abs(left[i]) / local);
        }
      });
    }
  }
  return bands;
}

} // namespace bem_contact::fem
