#pragma once

#include "bem_contact/contact/operator/settings.hpp"

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>

namespace bem_contact::contact {

/// FFTW's planner is not thread-safe; its execution is.
inline std::mutex& fft_planner() {
  static std::mutex mutex;
  return mutex;
}

/// FFTW's names in double and in single precision.
template <class Real> struct Fftw;

#define BEM_CONTACT_FFTW(Real, prefix)                                                                       \
  template <> struct Fftw<Real> {                                                                            \
    using Complex = prefix##complex;                                                                         \
    using Plan = prefix##plan;                                                                               \
    static constexpr auto& alloc_real = prefix##alloc_real;                                                  \
    static constexpr auto& free = prefix##free;                                                              \
    static constexpr auto& destroy_plan = prefix##destroy_plan;                                              \
    static constexpr auto& execute_dft = prefix##execute_dft;                                                \
    static constexpr auto& plan_many_dft = prefix##plan_many_dft;                                            \
  };
BEM_CONTACT_FFTW(double, fftw_)
BEM_CONTACT_FFTW(float, fftwf_)
#undef BEM_CONTACT_FFTW

template <class Real> struct FreeFftBuffer {
  void operator()(Real* p) const { Fftw<Real>::free(p); }
};
template <class Real> using FftBuffer = std::unique_ptr<Real[], FreeFftBuffer<Real>>;

/// Aligned for FFTW, not initialised.
template <class Real> FftBuffer<Real> make_fft_buffer(std::size_t n) {
  return FftBuffer<Real>(Fftw<Real>::alloc_real(std::max<std::size_t>(n, 1)));
}

/// The least multiple of a cache line, in reals of either kind, that holds n of them: FFTW expects blocks
/// that lie one after the other to be aligned alike.
inline std::size_t fft_block(std::size_t n) {
  return (n + 15) / 16 * 16;
}

/// Memory in which one operation after the other works. Each leaves there what it likes.
class Scratch {
public:
  /// Returns room for at least `n` reals, aligned for FFTW; what an earlier call gave may be gone.
  template <class Real> Real* reals(std::size_t n) {
    const std::size_t doubles = (n * sizeof(Real) + sizeof(double) - 1) / sizeof(double);
    if (doubles > size_) {
      memory_.reset(); // first, so that its pages serve again
      memory_ = make_fft_buffer<double>(doubles);
      size_ = doubles;
    }
    return reinterpret_cast<Real*>(memory_.get());
  }

private:
  std::size_t size_ = 0; ///< doubles
  FftBuffer<double> memory_;
};

template <class Real> struct DestroyFftPlan {
  void operator()(typename Fftw<Real>::Plan plan) const {
    const std::lock_guard lock(fft_planner());
    Fftw<Real>::destroy_plan(plan);
  }
};
template <class Real>
using FftPlan = std::unique_ptr<std::remove_pointer_t<typename Fftw<Real>::Plan>, DestroyFftPlan<Real>>;

/// About the time of one complex transform without FFTW's search for the fastest way, which would take longer
/// than it saves: single precision on AVX2, ns.
inline double transform_time(int n) {
  const bool quick = n <= 16 || n == 20 || n % 16 == 0;
  return (quick ? quick_transform : slow_transform) * n;
}

/// The smallest length >= n whose prime factors are 2, 3 and 5.
inline int good_fft_length(int n) {
  for (;; ++n) {
    int rest = n;
    for (const int prime : {2, 3, 5})
      while (rest % prime == 0)
        rest /= prime;
    if (rest == 1)
      return n;
  }
}

} // namespace bem_contact::contact
