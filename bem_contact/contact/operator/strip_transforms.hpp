#pragma once

#include "bem_contact/contact/operator/fft.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace bem_contact::contact {

/// Length of the transforms of a strip.
struct StripShape {
  int length = 0;

  bool operator==(const StripShape&) const = default;
  /// Reals of two lines: they are the parts of complex numbers. Pairs lie one after the other, each aligned
  /// for FFTW.
  std::size_t pair() const { return fft_block(2 * static_cast<std::size_t>(length)); }
};

/// The transforms along x of the lines of a strip, two at a time, from one block of scratch to another. To
/// plan a real transform of a new length takes FFTW forty times as long as a complex one. They are planned
/// for a single pair: operators with any number of lines share them.
template <class Real> class StripTransforms {
public:
  using Shape = StripShape;
  StripTransforms(const StripShape& the_shape, std::shared_ptr<Scratch> the_scratch)
      : shape(the_shape), scratch(std::move(the_scratch)) {
    Real* const from = scratch->template reals<Real>(2 * shape.pair());
    const auto plan = [&](int sign) {
      return Fft::plan_many_dft(1, &shape.length, 1, complex(from), nullptr, 1, 0,
                                complex(from + shape.pair()), nullptr, 1, 0, sign, FFTW_ESTIMATE);
    };
    const std::lock_guard lock(fft_planner());
    forward_.reset(plan(FFTW_FORWARD));
    backward_.reset(plan(FFTW_BACKWARD));
  }

  const StripShape shape;
  const std::shared_ptr<Scratch> scratch;

  void forward(int pairs, Real* from, Real* to) const { run(forward_, pairs, from, to); }
  void backward(int pairs, Real* from, Real* to) const { run(backward_, pairs, from, to); } ///< times length

private:
  using Fft = Fftw<Real>;
  static typename Fft::Complex* complex(Real* p) { return reinterpret_cast<typename Fft::Complex*>(p); }
  void run(const FftPlan<Real>& plan, int pairs, Real* from, Real* to) const {
    for (int k = 0; k < pairs; ++k, from += shape.pair(), to += shape.pair())
      Fft::execute_dft(plan.get(), complex(from), complex(to));
  }

  FftPlan<Real> forward_, backward_;
};

} // namespace bem_contact::contact
