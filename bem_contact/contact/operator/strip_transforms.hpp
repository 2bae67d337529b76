#pragma once

#include "bem_contact/contact/operator/fft.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace bem_contact::contact {

/// Length of the transforms of a strip. Lines and spectra lie one after the other, each aligned for FFTW.
struct StripShape {
  int length = 0;

  bool operator==(const StripShape&) const = default;
  int frequencies() const { return length / 2 + 1; }
  std::size_t line() const { return fft_block(length); }                             ///< reals
  std::size_t spectrum() const { return fft_block(2 * std::size_t(frequencies())); } ///< reals
};

/// The transforms along x of the lines of a strip, from one block of scratch to another. They are planned for
/// a single line: operators with any number of lines share them.
template <class Real> class StripTransforms {
public:
  using Shape = StripShape;
  StripTransforms(const StripShape& the_shape, std::shared_ptr<Scratch> the_scratch)
      : shape(the_shape), scratch(std::move(the_scratch)) {
    Real* const line = scratch->template reals<Real>(shape.line() + shape.spectrum());
    Complex* const spectrum = complex(line + shape.line());
    const int length = shape.length;
    const std::lock_guard lock(fft_planner());
    forward_.reset(
        Fft::plan_many_dft_r2c(1, &length, 1, line, nullptr, 1, 0, spectrum, nullptr, 1, 0, FFTW_ESTIMATE));
    backward_.reset(
        Fft::plan_many_dft_c2r(1, &length, 1, spectrum, nullptr, 1, 0, line, nullptr, 1, 0, FFTW_ESTIMATE));
  }

  const StripShape shape;
  const std::shared_ptr<Scratch> scratch;

  void forward(int lines, Real* from, Real* spectra) const {
    for (int k = 0; k < lines; ++k, from += shape.line(), spectra += shape.spectrum())
      Fft::execute_dft_r2c(forward_.get(), from, complex(spectra));
  }
  void backward(int lines, Real* spectra, Real* to) const { ///< times the length; the spectra are lost
    for (int k = 0; k < lines; ++k, to += shape.line(), spectra += shape.spectrum())
      Fft::execute_dft_c2r(backward_.get(), complex(spectra), to);
  }

private:
  using Fft = Fftw<Real>;
  using Complex = typename Fft::Complex;
  static Complex* complex(Real* p) { return reinterpret_cast<Complex*>(p); }

  FftPlan<Real> forward_, backward_;
};

} // namespace bem_contact::contact
