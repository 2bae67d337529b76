#include "bem_contact/contact/plane_operator.hpp"

#include "bem_contact/contact/fft.hpp"
#include "bem_contact/contact/rolling_step.hpp"
#include "bem_contact/contact/simd.hpp"

#include <cmath>
#include <cstdlib>

namespace bem_contact::contact {
namespace {

using Complex = std::complex<double>;

/// The periodic form is longer than the grid by 1/periodic_margin of it.
constexpr int periodic_margin = 3;

Complex* complex(const FftBuffer& buffer) {
  return reinterpret_cast<Complex*>(buffer.get());
}
fftw_complex* raw(Complex* p) {
  return reinterpret_cast<fftw_complex*>(p);
}

int even_length(int n) {
  n = good_fft_length(n);
  while (n % 2 != 0)
    n = good_fft_length(n + 1);
  return n;
}

/// out = a b or out += a b, element by element, without the tests for infinity that std::complex makes
BEM_CONTACT_WIDE void multiply(const double* __restrict a, const double* __restrict b, int n, bool add,
                               double* __restrict out) {
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

double* parts(Complex* p) {
  return reinterpret_cast<double*>(p);
}

} // namespace

struct PlaneOperator::Impl {
  int mx = 0, ms = 0, length_x = 0, length_s = 0, frequencies = 0, inputs = 0, outputs = 0;
  FftBuffer symbol; ///< complex [frequency][output][input][length_s]
  FftBuffer space_in, space_out;
  FftBuffer spectrum_in;  ///< complex [frequency][input][length_s]; rows beyond ms stay zero
  FftBuffer spectrum_out; ///< complex [frequency][output][ms]
  FftBuffer turned_in;    ///< complex [input][length_s]
  FftBuffer turned;       ///< complex [output][length_s]
  FftPlan x_forward, s_forward, s_backward, x_backward;

  Complex* symbol_at(int k, int a, int b) const {
    return complex(symbol) + ((static_cast<std::size_t>(k) * outputs + a) * inputs + b) * length_s;
  }
  void make_plans();
  void transform_numbers(const InfluenceNumbers& numbers, const std::vector<int>& i,
                         const std::vector<int>& j, int middle);
  void apply(std::span<const double> p) const;
};

void PlaneOperator::Impl::make_plans() {
  const auto lines = [this](int n) { return static_cast<std::size_t>(n) * ms * length_x; };
  space_in = make_fft_buffer(lines(inputs));
  space_out = make_fft_buffer(lines(outputs));
  spectrum_in = make_fft_buffer(2 * static_cast<std::size_t>(frequencies) * inputs * length_s);
  spectrum_out = make_fft_buffer(2 * static_cast<std::size_t>(frequencies) * outputs * ms);
  turned_in = make_fft_buffer(2 * static_cast<std::size_t>(inputs) * length_s);
  turned = make_fft_buffer(2 * static_cast<std::size_t>(outputs) * length_s);
  const std::lock_guard lock(fft_planner());
  // lines of one frequency lie side by side, so that the transform in s stays in the cache
  const fftw_iodim in_dims{length_x, 1, inputs * length_s};
  const fftw_iodim in_many[2] = {{inputs, ms * length_x, length_s}, {ms, length_x, 1}};
  x_forward.reset(fftw_plan_guru_dft_r2c(1, &in_dims, 2, in_many, space_in.get(), raw(complex(spectrum_in)),
                                         FFTW_ESTIMATE));
  const fftw_iodim out_dims{length_x, outputs * ms, 1};
  const fftw_iodim out_many[2] = {{outputs, ms, ms * length_x}, {ms, 1, length_x}};
  x_backward.reset(fftw_plan_guru_dft_c2r(1, &out_dims, 2, out_many, raw(complex(spectrum_out)),
                                          space_out.get(), FFTW_ESTIMATE));
  const auto along_s = [this](int lines_of_s, Complex* from, Complex* to, int sign) {
    return fftw_plan_many_dft(1, &length_s, lines_of_s, raw(from), nullptr, 1, length_s, raw(to), nullptr, 1,
                              length_s, sign, FFTW_ESTIMATE);
  };
  s_forward.reset(along_s(inputs, complex(spectrum_in), complex(turned_in), FFTW_FORWARD));
  s_backward.reset(along_s(outputs, complex(turned), complex(turned), FFTW_BACKWARD));
}

void PlaneOperator::Impl::transform_numbers(const InfluenceNumbers& numbers, const std::vector<int>& of_i,
                                            const std::vector<int>& of_j, int middle) {
  symbol = make_fft_buffer(2 * static_cast<std::size_t>(frequencies) * outputs * inputs * length_s);
  FftBuffer kernel = make_fft_buffer(static_cast<std::size_t>(length_s) * length_x);
  const int distance = inputs * outputs * length_s, one = 1;
  FftPlan along_x, along_s;
  {
    const std::lock_guard lock(fft_planner());
    along_x.reset(fftw_plan_many_dft_r2c(1, &length_x, length_s, kernel.get(), nullptr, 1, length_x,
                                         raw(complex(symbol)), nullptr, distance, one, FFTW_ESTIMATE));
    along_s.reset(fftw_plan_many_dft(1, &length_s, 1, raw(complex(symbol)), nullptr, 1, length_s,
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
        double* line = &kernel[static_cast<std::size_t>((d + 2 * length_s) % length_s) * length_x];
        for (int m = 0; m < ahead; ++m) {
          const double number = numbers.at(m, row_i, i, row_j, j);
          line[m % length_x] += number;
          if (m > 0 && m < mx)
            line[(2 * length_x - m) % length_x] += parity(i, j) * number;
        }
      }
      fftw_execute_dft_r2c(along_x.get(), kernel.get(), raw(symbol_at(0, a, b)));
      for (int k = 0; k < frequencies; ++k)
        fftw_execute_dft(along_s.get(), raw(symbol_at(k, a, b)), raw(symbol_at(k, a, b)));
    }
}

PlaneOperator::PlaneOperator(const InfluenceNumbers& numbers, int mx, int ms, std::vector<int> outputs,
                             std::vector<int> inputs, Form form, int middle)
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

PlaneOperator::~PlaneOperator() = default;
PlaneOperator::PlaneOperator(PlaneOperator&&) noexcept = default;
PlaneOperator& PlaneOperator::operator=(PlaneOperator&&) noexcept = default;

/// Leaves u of columns up to mx + 1, times both lengths, in space_out.
void PlaneOperator::Impl::apply(std::span<const double> p) const {
  for (int line = 0; line < inputs * ms; ++line) // what lies beyond stays zero
    std::copy_n(&p[static_cast<std::size_t>(line) * mx], mx,
                &space_in[static_cast<std::size_t>(line) * length_x]);
  fftw_execute(x_forward.get());
  for (int k = 0; k < frequencies; ++k) {
    Complex* in = complex(spectrum_in) + static_cast<std::size_t>(k) * inputs * length_s;
    fftw_execute_dft(s_forward.get(), raw(in), raw(complex(turned_in)));
    for (int a = 0; a < outputs; ++a)
      for (int b = 0; b < inputs; ++b)
        multiply(parts(symbol_at(k, a, b)), parts(complex(turned_in) + b * length_s), length_s, b > 0,
                 parts(complex(turned) + a * length_s));
    fftw_execute(s_backward.get());
    for (int a = 0; a < outputs; ++a)
      std::copy_n(complex(turned) + a * length_s, ms,
                  complex(spectrum_out) + (static_cast<std::size_t>(k) * outputs + a) * ms);
  }
  fftw_execute(x_backward.get());
}

void PlaneOperator::apply(std::span<const double> p, std::span<double> u, int columns) const {
  const Impl& o = *impl_;
  o.apply(p);
  const double scale = 1.0 / o.length_x / o.length_s;
  for (int line = 0; line < o.outputs * o.ms; ++line)
    for (int ix = 0; ix < o.mx; ++ix)
      u[static_cast<std::size_t>(line) * o.mx + ix] =
          scale * o.space_out[static_cast<std::size_t>(line) * o.length_x + ix + columns];
}

void PlaneOperator::apply_step(std::span<const double> p, std::span<double> u) const {
  const Impl& o = *impl_;
  o.apply(p);
  const double scale = 1.0 / o.length_x / o.length_s;
  for (int line = 0; line < o.outputs * o.ms; ++line) {
    const double* v = &o.space_out[static_cast<std::size_t>(line) * o.length_x];
    for (int ix = 0; ix < o.mx; ++ix)
      u[static_cast<std::size_t>(line) * o.mx + ix] =
          scale * (rolling_step[0] * v[ix] + rolling_step[1] * v[ix + 1] + rolling_step[2] * v[ix + 2]);
  }
}

void PlaneOperator::invert() {
  const Impl& o = *impl_;
  // the truncated kernel's ripples must not turn an eigenvalue's sign: positive and real
  double largest = 0;
  const std::size_t count = static_cast<std::size_t>(o.frequencies) * o.length_s;
  for (std::size_t k = 0; k < count; ++k)
    largest = std::max(largest, complex(o.symbol)[k].real());
  for (std::size_t k = 0; k < count; ++k) {
    Complex& z = complex(o.symbol)[k];
    z = 1 / std::max(std::abs(z.real()), 1e-4 * largest);
  }
}

void PlaneOperator::invert_factor(Factor factor) {
  const Impl& o = *impl_;
  const int n = o.length_x, half = n / 2;
  double largest = 0;
  for (int k = 0; k < o.frequencies; ++k)
    for (int l = 0; l < o.length_s; ++l)
      largest = std::max(largest, o.symbol_at(k, 0, 0)[l].real());
  // the part of the logarithm whose kernel lies behind (or ahead) only, one frequency of s at a time
  const std::size_t together = static_cast<std::size_t>(o.frequencies) * o.length_s;
  FftBuffer spectrum = make_fft_buffer(together), one_sided = make_fft_buffer(2 * together);
  FftBuffer kernel = make_fft_buffer(static_cast<std::size_t>(n) * o.length_s);
  FftPlan to_kernel, to_spectrum;
  {
    const std::lock_guard lock(fft_planner());
    const int count = half + 1;
    const fftw_r2r_kind even = FFTW_REDFT00;
    to_kernel.reset(fftw_plan_many_r2r(1, &count, o.length_s, spectrum.get(), nullptr, 1, count,
                                       spectrum.get(), nullptr, 1, count, &even, FFTW_ESTIMATE));
    to_spectrum.reset(fftw_plan_many_dft_r2c(1, &n, o.length_s, kernel.get(), nullptr, 1, n,
                                             raw(complex(one_sided)), nullptr, 1, count, FFTW_ESTIMATE));
  }
  for (int l = 0; l < o.length_s; ++l)
    for (int k = 0; k <= half; ++k)
      spectrum[static_cast<std::size_t>(l) * (half + 1) + k] =
          std::log(std::max(std::abs(o.symbol_at(k, 0, 0)[l].real()), 1e-4 * largest));
  fftw_execute(to_kernel.get());
  for (int l = 0; l < o.length_s; ++l)
    for (int m = 0; m <= half; ++m)
      kernel[static_cast<std::size_t>(l) * n + m] =
          spectrum[static_cast<std::size_t>(l) * (half + 1) + m] / n * (m == 0 || m == half ? 0.5 : 1.0);
  fftw_execute(to_spectrum.get());
  for (int l = 0; l < o.length_s; ++l)
    for (int k = 0; k <= half; ++k) {
      const Complex behind = std::exp(-complex(one_sided)[static_cast<std::size_t>(l) * (half + 1) + k]);
      o.symbol_at(k, 0, 0)[l] = factor == Factor::behind ? behind : std::conj(behind);
    }
}

} // namespace bem_contact::contact
