#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <limits>
#include <span>

namespace bem_contact {

/// A smoothing spline of degree five in discrete form (Whittaker 1923; Eilers 2003): of values c at rising t
/// it finds those that minimise
///
///     integral |c - measured|^2 dt + integral (wavelength / 2 pi)^6 H(|c'''|) dt
///
/// H is Huber's function (1964): H(b) = b^2 up to the bound B = (2 pi / wavelength)^3 highest, and
/// 2 B b - B^2 above, where c is allowed to bend abruptly. The wavelength may differ from place to place.
class SmoothingSpline {
public:
  /// `measured` has one row for each t (rising, at least 5), and a column for each component. A value weighs
  /// as the length that it stands for.
  SmoothingSpline(std::span<const double> t, Eigen::MatrixXd measured);

  /// Third derivatives, one for four neighbouring values each: how many, and the middle of their t.
  Eigen::Index third_derivatives() const { return length_.size(); }
  double middle(Eigen::Index i) const { return middle_[i]; }

  /// Holds the value i (0 or the last) by a weight.
  void hold(Eigen::Index i);

  /// The values of least sum, shaped as `measured`, for a wavelength (mm) at each third derivative.
  /// `highest`: half the height (mm) of a wave as long as that which is still smoothed by squares; without a
  /// limit all is.
  Eigen::MatrixXd minimise(const Eigen::VectorXd& wavelength,
                           double highest = std::numeric_limits<double>::infinity()) const;

private:
  Eigen::MatrixXd measured_;
  Eigen::VectorXd weight_;            ///< length that a value stands for, mm
  Eigen::VectorXd length_;            ///< that a third derivative stands for, mm
  Eigen::VectorXd middle_;            ///< mm
  Eigen::SparseMatrix<double> third_; ///< maps values to third derivatives, 1/mm^3
};

} // namespace bem_contact
