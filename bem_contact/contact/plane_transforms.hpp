#pragma once

#include "bem_contact/contact/fft.hpp"

#include <complex>
#include <list>
#include <memory>

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

/// FFTW's plans for fields [..][lines][length_x] and their vectors. Making them takes as long as some
/// products, so operators of the same shape share them: one after the other.
template <class Real> class PlaneTransforms {
public:
  using Complex = std::complex<Real>;
  explicit PlaneTransforms(const PlaneShape& shape);

  const PlaneShape shape;
  FftBuffer<Real> space_in;  ///< [input][lines][length_x]
  FftBuffer<Real> space_out; ///< [output][lines][length_x]

  const Real* line_out(int output, int row) const {
    return &space_out[(static_cast<std::size_t>(output) * shape.lines + row) * shape.length_x];
  }
  /// How many frequencies along x are transformed along s at once: all of them, where they stay in the cache.
  int together() const { return together_; }
  Complex* turned_in() { return complex(turned_in_); } ///< [together][input][length_s]
  Complex* turned() { return complex(turned_); }       ///< [together][output][length_s]

  void forward();         ///< space_in to spectra along x
  void forward_s(int k);  ///< those of frequencies k .. to turned_in
  void backward_s(int k); ///< turned to spectra along x of frequencies k ..
  void backward();        ///< those to space_out, times both lengths

  /// kernel [length_s][length_x] to symbol [frequency], each frequency's length_s values `stride` after those
  /// of the one before.
  Real* kernel();
  void transform_kernel(Complex* symbol, std::ptrdiff_t stride);
  /// Of real even spectra [length_s][frequencies], in place (DCT-I), and back from kernels [length_s]
  /// [length_x] to complex spectra [length_s][frequencies].
  void even_to_kernel(Real* spectra);
  void kernel_to_spectra(Complex* spectra);

private:
  int together_ = 1;
  static Complex* complex(const FftBuffer<Real>& b) { return reinterpret_cast<Complex*>(b.get()); }

  FftBuffer<Real> spectrum_in_;  ///< complex [frequency][input][length_s]; rows beyond lines stay zero
  FftBuffer<Real> spectrum_out_; ///< complex [frequency][output][lines]
  FftBuffer<Real> turned_in_, turned_, kernel_, one_sided_;
  FftPlan<Real> x_forward_, s_forward_, s_backward_, x_backward_;
  FftPlan<Real> kernel_x_, kernel_s_, even_, one_sided_x_;
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
    if (list.size() > most)
      list.pop_back(); // those who use it keep it
    return list.front();
  }

private:
  static constexpr std::size_t most = 32;
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
