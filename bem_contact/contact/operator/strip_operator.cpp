#include "bem_contact/contact/operator/strip_operator.hpp"

#include "bem_contact/base/large_table.hpp"
#include "bem_contact/base/parallel.hpp"
#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/plane_transforms.hpp"
#include "bem_contact/contact/operator/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/influence/dense.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <numbers>
#include <optional>

namespace bem_contact::contact {
namespace {

/// ns. Time of a strip's product for each value of a line, beside its transforms: 30 rows on AVX2.
constexpr double strip_product = 1.2;

/// ax = A x and ay = A y in one pass over the column-major A: fetching A is what takes the time.
template <class Real>
inline __attribute__((always_inline)) void multiply_both(const Real* __restrict a, int rows, int columns,
                                                         const Real* x, const Real* y, Real* __restrict ax,
                                                         Real* __restrict ay) {
  std::fill_n(ax, rows, Real(0));
  std::fill_n(ay, rows, Real(0));
  int j = 0;
  for (; j + 4 <= columns; j += 4, a += 4 * static_cast<std::ptrdiff_t>(rows)) {
    const Real x0 = x[j], x1 = x[j + 1], x2 = x[j + 2], x3 = x[j + 3];
    const Real y0 = y[j], y1 = y[j + 1], y2 = y[j + 2], y3 = y[j + 3];
    for (int i = 0; i < rows; ++i) {
      const Real a0 = a[i], a1 = a[i + rows], a2 = a[i + 2 * rows], a3 = a[i + 3 * rows];
      ax[i] += a0 * x0 + a1 * x1 + a2 * x2 + a3 * x3;
      ay[i] += a0 * y0 + a1 * y1 + a2 * y2 + a3 * y3;
    }
  }
  for (; j < columns; ++j, a += rows)
    for (int i = 0; i < rows; ++i) {
      ax[i] += a[i] * x[j];
      ay[i] += a[i] * y[j];
    }
}
/// At least `least`: the one whose products take the least time.
int good_length(int least) {
  const auto time = [](int n) { return transform_time(n) + strip_product * n; };
  int best = good_fft_length(least);
  for (int n = best; n < 2 * least; n = good_fft_length(n + 1))
    if (time(n) < time(best))
      best = n;
  return best;
}

BEM_CONTACT_WIDE void multiply(const double* a, int rows, int columns, const double* x, const double* y,
                               double* ax, double* ay) {
  multiply_both(a, rows, columns, x, y, ax, ay);
}
BEM_CONTACT_WIDE void multiply(const float* a, int rows, int columns, const float* x, const float* y,
                               float* ax, float* ay) {
  multiply_both(a, rows, columns, x, y, ax, ay);
}

} // namespace

template <class Real> struct BasicStripOperator<Real>::Impl {
  int mx = 0, ms = 0, length = 0, frequencies = 0, lines_in = 0, lines_out = 0;
  std::vector<int> outputs, inputs;
  LargeTable<Real> spectrum; ///< [frequency], column-major lines_out x lines_in
  std::shared_ptr<StripTransforms<Real>> transforms;
  int threads = 1;
  std::optional<BasicPlaneOperator<Real>> plane; ///< does all the work where the numbers are translational

  std::size_t spectrum_size() const { return static_cast<std::size_t>(frequencies) * lines_out * lines_in; }
  Real* column(int frequency, int line_in) {
    return &spectrum[(static_cast<std::size_t>(frequency) * lines_in + line_in) * lines_out];
  }
  const Real* column(int frequency, int line_in) const {
    return &spectrum[(static_cast<std::size_t>(frequency) * lines_in + line_in) * lines_out];
  }
  std::size_t line_size() const { return fft_block(std::max(lines_in, lines_out) + 1); } // of pairs
  void transform_rows(const InfluenceNumbers& numbers, const std::vector<int>& rows, int first,
                      const Eigen::MatrixXd& cosines, const Eigen::MatrixXd& sines);
  void take(TransformPool* pool);
  const Real* apply(std::span<const Real> p) const;
  template <class At> void write(const Real* v, const At& at, std::span<Real> u) const;
  void multiply_frequency(int k, const Real* in, Real* work, Real* out) const;
  void turn(const std::vector<int>& components, Real* re, Real* im, Real sign) const;
};

template <class Real>
BasicStripOperator<Real>::BasicStripOperator(const InfluenceNumbers& numbers, int mx,
                                             std::vector<int> outputs, std::vector<int> inputs,
                                             TransformPool* pool)
    : BasicStripOperator(numbers, Boxes{{{0, 0, mx, numbers.rows}}}, std::move(outputs), std::move(inputs),
                         pool) {}

template <class Real>
BasicStripOperator<Real>::BasicStripOperator(const InfluenceNumbers& numbers, const Boxes& boxes,
                                             std::vector<int> outputs, std::vector<int> inputs,
                                             TransformPool* pool)
    : impl_(std::make_unique<Impl>()) {
  using Plane = BasicPlaneOperator<Real>;
  Impl& o = *impl_;
  o.mx = boxes.mx();
  o.ms = boxes.rows();
  if (numbers.translational) {
    o.plane.emplace(numbers, boxes, outputs, inputs, Plane::Form::exact, pool);
    return;
  }
  std::vector<int> rows;
  for (const Box& box : boxes.boxes)
    for (int is = 0; is < box.ms; ++is)
      rows.push_back(box.first_s + is);
  o.length = good_length(2 * (o.mx + rolling_columns) + 1);
  o.frequencies = o.length / 2 + 1;
  o.outputs = std::move(outputs);
  o.inputs = std::move(inputs);
  o.lines_in = o.ms * static_cast<int>(o.inputs.size());
  o.lines_out = o.ms * static_cast<int>(o.outputs.size());

  // The spectra of many pairs of rows at once: one product with the cosines (or sines) of the offsets.
  const int used = std::min(numbers.offsets, o.mx + rolling_columns + 1);
  // columns: frequencies
  Eigen::MatrixXd cosines(used, o.frequencies), sines(used, o.frequencies);
  Eigen::ArrayXd angle = Eigen::ArrayXd::LinSpaced(o.length, 0, o.length - 1);
  angle *= 2.0 * std::numbers::pi / o.length;
  const Eigen::ArrayXd cosine = angle.cos(), sine = angle.sin();
  for (int k = 0; k < o.frequencies; ++k)
    for (int m = 0, turn = 0; m < used; ++m, turn = (turn + k) % o.length) {
      cosines(m, k) = m == 0 ? 1.0 : 2.0 * cosine[turn];
      sines(m, k) = -2.0 * sine[turn];
    }
  o.spectrum.resize(o.spectrum_size());
  o.take(pool);
  const int blocks = (o.ms + spectra_rows - 1) / spectra_rows;
  in_parts(o.threads, blocks, [&](int block, int end, int) {
    for (; block < end; ++block)
      o.transform_rows(numbers, rows, block * spectra_rows, cosines, sines);
  });
}

/// The spectra of displacements on the block of rows that begins with number `first`.
template <class Real>
void BasicStripOperator<Real>::Impl::transform_rows(const InfluenceNumbers& numbers,
                                                    const std::vector<int>& rows, int first,
                                                    const Eigen::MatrixXd& cosines,
                                                    const Eigen::MatrixXd& sines) {
  const int count = std::min<int>(spectra_rows, ms - first);
  const Eigen::Index used = cosines.rows(), blocks = static_cast<Eigen::Index>(count) * ms;
  const std::size_t in = inputs.size(), pairs = outputs.size() * in;
  std::vector<Eigen::MatrixXd> values(pairs); // [pair](row I of the block, J; offset)
  for (Eigen::MatrixXd& of_pair : values)
    of_pair.resize(blocks, used);
  // one pass over the numbers, which lie [m][I][i][J][j]: fetching them is what takes the time
  for (int m = 0; m < used; ++m)
    for (int row_i = 0; row_i < count; ++row_i)
      for (std::size_t pair = 0; pair < pairs; ++pair) {
        double* to = &values[pair](row_i, m);
        for (int row_j = 0; row_j < ms; ++row_j)
          to[static_cast<std::ptrdiff_t>(row_j) * count] =
              numbers.at(m, rows[first + row_i], outputs[pair / in], rows[row_j], inputs[pair % in]);
      }
  Eigen::MatrixXd transformed(blocks, frequencies);
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const int i = outputs[pair / in], j = inputs[pair % in];
    dense_product(values[pair], parity(i, j) > 0 ? cosines : sines, transformed.data());
    const double sign = parity(i, j) < 0 && i == component_x ? -1.0 : 1.0;
    for (int k = 0; k < frequencies; ++k)
      for (int row_j = 0; row_j < ms; ++row_j)
        std::transform(&transformed(row_j * count, k), &transformed(row_j * count, k) + count,
                       column(k, static_cast<int>(pair % in) * ms + row_j) + pair / in * ms + first,
                       [sign](double v) { return static_cast<Real>(sign * v); });
  }
}

template <class Real>
template <class Other>
BasicStripOperator<Real>::BasicStripOperator(const BasicStripOperator<Other>& other, TransformPool* pool)
    : impl_(std::make_unique<Impl>()) {
  Impl& o = *impl_;
  const auto& from = *other.impl_;
  o.mx = from.mx;
  o.ms = from.ms;
  if (from.plane) {
    o.plane.emplace(*from.plane, pool);
    return;
  }
  o.length = from.length;
  o.frequencies = from.frequencies;
  o.lines_in = from.lines_in;
  o.lines_out = from.lines_out;
  o.outputs = from.outputs;
  o.inputs = from.inputs;
  o.spectrum.assign(from.spectrum.begin(), from.spectrum.end());
  o.take(pool);
}

/// Transforms and threads.
template <class Real> void BasicStripOperator<Real>::Impl::take(TransformPool* pool) {
  const StripShape shape{length};
  transforms = pool ? pool->get<StripTransforms<Real>>(shape)
                    : std::make_shared<StripTransforms<Real>>(shape, std::make_shared<Scratch>());
  if (pool && ms * mx >= least_threaded)
    threads = pool->threads();
}

template <class Real> BasicStripOperator<Real>::~BasicStripOperator() = default;
template <class Real> BasicStripOperator<Real>::BasicStripOperator(BasicStripOperator&&) noexcept = default;
template <class Real>
BasicStripOperator<Real>& BasicStripOperator<Real>::operator=(BasicStripOperator&&) noexcept = default;

/// Of one frequency: transforms [pair][frequency] of tractions to those of displacements. `work`: four times
/// line_size().
template <class Real>
void BasicStripOperator<Real>::Impl::multiply_frequency(int k, const Real* in, Real* work, Real* out) const {
  Real *const re_in = work, *const im_in = work + line_size();
  Real *const re_out = im_in + line_size(), *const im_out = re_out + line_size();
  // The transform of line a plus i line b is that of a plus i times that of b; each is its own conjugate at
  // the opposite frequency.
  const std::size_t own = 2 * static_cast<std::size_t>(k), pair = transforms->shape.pair(),
                    opposite = k == 0 ? 0 : 2 * static_cast<std::size_t>(length - k);
  for (int line = 0; line < lines_in; line += 2, in += pair) {
    const Real *const a = in + own, *const b = in + opposite;
    re_in[line] = Real(0.5) * (a[0] + b[0]);
    im_in[line] = Real(0.5) * (a[1] - b[1]);
    re_in[line + 1] = Real(0.5) * (a[1] + b[1]);
    im_in[line + 1] = Real(0.5) * (b[0] - a[0]);
  }
  turn(inputs, re_in, im_in, 1);
  multiply(column(k, 0), lines_out, lines_in, re_in, im_in, re_out, im_out);
  turn(outputs, re_out, im_out, -1);
  if (lines_out % 2 != 0)
    re_out[lines_out] = im_out[lines_out] = 0;
  for (int line = 0; line < lines_out; line += 2, out += pair) {
    Real *const a = out + own, *const b = out + opposite;
    if (own == opposite) { // real, for they are of real lines
      a[0] = re_out[line];
      a[1] = re_out[line + 1];
      continue;
    }
    a[0] = re_out[line] - im_out[line + 1];
    a[1] = im_out[line] + re_out[line + 1];
    b[0] = re_out[line] + im_out[line + 1];
    b[1] = re_out[line + 1] - im_out[line];
  }
}

/// Times `sign` i where the component is x: then all spectra are real.
template <class Real>
void BasicStripOperator<Real>::Impl::turn(const std::vector<int>& components, Real* re, Real* im,
                                          Real sign) const {
  for (std::size_t c = 0; c < components.size(); ++c)
    if (components[c] == component_x)
      for (std::size_t line = c * ms; line < (c + 1) * ms; ++line) {
        const Real before = re[line];
        re[line] = -sign * im[line];
        im[line] = sign * before;
      }
}

/// u of columns up to mx + 1, times the transform's length: [pair][column][line of the pair], a pair
/// StripShape::pair() long, until the next product.
template <class Real> const Real* BasicStripOperator<Real>::Impl::apply(std::span<const Real> p) const {
  // Tractions, then the transforms of displacements; the transforms of tractions, then displacements.
  const StripShape& shape = transforms->shape;
  const int pairs_in = (lines_in + 1) / 2, pairs_out = (lines_out + 1) / 2;
  const std::size_t block = std::max(pairs_in, pairs_out) * shape.pair();
  Real* const first = transforms->scratch->template reals<Real>(2 * block + 4 * threads * line_size());
  Real *const second = first + block, *const work = second + block;
  for (int pair = 0; pair < pairs_in; ++pair) {
    Real* const to = first + pair * shape.pair();
    const Real* const a = &p[static_cast<std::size_t>(2 * pair) * mx];
    const bool both = 2 * pair + 1 < lines_in;
    for (int ix = 0; ix < mx; ++ix) {
      to[2 * ix] = a[ix];
      to[2 * ix + 1] = both ? a[mx + ix] : Real(0);
    }
    std::fill(to + 2 * static_cast<std::size_t>(mx), to + 2 * static_cast<std::size_t>(length), Real(0));
  }
  transforms->forward(pairs_in, first, second);
  in_parts(threads, frequencies, [&](int k, int end, int part) {
    for (; k < end; ++k)
      multiply_frequency(k, second, work + 4 * part * line_size(), first);
  });
  transforms->backward(pairs_out, first, second);
  return second;
}

/// u at each element, of what `at` makes of the values from there on, every other one of which is its line's.
template <class Real>
template <class At>
void BasicStripOperator<Real>::Impl::write(const Real* v, const At& at, std::span<Real> u) const {
  const Real scale = 1.0 / length;
  for (int line = 0; line < lines_out; ++line) {
    const Real* from = v + (line / 2) * transforms->shape.pair() + line % 2;
    for (int ix = 0; ix < mx; ++ix)
      u[static_cast<std::size_t>(line) * mx + ix] = scale * at(from + 2 * static_cast<std::size_t>(ix));
  }
}

template <class Real>
void BasicStripOperator<Real>::apply(std::span<const Real> p, std::span<Real> u, int columns) const {
  const Impl& o = *impl_;
  if (o.plane)
    return o.plane->apply(p, u, columns);
  o.write(
      o.apply(p), [columns](const Real* v) { return v[2 * columns]; }, u);
}

template <class Real>
void BasicStripOperator<Real>::apply_step(std::span<const Real> p, std::span<Real> u) const {
  const Impl& o = *impl_;
  if (o.plane)
    return o.plane->apply_step(p, u);
  const auto step = [](const Real* v) {
    return rolling_step[0] * v[0] + rolling_step[1] * v[2] + rolling_step[2] * v[4];
  };
  o.write(o.apply(p), step, u);
}

template <class Real> bool BasicStripOperator<Real>::change_to_steps(const std::array<double, 3>& step) {
  if (impl_->plane)
    impl_->plane->change_to_steps(step);
  return impl_->plane.has_value();
}

template class BasicStripOperator<double>;
template class BasicStripOperator<float>;
template BasicStripOperator<float>::BasicStripOperator(const BasicStripOperator<double>&, TransformPool*);

} // namespace bem_contact::contact
