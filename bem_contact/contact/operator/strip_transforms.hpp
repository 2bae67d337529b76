#pragma once

#include "bem_contact/contact/operator/fft.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace bem_contact::contact {

/// Length of the transforms of a strip, and how many lines go through them at once.
struct StripShape {
  int length = 0, lines_in = 0, lines_out = 0;

  bool operator==(const StripShape&) const = default;
  int frequencies() const { return length / 2 + 1; }
  /// A block of scratch holds all lines, [line][place] or [line][frequency].
  std::size_t block_size() const {
    return fft_block(static_cast<std::size_t>(lines_in > lines_out ? lines_in : lines_out) * 2 *
                     frequencies());
  }
};

/// The transforms along x of all lines of a strip, from one block of scratch to another. Operators of the
/// same shape share them.
template <class Real> class StripTransforms {
public:
  using Shape = StripShape;
  StripTransforms(const StripShape& the_shape, std::shared_ptr<Scratch> the_scratch)
      : shape(the_shape), scratch(std::move(the_scratch)) {
    Real* const first = scratch->template reals<Real>(2 * shape.block_size());
    Real* const second = first + shape.block_size();
    const int length = shape.length, frequencies = shape.frequencies();
    const std::lock_guard lock(fft_planner());
    // Line by line: FFTW remembers a length, whatever the number of lines.
    forward_.reset(Fft::plan_many_dft_r2c(1, &length, shape.lines_in, first, nullptr, 1, length,
                                          complex(second), nullptr, 1, frequencies, FFTW_ESTIMATE));
    backward_.reset(Fft::plan_many_dft_c2r(1, &length, shape.lines_out, complex(first), nullptr, 1,
                                           frequencies, second, nullptr, 1, length, FFTW_ESTIMATE));
  }

  const StripShape shape;
  const std::shared_ptr<Scratch> scratch;

  void forward(Real* lines, Real* spectra) const {
    Fft::execute_dft_r2c(forward_.get(), lines, complex(spectra));
  }
  void backward(Real* spectra, Real* lines) const { ///< times the length; the spectra are lost
    Fft::execute_dft_c2r(backward_.get(), complex(spectra), lines);
  }

private:
  using Fft = Fftw<Real>;
  static typename Fft::Complex* complex(Real* p) { return reinterpret_cast<typename Fft::Complex*>(p); }

  FftPlan<Real> forward_, backward_;
};

} // namespace bem_contact::contact
