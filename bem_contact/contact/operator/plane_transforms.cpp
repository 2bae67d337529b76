#include "bem_contact/contact/operator/plane_transforms.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/settings.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact::contact {
namespace {

template <class Real> typename Fftw<Real>::Complex* raw(std::complex<Real>* p) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(p);
}

/// The spectra of two real rows from that of the first plus i times the second, for `pairs` pairs of rows:
/// z [pairs][n] to out [k - from][row], frequencies from .. to - 1, each `stride` after the one before.
/// Complex numbers are two reals here.
template <class Real>
inline __attribute__((always_inline)) void separate_rows(const Real* __restrict z, int n, int pairs, int from,
                                                         int to, Real* __restrict out, int stride) {
  for (int first = from; first < to; first += least_together)
    for (int pair = 0; pair < pairs; ++pair) {
      const Real* row = z + 2 * static_cast<std::ptrdiff_t>(pair) * n;
      for (int k = first; k < std::min(first + least_together, to); ++k) {
        const Real *a = row + 2 * k, *b = row + 2 * (k == 0 ? 0 : n - k);
        Real* o = out + 2 * (static_cast<std::ptrdiff_t>(k - from) * stride + 2 * pair);
        o[0] = Real(0.5) * (a[0] + b[0]);
        o[1] = Real(0.5) * (a[1] - b[1]);
        o[2] = Real(0.5) * (a[1] + b[1]);
        o[3] = Real(0.5) * (b[0] - a[0]);
      }
    }
}
BEM_CONTACT_WIDE void separate(const double* z, int n, int pairs, int from, int to, double* out, int stride) {
  separate_rows(z, n, pairs, from, to, out, stride);
}
BEM_CONTACT_WIDE void separate(const float* z, int n, int pairs, int from, int to, float* out, int stride) {
  separate_rows(z, n, pairs, from, to, out, stride);
}

/// The way back; n is even.
template <class Real>
inline __attribute__((always_inline)) void join_rows(const Real* __restrict in, int stride, int n, int pairs,
                                                     int from, int to, Real* __restrict z) {
  for (int first = from; first < to; first += least_together)
    for (int pair = 0; pair < pairs; ++pair) {
      Real* row = z + 2 * static_cast<std::ptrdiff_t>(pair) * n;
      for (int k = first; k < std::min(first + least_together, to); ++k) {
        const Real* i = in + 2 * (static_cast<std::ptrdiff_t>(k - from) * stride + 2 * pair);
        Real *a = row + 2 * k, *b = row + 2 * (n - k);
        if (k == 0 || 2 * k == n) { // real, for they are of real rows
          a[0] = i[0];
          a[1] = i[2];
          continue;
        }
        a[0] = i[0] - i[3];
        a[1] = i[1] + i[2];
        b[0] = i[0] + i[3];
        b[1] = i[2] - i[1];
      }
    }
}
BEM_CONTACT_WIDE void join(const double* in, int stride, int n, int pairs, int from, int to, double* z) {
  join_rows(in, stride, n, pairs, from, to, z);
}
BEM_CONTACT_WIDE void join(const float* in, int stride, int n, int pairs, int from, int to, float* z) {
  join_rows(in, stride, n, pairs, from, to, z);
}

/// About the time of one complex transform without FFTW's search for the fastest way, which would take longer
/// than it saves: single precision on AVX2, ns.
double cost_of_line(int n) {
  const bool quick = n <= 16 || n == 20 || n % 16 == 0;
  return (quick ? quick_transform : slow_transform) * n;
}

} // namespace

std::pair<int, int> good_lengths(int least_x, int least_s, int lines) {
  const auto even_from = [](int n) {
    do
      n = good_fft_length(n);
    while (n % 2 != 0 && ++n);
    return n;
  };
  std::pair<int, int> best;
  double least = std::numeric_limits<double>::infinity();
  for (int x = even_from(least_x); x < 2 * least_x + 2; x = even_from(x + 1))
    for (int s = even_from(least_s); s < 2 * least_s + 2; s = even_from(s + 1)) {
      const double cost = 0.5 * lines * cost_of_line(x) + (0.5 * x + 1) * (cost_of_line(s) + s);
      if (cost < least) {
        least = cost;
        best = {x, s};
      }
    }
  return best;
}

template <class Real> PlaneTransforms<Real>::PlaneTransforms(const PlaneShape& the_shape) : shape(the_shape) {
  const std::size_t bytes =
      2 * static_cast<std::size_t>(shape.inputs + shape.outputs) * shape.length_s * sizeof(Real);
  const int fit = static_cast<int>(std::min<std::size_t>(bytes_in_cache / bytes, shape.frequencies()));
  together_ = std::clamp(fit, std::min(least_together, shape.frequencies()), shape.frequencies());
}

template <class Real>
FftPlan<Real> PlaneTransforms<Real>::plan(int length, int lines, const FftBuffer<Real>& from,
                                          const FftBuffer<Real>& to, int sign) const {
  const std::lock_guard lock(fft_planner());
  return FftPlan<Real>(Fftw<Real>::plan_many_dft(1, &length, lines, raw(complex(from)), nullptr, 1, length,
                                                 raw(complex(to)), nullptr, 1, length, sign, FFTW_ESTIMATE));
}

template <class Real> void PlaneTransforms<Real>::forward() {
  Fftw<Real>::execute(x_forward_.get());
}

template <class Real> void PlaneTransforms<Real>::forward_s(int k) {
  const int stride = shape.inputs * shape.length_s;
  for (int field = 0; field < shape.inputs; ++field) {
    Complex* to = complex(columns_in_) + static_cast<std::ptrdiff_t>(field) * shape.length_s;
    separate(rows(spectra_in_, field, 0), shape.length_x, shape.lines / 2, k, k + together_,
             reinterpret_cast<Real*>(to), stride);
    for (int line = 0; line < together_; ++line, to += stride)
      std::fill(to + shape.lines, to + shape.length_s, Complex(0));
  }
  Fftw<Real>::execute(s_forward_.get());
}

template <class Real> void PlaneTransforms<Real>::backward_s(int k) {
  Fftw<Real>::execute(s_backward_.get());
  for (int field = 0; field < shape.outputs; ++field)
    join(reinterpret_cast<Real*>(complex(columns_out_) + static_cast<std::ptrdiff_t>(field) * shape.length_s),
         shape.outputs * shape.length_s, shape.length_x, shape.lines / 2, k, k + together_,
         rows(spectra_out_, field, 0));
}

template <class Real> void PlaneTransforms<Real>::backward() {
  Fftw<Real>::execute(x_backward_.get());
}

template <class Real> void PlaneTransforms<Real>::ready() {
  if (space_in_)
    return;
  const auto rows_of = [&](int fields) { return fields * shape.lines / 2; };
  const auto make = [](int lines, int length) {
    return make_fft_buffer<Real>(2 * static_cast<std::size_t>(lines) * length);
  };
  for (auto* field : {&space_in_, &spectra_in_})
    *field = make(rows_of(shape.inputs), shape.length_x);
  for (auto* field : {&space_out_, &spectra_out_})
    *field = make(rows_of(shape.outputs), shape.length_x);
  for (auto* field : {&columns_in_, &turned_in_})
    *field = make(together_ * shape.inputs, shape.length_s);
  for (auto* field : {&columns_out_, &turned_})
    *field = make(together_ * shape.outputs, shape.length_s);
  x_forward_ = plan(shape.length_x, rows_of(shape.inputs), space_in_, spectra_in_, FFTW_FORWARD);
  x_backward_ = plan(shape.length_x, rows_of(shape.outputs), spectra_out_, space_out_, FFTW_BACKWARD);
  s_forward_ = plan(shape.length_s, together_ * shape.inputs, columns_in_, turned_in_, FFTW_FORWARD);
  s_backward_ = plan(shape.length_s, together_ * shape.outputs, turned_, columns_out_, FFTW_BACKWARD);
}

template <class Real> Real* PlaneTransforms<Real>::kernel() {
  if (!kernel_)
    kernel_ = make_fft_buffer<Real>(static_cast<std::size_t>(shape.length_s) * shape.length_x);
  return kernel_.get();
}

template <class Real> Real* PlaneTransforms<Real>::kernel_pairs() {
  if (!pairs_) {
    for (auto* field : {&pairs_, &pair_spectra_})
      *field = make_fft_buffer<Real>(static_cast<std::size_t>(shape.length_s) * shape.length_x);
    for (auto* field : {&one_sided_, &symbol_})
      *field = make_fft_buffer<Real>(2 * static_cast<std::size_t>(shape.frequencies()) * shape.length_s);
    kernel_x_ = plan(shape.length_x, shape.length_s / 2, pairs_, pair_spectra_, FFTW_FORWARD);
    kernel_s_ = plan(shape.length_s, shape.frequencies(), one_sided_, symbol_, FFTW_FORWARD);
  }
  return pairs_.get();
}

template <class Real> void PlaneTransforms<Real>::transform_kernel(Complex* symbol, std::ptrdiff_t stride) {
  const int n = shape.length_x, length_s = shape.length_s;
  Real* pairs = kernel_pairs();
  for (int pair = 0; pair < length_s / 2; ++pair) {
    const Real* row = kernel() + static_cast<std::size_t>(2 * pair) * n;
    Real* to = pairs + static_cast<std::size_t>(2 * pair) * n;
    for (int m = 0; m < n; ++m) {
      to[2 * m] = row[m];
      to[2 * m + 1] = row[n + m];
    }
  }
  Fftw<Real>::execute(kernel_x_.get());
  separate(pair_spectra_.get(), n, length_s / 2, 0, shape.frequencies(), one_sided_.get(), length_s);
  Fftw<Real>::execute(kernel_s_.get());
  for (int k = 0; k < shape.frequencies(); ++k)
    std::copy_n(complex(symbol_) + static_cast<std::size_t>(k) * length_s, length_s, symbol + k * stride);
}

template <class Real>
const std::complex<Real>* PlaneTransforms<Real>::half_behind(const std::vector<Real>& spectra) {
  const int n = shape.length_x, half = n / 2, length_s = shape.length_s;
  Real* pairs = kernel_pairs();
  for (int pair = 0; pair < length_s / 2; ++pair) {
    Real* z = pairs + static_cast<std::size_t>(2 * pair) * n;
    for (int k = 0; k <= half; ++k)
      for (int part = 0; part < 2; ++part)
        z[2 * k + part] = z[2 * ((n - k) % n) + part] =
            spectra[static_cast<std::size_t>(k) * length_s + 2 * pair + part];
  }
  Fftw<Real>::execute(kernel_x_.get()); // of what is even: there and back are the same
  for (int pair = 0; pair < length_s / 2; ++pair)
    for (int m = 0; m < n; ++m)
      for (int part = 0; part < 2; ++part)
        pairs[2 * (static_cast<std::size_t>(pair) * n + m) + part] =
            pair_spectra_[2 * (static_cast<std::size_t>(pair) * n + m) + part] *
            (m == 0 || m == half ? Real(0.5) : Real(m < half)) / static_cast<Real>(n);
  Fftw<Real>::execute(kernel_x_.get());
  separate(pair_spectra_.get(), n, length_s / 2, 0, shape.frequencies(), one_sided_.get(), length_s);
  return complex(one_sided_);
}

template class PlaneTransforms<double>;
template class PlaneTransforms<float>;

} // namespace bem_contact::contact
