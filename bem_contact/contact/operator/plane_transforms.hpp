#pragma once

#include "bem_contact/contact/operator/fft.hpp"
#include "bem_contact/contact/settings.hpp"

#include <complex>
#include <list>
#include <memory>
#include <utility>
#include <vector>

namespace bem_contact::contact {

/// Lengths of the transforms of a plane, and how many fields go through them at once.
struct PlaneShape {
  int length_x = 0, length_s = 0;
  int lines = 0; ///< rows of a field, at least: a whole multiple of PlaneShape::step
  int inputs = 1, outputs = 1;

  static constexpr int step = 4;
  bool operator==(const PlaneShape&) const = default;
  int frequencies() const { return length_x / 2 + 1; } ///< along x
};

/// Even lengths, at least these, for which the transforms of `lines` rows, along x in pairs and then along s,
/// cost least.
std::pair<int, int> good_lengths(int least_x, int least_s, int lines);

/// FFTW's plans for fields [..][lines][length_x] and their vectors, made when first needed. Operators of the
/// same shape share them: one after the other.
///
/// Along x two rows are transformed as the real and the imaginary part of one: complex transforms line by
/// line are what FFTW does fastest, and it remembers how for a length, whatever the number of lines.
template <class Real> class PlaneTransforms {
public:
  using Complex = std::complex<Real>;
  explicit PlaneTransforms(const PlaneShape& shape);

  const PlaneShape shape;

  void ready(); ///< before the first product

  /// Two rows of a field, 2 `pair` and the next, element by element in turn; length_x of each.
  Real* rows_in(int input, int pair) { return rows(space_in_, input, pair); }
  const Real* rows_out(int output, int pair) const { return rows(space_out_, output, pair); }
  /// How many frequencies along x are transformed along s at once: as many as stay in the cache.
  int together() const { return together_; }
  Complex* turned_in() { return complex(turned_in_); } ///< [together][input][length_s]
  Complex* turned() { return complex(turned_); }       ///< [together][output][length_s]

  void forward();         ///< rows_in to spectra along x
  void forward_s(int k);  ///< those of frequencies k .. k + together - 1 to turned_in
  void backward_s(int k); ///< turned to spectra along x of these frequencies
  void backward();        ///< those to rows_out, times both lengths

  /// kernel [length_s][length_x] to symbol [frequency], each frequency's length_s values `stride` after those
  /// of the one before.
  Real* kernel();
  void transform_kernel(Complex* symbol, std::ptrdiff_t stride);
  /// Of real spectra [frequency][length_s] of kernels even in x those of the kernels' halves behind, in which
  /// what lies at 0 and at the far end counts half; until the next kernel.
  const Complex* half_behind(const std::vector<Real>& spectra);

private:
  static Complex* complex(const FftBuffer<Real>& b) { return reinterpret_cast<Complex*>(b.get()); }
  Real* rows(const FftBuffer<Real>& space, int field, int pair) const {
    return &space[2 * (static_cast<std::size_t>(field) * shape.lines / 2 + pair) * shape.length_x];
  }
  FftPlan<Real> plan(int length, int lines, const FftBuffer<Real>& from, const FftBuffer<Real>& to,
                     int sign) const;
  Real* kernel_pairs();

  int together_ = 1;
  // no transform in place: FFTW plans and does others in half the time
  FftBuffer<Real> space_in_, spectra_in_, spectra_out_, space_out_;
  FftBuffer<Real> columns_in_, turned_in_, turned_, columns_out_;
  FftBuffer<Real> kernel_, pairs_, pair_spectra_, one_sided_, symbol_;
  FftPlan<Real> x_forward_, s_forward_, s_backward_, x_backward_;
  FftPlan<Real> kernel_x_, kernel_s_;
};

/// Transforms made before, the last used first. All that share one pool serve one thread at a time.
class TransformPool {
public:
  template <class Real> std::shared_ptr<PlaneTransforms<Real>> get(const PlaneShape& shape) {
    auto& list = lists<Real>();
    for (auto it = list.begin(); it != list.end(); ++it)
      if ((*it)->shape == shape) {
        list.splice(list.begin(), list, it);
        return list.front();
      }
    list.push_front(std::make_shared<PlaneTransforms<Real>>(shape));
    if (list.size() > std::size_t(most_transforms))
      list.pop_back(); // those who use it keep it
    return list.front();
  }

private:
  template <class Real> using List = std::list<std::shared_ptr<PlaneTransforms<Real>>>;
  template <class Real> List<Real>& lists() {
    if constexpr (std::is_same_v<Real, float>)
      return single_;
    else
      return double_;
  }
  List<float> single_;
  List<double> double_;
};

extern template class PlaneTransforms<double>;
extern template class PlaneTransforms<float>;

} // namespace bem_contact::contact
