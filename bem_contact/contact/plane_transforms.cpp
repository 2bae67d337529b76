#include "bem_contact/contact/plane_transforms.hpp"

namespace bem_contact::contact {
namespace {

template <class Real> typename Fftw<Real>::Complex* raw(std::complex<Real>* p) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(p);
}

/// Bytes of the spectra on both sides of a product that stay near the processor.
constexpr std::size_t in_cache = 1 << 19;

} // namespace

template <class Real> PlaneTransforms<Real>::PlaneTransforms(const PlaneShape& the_shape) : shape(the_shape) {
  using Fft = Fftw<Real>;
  const auto& [length_x, length_s, lines, inputs, outputs] = shape;
  const auto fields = [&](int count) { return static_cast<std::size_t>(count) * lines * length_x; };
  const auto spectra = [&](int rows) { return 2 * static_cast<std::size_t>(shape.frequencies()) * rows; };
  space_in = make_fft_buffer<Real>(fields(inputs));
  space_out = make_fft_buffer<Real>(fields(outputs));
  spectrum_in_ = make_fft_buffer<Real>(spectra(inputs * length_s));
  spectrum_out_ = make_fft_buffer<Real>(spectra(outputs * lines));
  const std::size_t bytes = spectra((inputs + outputs) * length_s) * sizeof(Real);
  together_ = bytes <= in_cache ? shape.frequencies() : 1;
  turned_in_ = make_fft_buffer<Real>(2 * static_cast<std::size_t>(together_) * inputs * length_s);
  turned_ = make_fft_buffer<Real>(2 * static_cast<std::size_t>(together_) * outputs * length_s);
  const std::lock_guard lock(fft_planner());
  // lines of one frequency lie side by side, so that the transform in s stays in the cache
  const fftw_iodim in_dims{length_x, 1, inputs * length_s};
  const fftw_iodim in_many[2] = {{inputs, lines * length_x, length_s}, {lines, length_x, 1}};
  x_forward_.reset(Fft::plan_guru_dft_r2c(1, &in_dims, 2, in_many, space_in.get(), raw(complex(spectrum_in_)),
                                          FFTW_ESTIMATE));
  const fftw_iodim out_dims{length_x, outputs * lines, 1};
  const fftw_iodim out_many[2] = {{outputs, lines, lines * length_x}, {lines, 1, length_x}};
  x_backward_.reset(Fft::plan_guru_dft_c2r(1, &out_dims, 2, out_many, raw(complex(spectrum_out_)),
                                           space_out.get(), FFTW_ESTIMATE));
  const auto along_s = [&](int lines_of_s, Complex* from, Complex* to, int sign) {
    return Fft::plan_many_dft(1, &shape.length_s, lines_of_s, raw(from), nullptr, 1, length_s, raw(to),
                              nullptr, 1, length_s, sign, FFTW_ESTIMATE);
  };
  s_forward_.reset(along_s(together_ * inputs, complex(spectrum_in_), complex(turned_in_), FFTW_FORWARD));
  s_backward_.reset(along_s(together_ * outputs, complex(turned_), complex(turned_), FFTW_BACKWARD));
}

template <class Real> void PlaneTransforms<Real>::forward() {
  Fftw<Real>::execute(x_forward_.get());
}

template <class Real> void PlaneTransforms<Real>::forward_s(int k) {
  Complex* from = complex(spectrum_in_) + static_cast<std::size_t>(k) * shape.inputs * shape.length_s;
  Fftw<Real>::execute_dft(s_forward_.get(), raw(from), raw(turned_in()));
}

template <class Real> void PlaneTransforms<Real>::backward_s(int k) {
  Fftw<Real>::execute(s_backward_.get());
  for (int line = 0; line < together_ * shape.outputs; ++line)
    std::copy_n(turned() + static_cast<std::size_t>(line) * shape.length_s, shape.lines,
                complex(spectrum_out_) + (static_cast<std::size_t>(k) * shape.outputs + line) * shape.lines);
}

template <class Real> void PlaneTransforms<Real>::backward() {
  Fftw<Real>::execute(x_backward_.get());
}

template <class Real> Real* PlaneTransforms<Real>::kernel() {
  if (!kernel_)
    kernel_ = make_fft_buffer<Real>(static_cast<std::size_t>(shape.length_s) * shape.length_x);
  return kernel_.get();
}

template <class Real> void PlaneTransforms<Real>::transform_kernel(Complex* symbol, std::ptrdiff_t stride) {
  using Fft = Fftw<Real>;
  const int length_x = shape.length_x, length_s = shape.length_s;
  const std::size_t together = static_cast<std::size_t>(shape.frequencies()) * length_s;
  if (!one_sided_)
    one_sided_ = make_fft_buffer<Real>(2 * together);
  if (!kernel_x_) {
    const std::lock_guard lock(fft_planner());
    kernel_x_.reset(Fft::plan_many_dft_r2c(1, &length_x, length_s, kernel(), nullptr, 1, length_x,
                                           raw(complex(one_sided_)), nullptr, length_s, 1, FFTW_ESTIMATE));
    kernel_s_.reset(Fft::plan_many_dft(1, &length_s, shape.frequencies(), raw(complex(one_sided_)), nullptr,
                                       1, length_s, raw(complex(one_sided_)), nullptr, 1, length_s,
                                       FFTW_FORWARD, FFTW_ESTIMATE));
  }
  Fft::execute(kernel_x_.get());
  Fft::execute(kernel_s_.get());
  for (int k = 0; k < shape.frequencies(); ++k)
    std::copy_n(complex(one_sided_) + static_cast<std::size_t>(k) * length_s, length_s, symbol + k * stride);
}

template <class Real> void PlaneTransforms<Real>::even_to_kernel(Real* spectra) {
  using Fft = Fftw<Real>;
  const int count = shape.frequencies();
  const fftw_r2r_kind even = FFTW_REDFT00;
  if (!even_) {
    const std::lock_guard lock(fft_planner());
    even_.reset(Fft::plan_many_r2r(1, &count, shape.length_s, spectra, nullptr, 1, count, spectra, nullptr, 1,
                                   count, &even, FFTW_ESTIMATE));
  }
  Fft::execute_r2r(even_.get(), spectra, spectra);
}

template <class Real> void PlaneTransforms<Real>::kernel_to_spectra(Complex* spectra) {
  using Fft = Fftw<Real>;
  const int n = shape.length_x, count = shape.frequencies();
  if (!one_sided_x_) {
    const std::lock_guard lock(fft_planner());
    one_sided_x_.reset(Fft::plan_many_dft_r2c(1, &n, shape.length_s, kernel(), nullptr, 1, n, raw(spectra),
                                              nullptr, 1, count, FFTW_ESTIMATE));
  }
  Fft::execute_dft_r2c(one_sided_x_.get(), kernel(), raw(spectra));
}

template class PlaneTransforms<double>;
template class PlaneTransforms<float>;

} // namespace bem_contact::contact
