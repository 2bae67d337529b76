#include "bem_contact/contact/operator/plane_operator.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/operator/plane_transforms.hpp"
#include "bem_contact/contact/operator/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <span>
#include <tuple>

namespace bem_contact::contact {
namespace {

template <class Real> using Complex = std::complex<Real>;

template <class Real> Complex<Real>* complex(const FftBuffer<Real>& buffer) {
  return reinterpret_cast<Complex<Real>*>(buffer.get());
}
int lines_of(int ms) {
  return (ms + PlaneShape::step - 1) / PlaneShape::step * PlaneShape::step;
}

template <class Real>
std::shared_ptr<PlaneTransforms<Real>> pooled(const PlaneShape& shape, TransformPool* pool) {
  return pool ? pool->get<PlaneTransforms<Real>>(shape) : TransformPool().get<PlaneTransforms<Real>>(shape);
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

/// The symbol of sum_k step[k] u(x + k dx) at a frequency.
std::complex<double> symbol_of_steps(const std::array<double, 3>& step, int frequency, int length) {
  const std::complex<double> ahead = std::polar(1.0, 2 * std::numbers::pi * frequency / length);
  return step[0] + ahead * (step[1] + ahead * step[2]);
}

} // namespace

struct PlaneSizes {
  int mx = 0, ms = 0, length_x = 0, length_s = 0, frequencies = 0, inputs = 0, outputs = 0;
};

template <class Real> struct BasicPlaneOperator<Real>::Impl : PlaneSizes {
  FftBuffer<Real> symbol; ///< complex [frequency][output][input][length_s]
  std::vector<char> zero; ///< [output][input]: all numbers are, and the symbol is not there
  std::shared_ptr<PlaneTransforms<Real>> transforms;

  std::size_t symbol_size() const { // reals
    return 2 * static_cast<std::size_t>(frequencies) * outputs * inputs * length_s;
  }
  Complex<Real>* symbol_at(int k, int a, int b) const {
    return complex(symbol) + ((static_cast<std::size_t>(k) * outputs + a) * inputs + b) * length_s;
  }
  PlaneShape shape() const { return {length_x, length_s, lines_of(ms), inputs, outputs}; }
  template <class Other> void copy(const Other& from) {
    static_cast<PlaneSizes&>(*this) = from;
    zero = from.zero;
    symbol = make_fft_buffer<Real>(symbol_size());
    const std::size_t pairs = zero.size(), each = 2 * static_cast<std::size_t>(length_s);
    for (std::size_t block = 0; block < frequencies * pairs; ++block)
      if (!zero[block % pairs])
        std::transform(from.symbol.get() + block * each, from.symbol.get() + (block + 1) * each,
                       symbol.get() + block * each, [](auto v) { return static_cast<Real>(v); });
  }
  /// Of A_ij where the target lies so many columns and rows ahead of the load.
  struct Entry {
    int i, j, ahead_x = 0, ahead_s = 0;
  };
  /// Symbol (a, b) of this entry. `middle`: as in the constructor of the operator.
  void transform_numbers(const InfluenceNumbers& numbers, const Entry& entry, int middle, int a, int b);
  void multiply_line(int frequency, int a, Complex<Real>* in, Real* out) const;
  void apply(std::span<const Real> p) const;
  template <class At> void write(const At& at, std::span<Real> u) const;
  Real largest() const;
};

template <class Real>
void BasicPlaneOperator<Real>::Impl::transform_numbers(const InfluenceNumbers& numbers, const Entry& entry,
                                                       int middle, int a, int b) {
  const auto [i, j, ahead_x, ahead_s] = entry;
  bool none = true;
  const std::size_t next =
      numbers.offsets > 1 ? numbers.index(1, 0, 0, 0, 0) - numbers.index(0, 0, 0, 0, 0) : 0;
  const double sign = parity(i, j);
  Real* kernel = transforms->kernel();
  std::fill_n(kernel, static_cast<std::size_t>(length_s) * length_x, Real(0));
  for (int d = 1 - ms; d < ms; ++d) {
    const int rows = d + ahead_s;
    int row_i = std::max(rows, 0), row_j = std::max(-rows, 0);
    if (!numbers.translational) {
      row_i = std::clamp(middle + rows / 2, row_i, numbers.rows - 1 - row_j);
      row_j = row_i - rows;
    }
    Real* line = &kernel[static_cast<std::size_t>((d + 2 * length_s) % length_s) * length_x];
    const double* at_zero = &numbers.values[numbers.index(0, row_i, i, row_j, j)];
    const int from = std::max(1 - mx, 1 - numbers.offsets - ahead_x),
              to = std::min(mx + rolling_columns, numbers.offsets - ahead_x);
    int place = (from + 2 * length_x) % length_x;
    for (int m = from; m < to; ++m, place = place + 1 < length_x ? place + 1 : 0) {
      const int offset = m + ahead_x;
      const double number = at_zero[static_cast<std::size_t>(std::abs(offset)) * next];
      line[place] += static_cast<Real>(offset < 0 ? sign * number : number);
      none = none && number == 0;
    }
  }
  zero[a * inputs + b] = none;
  if (!none)
    transforms->transform_kernel(symbol_at(0, a, b),
                                 static_cast<std::ptrdiff_t>(inputs) * outputs * length_s);
}

template <class Real>
BasicPlaneOperator<Real>::BasicPlaneOperator(const InfluenceNumbers& numbers, const Boxes& boxes,
                                             const std::vector<int>& outputs, const std::vector<int>& inputs,
                                             Form form, TransformPool* pool)
    : impl_(std::make_unique<Impl>()) {
  Impl& o = *impl_;
  const int mx = o.mx = boxes.mx(), ms = o.ms = boxes.ms();
  const bool exact = form == Form::exact;
  std::tie(o.length_x, o.length_s) =
      good_lengths(exact ? 2 * mx + rolling_columns - 1 : mx + periodic_elements + mx / periodic_margin,
                   std::max(lines_of(ms), exact ? 2 * ms - 1 : ms + periodic_elements + ms / periodic_margin),
                   lines_of(ms));
  o.frequencies = o.length_x / 2 + 1;
  // each box of a component is a component of its own
  const int count = boxes.count();
  o.inputs = count * static_cast<int>(inputs.size());
  o.outputs = count * static_cast<int>(outputs.size());
  o.transforms = pooled<Real>(o.shape(), pool);
  o.symbol = make_fft_buffer<Real>(o.symbol_size());
  o.zero.assign(static_cast<std::size_t>(o.outputs) * o.inputs, 0);
  const int middle = boxes.boxes.front().first_s + ms / 2;
  for (int a = 0; a < o.outputs; ++a)
    for (int b = 0; b < o.inputs; ++b) {
      const Box &to = boxes.boxes[a % count], &from = boxes.boxes[b % count];
      o.transform_numbers(
          numbers,
          {outputs[a / count], inputs[b / count], to.first_x - from.first_x, to.first_s - from.first_s},
          middle, a, b);
    }
}

template <class Real>
template <class Other>
BasicPlaneOperator<Real>::BasicPlaneOperator(const BasicPlaneOperator<Other>& other, TransformPool* pool)
    : impl_(std::make_unique<Impl>()) {
  impl_->copy(*other.impl_);
  impl_->transforms = pooled<Real>(impl_->shape(), pool);
}

template <class Real>
BasicPlaneOperator<Real>::BasicPlaneOperator(const BasicPlaneOperator& other)
    : impl_(std::make_unique<Impl>()) {
  impl_->copy(*other.impl_);
  impl_->transforms = other.impl_->transforms;
}

template <class Real> BasicPlaneOperator<Real>::~BasicPlaneOperator() = default;
template <class Real> BasicPlaneOperator<Real>::BasicPlaneOperator(BasicPlaneOperator&&) noexcept = default;
template <class Real>
BasicPlaneOperator<Real>& BasicPlaneOperator<Real>::operator=(BasicPlaneOperator&&) noexcept = default;

/// Leaves u of columns up to mx + 1, times both lengths, in rows_out.
template <class Real> void BasicPlaneOperator<Real>::Impl::apply(std::span<const Real> p) const {
  PlaneTransforms<Real>& t = *transforms;
  t.begin_product();
  const int pairs = t.shape.lines / 2;
  for (int b = 0; b < inputs; ++b)
    for (int pair = 0; pair < pairs; ++pair) { // others have left what they had beyond
      Real* to = t.rows_in(b, pair);
      const Real* row = &p[static_cast<std::size_t>(b * ms + std::min(2 * pair, ms - 1)) * mx];
      const int count = 2 * pair < ms ? mx : 0;
      const Real second = 2 * pair + 1 < ms;
      const Real* next = row + (second != 0 ? mx : 0);
      for (int ix = 0; ix < count; ++ix) {
        to[2 * ix] = row[ix];
        to[2 * ix + 1] = second * next[ix];
      }
      std::fill(to + 2 * count, to + 2 * length_x, Real(0));
    }
  t.forward();
  for (int group = 0; group < t.groups(); ++group) {
    const auto columns = t.forward_s(group);
    for (int line = 0; line < columns.count; ++line)
      for (int a = 0; a < outputs; ++a)
        multiply_line(columns.first + line, a, columns.in + line * inputs * length_s,
                      parts(columns.out + (line * outputs + a) * length_s));
    t.backward_s(columns);
  }
  t.backward();
}

/// out = sum over b of the symbols (a, b) of a frequency times in [b][length_s]
template <class Real>
void BasicPlaneOperator<Real>::Impl::multiply_line(int frequency, int a, Complex<Real>* in, Real* out) const {
  bool add = false;
  for (int b = 0; b < inputs; ++b)
    if (!zero[a * inputs + b]) {
      multiply(parts(symbol_at(frequency, a, b)), parts(in + b * length_s), length_s, add, out);
      add = true;
    }
  if (!add)
    std::fill_n(out, 2 * length_s, Real(0));
}

/// u at each element, of what `at` makes of the values from there on, every second of which is of this row.
template <class Real>
template <class At>
void BasicPlaneOperator<Real>::Impl::write(const At& at, std::span<Real> u) const {
  const Real scale = 1.0 / length_x / length_s;
  for (int a = 0; a < outputs; ++a)
    for (int is = 0; is < ms; ++is) {
      const Real* v = transforms->rows_out(a, is / 2) + is % 2;
      for (int ix = 0; ix < mx; ++ix)
        u[static_cast<std::size_t>(a * ms + is) * mx + ix] = scale * at(v + 2 * ix);
    }
}

template <class Real>
void BasicPlaneOperator<Real>::apply(std::span<const Real> p, std::span<Real> u, int columns) const {
  impl_->apply(p);
  impl_->write([columns](const Real* v) { return v[2 * columns]; }, u);
}

template <class Real>
void BasicPlaneOperator<Real>::apply_step(std::span<const Real> p, std::span<Real> u) const {
  impl_->apply(p);
  const auto step = [](const Real* v) {
    return rolling_step[0] * v[0] + rolling_step[1] * v[2] + rolling_step[2] * v[4];
  };
  impl_->write(step, u);
}

/// The largest real part of the symbol.
template <class Real> Real BasicPlaneOperator<Real>::Impl::largest() const {
  Real largest = 0;
  const std::size_t count = static_cast<std::size_t>(frequencies) * length_s;
  for (std::size_t k = 0; k < count; ++k)
    largest = std::max(largest, complex(symbol)[k].real());
  return largest;
}

template <class Real> void BasicPlaneOperator<Real>::invert() {
  const Impl& o = *impl_;
  // the truncated kernel's ripples must not turn an eigenvalue's sign: positive and real
  const Real least = Real(least_eigenvalue) * o.largest();
  const std::size_t count = static_cast<std::size_t>(o.frequencies) * o.length_s;
  for (std::size_t k = 0; k < count; ++k) {
    Complex<Real>& z = complex(o.symbol)[k];
    z = 1 / std::max(std::abs(z.real()), least);
  }
}

template <class Real> void BasicPlaneOperator<Real>::invert_behind() {
  const Impl& o = *impl_;
  const Real least = Real(least_eigenvalue) * o.largest();
  const std::size_t count = static_cast<std::size_t>(o.frequencies) * o.length_s;
  // the part of the logarithm whose kernel lies behind (or ahead) only, one frequency of s at a time
  std::vector<Real> logarithm(count);
  for (std::size_t k = 0; k < count; ++k)
    logarithm[k] = std::log(std::max(std::abs(complex(o.symbol)[k].real()), least));
  const Complex<Real>* half = o.transforms->half_behind(logarithm);
  for (std::size_t k = 0; k < count; ++k)
    complex(o.symbol)[k] = std::exp(-half[k]);
}

template <class Real> void BasicPlaneOperator<Real>::mirror() {
  const Impl& o = *impl_; // of real numbers
  for (std::size_t k = 1; k < o.symbol_size(); k += 2)
    o.symbol[k] = -o.symbol[k];
}

template <class Real> void BasicPlaneOperator<Real>::change_to_steps(const std::array<double, 3>& step) {
  const Impl& o = *impl_;
  for (int k = 0; k < o.frequencies; ++k) {
    const Complex<Real> factor(symbol_of_steps(step, k, o.length_x));
    for (int a = 0; a < o.outputs; ++a)
      for (int b = 0; b < o.inputs; ++b)
        if (!o.zero[a * o.inputs + b])
          for (Complex<Real>& z : std::span(o.symbol_at(k, a, b), o.length_s))
            z = {z.real() * factor.real() - z.imag() * factor.imag(),
                 z.real() * factor.imag() + z.imag() * factor.real()};
  }
}

template <class Real>
void BasicPlaneOperator<Real>::invert_shifted(const BasicPlaneOperator& of, Real shift, Real scale,
                                              const std::array<double, 3>& step) {
  const Impl& o = *impl_;
  for (int k = 0; k < o.frequencies; ++k) {
    const Complex<Real> factor(static_cast<double>(scale) * symbol_of_steps(step, k, o.length_x));
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
template BasicPlaneOperator<float>::BasicPlaneOperator(const BasicPlaneOperator<double>&, TransformPool*);

} // namespace bem_contact::contact
