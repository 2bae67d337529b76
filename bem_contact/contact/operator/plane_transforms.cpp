#include "bem_contact/contact/operator/plane_transforms.hpp"

#include "bem_contact/contact/operator/row_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace bem_contact::contact {
namespace {

/// Bytes of spectra that are transformed along s at once: they stay in a second-level cache.
constexpr int bytes_in_cache = 1 << 19;
template <class Real> typename Fftw<Real>::Complex* raw(Real* p) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(p);
}
template <class Real> std::complex<Real>* complex(Real* p) {
  return reinterpret_cast<std::complex<Real>*>(p);
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
      const double cost = 0.5 * lines * transform_time(x) + (0.5 * x + 1) * (transform_time(s) + s);
      if (cost < least) {
        least = cost;
        best = {x, s};
      }
    }
  return best;
}

template <class Real>
PlaneTransforms<Real>::PlaneTransforms(const PlaneShape& the_shape, std::shared_ptr<Scratch> scratch)
    : shape(the_shape), scratch_(std::move(scratch)) {
  const std::size_t bytes =
      2 * static_cast<std::size_t>(shape.inputs + shape.outputs) * shape.length_s * sizeof(Real);
  const int fit = static_cast<int>(std::min<std::size_t>(bytes_in_cache / bytes, shape.frequencies()));
  together_ = std::clamp(fit, std::min(exchanged_together, shape.frequencies()), shape.frequencies());
  const int fields = std::max(shape.inputs, shape.outputs);
  space_size_ = fft_block(static_cast<std::size_t>(fields) * shape.lines * shape.length_x);
  column_size_ = fft_block(2 * static_cast<std::size_t>(together_) * fields * shape.length_s);
  kernel_size_ = fft_block(2 * static_cast<std::size_t>(shape.frequencies()) * shape.length_s);
}

template <class Real> FftPlan<Real> PlaneTransforms<Real>::plan(int length, int lines, int sign) const {
  const std::lock_guard lock(fft_planner());
  return FftPlan<Real>(Fftw<Real>::plan_many_dft(1, &length, lines, raw(first_), nullptr, 1, length,
                                                 raw(second_), nullptr, 1, length, sign, FFTW_ESTIMATE));
}

/// All blocks are aligned alike, so that a plan serves any of them.
template <class Real> void PlaneTransforms<Real>::run(const FftPlan<Real>& plan, Real* from, Real* to) const {
  Fftw<Real>::execute_dft(plan.get(), raw(from), raw(to));
}

template <class Real> void PlaneTransforms<Real>::make_product_plans() {
  x_forward_ = plan(shape.length_x, shape.inputs * shape.lines / 2, FFTW_FORWARD);
  x_backward_ = plan(shape.length_x, shape.outputs * shape.lines / 2, FFTW_BACKWARD);
  const auto along_s = [&](int count) {
    return ColumnPlans{plan(shape.length_s, count * shape.inputs, FFTW_FORWARD),
                       plan(shape.length_s, count * shape.outputs, FFTW_BACKWARD)};
  };
  whole_ = along_s(together_);
  if (const int rest = shape.frequencies() % together_)
    rest_ = along_s(rest);
}

template <class Real> void PlaneTransforms<Real>::begin_product() {
  first_ = scratch_->reals<Real>(2 * (space_size_ + column_size_));
  second_ = first_ + space_size_;
  columns_ = second_ + space_size_;
  if (!x_forward_)
    make_product_plans();
}

template <class Real> void PlaneTransforms<Real>::forward() {
  run(x_forward_, first_, second_);
}

template <class Real>
typename PlaneTransforms<Real>::Group PlaneTransforms<Real>::forward_s(int group) const {
  const int first = group * together_, count = std::min(together_, shape.frequencies() - first);
  Real *const before = columns_, *const after = columns_ + column_size_;
  const int stride = shape.inputs * shape.length_s;
  for (int field = 0; field < shape.inputs; ++field) {
    Real* to = before + 2 * static_cast<std::ptrdiff_t>(field) * shape.length_s;
    separate({shape.length_x, shape.lines / 2, first, first + count, stride}, rows(second_, field, 0), to);
    for (int line = 0; line < count; ++line, to += 2 * stride)
      std::fill(to + 2 * shape.lines, to + 2 * shape.length_s, Real(0));
  }
  run(column_plans(count).forward, before, after);
  return {first, count, complex(after), complex(before)};
}

template <class Real> void PlaneTransforms<Real>::backward_s(const Group& group) const {
  Real *const before = columns_, *const after = columns_ + column_size_;
  run(column_plans(group.count).backward, before, after);
  for (int field = 0; field < shape.outputs; ++field)
    join({shape.length_x, shape.lines / 2, group.first, group.first + group.count,
          shape.outputs * shape.length_s},
         after + 2 * static_cast<std::ptrdiff_t>(field) * shape.length_s, rows(first_, field, 0));
}

template <class Real> void PlaneTransforms<Real>::backward() {
  run(x_backward_, first_, second_);
}

template <class Real> Real* PlaneTransforms<Real>::kernel() {
  first_ = scratch_->reals<Real>(2 * kernel_size_);
  second_ = first_ + kernel_size_;
  if (!kernel_x_) {
    kernel_x_ = plan(shape.length_x, shape.length_s / 2, FFTW_FORWARD);
    kernel_s_ = plan(shape.length_s, shape.frequencies(), FFTW_FORWARD);
  }
  return first_;
}

template <class Real> void PlaneTransforms<Real>::transform_kernel(Complex* symbol, std::ptrdiff_t stride) {
  const int n = shape.length_x, length_s = shape.length_s, frequencies = shape.frequencies();
  for (int pair = 0; pair < length_s / 2; ++pair) {
    const Real* row = first_ + static_cast<std::size_t>(2 * pair) * n;
    Real* to = second_ + static_cast<std::size_t>(2 * pair) * n;
    for (int m = 0; m < n; ++m) {
      to[2 * m] = row[m];
      to[2 * m + 1] = row[n + m];
    }
  }
  run(kernel_x_, second_, first_);
  separate({n, length_s / 2, 0, frequencies, length_s}, first_, second_);
  run(kernel_s_, second_, first_);
  for (int k = 0; k < frequencies; ++k)
    std::copy_n(complex(first_) + static_cast<std::size_t>(k) * length_s, length_s, symbol + k * stride);
}

template <class Real>
const std::complex<Real>* PlaneTransforms<Real>::half_behind(const std::vector<Real>& spectra) {
  const int n = shape.length_x, half = n / 2, length_s = shape.length_s;
  Real* const pairs = kernel();
  for (int pair = 0; pair < length_s / 2; ++pair) {
    Real* z = pairs + static_cast<std::size_t>(2 * pair) * n;
    for (int k = 0; k <= half; ++k)
      for (int part = 0; part < 2; ++part)
        z[2 * k + part] = z[2 * ((n - k) % n) + part] =
            spectra[static_cast<std::size_t>(k) * length_s + 2 * pair + part];
  }
  run(kernel_x_, pairs, second_); // of what is even: there and back are the same
  for (int pair = 0; pair < length_s / 2; ++pair)
    for (int m = 0; m < n; ++m)
      for (int part = 0; part < 2; ++part)
        pairs[2 * (static_cast<std::size_t>(pair) * n + m) + part] =
            second_[2 * (static_cast<std::size_t>(pair) * n + m) + part] *
            (m == 0 || m == half ? Real(0.5) : Real(m < half)) / static_cast<Real>(n);
  run(kernel_x_, pairs, second_);
  separate({n, length_s / 2, 0, shape.frequencies(), length_s}, second_, pairs);
  return complex(pairs);
}

template class PlaneTransforms<double>;
template class PlaneTransforms<float>;

} // namespace bem_contact::contact
