#pragma once

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

struct FreeFftBuffer {
  void operator()(double* p) const { fftw_free(p); }
};
using FftBuffer = std::unique_ptr<double[], FreeFftBuffer>;

/// Zeros, aligned for FFTW.
inline FftBuffer make_fft_buffer(std::size_t n) {
  FftBuffer buffer(fftw_alloc_real(std::max<std::size_t>(n, 1)));
  std::fill_n(buffer.get(), n, 0.0);
  return buffer;
}

struct DestroyFftPlan {
  void operator()(fftw_plan plan) const {
    const std::lock_guard lock(fft_planner());
    fftw_destroy_plan(plan);
  }
};
using FftPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyFftPlan>;

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
