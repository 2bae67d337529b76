#include "bem_contact/contact/plane_operator.hpp"

#include "bem_contact/contact/fft.hpp"
#include "bem_contact/contact/rolling_step.hpp"
#include "bem_contact/contact/simd.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace bem_contact::contact {
namespace {

template <class Real> using Complex = std::complex<Real>;

/// The periodic form is longer than the grid by 1/periodic_margin of it.
constexpr int periodic_margin = 3;

template <class Real> Complex<Real>* complex(const FftBuffer<Real>& buffer) {
  return reinterpret_cast<Complex<Real>*>(buffer.get());
}
template <class Real> typename Fftw<Real>::Complex* raw(Complex<Real>* p) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(p);
}

int even_length(int n) {
  n = good_fft_length(n);
  while (n % 2 != 0)
    n = good_fft_length(n + 1);
  return n;
}

/// out = a b or out += a b, element by element, without the tests for infinity that std::complex makes
template <class Real>
inline __attribute__((always_inline)) void multiply_parts(const Real* __restrict a, const Real* __restrict b,
                                                          int n, bool add, Real* __restrict out) {
  if (!add)
    for (int k = 0; k < 2 * n; k += 2) {
      out[k] = a[k] * b[k] - a[k + 1] * b[k + 1];
      out[k + 1] = a[k] * b[k + 1] + a[k + 1] * b[k];
    }
  else
    for (int k = 0; k < 2 * n; k += 2) {
      out[k] += a[k] * b[k] - a[k + 1] * b[k + 1];
      out[k + 1] += a[k] * b[k + 1] + a[k + 1] * b[k];
    }
}
BEM_CONTACT_WIDE void multiply(const double* a, const double* b, int n, bool add, double* out) {
  multiply_parts(a, b, n, add, out);
}
BEM_CONTACT_WIDE void multiply(const float* a, const float* b, int n, bool add, float* out) {
  multiply_parts(a, b, n, add, out);
}

template <class Real> Real* parts(Complex<Real>* p) {
  return reinterpret_cast<Real*>(p);
}

} // namespace

template <class Real> struct BasicPlaneOperator<Real>::Impl {
  using Fft = Fftw<Real>;
  int mx = 0, ms = 0, length_x = 0, length_s = 0, frequencies = 0, inputs = 0, outputs = 0;
  FftBuffer<Real> symbol; ///< complex [frequency][output][input][length_s]
  FftBuffer<Real> space_in, space_out;
  FftBuffer<Real> spectrum_in;  ///< complex [frequency][input][length_s]; rows beyond ms stay zero
  FftBuffer<Real> spectrum_out; ///< complex [frequency][output][ms]
  FftBuffer<Real> turned_in;    ///< complex [input][length_s]
  FftBuffer<Real> turned;       ///< complex [output][length_s]
  FftPlan<Real> x_forward, s_forward, s_backward, x_backward;

  Complex<Real>* symbol_at(int k, int a, int b) const {
    return complex(symbol) + ((static_cast<std::size_t>(k) * outputs + a) * inputs + b) * length_s;
  }
  void make_plans();
  void transform_numbers(const InfluenceNumbers& numbers, const std::vector<int>& i,
                         const std::vector<int>& j, int middle);
  void apply(std::span<const Real> p) const;
};

template <class Real> void BasicPlaneOperator<Real>::Impl::make_plans() {
  const auto lines = [this](int n) { return static_cast<std::size_t>(n) * ms * length_x; };
  space_in = make_fft_buffer<Real>(lines(inputs));
  space_out = make_fft_buffer<Real>(lines(outputs));
  spectrum_in = make_fft_buffer<Real>(2 * static_cast<std::size_t>(frequencies) * inputs * length_s);
  spectrum_out = make_fft_buffer<Real>(2 * static_cast<std::size_t>(frequencies) * outputs * ms);
  turned_in = make_fft_buffer<Real>(2 * static_cast<std::size_t>(inputs) * length_s);
  turned = make_fft_buffer<Real>(2 * static_cast<std::size_t>(outputs) * length_s);
  const std::lock_guard lock(fft_planner());
  // lines of one frequency lie side by side, so that the transform in s stays in the cache
  const fftw_iodim in_dims{length_x, 1, inputs * length_s};
  const fftw_iodim in_many[2] = {{inputs, ms * length_x, length_s}, {ms, length_x, 1}};
  x_forward.reset(Fft::plan_guru_dft_r2c(1, &in_dims, 2, in_many, space_in.get(), raw(complex(spectrum_in)),
                                         FFTW_ESTIMATE));
  const fftw_iodim out_dims{length_x, outputs * ms, 1};
  const fftw_iodim out_many[2] = {{outputs, ms, ms * length_x}, {ms, 1, length_x}};
  x_backward.reset(Fft::plan_guru_dft_c2r(1, &out_dims, 2, out_many, raw(complex(spectrum_out)),
                                          space_out.get(), FFTW_ESTIMATE));
  const auto along_s = [this](int lines_of_s, Complex<Real>* from, Complex<Real>* to, int sign) {
    return Fft::plan_many_dft(1, &length_s, lines_of_s, raw(from), nullptr, 1, length_s, raw(to), nullptr, 1,
                              length_s, sign, FFTW_ESTIMATE);
  };
  s_forward.reset(along_s(inputs, complex(spectrum_in), complex(turned_in), FFTW_FORWARD));
  s_backward.reset(along_s(outputs, complex(turned), complex(turned), FFTW_BACKWARD));
}

template <class Real>
void BasicPlaneOperator<Real>::Impl::transform_numbers(const InfluenceNumbers& numbers,
                                                       const std::vector<int>& of_i,
                                                       const std::vector<int>& of_j, int middle) {
  symbol = make_fft_buffer<Real>(2 * static_cast<std::size_t>(frequencies) * outputs * inputs * length_s);
  FftBuffer<Real> kernel = make_fft_buffer<Real>(static_cast<std::size_t>(length_s) * length_x);
  const int distance = inputs * outputs * length_s, one = 1;
  FftPlan<Real> along_x, along_s;
  {
    const std::lock_guard lock(fft_planner());
    along_x.reset(Fft::plan_many_dft_r2c(1, &length_x, length_s, kernel.get(), nullptr, 1, length_x,
                                         raw(complex(symbol)), nullptr, distance, one, FFTW_ESTIMATE));
    along_s.reset(Fft::plan_many_dft(1, &length_s, 1, raw(complex(symbol)), nullptr, 1, length_s,
                                     raw(complex(symbol)), nullptr, 1, length_s, FFTW_FORWARD,
                                     FFTW_ESTIMATE));
  }
  const int ahead = std::min(mx + rolling_columns, numbers.offsets);
  for (int a = 0; a < outputs; ++a)
    for (int b = 0; b < inputs; ++b) {
      const int i = of_i[a], j = of_j[b];
      std::fill_n(kernel.get(), static_cast<std::size_t>(length_s) * length_x, 0.0);
      for (int d = 1 - ms; d < ms; ++d) {
        int row_i = std::max(d, 0), row_j = std::max(-d, 0);
        if (!numbers.translational) {
          row_i = std::clamp(middle + d / 2, row_i, numbers.rows - 1 - row_j);
          row_j = row_i - d;
        }
        Real* line = &kernel[static_cast<std::size_t>((d + 2 * length_s) % length_s) * length_x];
        for (int m = 0; m < ahead; ++m) {
          const Real number = numbers.at(m, row_i, i, row_j, j);
          line[m % length_x] += number;
          if (m > 0 && m < mx)
            line[(2 * length_x - m) % length_x] += parity(i, j) * number;
        }
      }
      Fft::execute_dft_r2c(along_x.get(), kernel.get(), raw(symbol_at(0, a, b)));
      for (int k = 0; k < frequencies; ++k)
        Fft::execute_dft(along_s.get(), raw(symbol_at(k, a, b)), raw(symbol_at(k, a, b)));
    }
}

template <class Real>
BasicPlaneOperator<Real>::BasicPlaneOperator(const InfluenceNumbers& numbers, int mx, int ms,
                                             std::vector<int> outputs, std::vector<int> inputs, Form form,
                                             int middle)
    : impl_(std::make_unique<Impl>()) {
  Impl& o = *impl_;
  o.mx = mx;
  o.ms = ms;
  const bool exact = form == Form::exact;
  o.length_x = even_length(exact ? 2 * mx + rolling_columns - 1 : mx + 4 + mx / periodic_margin);
  o.length_s = even_length(exact ? 2 * ms - 1 : ms + 4 + ms / periodic_margin);
  o.frequencies = o.length_x / 2 + 1;
  o.inputs = static_cast<int>(inputs.size());
  o.outputs = static_cast<int>(outputs.size());
  o.make_plans();
  o.transform_numbers(numbers, outputs, inputs, middle);
}

template <class Real>
template <class Other>
BasicPlaneOperator<Real>::BasicPlaneOperator(const BasicPlaneOperator<Other>& other)
    : impl_(std::make_unique<Impl>()) {
  Impl& o = *impl_;
  const auto& from = *other.impl_;
  o.mx = from.mx;
  o.ms = from.ms;
  o.length_x = from.length_x;
  o.length_s = from.length_s;
  o.frequencies = from.frequencies;
  o.inputs = from.inputs;
  o.outputs = from.outputs;
  o.make_plans();
  const std::size_t count = 2 * static_cast<std::size_t>(o.frequencies) * o.outputs * o.inputs * o.length_s;
  o.symbol = make_fft_buffer<Real>(count);
  std::transform(from.symbol.get(), from.symbol.get() + count, o.symbol.get(),
                 [](Other v) { return static_cast<Real>(v); });
}

template <class Real> BasicPlaneOperator<Real>::~BasicPlaneOperator() = default;
template <class Real> BasicPlaneOperator<Real>::BasicPlaneOperator(BasicPlaneOperator&&) noexcept = default;
template <class Real>
BasicPlaneOperator<Real>& BasicPlaneOperator<Real>::operator=(BasicPlaneOperator&&) noexcept = default;

/// Leaves u of columns up to mx + 1, times both lengths, in space_out.
template <class Real> void BasicPlaneOperator<Real>::Impl::apply(std::span<const Real> p) const {
  for (int line = 0; line < inputs * ms; ++line) // what lies beyond stays zero
    std::copy_n(&p[static_cast<std::size_t>(line) * mx], mx,
                &space_in[static_cast<std::size_t>(line) * length_x]);
  Fft::execute(x_forward.get());
  for (int k = 0; k < frequencies; ++k) {
    Complex<Real>* in = complex(spectrum_in) + static_cast<std::size_t>(k) * inputs * length_s;
    Fft::execute_dft(s_forward.get(), raw(in), raw(complex(turned_in)));
    for (int a = 0; a < outputs; ++a)
      for (int b = 0; b < inputs; ++b)
        multiply(parts(symbol_at(k, a, b)), parts(complex(turned_in) + b * length_s), length_s, b > 0,
                 parts(complex(turned) + a * length_s));
    Fft::execute(s_backward.get());
    for (int a = 0; a < outputs; ++a)
      std::copy_n(complex(turned) + a * length_s, ms,
                  complex(spectrum_out) + (static_cast<std::size_t>(k) * outputs + a) * ms);
  }
  Fft::execute(x_backward.get());
}

template <class Real>
void BasicPlaneOperator<Real>::apply(std::span<const Real> p, std::span<Real> u, int columns) const {
  const Impl& o = *impl_;
  o.apply(p);
  const Real scale = 1.0 / o.length_x / o.length_s;
  for (int line = 0; line < o.outputs * o.ms; ++line)
    for (int ix = 0; ix < o.mx; ++ix)
      u[static_cast<std::size_t>(line) * o.mx + ix] =
          scale * o.space_out[static_cast<std::size_t>(line) * o.length_x + ix + columns];
}

template <class Real>
void BasicPlaneOperator<Real>::apply_step(std::span<const Real> p, std::span<Real> u) const {
  const Impl& o = *impl_;
  o.apply(p);
  const Real scale = 1.0 / o.length_x / o.length_s;
  for (int line = 0; line < o.outputs * o.ms; ++line) {
    const Real* v = &o.space_out[static_cast<std::size_t>(line) * o.length_x];
    for (int ix = 0; ix < o.mx; ++ix)
      u[static_cast<std::size_t>(line) * o.mx + ix] =
          scale * (rolling_step[0] * v[ix] + rolling_step[1] * v[ix + 1] + rolling_step[2] * v[ix + 2]);
  }
}

template <class Real> void BasicPlaneOperator<Real>::invert() {
  const Impl& o = *impl_;
  constexpr Real least_share = 1e-4f;
  // the truncated kernel's ripples must not turn an eigenvalue's sign: positive and real
  Real largest = 0;
  const std::size_t count = static_cast<std::size_t>(o.frequencies) * o.length_s;
  for (std::size_t k = 0; k < count; ++k)
    largest = std::max(largest, complex(o.symbol)[k].real());
  for (std::size_t k = 0; k < count; ++k) {
    Complex<Real>& z = complex(o.symbol)[k];
    z = 1 / std::max(std::abs(z.real()), least_share * largest);
  }
}

template <class Real> void BasicPlaneOperator<Real>::invert_factor(Factor factor) {
  using Fft = Fftw<Real>;
  const Impl& o = *impl_;
  const int n = o.length_x, half = n / 2;
  Real largest = 0;
  for (int k = 0; k < o.frequencies; ++k)
    for (int l = 0; l < o.length_s; ++l)
      largest = std::max(largest, o.symbol_at(k, 0, 0)[l].real());
  constexpr Real least_share = 1e-4f;
  // the part of the logarithm whose kernel lies behind (or ahead) only, one frequency of s at a time
  const std::size_t together = static_cast<std::size_t>(o.frequencies) * o.length_s;
  FftBuffer<Real> spectrum = make_fft_buffer<Real>(together), one_sided = make_fft_buffer<Real>(2 * together);
  FftBuffer<Real> kernel = make_fft_buffer<Real>(static_cast<std::size_t>(n) * o.length_s);
  FftPlan<Real> to_kernel, to_spectrum;
  {
    const std::lock_guard lock(fft_planner());
    const int count = half + 1;
    const fftw_r2r_kind even = FFTW_REDFT00;
    to_kernel.reset(Fft::plan_many_r2r(1, &count, o.length_s, spectrum.get(), nullptr, 1, count,
                                       spectrum.get(), nullptr, 1, count, &even, FFTW_ESTIMATE));
    to_spectrum.reset(Fft::plan_many_dft_r2c(1, &n, o.length_s, kernel.get(), nullptr, 1, n,
                                             raw(complex(one_sided)), nullptr, 1, count, FFTW_ESTIMATE));
  }
  for (int l = 0; l < o.length_s; ++l)
    for (int k = 0; k <= half; ++k)
      spectrum[static_cast<std::size_t>(l) * (half + 1) + k] =
          std::log(std::max(std::abs(o.symbol_at(k, 0, 0)[l].real()), least_share * largest));
  Fft::execute(to_kernel.get());
  for (int l = 0; l < o.length_s; ++l)
    for (int m = 0; m <= half; ++m)
      kernel[static_cast<std::size_t>(l) * n + m] =
          spectrum[static_cast<std::size_t>(l) * (half + 1) + m] / n * (m == 0 || m == half ? 0.5 : 1.0);
  Fft::execute(to_spectrum.get());
  for (int l = 0; l < o.length_s; ++l)
    for (int k = 0; k <= half; ++k) {
      const Complex<Real> behind =
          std::exp(-complex(one_sided)[static_cast<std::size_t>(l) * (half + 1) + k]);
      o.symbol_at(k, 0, 0)[l] = factor == Factor::behind ? behind : std::conj(behind);
    }
}

template <class Real>
void BasicPlaneOperator<Real>::invert_shifted(const BasicPlaneOperator& of, Real shift, Real scale,
                                              const std::array<double, 3>& step) {
  const Impl& o = *impl_;
  for (int k = 0; k < o.frequencies; ++k) {
    const std::complex<double> ahead = std::polar(1.0, 2 * std::numbers::pi * k / o.length_x);
    const Complex<Real> factor(static_cast<double>(scale) * (step[0] + ahead * (step[1] + ahead * step[2])));
    const Complex<Real>* from = of.impl_->symbol_at(k, 0, 0);
    Complex<Real>* to = o.symbol_at(k, 0, 0);
    for (int l = 0; l < o.length_s; ++l) {
      const Real positive = std::abs(from[l].real());
      const Real re = shift + positive * factor.real(), im = positive * factor.imag();
      const Real share = 1 / (re * re + im * im);
      to[l] = {re * share, -im * share};
    }
  }
}

template class BasicPlaneOperator<double>;
template class BasicPlaneOperator<float>;
template BasicPlaneOperator<float>::BasicPlaneOperator(const BasicPlaneOperator<double>&);

} // namespace bem_contact::contact
