#include "fem_influence/solid/solid_check.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// mm. Ends of the bands of distance in which differences are reported (about 3, 9 and 32 elements of 0.5
/// mm).
constexpr double near_band = 1.6;
constexpr double middle_band = 4.5;
constexpr double far_band = 16.0;

/// Place and frame (columns e_x, e_s, e_n) of element (m, I).
struct Element {
  Vector3d position;
  Matrix3d frame;
};

Element element_at(const Station& station, double x, double radius) {
  const Point2 s = tangent_of(station.delta), n = normal_of(station.delta), p = station.position;
  const double theta = radius != 0 ? x / radius : 0, c = std::cos(theta), d = std::sin(theta);
  Element e;
  e.frame << c, s.z * d, n.z * d, 0, s.y, n.y, -d, s.z * c, n.z * c;
  e.position =
      radius != 0 ? Vector3d((radius + p.z) * d, p.y, (radius + p.z) * c - radius) : Vector3d(x, p.y, p.z);
  return e;
}

/// The three rigid motions that the mirror plane x = 0 lets pass, in the element's frame, as columns.
Matrix3d mirrored_motions(const Element& e, bool odd, const Vector3d& centre) {
  const Vector3d r = e.position - centre;
  Matrix3d motions;
  if (odd) // along x, about y, about z
    motions << 1, r.z(), -r.y(), 0, 0, r.x(), 0, -r.x(), 0;
  else // along y, along z, about x
    motions << 0, 0, 0, 1, 0, -r.z(), 0, 1, r.y();
  return e.frame.transpose() * motions;
}

/// The elements under one load that are compared, and their differences.
class LoadedStation {
public:
  LoadedStation(const SolidNumbers& numbers, const InfluenceNumbers& reference, double reference_radius,
                std::size_t load)
      : a_(numbers), reference_(reference), radius_(reference_radius), load_(load), J_(numbers.loads[load]),
        position_(element_at(numbers.stations[static_cast<std::size_t>(J_)], 0, radius_).position) {}

  /// visit(m, I, element, distance)
  template <class Visit> void for_each_element(Visit&& visit) const {
    for (int m = 0; m < a_.offsets; ++m)
      for (int I = 0; I < reference_.rows; ++I) {
        const Element e = element_at(a_.stations[static_cast<std::size_t>(I)], m * a_.dx, radius_);
        if (const double distance = (e.position - position_).norm(); distance <= far_band * (1 + 1e-9))
          visit(m, I, e, distance);
      }
  }

  Vector3d difference(int m, int I, int j) const {
    Vector3d d;
    for (int i = 0; i < 3; ++i)
      d[i] = a_.at(load_, j, m, I, i) - reference_.at(m, I, i, J_, j);
    return d;
  }

  Matrix3d motions(const Element& e, int j) const { return mirrored_motions(e, j == component_x, position_); }

  /// The rigid motion that fits the differences under component j beyond the middle band best.
  Vector3d fitted_motion(int j) const {
    Matrix3d normal = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for_each_element([&](int m, int I, const Element& e, double distance) {
      if (distance <= middle_band)
        return;
      const Matrix3d r = motions(e, j);
      normal += r.transpose() * r;
      right += r.transpose() * difference(m, I, j);
    });
    return normal.ldlt().solve(right);
  }

  /// Raises a band's largest differences to what is `left` at one element.
  void record(SolidDifference& band, int m, int I, int j, const Vector3d& left) const {
    double local = 0;
    for (int i = 0; i < 3; ++i)
      local = std::max(local, std::abs(reference_.at(m, I, i, J_, i)));
    for (int i = 0; i < 3; ++i) {
      if (m == 0 && parity(i, j) < 0)
        continue; // the mean of an odd one, zero on both sides
      const double self = std::sqrt(reference_.at(0, J_, i, J_, i) * reference_.at(0, J_, j, J_, j));
      band.of_self[i][j] = std::max(band.of_self[i][j], std::abs(left[i]) / self);
      band.of_local[i][j] = std::max(band.of_local[i][j], std::abs(left[i]) / local);
    }
  }

private:
  const SolidNumbers& a_;
  const InfluenceNumbers& reference_;
  double radius_;
  std::size_t load_;
  int J_;
  Vector3d position_;
};

} // namespace

std::vector<SolidDifference> compare(const SolidNumbers& a, const InfluenceNumbers& reference,
                                     double reference_radius, bool rigid_motion_removed) {
  if (reference.rows != static_cast<int>(a.stations.size()) || reference.offsets < a.offsets ||
      std::abs(reference.dx - a.dx) > 1e-9 * a.dx || std::abs(reference.ds - a.ds) > 1e-9 * a.ds)
    throw InputError("The influence numbers cannot be compared", "they belong to other stations or elements",
                     "Compute both from one body file.");
  std::vector<SolidDifference> bands(4);
  bands[1].up_to = near_band;
  bands[2].up_to = middle_band;
  bands[3].up_to = far_band;
  for (std::size_t load = 0; load < a.loads.size(); ++load) {
    const LoadedStation loaded(a, reference, reference_radius, load);
    for (int j = 0; j < 3; ++j) {
      const Vector3d motion = rigid_motion_removed ? loaded.fitted_motion(j) : Vector3d(Vector3d::Zero());
      loaded.for_each_element([&](int m, int I, const Element& e, double distance) {
        auto& band = *std::find_if(bands.begin(), bands.end(),
                                   [&](const auto& b) { return distance <= b.up_to * (1 + 1e-9); });
        band.elements += j == 0;
        loaded.record(band, m, I, j, loaded.difference(m, I, j) - loaded.motions(e, j) * motion);
      });
    }
  }
  return bands;
}

} // namespace bem_contact::fem
